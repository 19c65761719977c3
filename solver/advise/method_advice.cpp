#include "solver/advise/method_advice.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/base/error.hpp"

namespace talus {
namespace {

/// Rungs per octave of steps or decade of tolerance in the search for the cheapest method.
constexpr int rungs_of_unit = 6;
/// Fraction of the accuracy that the error of an extreme by the output interval may reach.
constexpr double output_fraction = 0.25;
/// Maximum relative excess over the required number of outputs; it varies from run to run, so that an extreme does not
/// always coincide with an output.
constexpr double output_spread = 0.5;
/// Maximum number of outputs of a run requested to resolve its extremes.
constexpr long maximum_outputs = 2'000'000;

/// i-th number of a sequence in [0, 1) that is evenly distributed at any length: multiples of the golden ratio.
double golden_fraction(int i) {
  const double x = 0.6180339887498949 * i;
  return x - std::floor(x);
}

/// Largest error of an extreme that results from sampling only every n-th value, over all positions of the two samples
/// around it and without help from another extreme. The first and the last value are always sampled.
double error_of_every(std::size_t n, const Reference& reference, const Quantity& quantity) {
  const std::vector<double>& values = reference.values;
  const auto less = [&](double a, double b) { return quantity.of(a, a, a) < quantity.of(b, b, b); };
  const auto extreme =
      quantity.reduction == Reduction::min ? std::ranges::min_element(values) : std::ranges::max_element(values, less);
  const auto index = static_cast<std::size_t>(extreme - values.begin());
  double worst = 0.0;
  for (std::size_t before = 0; before < n; ++before) {
    if (before > index || index - before + n >= values.size()) continue;
    const double a = values[index - before], b = values[index - before + n];
    const double seen = quantity.of(std::min(a, b), std::max(a, b), b);
    worst = std::max(worst, std::abs(seen / reference.value - 1.0));
  }
  return worst;
}

/// Number of outputs that a method with step control needs to resolve the extremes; nothing if that is too many.
std::optional<long> outputs_needed(PilotRuns& runs, const AdviceRules& rules, Reference reference, long resolving) {
  if (runs.quantity().reduction == Reduction::end || !rules.judges_as_printed) return resolving;
  const double maximum = output_fraction * rules.accuracy;
  for (;;) {
    long outputs = 0;
    for (long n = 2; reference.method.steps >= n * resolving / 2; n *= 2) {
      if (error_of_every(static_cast<std::size_t>(n), reference, runs.quantity()) > maximum) break;
      outputs = std::max(resolving, reference.method.steps / n);
    }
    if (outputs != 0) return outputs;
    reference.method.steps *= 2;
    const long left = rules.evaluations - runs.evaluations();
    if (reference.method.steps > maximum_outputs || left <= 0) return {};
    Pilot pilot = runs.run(reference.method, left);
    if (!pilot.failure.empty()) return {};
    reference.values = std::move(pilot.values);
  }
}

/// State of the search on one ladder.
struct Climb {
  MethodLadder ladder;
  std::vector<TriedMethod> good{};  ///< the last consecutive rungs that are accurate enough
  TriedMethod last{};
  int rung{};
  double next_cost{};  ///< estimated evaluations of the next rung
  bool confirmed{};    ///< runs next to the first of these rungs are accurate enough, too
  bool ended{};
};

class MethodSearch {
 public:
  MethodSearch(PilotRuns& runs, const AdviceRules& rules, const Reference& reference, long resolving,
               std::optional<long> outputs)
      : runs_{&runs}, rules_{&rules}, reference_{&reference}, outputs_{outputs} {
    for (MethodLadder& ladder : method_ladders(rules.among.empty() ? integrator_names() : rules.among, resolving)) {
      const auto cost = static_cast<double>(runs.cost(ladder.at(0.0, outputs.value_or(resolving))));
      climbs_.push_back({.ladder = std::move(ladder), .next_cost = cost});
      if (climbs_.back().ladder.by_tolerance && !outputs) end(climbs_.back(), "its outputs would lie too close");
    }
  }

