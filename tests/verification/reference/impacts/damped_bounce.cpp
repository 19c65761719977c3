#include "verification/reference/impacts/damped_bounce.hpp"

#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "verification/reference/impacts/restitution.hpp"
#include "verification/reference/mathematics/trajectory.hpp"

BOOST_AUTO_TEST_SUITE(damped_bounce_tests)

namespace ref = talus::verification::reference;
using ref::Coordinates;
using ref::EndRule;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

// Ends of the first contacts by tight integration with events: an independent algorithm.
std::vector<ref::Bounce> integrated(const ref::DampedBounce& drop, int count) {
  const long double w = drop.frequency;
  const long double xi = drop.damping_ratio;
  const long double g = drop.gravity;
  const auto inside = [=](const Coordinates& y, Coordinates& dydt) {
    dydt[0] = y[1];
    dydt[1] = g - w * w * y[0] - 2.0L * xi * w * y[1];
  };
  const auto flight = [=](const Coordinates& y, Coordinates& dydt) {
    dydt[0] = y[1];
    dydt[1] = g;
  };
  const ref::Guard outside = [](const Coordinates& y) { return -y[0]; };
  const ref::Guard overlap = [](const Coordinates& y) { return y[0]; };
  const ref::Guard push = [=](const Coordinates& y) { return w * w * y[0] + 2.0L * xi * w * y[1]; };
  std::vector<ref::Bounce> list;
  Coordinates y{-static_cast<long double>(drop.gap), drop.speed};
  long double t = 0.0L;
  for (int i = 0; i < count; ++i) {
    ref::Trajectory fall(flight, y, t, 0.02L / w);
    if (!fall.advance_until(std::array{outside}, t + 3.0L)) break;
    ref::Bounce bounce;
    bounce.start_time = static_cast<double>(fall.time());
    bounce.start_speed = static_cast<double>(fall.coordinates()[1]);
    ref::Trajectory contact(inside, {0.0L, fall.coordinates()[1]}, fall.time(), 0.02L / w);
    if (!contact.advance_until(std::array{drop.end == EndRule::clamped ? push : overlap}, fall.time() + 50.0L / w))
      break;
    y = contact.coordinates();
    t = contact.time();
    bounce.end_time = static_cast<double>(t);
    bounce.end_velocity = static_cast<double>(y[1]);
    bounce.end_depth = static_cast<double>(y[0]);
    list.push_back(bounce);
  }
  return list;
}

}  // namespace

BOOST_AUTO_TEST_CASE(without_gravity_it_is_the_closed_form) {
  for (const double xi : {0.0, 0.2, 0.8, 1.0, 1.6}) {
    for (const EndRule end : {EndRule::attractive, EndRule::clamped}) {
      if (end == EndRule::attractive && xi >= 1.0) continue;
      const ref::ImpactEvents truth = ref::impact_events({4.0, 4.0 * xi, 1.0, 3.0}, end);
      const auto list = ref::bounces({2.0, xi, 0.0, 1.5, 3.0, end}, 5);
      BOOST_TEST(list.size() == 1u);
      BOOST_TEST(list[0].start_time == 0.5);
      BOOST_TEST(std::abs(list[0].end_time - 0.5 - truth.contact_time) < 4 * eps * list[0].end_time);
      BOOST_TEST(std::abs(-list[0].end_velocity / 3.0 / truth.restitution - 1.0) < 40 * eps);
      BOOST_TEST(std::abs(list[0].largest_depth / truth.largest_depth - 1.0) < 8 * eps);
      BOOST_TEST(std::abs(list[0].end_depth - truth.depth_at_end) < 8 * eps * truth.largest_depth);
      BOOST_TEST(std::isinf(list[0].apex_gap));
    }
  }
}

