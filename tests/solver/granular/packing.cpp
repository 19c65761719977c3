#include "solver/granular/packing.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "solver/base/error.hpp"
#include "solver/granular/stress.hpp"

BOOST_AUTO_TEST_SUITE(packing_tests)

using namespace talus;

namespace {

PackingPlan plan_of(std::size_t discs, double fraction, double spread = 0.0, bool walls = false) {
  return {.discs = discs,
          .diameter = 0.3,
          .spread = spread,
          .mass = 2.0,
          .solid_fraction = fraction,
          .walls = walls,
          .seed = 5};
}

/// Smallest ratio of the centre distance to the sum of radii over all pairs and images.
double minimum_distance(const Packing& p) {
  double minimum = 1e300;
  for (std::size_t i = 0; i < p.discs.size(); ++i) {
    for (std::size_t j = i + 1; j < p.discs.size(); ++j) {
      if (p.shapes.inverse_mass[i] == 0.0 && p.shapes.inverse_mass[j] == 0.0) continue;
      for (int right = -1; right <= 1; ++right) {
        for (int up = -1; up <= 1; ++up) {
          if (up != 0 && !p.box.repeats_y()) continue;
          const double dx = p.discs.x[j] - p.discs.x[i] + right * p.width;
          const double dy = p.discs.y[j] - p.discs.y[i] + (up == 0 ? 0.0 : up * p.box.height);
          minimum = std::min(minimum, std::hypot(dx, dy) / (p.shapes.radius[i] + p.shapes.radius[j]));
        }
      }
    }
  }
  return minimum;
}

/// Checks the properties that every packing of a plan must have.
void demand_that_it_is_as_planned(const Packing& p, const PackingPlan& plan) {
  double area = 0.0, small = 1e300, large = 0.0;
  std::size_t free = 0;
  for (std::size_t i = 0; i < p.discs.size(); ++i) {
    if (p.shapes.wall[i] != DiscShapes::free) continue;
    const double r = p.shapes.radius[i];
    ++free;
    area += std::numbers::pi * r * r;
    small = std::min(small, r), large = std::max(large, r);
    BOOST_TEST(1.0 / p.shapes.inverse_mass[i] == plan.mass * r * r / (0.25 * plan.diameter * plan.diameter),
               boost::test_tools::tolerance(1e-12));
    BOOST_TEST((p.discs.vx[i] == 0.0 && p.discs.vy[i] == 0.0));
    BOOST_TEST(std::abs(p.discs.x[i]) <= 0.5 * p.width * (1.0 + 1e-12));
    // A disc may lie slightly between two wall discs.
    BOOST_TEST(std::abs(p.discs.y[i]) <= 0.5 * p.height * (1.0 + 1e-12) - (plan.walls ? 0.6 * r : 0.0));
  }
  BOOST_TEST(free == plan.discs);
  BOOST_TEST(area / (p.width * p.height) == plan.solid_fraction, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(small >= 0.5 * plan.diameter * (1.0 - plan.spread));
  BOOST_TEST(large <= 0.5 * plan.diameter * (1.0 + plan.spread));
  if (plan.spread > 0.0) BOOST_TEST(large - small > 0.9 * plan.spread * plan.diameter);
  BOOST_TEST(p.height / p.width == plan.aspect, boost::test_tools::tolerance(plan.walls ? 0.2 : 1e-12));
  BOOST_TEST(p.box.width == p.width);
  BOOST_TEST(p.box.repeats_y() == !plan.walls);
  const double minimum = minimum_distance(p);
  BOOST_TEST(minimum >= 1.0);
  // closest() searches up to 1.1.
  BOOST_TEST(closest(p) == std::min(minimum, 1.1), boost::test_tools::tolerance(1e-12));
}

/// Mean of |psi_6| over the discs, from their six nearest neighbours: 1 in a triangular lattice, below 0.6 without
/// order.
double order(const Packing& p) {
  double sum = 0.0;
  const std::size_t discs = p.discs.size();
  for (std::size_t i = 0; i < discs; ++i) {
    std::vector<std::pair<double, double>> near;
    for (std::size_t j = 0; j < discs; ++j) {
      if (j == i) continue;
      const double dx = std::remainder(p.discs.x[j] - p.discs.x[i], p.width);
      const double dy = std::remainder(p.discs.y[j] - p.discs.y[i], p.height);
      near.emplace_back(std::hypot(dx, dy), std::atan2(dy, dx));
    }
    std::partial_sort(near.begin(), near.begin() + 6, near.end());
    double c = 0.0, s = 0.0;
    for (std::size_t k = 0; k < 6; ++k)
      c += std::cos(6.0 * near[k].second) / 6.0, s += std::sin(6.0 * near[k].second) / 6.0;
    sum += std::hypot(c, s) / static_cast<double>(discs);
  }
  return sum;
}

}  // namespace

BOOST_AUTO_TEST_CASE(scattered_discs_are_as_planned) {
  for (const bool walls : {false, true}) {
    for (const double spread : {0.0, 0.2}) {
      for (const double fraction : {0.1, 0.45}) {
        const PackingPlan plan = plan_of(400, fraction, spread, walls);
        demand_that_it_is_as_planned(scatter(plan), plan);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(grown_discs_are_as_planned_and_reach_further) {
  PackingPlan equal = plan_of(400, 0.84), unlike = plan_of(400, 0.82, 0.2), between = plan_of(300, 0.8, 0.2, true);
  unlike.aspect = 1.5;
  const Packing ordered = grow(equal), disordered = grow(unlike);
  demand_that_it_is_as_planned(ordered, equal);
  demand_that_it_is_as_planned(disordered, unlike);
  demand_that_it_is_as_planned(grow(between), between);
  BOOST_TEST_MESSAGE("order " << order(ordered) << ", " << order(disordered));
  BOOST_TEST(order(ordered) > 0.8);
  BOOST_TEST(order(disordered) < 0.75);
  const PackingPlan thin = plan_of(50, 0.15);
  BOOST_TEST((grow(thin).discs == scatter(thin).discs));
}

BOOST_AUTO_TEST_CASE(seeds_give_other_packings_and_the_same_seed_the_same_bits) {
  for (Packing (*make)(const PackingPlan&) : {&scatter, &grow}) {
    PackingPlan plan = plan_of(100, 0.4, 0.1);
    const Packing one = make(plan), again = make(plan);
    plan.seed = 6;
    const Packing other = make(plan);
    BOOST_TEST((one.discs == again.discs));
    BOOST_TEST((one.shapes.radius == again.shapes.radius));
    BOOST_TEST(!(one.discs == other.discs));
    BOOST_TEST(!(one.shapes.radius == other.shapes.radius));
  }
}

BOOST_AUTO_TEST_CASE(agitated_discs_have_a_temperature_and_no_momentum) {
  Packing p = scatter(plan_of(2000, 0.1, 0.2, true));
  agitate(p, 3.0, 9);
  BOOST_TEST(temperature(p.shapes, p.discs, {}) == 3.0, boost::test_tools::tolerance(1e-12));
  double px = 0.0, py = 0.0, second = 0.0, fourth = 0.0;
  for (std::size_t i = 0; i < p.discs.size(); ++i) {
    if (p.shapes.wall[i] != DiscShapes::free) {
      BOOST_TEST((p.discs.vx[i] == 0.0 && p.discs.vy[i] == 0.0));
      continue;
    }
    const double m = 1.0 / p.shapes.inverse_mass[i], v = p.discs.vx[i];
    px += m * v, py += m * p.discs.vy[i];
    second += m * v * v / 2000.0, fourth += m * m * v * v * v * v / 2000.0;
  }
  BOOST_TEST(std::abs(px) + std::abs(py) < 1e-9);
  // For sums of twelve uniform numbers 2.9; for a Gaussian 3; the standard deviation for 2000 discs is 0.1.
  BOOST_TEST(fourth / (second * second) == 2.9, boost::test_tools::tolerance(0.1));
}

BOOST_AUTO_TEST_CASE(packings_that_cannot_be) {
  BOOST_CHECK_THROW((void)scatter(plan_of(200, 0.6)), InputError);
  BOOST_CHECK_THROW((void)grow(plan_of(60, 0.9, 0.2)), InputError);
  const auto refused = [](auto&& change) {
    PackingPlan plan = plan_of(50, 0.1);
    change(plan);
    BOOST_CHECK_THROW((void)scatter(plan), InputError);
  };
  refused([](PackingPlan& plan) { plan.discs = 0; });
  refused([](PackingPlan& plan) { plan.diameter = 0.0; });
  refused([](PackingPlan& plan) { plan.spread = 0.95; });
  refused([](PackingPlan& plan) { plan.mass = -1.0; });
  refused([](PackingPlan& plan) { plan.solid_fraction = 0.95; });
  refused([](PackingPlan& plan) { plan.aspect = std::nan(""); });
}

BOOST_AUTO_TEST_CASE(what_would_touch_itself_or_cannot_be_warm_is_refused) {
  BOOST_CHECK_THROW(static_cast<void>(scatter(plan_of(1, 0.8))), talus::InputError);
  Packing one = scatter(plan_of(1, 0.5));
  BOOST_CHECK_THROW(agitate(one, 3.0, 1), talus::InputError);
  BOOST_CHECK_NO_THROW(agitate(one, 0.0, 1));
}

BOOST_AUTO_TEST_SUITE_END()
