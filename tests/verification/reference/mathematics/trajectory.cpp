#include "verification/reference/mathematics/trajectory.hpp"

#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

BOOST_AUTO_TEST_SUITE(trajectory_tests)

namespace ref = talus::verification::reference;
using ref::Coordinates;

namespace {

void oscillator(const Coordinates& y, Coordinates& dydt) {
  dydt[0] = y[1];
  dydt[1] = -y[0];
}

}  // namespace

BOOST_AUTO_TEST_CASE(an_oscillator_keeps_its_digits) {
  ref::Trajectory path(oscillator, {0.0L, 1.0L}, 0.0L, 0.05L);
  path.advance_to(20.0L);
  BOOST_TEST((path.time() == 20.0L));
  // A tolerance of 1e-17 per step over 400 steps is 4e-15 at worst; at this step length the truncation is far below,
  // and 400 roundings of 1.1e-19/2 add up to at most 2e-17.
  BOOST_TEST((std::abs(path.coordinates()[0] - std::sin(20.0L)) < 2e-17L));
}

BOOST_AUTO_TEST_CASE(events_are_located_to_round_off) {
  ref::Trajectory path(oscillator, {0.0L, 1.0L}, 0.0L, 0.05L);
  const std::array<ref::Guard, 2> guards{[](const Coordinates& y) { return y[0]; },
                                         [](const Coordinates& y) { return y[1] + 0.5L; }};
  // 42 and 63 steps with some roundings of 1.1e-19 each.
  const auto first = path.advance_until(guards, 10.0L);
  BOOST_TEST((first == std::size_t{1}));  // cos t = -1/2 comes before sin t = 0
  BOOST_TEST((std::abs(path.time() - 2.0L * std::numbers::pi_v<long double> / 3.0L) < 1e-17L));
  const std::array<ref::Guard, 1> depth{guards[0]};
  BOOST_TEST((path.advance_until(depth, 10.0L) == std::size_t{0}));
  BOOST_TEST((std::abs(path.time() - std::numbers::pi_v<long double>) < 1e-17L));
  BOOST_TEST(!path.advance_until(depth, 6.0L).has_value());  // negative until 2 pi: not located
  BOOST_TEST((path.time() == 6.0L));
}

BOOST_AUTO_TEST_SUITE_END()