  void climb_all() {
    while (Climb* const next = cheapest())
      climb(*next);
  }

  std::vector<TriedMethod> tried() const {
    std::vector<TriedMethod> all;
    for (const Climb& climb : climbs_)
      all.push_back(enough(climb) ? chosen(climb) : climb.last);
    std::stable_sort(all.begin(), all.end(), [](const TriedMethod& a, const TriedMethod& b) {
      if (a.verdict.empty() != b.verdict.empty()) return a.verdict.empty();
      return a.verdict.empty() && a.evaluations < b.evaluations;
    });
    return all;
  }

 private:
  bool enough(const Climb& climb) const {
    return climb.confirmed && climb.good.size() >= static_cast<std::size_t>(rules_->in_a_row);
  }

  static TriedMethod chosen(const Climb& climb) {
    TriedMethod first = climb.good.front();
    for (const TriedMethod& each : climb.good)
      first.error = std::max(first.error, each.error);
    return first;
  }

  void end(Climb& climb, std::string verdict) const {
    climb.ended = true;
    climb.last.method.integrator = climb.ladder.integrator;
    climb.last.verdict = std::move(verdict);
  }

  /// Evaluations of the method that the ladder would give if all following runs are accurate enough.
  double hoped_cost(const Climb& climb) const {
    return climb.good.empty() ? climb.next_cost : static_cast<double>(climb.good.front().evaluations);
  }

  Climb* cheapest() {
    Climb* best = nullptr;
    for (Climb& climb : climbs_) {
      if (climb.ended) continue;
      if (hoped_cost(climb) >= best_cost_) {
        end(climb, "costs more");
      } else if (climb.next_cost > static_cast<double>(rules_->evaluations - runs_->evaluations())) {
        end(climb, "not reached");
      } else if (best == nullptr || climb.next_cost < best->next_cost) {
        best = &climb;
      }
    }
    return best;
  }

  void climb(Climb& climb) {
    const double height = static_cast<double>(climb.rung++) / rungs_of_unit;
    if (height > climb.ladder.top()) return end(climb, "not reached");
    const long outputs =
        std::lround(static_cast<double>(outputs_.value_or(1)) * (1.0 + output_spread * golden_fraction(climb.rung)));
    TriedMethod& now = climb.last;
    now.method = climb.ladder.at(height, outputs);
    if (now.method.steps > rules_->evaluations) return end(climb, "not reached");
    if (std::string refusal = judge(now, climb.next_cost); now.evaluations == 0) return end(climb, std::move(refusal));
    const double growth = climb.ladder.by_tolerance ? 1.0 : std::exp2(1.0 / rungs_of_unit);
    climb.next_cost = growth * static_cast<double>(std::max(1L, now.evaluations));
    if (!good_enough(now)) {
      climb.good.clear();
      return;
    }
    climb.good.push_back(now);
    if (climb.good.size() >= static_cast<std::size_t>(rules_->in_a_row)) confirm(climb);
  }

  /// Runs a method and records its error and cost; returns the message of a failed run, else an empty string.
  std::string judge(TriedMethod& tried, double cost) {
    const long left = rules_->evaluations - runs_->evaluations();
    const Pilot pilot = runs_->run(tried.method, std::min(left, evaluation_limit(std::lround(cost))));
    if (rules_->progress) rules_->progress(runs_->evaluations());
    tried.evaluations = pilot.evaluations;
    const double value = rules_->judges_as_printed ? pilot.printed : pilot.between;
    tried.error =
        pilot.failure.empty() ? std::abs(value / reference_->value - 1.0) : std::numeric_limits<double>::infinity();
    return pilot.failure;
  }

  bool good_enough(const TriedMethod& tried) const { return tried.error <= rules_->kept * rules_->accuracy; }

