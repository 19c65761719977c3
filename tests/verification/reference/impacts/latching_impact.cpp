#include "verification/reference/impacts/latching_impact.hpp"

#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "verification/reference/mathematics/trajectory.hpp"

BOOST_AUTO_TEST_SUITE(latching_impact_tests)

namespace ref = talus::verification::reference;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr ref::LatchingImpact constant{3.0, 7.0, 0.0, 0.4, 1.7};
constexpr ref::LatchingImpact growing{3.0, 3.0, 2.5, 0.4, 1.7};

}  // namespace

// Loading and unloading by tight integration with located events, without using closed forms or frequencies.
BOOST_AUTO_TEST_CASE(events_match_a_tight_integration) {
  for (const ref::LatchingImpact& impact : {constant, growing}) {
    const auto loading = [&](const ref::Coordinates& y, ref::Coordinates& dydt) {
      dydt[0] = y[1];
      dydt[1] = -impact.loading * y[0] / static_cast<long double>(impact.effective_mass);
    };
    ref::Trajectory closing(loading, {0.0L, impact.approach_speed}, 0.0L, 0.01L);
    const ref::Guard closes = [](const ref::Coordinates& y) { return y[1]; };
    BOOST_REQUIRE(closing.advance_until(std::array{closes}, 10.0L).has_value());
    const long double largest = closing.coordinates()[0];
    const long double back = impact.unloading + impact.growth * impact.loading * largest;
    const auto force = [=](const ref::Coordinates& y) { return impact.loading * largest - back * (largest - y[0]); };
    const auto unloading = [=](const ref::Coordinates& y, ref::Coordinates& dydt) {
      dydt[0] = y[1];
      dydt[1] = -force(y) / static_cast<long double>(impact.effective_mass);
    };
    ref::Trajectory parting(unloading, {largest, 0.0L}, closing.time(), 0.01L);
    BOOST_REQUIRE(parting.advance_until(std::array{ref::Guard{force}}, 10.0L).has_value());
    const ref::LatchingEvents found = ref::latching_events(impact);
    BOOST_TEST(std::abs(found.turn_time - static_cast<double>(closing.time())) < 4 * eps);
    BOOST_TEST(std::abs(found.largest_depth - static_cast<double>(largest)) < 4 * eps);
    BOOST_TEST(std::abs(found.contact_time - static_cast<double>(parting.time())) < 8 * eps);
    BOOST_TEST(std::abs(found.residual_depth - static_cast<double>(parting.coordinates()[0])) < 8 * eps);
    BOOST_TEST(std::abs(found.restitution * impact.approach_speed + static_cast<double>(parting.coordinates()[1])) <
               8 * eps);
  }
}

BOOST_AUTO_TEST_CASE(depth_satisfies_its_equation_and_loses_what_the_loop_holds) {
  for (const ref::LatchingImpact& impact : {constant, growing}) {
    const ref::LatchingEvents at = ref::latching_events(impact);
    BOOST_TEST(ref::latching_depth_at(impact, 0.0).depth == 0.0);
    BOOST_TEST(ref::latching_depth_at(impact, 0.0).rate == impact.approach_speed);
    for (const double t : {0.3 * at.turn_time, 0.5 * (at.turn_time + at.contact_time)}) {
      const double d = 1e-4;
      const std::array path{at.largest_depth, ref::latching_depth_at(impact, t).depth};
      const double force = ref::latching_forces(impact, t < at.turn_time ? std::span{path}.last(1) : path).back();
      const double change = ref::latching_depth_at(impact, t + d).rate - ref::latching_depth_at(impact, t - d).rate;
      BOOST_TEST(std::abs(impact.effective_mass * change / (2.0 * d) + force) < 1e-6);  // d^2/6 w^2 F = 2e-7
    }
    const double back = at.unloading_frequency * at.unloading_frequency * impact.effective_mass;
    const double force = impact.loading * at.largest_depth;
    const double loop = 0.5 * force * force * (1.0 / impact.loading - 1.0 / back);
    const double lost = 0.5 * impact.effective_mass * impact.approach_speed * impact.approach_speed *
                        (1.0 - at.restitution * at.restitution);
    BOOST_TEST(lost == loop, boost::test_tools::tolerance(8 * eps));
  }
  const double w = std::sqrt(3.0 / 0.4);
  BOOST_TEST(ref::latching_events(growing).restitution == 1.0 / std::sqrt(1.0 + 2.5 * 1.7 / w),
             boost::test_tools::tolerance(4 * eps));
}

BOOST_AUTO_TEST_CASE(forces_on_a_path) {
  const ref::LatchingImpact law{4.0, 16.0, 0.0, 1.0, 1.0};
  const std::array path{0.5, 1.0, 0.875, 0.9375, 0.75, 0.5, 0.875, 1.5, 1.25, 0.0, 0.25};
  const std::array forces{2.0, 4.0, 2.0, 3.0, 0.0, 0.0, 2.0, 6.0, 2.0, 0.0, 1.0};
  const auto found = ref::latching_forces(law, path);
  BOOST_TEST(found == forces, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(bad_parameters) {
  BOOST_CHECK_THROW((void)ref::latching_events({2.0, 1.0, 0.0, 1.0, 1.0}), std::invalid_argument);
  BOOST_CHECK_THROW((void)ref::latching_events({1.0, 1.0, -1.0, 1.0, 1.0}), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
