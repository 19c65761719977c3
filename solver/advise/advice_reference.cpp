#include "solver/advise/advice_reference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace talus {
namespace {

/// Height of a rung in the search for the value: two rungs per octave or decade.
constexpr double rung_height = 0.5;
/// Fraction of the accuracy within which the last values of one method must agree with each other.
constexpr double own_agreement = 0.1;
/// Fraction of the accuracy within which the last values of a second method must agree with the value of the first.
constexpr double other_agreement = 0.25;
/// Number of last values that must agree: they span an octave or decade.
constexpr std::size_t agreeing = 3;
/// Tolerance from which on the growth of small differences is measured, even if no two methods agree yet.
constexpr double fine = 1e-10;

/// Whether the errors of two methods are independent: their orders differ, and at least one has step control (all
/// leapfrog methods pass through the same positions).
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

/// Runs the next finer rung. Output intervals shrink with the tolerance: extremes between outputs must converge, too.
void ReferenceSearch::climb(Climb& climb) {
  const double height = rung_height * climb.rungs++;
  const long outputs = std::lround(static_cast<double>(resolving_) * std::exp2(0.5 * height));
  climb.method = climb.ladder.at(climb.ladder.by_tolerance ? height + 1.0 : height, outputs);
  climb.last =
      runs_->run(climb.method, std::min(rules_->evaluations - runs_->evaluations(), evaluation_limit(climb.next_cost)));
  if (rules_->progress) rules_->progress(runs_->evaluations());
  // Closed-form steps take no force evaluation, but computing time: each counts as one.
  const long cost = std::max(climb.last.evaluations, climb.ladder.by_tolerance ? 1L : climb.method.steps);
  climb.next_cost =
      static_cast<long>(static_cast<double>(cost) * (climb.ladder.by_tolerance ? 1.2 : std::exp2(rung_height))) + 1;
  if (!climb.last.failure.empty()) {
    climb.values.clear();
    // A method that rejects the scene (no evaluations) does so at every rung; a tolerance that failed three times will
    // not be met when it is finer.
    const bool refused = climb.last.evaluations == 0;
    if (refused || ++climb.failures == 3) climb.failures = refused || climb.ladder.by_tolerance ? 3 : 2;
    return;
  }
  climb.failures = 0;
  if (climb.method.steps >= resolving_) climb.values.push_back(climb.last.between);
}

/// Largest relative deviation of a climb's last values from a value; nothing while there are too few values.
std::optional<double> ReferenceSearch::distance(const Climb& climb, double value) const {
  if (climb.values.size() < agreeing) return {};
  double largest = 0.0;
  for (std::size_t i = climb.values.size() - agreeing; i < climb.values.size(); ++i)
    largest = std::max(largest, std::abs(climb.values[i] - value));
  return largest == 0.0 ? 0.0 : largest / std::abs(value);
}

/// Whether two methods of different orders have converged to the same value; stores it as the reference.
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

/// Estimated cost of a climb's next rung; for fixed steps, the cost until its values agree with each other, because
/// their errors may fall no faster than their cost grows, whereas errors of methods with tolerance fall by a factor of
/// 3 at 1.2 times the cost.
double ReferenceSearch::hoped_cost(const Climb& climb) const {
  const double next = static_cast<double>(climb.next_cost);
  if (climb.ladder.by_tolerance || climb.values.empty()) return next;
  const auto own = distance(climb, climb.values.back());
  return next * std::clamp(own ? *own / (own_agreement * rules_->accuracy) : 1.0, 1.0, 100.0);
}

/// The climb with values and the most rungs.
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

/// Repeats the last rung of a climb from slightly different starts. Returns a refusal if the result differs by more
/// than the accuracy although the starts differ by only 1e-6 or 1e-9 of the accuracy.
std::optional<Refusal> ReferenceSearch::follow_differences(const Climb& climb) {
  followed_ = true;
  if (!rules_->follows_differences) return {};
  const auto run = [&](double fraction, int direction) {
    Pilot pilot =
        runs_->run(climb.method, rules_->evaluations - runs_->evaluations(), {fraction, direction, climb.last.speed});
    if (rules_->progress) rules_->progress(runs_->evaluations());
    return pilot;
  };
  const Pilot from = run(0.0, 1);
  if (!from.failure.empty()) return {};
  if (auto refusal = vanishing(from.between, from.size)) return refusal;
  // Differences below 1e-13 are comparable to round-off after some thousand operations.
  const std::array fractions{std::max(1e-13, 1e-9 * rules_->accuracy), std::max(1e-13, 1e-6 * rules_->accuracy)};
  for (const double fraction : fractions) {
    for (const int direction : {1, 2}) {
      const Pilot to = run(fraction, direction);
      if (!to.failure.empty() || to.between == from.between) continue;
      const double result = std::abs(to.between - from.between) / std::abs(from.between);
      if (!(result <= growth_.result)) growth_ = {fraction, result};
    }
    if (!(growth_.result > rules_->accuracy)) continue;
    return Refusal{Refusal::Kind::chaotic,
                   fmt::format("differences of {:.0e} in the start grow to {:.0e} of the result: no step gives {:.0e}",
                               growth_.fraction, growth_.result, rules_->accuracy)};
  }
  return {};
}

/// Returns a refusal for a value that is zero or negligible compared with the largest magnitude during the run.
std::optional<Refusal> ReferenceSearch::vanishing(double value, double size) const {
  constexpr double nothing = 1e-9;
  if (std::abs(value) > nothing * size) return {};
  return Refusal{
      Refusal::Kind::vanishing,
      fmt::format("{} is {:.0e}, less than {:.0e} of the largest in the run: there is no relative accuracy of it",
                  runs_->quantity().name, value, nothing)};
}

/// Refusal if fewer than two methods gave enough values for a comparison.
Refusal ReferenceSearch::too_dear() const {
  const bool all_failed = std::ranges::all_of(climbs_, [](const Climb& climb) { return climb.failures != 0; });
  if (all_failed) {
    return {Refusal::Kind::unsettled, fmt::format("every integrator fails; the last one, {}: {}",
                                                  climbs_.back().method.integrator, climbs_.back().last.failure)};
  }
  return {Refusal::Kind::stiff,
          fmt::format("resolving the fastest spring takes {} steps; fewer than two integrators completed {} runs "
                      "within {} force evaluations",
                      resolving_, agreeing, rules_->evaluations)};
}

/// Refusal if no two methods agreed; reports the two methods that came closest to convergence.
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
  return {
      Refusal::Kind::unsettled,
      fmt::format("no reference value within {} force evaluations: {} gives {:.10g}, its last {} runs differ by "
                  "{:.1e}; {} gives {:.10g}, its last {} by {:.1e}; required are differences below {:.1e} and, from "
                  "another integrator of different order, {:.1e}{}",
                  rules_->evaluations, first.method.integrator, first.values.back(), agreeing, spread(&first),
                  second.method.integrator, second.values.back(), agreeing, spread(&second),
                  own_agreement * rules_->accuracy, other_agreement * rules_->accuracy,
                  rules_->among.empty() ? "" : "; all integrators are run for this, not only the given ones")};
}

}  // namespace talus
