#include "solver/python/script_simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "solver/base/error.hpp"
#include "solver/run/simulate.hpp"
#include "solver/run/snapshot.hpp"
#include "solver/state/state_archive.hpp"

namespace talus::python {
namespace {

void set_numbers(std::vector<double>& numbers, const std::vector<double>& given, const char* name) {
  if (given.size() != numbers.size())
    throw InputError{fmt::format("{}: found {} numbers; it must be {}, one for each coordinate of the scene", name,
                                 given.size(), numbers.size())};
  const auto bad = std::ranges::find_if_not(given, [](double number) { return std::isfinite(number); });
  if (bad != given.end())
    throw InputError{fmt::format("{}[{}]: found {}; it must be finite", name, bad - given.begin(), *bad)};
  numbers = given;
}

}  // namespace

ScriptSimulation::ScriptSimulation(const ScriptScene& scene, const app::MethodOptions& method)
    : scene_{scene},
      method_{method},
      file_{with_method(scene, method)},
      dynamics_{file_.scene.model},
      system_{dynamics_, file_.scene.plan.ledger},
      run_state_{initial_run_state(file_.scene.integrator, started(file_.scene.initial))},
      seen_{dynamics_, run_state_.state},
      steps_{step_count({.step = plan().step, .end = plan().end - run_state_.start, .interval = plan().interval})} {}

State ScriptSimulation::started(State state) {
  system_.begin(state);
  return state;
}

const ScriptSimulation& ScriptSimulation::idle() const {
  demand_idle(is_advancing_);
  return *this;
}

bool ScriptSimulation::advance(const Advancing& /*advancing*/, long steps, const std::function<bool()>& interrupted) {
  if (outcome_ || steps <= 0) return !outcome_;
  const long until = steps < steps_ - run_state_.step ? run_state_.step + steps : steps_;
  // One step leaves the last finite state as it is.
  std::optional<RunState> before;
  if (until > run_state_.step + 1) before = run_state_;
  Outcome outcome = take(until, interrupted);
  if (outcome.kind == Outcome::Kind::stopped) return true;
  if (outcome.kind == Outcome::Kind::diverged && before) {
    // The run is repeated to the state before the step that diverged.
    const RunState last = std::exchange(run_state_, *before);
    if (last.step > run_state_.step) static_cast<void>(take(last.step, {}));
    run_state_ = last;
  }
  outcome_ = std::move(outcome);
  return false;
}

Outcome ScriptSimulation::take(long until, const std::function<bool()>& interrupted) {
  const Scene& scene = file_.scene;
  bool ends_early = false;
  const StopCondition stop = [&](const Snapshot& seen) {
    ends_early = scene.early_end && reached(*scene.early_end, scene.model, seen.state());
    return ends_early || run_state_.step >= until || (interrupted && interrupted());
  };
  // The snapshot keeps the last state that was requested.
  const Observer last = [](const Snapshot& seen, const StepInfo& info) {
    if (info.last) static_cast<void>(seen.state());
  };
  Outcome outcome = simulate(system_, run_state_, scene.plan, {&last, 1}, stop, &seen_);
  if (outcome && ends_early) outcome.kind = Outcome::Kind::finished;
  return outcome;
}

void ScriptSimulation::restart(const std::optional<std::vector<double>>& q,
                               const std::optional<std::vector<double>>& v) {
  static_cast<void>(idle());
  State state = file_.scene.initial;
  if (q) set_numbers(state.q, *q, "q");
  if (v) set_numbers(state.v, *v, "v");
  if (q || v) dynamics_.wake_all(state);
  run_state_ = initial_run_state(file_.scene.integrator, started(std::move(state)));
  seen_.set(run_state_.state);
  outcome_.reset();
}

void ScriptSimulation::serialize(Archive& archive) {
  static_cast<void>(idle());
  // Before its first step a method holds nothing.
  bool is_started = run_state_.step > 0;
  archive.flag("started", is_started);
  if (!is_started) {
    archive.scope("state", [&] { talus::serialize(archive, run_state_.state); });
    if (archive.is_loading()) seen_.set(run_state_.state);
    return;
  }
  archive.scope("run", [&] { run_state_.serialize(archive); });
  State seen = seen_.state();
  archive.scope("seen", [&] { talus::serialize(archive, seen); });
  if (archive.is_loading()) seen_.set(seen);
  bool ended = outcome_.has_value();
  archive.flag("ended", ended);
  if (!ended) return;
  if (archive.is_loading()) outcome_.emplace();
  auto kind = static_cast<long>(outcome_->kind);
  archive.count("outcome", kind);
  outcome_->kind = static_cast<Outcome::Kind>(kind);
  archive.number("outcome_time", outcome_->time);
  archive.text("outcome_message", outcome_->message);
}

std::vector<double> ScriptSimulation::angles() const {
  std::vector<double> found;
  for (std::size_t i = 0; i < model().bodies.size(); ++i)
    found.push_back(angle(model(), dynamics_.layout(), seen_.state(), static_cast<BodyId>(i)));
  return found;
}

std::vector<double> ScriptSimulation::elongations() const {
  std::vector<double> found;
  for (std::size_t i = 0; i < model().cables.size(); ++i)
    found.push_back(dynamics_.elongation(seen_.geometry(), static_cast<CableId>(i)));
  return found;
}

}  // namespace talus::python