  /// Tries methods between the first of the consecutive rungs and the next, whose errors should be statistically alike.
  /// If one is not accurate enough, the first rung was accurate by chance, and the next rung becomes the first.
  void confirm(Climb& climb) {
    TriedMethod& first = climb.good.front();
    for (int i = 1; i <= rules_->beside; ++i) {
      TriedMethod other = first;
      const double up = golden_fraction(i) / rungs_of_unit;
      const double stretch = climb.ladder.by_tolerance ? 1.0 + output_spread * golden_fraction(i * i) : std::exp2(up);
      other.method.steps = std::lround(static_cast<double>(first.method.steps) * stretch);
      other.method.tolerance = first.method.tolerance * std::pow(10.0, -up);
      static_cast<void>(judge(other, climb.next_cost));
      if (!good_enough(other)) {
        climb.good.erase(climb.good.begin());
        return;
      }
      first.error = std::max(first.error, other.error);
    }
    climb.confirmed = climb.ended = true;
    best_cost_ = std::min(best_cost_, static_cast<double>(first.evaluations));
  }

  PilotRuns* runs_;
  const AdviceRules* rules_;
  const Reference* reference_;
  std::optional<long> outputs_;
  std::vector<Climb> climbs_;
  double best_cost_{std::numeric_limits<double>::infinity()};
};

void check(const AdviceRules& rules) {
  if (!(rules.accuracy >= 1e-10 && rules.accuracy <= 0.5))
    throw InputError{fmt::format("accuracy: found {}; it must be in [1e-10, 0.5]", rules.accuracy)};
  if (rules.evaluations < 1) throw InputError{fmt::format("evaluations: found {}; it must be > 0", rules.evaluations)};
  for (const std::string& name : rules.among) {
    try {
      static_cast<void>(needs_tolerance(name));
    } catch (const InputError& error) {
      throw InputError{fmt::format("among: {}", error.what())};
    }
  }
}

Refusal unreached(const Advice& advice, const AdviceRules& rules) {
  const TriedMethod* nearest = nullptr;
  for (const TriedMethod& tried : advice.tried) {
    if (tried.evaluations > 0 && (nearest == nullptr || tried.error < nearest->error)) nearest = &tried;
  }
  const std::string given =
      rules.among.empty() ? "integrator" : fmt::format("given integrator ({})", fmt::join(rules.among, ", "));
  std::string message = fmt::format("no {} has errors below {:.2g} in {} consecutive runs within {} force evaluations",
                                    given, rules.kept * rules.accuracy, rules.in_a_row, rules.evaluations);
  if (nearest != nullptr) {
    message += fmt::format("; the smallest error of a single run is {:.1e}, of {}", nearest->error,
                           nearest->method.integrator);
  }
  return {Refusal::Kind::unreached, message};
}

}  // namespace

Advice advise_method(const Scene& scene, const Quantity& quantity, const AdviceRules& rules) {
  check(rules);
  Advice advice;
  PilotRuns runs{scene, quantity, rules.allows_warnings};
  const double resolving = resolving_steps(runs.dynamics(), scene);
  if (!(resolving <= static_cast<double>(rules.evaluations))) {
    advice.refusal = {Refusal::Kind::stiff,
                      fmt::format("four steps in half a period of the fastest spring are {:.3g} in the run; at most {} "
                                  "force evaluations may be spent",
                                  resolving, rules.evaluations)};
    return advice;
  }
  const long steps = std::lround(resolving);
  ReferenceSearch search{runs, rules, steps};
  advice.refusal = search.find();
  advice.growth = search.growth();
  advice.reference = search.reference();
  if (!advice.refusal) {
    MethodSearch methods{runs, rules, search.reference(), steps,
                         outputs_needed(runs, rules, search.reference(), steps)};
    methods.climb_all();
    advice.tried = methods.tried();
    if (!advice.tried.empty() && advice.tried.front().verdict.empty()) {
      advice.best = advice.tried.front();
    } else {
      advice.refusal = unreached(advice, rules);
    }
  }
  advice.reference.values.clear();
  advice.evaluations = runs.evaluations();
  return advice;
}

}  // namespace talus
