#include "solver/calibrate/impact_range.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <variant>

#include "solver/base/error.hpp"
#include "solver/calibrate/impact.hpp"

namespace talus {
namespace {

/// Largest difference of the restitutions of two pairs of which one is judged by the other.
constexpr double nearly = 0.02;

/// An impact that was simulated, and accurate.
struct JudgedImpact {
  double restitution{};
  double steps{};  ///< in its contact
};

}  // namespace

double exact_dissipation(const ImpactingPair& pair, double e) {
  return std::visit(
      [&]<class L>(L law) -> double {
        if constexpr (SetsEveryRestitution<L>) {
          law.set_restitution(e, pair.effective_mass, pair.speed);
          return law.*restitution_parameter<L>().member;
        } else {
          throw InputError{fmt::format("the law '{}' has no damping", L::name)};
        }
      },
      pair.law);
}

double restitution_with(const ImpactingPair& pair, double dissipation) {
  return std::visit(
      [&]<class L>(const L& law) -> double {
        if constexpr (KnowsImpacts<L>) return law.restitution(pair.effective_mass, pair.speed);
        throw InputError{fmt::format("the law '{}' has no impact in closed form", L::name)};
      },
      with_dissipation(pair.law, dissipation));
}

double largest_deviation(std::span<const ImpactingPair> pairs, double dissipation, double e) {
  double largest = 0.0;
  for (const ImpactingPair& pair : pairs)
    largest = std::max(largest, std::abs(restitution_with(pair, dissipation) - e));
  return largest;
}

double minimax_dissipation(std::span<const ImpactingPair> pairs, std::span<const double> exact, double e) {
  const auto [smallest, largest] = std::ranges::minmax_element(exact);
  const ImpactingPair& lowest = pairs[static_cast<std::size_t>(smallest - exact.begin())];
  const ImpactingPair& highest = pairs[static_cast<std::size_t>(largest - exact.begin())];
  const auto excess = [&](double dissipation) {
    return (restitution_with(highest, dissipation) - e) - (e - restitution_with(lowest, dissipation));
  };
  // Exact parameters that are equal up to round-off leave no bracket.
  const double at_smallest = excess(*smallest), at_largest = excess(*largest);
  if (!(at_smallest > 0.0)) return *smallest;
  if (!(at_largest < 0.0)) return *largest;
  std::uintmax_t maximum = 200;
  const auto [below, above] = boost::math::tools::toms748_solve(excess, *smallest, *largest, at_smallest, at_largest,
                                                                boost::math::tools::eps_tolerance<double>(50), maximum);
  return 0.5 * (below + above);
}

std::optional<RangeStep> advise_range_step(std::span<const ImpactingPair> pairs, double dissipation, double bound,
                                           const Integrator& integrator) {
  std::vector<KnownImpact> known;
  for (const ImpactingPair& pair : pairs)
    known.push_back(known_impact(with_dissipation(pair.law, dissipation), pair.effective_mass, pair.speed));
  std::vector<std::size_t> order(pairs.size());
  std::iota(order.begin(), order.end(), 0UL);
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return known[i].contact_time; });
  CommonStep common{bound};
  std::optional<RangeStep> found;
  std::vector<JudgedImpact> judged;
  for (const std::size_t i : order) {
    const double time = known[i].contact_time, e = known[i].restitution;
    if (!std::isfinite(time)) continue;
    const auto is_more_demanding = [&](const JudgedImpact& other) {
      const double more = (time / common.step()) / other.steps;
      return (other.restitution <= e && more >= 2.0) || (std::abs(other.restitution - e) <= nearly && more >= 1.0);
    };
    if (std::ranges::any_of(judged, is_more_demanding)) continue;
    const ImpactError error = restitution_error(with_dissipation(pairs[i].law, dissipation), pairs[i].effective_mass,
                                                pairs[i].speed, integrator);
    const std::size_t pair = common.require(error, time) ? i : found->pair;
    found = RangeStep{common.step(), common.found().largest_error, pair};
    judged.push_back({e, time / common.step()});
  }
  return found;
}

double EqualSpheres::effective_mass() const {
  return 2.0 / 3.0 * std::numbers::pi * density * radius * radius * radius;
}

double EqualSpheres::effective_radius() const { return 0.5 * radius; }

std::vector<double> log_spaced(double first, double last, int count) {
  std::vector<double> numbers;
  for (int i = 0; i < count; ++i)
    numbers.push_back(first * std::pow(last / first, static_cast<double>(i) / (count - 1)));
  numbers.back() = last;
  return numbers;
}

}  // namespace talus
