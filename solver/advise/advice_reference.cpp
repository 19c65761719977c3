#include "solver/advise/advice_reference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace talus {
namespace {

/// Rungs of the search for the value: two to an octave or decade.
constexpr double rung_height = 0.5;
/// Share of the accuracy within which the last values of one method must lie.
constexpr double own_agreement = 0.1;
/// Share of it within which the last values of another must lie about those.
constexpr double other_agreement = 0.25;
/// How many those are: over an octave or decade.
constexpr std::size_t agreeing = 3;
/// Tolerance from which on a method tells what small differences grow to, whether or not it has agreed with another.
constexpr double fine = 1e-10;

/// Whether two methods have hardly an error in common: their orders differ, and one chooses its own steps. (All
/// leapfrog methods go through the same places.)
bool differ(const RunMethod& a, const RunMethod& b) {
  return integrator_traits(a.integrator).order != integrator_traits(b.integrator).order &&
         (a.tolerance != 0.0 || b.tolerance != 0.0);
}

}  // namespace

ReferenceSearch::ReferenceSearch(PilotRuns& runs, const AdviceRules& rules, long resolving)
    : runs_{&runs}, rules_{&rules}, resolving_{resolving} {
  for (MethodLadder& ladder : method_ladders(integrator_names(), resolving)) {
    const long cost = runs.cost(ladder.at(0.0, resolving));
    climbs_.push_back({.ladder = std::move(ladder), .next_cost = cost});
  }
}

/// One rung further up. Outputs draw together with the tolerance: extremes between them must settle too.
void ReferenceSearch::climb(Climb& climb) {
  const double height = rung_height * climb.rungs++;
  const long outputs = std::lround(static_cast<double>(resolving_) * std::exp2(0.5 * height));
  climb.method = climb.ladder.at(climb.ladder.by_tolerance ? height + 1.0 : height, outputs);
  climb.last = runs_->run(climb.method, std::min(rules_->evaluations - runs_->evaluations(), most_of(climb.next_cost)));
  if (rules_->progress) rules_->progress(runs_->evaluations());
  // Steps that cost no evaluation, of closed forms, cost their time.
  const long cost = std::max(climb.last.evaluations, climb.ladder.by_tolerance ? 1L : climb.method.steps);
  climb.next_cost =
      static_cast<long>(static_cast<double>(cost) * (climb.ladder.by_tolerance ? 1.2 : std::exp2(rung_height))) + 1;
  if (!climb.last.failure.empty()) {
    climb.values.clear();
    // What a method refuses it refuses at every rung; a tolerance that cannot be kept will not be when it is finer.
    const bool refused = climb.last.evaluations == 0;
    if (refused || ++climb.failures == 3) climb.failures = refused || climb.ladder.by_tolerance ? 3 : 2;
    return;
  }
  climb.failures = 0;
  if (climb.method.steps >= resolving_) climb.values.push_back(climb.last.between);
}

/// Largest distance of a climb's last values from a value, as a share of it; none before there are enough.
std::optional<double> ReferenceSearch::distance(const Climb& climb, double value) const {
  if (climb.values.size() < agreeing) return {};
  double largest = 0.0;
  for (std::size_t i = climb.values.size() - agreeing; i < climb.values.size(); ++i)
    largest = std::max(largest, std::abs(climb.values[i] - value));
  return largest == 0.0 ? 0.0 : largest / std::abs(value);
}

/// Whether a method has come to a value and another of a different order to the same.
bool ReferenceSearch::agreed() {
  for (const Climb& a : climbs_) {
    if (a.values.empty()) continue;
    const double value = a.values.back();
    const auto own = distance(a, value);
    if (!own || *own > own_agreement * rules_->accuracy) continue;
    for (const Climb& b : climbs_) {
      const auto apart = distance(b, value);
      if (!apart || *apart > other_agreement * rules_->accuracy || !differ(a.method, b.method)) continue;
      reference_ = {value, a.last.size, *apart, a.method, b.method.integrator, a.last.values};
      return true;
    }
  }
  return false;
}

ReferenceSearch::Climb* ReferenceSearch::cheapest() {
  Climb* best = nullptr;
  for (Climb& climb : climbs_) {
    const double height = rung_height * climb.rungs + (climb.ladder.by_tolerance ? 1.0 : 0.0);
    if (climb.failures == 3 || height > climb.ladder.top()) continue;
    if (climb.next_cost > rules_->evaluations - runs_->evaluations()) continue;
    if (best == nullptr || hoped_cost(climb) < hoped_cost(*best)) best = &climb;
  }
  return best;
}

/// What a climb's next rung costs; of fixed steps until it agrees with itself, for their errors may fall no faster than
/// their cost grows, where those of a tolerance fall by a factor of 3 at 1.2 times the cost.
double ReferenceSearch::hoped_cost(const Climb& climb) const {
  const double next = static_cast<double>(climb.next_cost);
  if (climb.ladder.by_tolerance || climb.values.empty()) return next;
  const auto own = distance(climb, climb.values.back());
  return next * std::clamp(own ? *own / (own_agreement * rules_->accuracy) : 1.0, 1.0, 100.0);
}

