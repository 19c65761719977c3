#include "verification/reference/impacts/bed_of_springs.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

BOOST_AUTO_TEST_SUITE(bed_of_springs_tests)

namespace ref = talus::verification::reference;

namespace {

constexpr ref::BedOfSprings bed{.radius = 0.9, .stiffness = 2.0e5, .relaxation = 1e-3};

/// Force of `count` springs around the circle, computed one by one, each pushing or not.
double spring_by_spring(int count, double relaxation, double depth, double rate) {
  double sum = 0.0;
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * std::numbers::pi * (i + 0.5) / count;
    const double own = bed.radius * std::cos(angle) - (bed.radius - depth);
    if (own > 0.0) sum += std::max(0.0, own + relaxation * rate);
  }
  return bed.stiffness * sum * 2.0 * std::numbers::pi * bed.radius / count;
}

}  // namespace

BOOST_AUTO_TEST_CASE(force_is_that_of_many_springs) {
  for (const double depth : {0.01, 0.1, 0.5})
    BOOST_TEST(ref::bed_force(bed, depth) == spring_by_spring(200000, 0.0, depth, 0.0),
               boost::test_tools::tolerance(1e-7));
}

BOOST_AUTO_TEST_CASE(force_is_the_slope_of_the_energy) {
  for (const double depth : {0.01, 0.1, 0.5}) {
    const double h = 1e-4 * depth;
    const double slope = (ref::bed_energy(bed, depth + h) - ref::bed_energy(bed, depth - h)) / (2.0 * h);
    BOOST_TEST(ref::bed_force(bed, depth) == slope, boost::test_tools::tolerance(1e-7));
  }
  BOOST_TEST(ref::bed_energy(bed, 0.0) == 0.0);
}

// Small overlaps: A = (4/3) sqrt(2 R) d^(3/2) (1 - 3 d/(20 R) ...) from the series of sine and cosine.
BOOST_AUTO_TEST_CASE(shallow_contact_grows_with_the_power_three_halves) {
  const double d = 1e-6;
  const double shallow = bed.stiffness * (4.0 / 3.0) * std::sqrt(2.0 * bed.radius) * d * std::sqrt(d);
  BOOST_TEST(ref::bed_force(bed, d) == shallow, boost::test_tools::tolerance(1e-6));
}

// The power 3/2 at first contact and end reduces the integrator's order there: the measured error is 2e-10.
BOOST_AUTO_TEST_CASE(without_dashpots_energy_gives_the_force) {
  const double mass = 8.0, depth = 0.07;
  const ref::BedOfSprings springs{bed.radius, bed.stiffness, 0.0};
  const double speed = std::sqrt(2.0 * ref::bed_energy(springs, depth) / mass);
  const ref::BedImpact found = ref::bed_impact(springs, mass, speed);
  BOOST_TEST(found.largest_force == ref::bed_force(springs, depth), boost::test_tools::tolerance(1e-9));
  BOOST_TEST(found.restitution == 1.0, boost::test_tools::tolerance(1e-9));
}

// 4000 springs and dashpots computed one by one, by velocity Verlet with the rate of the half step: second order except
// where one of the 4000 springs begins or ends to act.
BOOST_AUTO_TEST_CASE(damped_impact_is_that_of_many_springs) {
  const double mass = 8.0, speed = 40.0, h = 2e-6;
  double depth = 0.0, rate = speed, largest = 0.0;
  for (bool pushes = true; pushes;) {
    const double half = rate - 0.5 * h * spring_by_spring(4000, bed.relaxation, depth, rate) / mass;
    depth += h * half;
    const double force = spring_by_spring(4000, bed.relaxation, depth, half);
    rate = half - 0.5 * h * force / mass;
    largest = std::max(largest, force);
    pushes = rate > 0.0 || force > 0.0;
  }
  const ref::BedImpact found = ref::bed_impact(bed, mass, speed);
  BOOST_TEST(found.largest_force == largest, boost::test_tools::tolerance(1e-3));
  BOOST_TEST(found.restitution == -rate / speed, boost::test_tools::tolerance(1e-3));
}

BOOST_AUTO_TEST_CASE(bad_parameters) {
  BOOST_CHECK_THROW((void)ref::bed_impact({0.0, 1.0, 0.0}, 1.0, 1.0), std::invalid_argument);
  BOOST_CHECK_THROW((void)ref::bed_impact(bed, 1.0, 0.0), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
