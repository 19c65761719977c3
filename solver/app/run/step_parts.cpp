#include "solver/app/run/step_parts.hpp"

#include <algorithm>

namespace talus::app {
namespace {

using Clock = std::chrono::steady_clock;

/// Evaluations of each part in a look; averaging reduces the overhead of reading the clock.
constexpr int repetitions = 8;
/// Largest number of steps between two looks. Before, a look comes whenever the number of steps has doubled.
constexpr long rare = 4096;

}  // namespace

StepParts::StepParts(const Dynamics& dynamics, bool ledger)
    : dynamics_{&dynamics}, ledger_{ledger}, work_{dynamics.workspace()}, rates_{rest_state(dynamics.model())} {}

/// Time of one repetition.
template <class Work>
std::chrono::duration<double, std::nano> StepParts::time(Work&& work) {
  const Clock::time_point start = Clock::now();
  for (int i = 0; i < repetitions; ++i)
    work();
  return std::chrono::duration<double, std::nano>{Clock::now() - start} / repetitions;
}

void StepParts::observed(Clock::duration taken) {
  // A time far above the mean so far is limited: another process probably ran in between.
  if (observed_ >= 16) taken = std::min(taken, 16 * observers_ / observed_);
  observers_ += taken;
  ++observed_;
}

void StepParts::look(const State& state, const StepInfo& info) {
  if (info.step < next_) return;
  next_ = info.step + std::min(info.step, rare);
  const Clock::time_point start = Clock::now();
  State copy = state;
  Rates* const accounts = ledger_ ? &rates_ : nullptr;
  evaluation_ += time([&] { dynamics_->evaluate(copy, work_, rates_, ledger_); });
  // count() needs all cable paths, which an evaluation for rates only does not compute.
  if (work_.pulled) {
    dynamics_->update(copy, work_);
    dynamics_->rates(copy, work_, rates_, ledger_);
  }
  count(copy);
  // The parts are timed separately, including the calls of the laws.
  work_.evaluated = Evaluated::geometry;
  contacts_ += time([&] {
    if (dynamics_->contacts().find(copy, work_)) dynamics_->contacts().update(copy, work_);
    dynamics_->contacts().update_modes(copy, work_, nullptr);
    dynamics_->contacts().add(copy, work_, accounts, false);
  });
  cables_ += time([&] {
    dynamics_->cables().update(copy, work_);
    dynamics_->cables().update_modes(copy, work_);
    dynamics_->cables().load(copy, work_, accounts);
  });
  ++sums_.looks;
  looking_ += Clock::now() - start;
}

void StepParts::count(const State& state) {
  const Layout& layout = dynamics_->layout();
  sums_.near += static_cast<double>(std::count(work_.near.begin(), work_.near.end(), char{1}));
  for (std::size_t c = 0; c < layout.contact_slots.size(); ++c) {
    const auto first = state.mode.begin() + static_cast<std::ptrdiff_t>(layout.contact_slots[c].mode);
    const auto last = first + static_cast<std::ptrdiff_t>(layout.contact_instances[c]);
    if (std::any_of(first, last, [](Mode mode) { return mode != 0; })) sums_.touching += 1.0;
  }
  for (const std::vector<CableSpan>& runs : work_.active.cables) {
    for (const CableSpan& run : runs) {
      sums_.awake += static_cast<double>(run.count);
      const double* const first = work_.paths.tension.at(run.cable);
      sums_.taut +=
          static_cast<double>(std::count_if(first, first + run.count, [](double tension) { return tension > 0.0; }));
    }
  }
}

void StepParts::ended(double seconds, long steps, long evaluations) {
  run_ += std::chrono::duration<double>{seconds};
  steps_ += steps;
  evaluations_ += evaluations;
}

StepParts::Found StepParts::found() const {
  Found found = sums_;
  found.pairs = dynamics_->contacts().candidates();
  found.cables = dynamics_->cables().size();
  found.memory = dynamics_->layout().memory_count;
  if (found.looks == 0 || observed_ == 0 || steps_ == 0) return found;
  const auto looks = static_cast<double>(found.looks), steps = static_cast<double>(steps_);
  for (double* const sum : {&found.near, &found.touching, &found.awake, &found.taut})
    *sum /= looks;
  const double each = static_cast<double>(evaluations_) / steps / looks;  // evaluations per step, divided by looks
  Times& times = found.times;
  times.step = (run_ - looking_).count() / steps;
  times.contacts = each * contacts_.count();
  times.cables = each * cables_.count();
  times.bodies = std::max(0.0, each * evaluation_.count() - times.contacts - times.cables);
  times.observers = std::chrono::duration<double, std::nano>{observers_}.count() / static_cast<double>(observed_);
  // The parts are measured separately, on sampled states: they are scaled so that their sum does not exceed the step.
  const double all = times.contacts + times.cables + times.bodies + times.observers;
  const double fit = all > 0.0 ? std::min(1.0, times.step / all) : 1.0;
  for (double* const part : {&times.contacts, &times.cables, &times.bodies, &times.observers})
    *part *= fit;
  times.integration = std::max(0.0, times.step - times.contacts - times.cables - times.bodies - times.observers);
  return found;
}

}  // namespace talus::app