/// The climb that got furthest: by its tolerance, or else by its steps.
const ReferenceSearch::Climb* ReferenceSearch::finest() const {
  const Climb* best = nullptr;
  for (const Climb& climb : climbs_) {
    if (climb.values.empty()) continue;
    if (best == nullptr || climb.rungs > best->rungs) best = &climb;
  }
  return best;
}

std::optional<Refusal> ReferenceSearch::find() {
  while (!agreed()) {
    Climb* const next = cheapest();
    if (next == nullptr) {
      const Climb* const last = finest();
      if (last != nullptr && !followed_) {
        if (auto refusal = follow_differences(*last)) return refusal;
      }
      return unsettled();
    }
    climb(*next);
    if (followed_ || next->method.tolerance == 0.0 || next->method.tolerance > fine || next->values.empty()) continue;
    if (auto refusal = follow_differences(*next)) return refusal;
  }
  if (auto refusal = vanishing(reference_.value, reference_.size)) return refusal;
  if (followed_) return {};
  for (const Climb& climb : climbs_) {
    if (climb.method.integrator == reference_.method.integrator &&
        climb.method.tolerance == reference_.method.tolerance && climb.method.steps == reference_.method.steps)
      return follow_differences(climb);
  }
  return {};
}

/// Runs the last rung of a climb again from starts that hardly differ. Refuses where the result differs by more than
/// the accuracy though the starts differ by a millionth, or by a billionth, of it.
std::optional<Refusal> ReferenceSearch::follow_differences(const Climb& climb) {
  followed_ = true;
  if (!rules_->follows_differences) return {};
  const auto run = [&](double share, int direction) {
    Pilot pilot =
        runs_->run(climb.method, rules_->evaluations - runs_->evaluations(), {share, direction, climb.last.speed});
    if (rules_->progress) rules_->progress(runs_->evaluations());
    return pilot;
  };
  const Pilot from = run(0.0, 1);
  if (!from.failure.empty()) return {};
  if (auto refusal = vanishing(from.between, from.size)) return refusal;
  // Less than 1e-13 is what the arithmetic itself leaves after some thousand operations.
  const std::array shares{std::max(1e-13, 1e-9 * rules_->accuracy), std::max(1e-13, 1e-6 * rules_->accuracy)};
  for (const double share : shares) {
    for (const int direction : {1, 2}) {
      const Pilot to = run(share, direction);
      if (!to.failure.empty() || to.between == from.between) continue;
      const double result = std::abs(to.between - from.between) / std::abs(from.between);
      if (!(result <= growth_.result)) growth_ = {share, result};
    }
    if (!(growth_.result > rules_->accuracy)) continue;
    return Refusal{Refusal::Kind::chaotic,
                   fmt::format("differences of {:.0e} in the start grow to {:.0e} of the result: no step gives {:.0e}",
                               growth_.share, growth_.result, rules_->accuracy)};
  }
  return {};
}

/// Refuses a value that is zero, or as good as zero beside what it is during the run.
std::optional<Refusal> ReferenceSearch::vanishing(double value, double size) const {
  constexpr double nothing = 1e-9;
  if (std::abs(value) > nothing * size) return {};
  return Refusal{
      Refusal::Kind::vanishing,
      fmt::format("{} is {:.0e}, less than {:.0e} of the largest in the run: there is no relative accuracy of it",
                  runs_->quantity().name, value, nothing)};
}

/// Why not even two methods came to values that can be compared.
Refusal ReferenceSearch::too_dear() const {
  const bool all_failed = std::ranges::all_of(climbs_, [](const Climb& climb) { return climb.failures != 0; });
  if (all_failed) {
    return {Refusal::Kind::unsettled, fmt::format("no method comes through: {}: {}", climbs_.back().method.integrator,
                                                  climbs_.back().last.failure)};
  }
  return {Refusal::Kind::stiff,
          fmt::format("the run takes {} steps to resolve its fastest spring, and no two methods came to {} values "
                      "within {} force evaluations",
                      resolving_, agreeing, rules_->evaluations)};
}

/// What was reached, of methods that did not agree.
Refusal ReferenceSearch::unsettled() const {
  std::vector<const Climb*> climbs;
  for (const Climb& climb : climbs_) {
    if (climb.values.size() >= agreeing) climbs.push_back(&climb);
  }
  const auto spread = [this](const Climb* climb) { return *distance(*climb, climb->values.back()); };
  std::ranges::stable_sort(climbs, [&](const Climb* a, const Climb* b) { return spread(a) < spread(b); });
  if (climbs.size() < 2) return too_dear();
  const Climb &first = *climbs[0], &second = *climbs[1];
  if (auto refusal = vanishing(first.values.back(), first.last.size)) return *refusal;
  return {Refusal::Kind::unsettled,
          fmt::format("within {} force evaluations the methods come to no common value: {} gives {:.10g}, {:.1e} from "
                      "what it gave an octave before, {} gives {:.10g}, {:.1e} from that; {:.0e} is asked",
                      rules_->evaluations, first.method.integrator, first.values.back(), spread(&first),
                      second.method.integrator, second.values.back(), spread(&second), rules_->accuracy)};
}

}  // namespace talus