BOOST_AUTO_TEST_CASE(bounces_match_a_tight_integration) {
  for (const double xi : {0.0, 0.1, 0.3, 1.2}) {
    for (const EndRule end : {EndRule::attractive, EndRule::clamped}) {
      if (end == EndRule::attractive && xi >= 1.0) continue;
      const ref::DampedBounce drop{30.0, xi, 9.81, 0.7, 0.1, end};
      const auto truth = integrated(drop, 3);
      const auto list = ref::bounces(drop, 3);
      BOOST_TEST(list.size() >= truth.size());
      for (std::size_t i = 0; i < truth.size(); ++i) {
        const double bound = 1e-14;  // a few steps with errors of 1e-17, amplified by each rebound; doubles of order 1
        BOOST_TEST(std::abs(list[i].start_time - truth[i].start_time) < bound);
        BOOST_TEST(std::abs(list[i].start_speed - truth[i].start_speed) < bound);
        BOOST_TEST(std::abs(list[i].end_time - truth[i].end_time) < bound);
        BOOST_TEST(std::abs(list[i].end_velocity - truth[i].end_velocity) < bound);
        BOOST_TEST(std::abs(list[i].end_depth - truth[i].end_depth) < bound);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(elastic_bounces_repeat) {
  const auto list = ref::bounces({25.0, 0.0, 9.81, 0.5, 0.0, EndRule::attractive}, 6);
  BOOST_TEST(list.size() == 6u);
  for (const ref::Bounce& bounce : list) {
    BOOST_TEST(std::abs(bounce.apex_gap - 0.5) < 2 * eps);
    BOOST_TEST(bounce.start_speed == -bounce.end_velocity);
  }
  // m g (h + d) = k d^2/2.
  const double rest = 9.81 / 625.0;
  BOOST_TEST(std::abs(list[0].largest_depth - (rest + std::sqrt(rest * rest + 2.0 * rest * 0.5))) < 4 * eps);
}

BOOST_AUTO_TEST_CASE(damped_bounces_end_in_rest) {
  for (const EndRule end : {EndRule::attractive, EndRule::clamped}) {
    const auto list = ref::bounces({40.0, 0.15, 9.81, 0.3, 0.0, end}, 1000);
    BOOST_TEST(list.size() > 3u);
    BOOST_TEST(list.size() < 1000u);
    const ref::Bounce& last = list.back();
    BOOST_TEST(std::isinf(last.end_time));
    BOOST_TEST(last.end_depth == 9.81 / 1600.0, boost::test_tools::tolerance(2 * eps));
    for (std::size_t i = 1; i < list.size(); ++i)
      BOOST_TEST(list[i].start_speed < list[i - 1].start_speed);
    const std::array<double, 1> late{last.start_time + 10.0};
    const auto states = ref::bounce_states({40.0, 0.15, 9.81, 0.3, 0.0, end}, late);
    BOOST_TEST(states[0].touching);
    BOOST_TEST(std::abs(states[0].gap + 9.81 / 1600.0) < 1e-12);
  }
  // Critical and overdamped attractive contacts never end.
  BOOST_TEST(ref::bounces({40.0, 1.0, 9.81, 0.3, 0.0, EndRule::attractive}, 9).size() == 1u);
  BOOST_TEST(ref::bounces({40.0, 1.5, 9.81, 0.3, 0.0, EndRule::attractive}, 9).size() == 1u);
}

BOOST_AUTO_TEST_CASE(states_are_continuous_and_satisfy_the_equation) {
  const ref::DampedBounce drop{20.0, 0.2, 9.81, 0.4, 0.0, EndRule::clamped};
  const auto list = ref::bounces(drop, 3);
  std::vector<double> times;
  for (const ref::Bounce& b : list) {
    const double middle = b.start_time + 0.05;  // contacts last pi/20 or longer
    for (const double t :
         {b.start_time * (1 - 4e-16), b.start_time * (1 + 4e-16), middle - 1e-4, middle, middle + 1e-4}) {
      times.push_back(t);
    }
  }
  const auto s = ref::bounce_states(drop, times);
  for (std::size_t i = 0; i < s.size(); i += 5) {
    BOOST_TEST(!s[i].touching);
    BOOST_TEST(s[i + 1].touching);
    BOOST_TEST(std::abs(s[i].velocity - s[i + 1].velocity) < 1e-13);
    BOOST_TEST(std::abs(s[i].gap) < 1e-14);
    const double second = (s[i + 4].velocity - s[i + 2].velocity) / 2e-4;
    const double law = 9.81 + 400.0 * s[i + 3].gap - 8.0 * s[i + 3].velocity;
    BOOST_TEST(std::abs(second - law) < 2e-4);  // 1e-8/6 x'''' with x'''' ~ w^3 v = 2e4
  }
}

BOOST_AUTO_TEST_CASE(bad_parameters) {
  BOOST_CHECK_THROW((void)ref::bounces({0.0, 0.1, 9.81, 1.0, 0.0, EndRule::clamped}, 1), std::invalid_argument);
  BOOST_CHECK_THROW((void)ref::bounces({1.0, 0.1, 0.0, 1.0, 0.0, EndRule::clamped}, 1), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
