#include "verification/reference/cables/cable_draw.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stdexcept>

BOOST_AUTO_TEST_SUITE(cable_draw_tests)

namespace ref = talus::verification::reference;

namespace {

const ref::YieldingCable straight{8.0, {{0.0, 2.0}}, 2.0};
const ref::YieldingCable bent{8.0, {{0.0, 2.0}, {0.25, 2.5}, {1.25, 2.5}, {1.5, 4.0}}, 1.0};

/// The yield force Y(p) in plain doubles.
double plain_yield_force(const ref::YieldingCable& cable, double p) {
  for (std::size_t i = 1; i < cable.points.size(); ++i) {
    const auto &from = cable.points[i - 1], &to = cable.points[i];
    if (p < to.stretch) return from.force + (to.force - from.force) * (p - from.stretch) / (to.stretch - from.stretch);
  }
  return cable.points.back().force + cable.last_slope * (p - cable.points.back().stretch);
}

/// The same draw by small steps of the mass (leapfrog); the cable elongates plastically when k (e - p) exceeds Y(p).
ref::CableDraw stepped(const ref::YieldingCable& cable, double mass, double speed, double stretch) {
  double e = stretch, p = stretch, v = speed, peak = 0.0, lost = 0.0;
  const double h = 1e-5;
  for (;;) {
    e += 0.5 * h * v;
    for (double excess = 1.0; excess > 1e-12;) {
      excess = cable.stiffness * (e - p) - plain_yield_force(cable, p);
      const double by = std::max(0.0, excess) / (cable.stiffness + 6.0);
      lost += by * plain_yield_force(cable, p + 0.5 * by);
      p += by;
    }
    const double tension = cable.stiffness * (e - p);
    if (tension < 0.0) return {peak, p, lost, -v};
    peak = std::max(peak, tension);
    v -= h * tension / mass;
    e += 0.5 * h * v;
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(yield_force_runs_through_its_points) {
  for (double p = 0.0; p < 3.0; p += 0.0937)
    BOOST_TEST(ref::yield_force(bent, p) == plain_yield_force(bent, p), boost::test_tools::tolerance(1e-14));
  BOOST_TEST(ref::yield_force(bent, 0.0) == 2.0);
  BOOST_TEST(ref::yield_force(bent, 0.125) == 2.25);
  BOOST_TEST(ref::yield_force(bent, 0.7) == 2.5);
  BOOST_TEST(ref::yield_force(bent, 1.5) == 4.0);
  BOOST_TEST(ref::yield_force(bent, 2.5) == 5.0);
  BOOST_TEST(ref::yield_elongation(bent, 0.25) == 0.5625);
}

BOOST_AUTO_TEST_CASE(agrees_with_small_steps) {
  for (const auto* cable : {&straight, &bent}) {
    for (const double speed : {0.3, 1.0, 2.0, 3.5}) {
      for (const double stretch : {0.0, 0.1, 1.3}) {
        const ref::CableDraw a = ref::draw(*cable, 1.5, speed, stretch), b = stepped(*cable, 1.5, speed, stretch);
        BOOST_TEST(std::abs(a.peak_tension - b.peak_tension) < 1e-5);
        BOOST_TEST(std::abs(a.stretch - b.stretch) < 1e-5);
        BOOST_TEST(std::abs(a.lost - b.lost) < 2e-5);
        BOOST_TEST(std::abs(a.exit_speed - b.exit_speed) < 1e-5);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(energy_is_shared_out) {
  for (const double speed : {0.3, 2.0, 10.0}) {
    const ref::CableDraw found = ref::draw(bent, 1.5, speed, 0.0);
    const double left = 0.75 * found.exit_speed * found.exit_speed;
    BOOST_TEST(found.lost + left == 0.75 * speed * speed, boost::test_tools::tolerance(1e-14));
    BOOST_TEST(found.peak_tension <= ref::yield_force(bent, found.stretch));
  }
}

BOOST_AUTO_TEST_CASE(perfectly_plastic_is_the_flat_case) {
  const ref::YieldingCable flat{8.0, {{0.0, 2.0}}, 0.0};
  for (const double speed : {0.2, 0.57, 0.58, 1.0, 4.0}) {
    const ref::CableDraw a = ref::draw(flat, 1.5, speed), b = ref::perfectly_plastic_draw(8.0, 2.0, 1.5, speed);
    BOOST_TEST(a.peak_tension == b.peak_tension, boost::test_tools::tolerance(1e-14));
    BOOST_TEST(std::abs(a.stretch - b.stretch) < 1e-14);
    BOOST_TEST(std::abs(a.lost - b.lost) < 1e-14);
    BOOST_TEST(a.exit_speed == b.exit_speed, boost::test_tools::tolerance(1e-14));
  }
}

BOOST_AUTO_TEST_CASE(bungee_obeys_energy_and_time) {
  const ref::Bungee b{40.0, 2.0, 10.0, 0.7};
  const double x = ref::bungee_depth(b);
  BOOST_TEST(b.mass * b.gravity * (b.height + x) == 0.5 * b.stiffness * x * x, boost::test_tools::tolerance(1e-14));
  // Integrated by small steps from rest to the turning point: half the period.
  double y = -b.height, v = 0.0, t = 0.0;
  const double h = 1e-6;
  do {
    y += 0.5 * h * v;
    v += h * (b.gravity - b.stiffness / b.mass * std::max(0.0, y));
    y += 0.5 * h * v;
    t += h;
  } while (v > 0.0);
  BOOST_TEST(y == x, boost::test_tools::tolerance(1e-6));
  BOOST_TEST(2.0 * t == ref::bungee_period(b), boost::test_tools::tolerance(1e-5));
}

BOOST_AUTO_TEST_CASE(breaking) {
  BOOST_TEST(ref::broken_energy(8.0, 4.0) == 1.0);
  BOOST_TEST(ref::speed_kept(8.0, 4.0, 2.0, 3.0) == std::sqrt(8.0));
}

BOOST_AUTO_TEST_CASE(drawn_out_until_it_breaks) {
  for (const auto* cable : {&straight, &bent}) {
    for (const double stretch : {0.0, 0.1, 0.25, 1.3, 4.0}) {
      const double h = 1e-4;
      double work = 0.0;
      for (double p = 0.5 * h; p < stretch; p += h)
        work += h * plain_yield_force(*cable, p);
      BOOST_TEST(std::abs(ref::plastic_work(*cable, stretch) - work) < 1e-6);
      if (stretch == 0.0) continue;
      // A mass that turns at this elongation keeps no speed; the excess of the squared speed remains.
      const double turns = std::sqrt(
          (2.0 * ref::plastic_work(*cable, stretch) + std::pow(ref::yield_force(*cable, stretch), 2) / 8.0) / 1.5);
      BOOST_TEST(ref::draw(*cable, 1.5, turns).stretch == stretch, boost::test_tools::tolerance(1e-13));
      BOOST_TEST(ref::speed_kept(*cable, 1.5, std::hypot(turns, 0.7), stretch) == 0.7,
                 boost::test_tools::tolerance(1e-12));
      BOOST_CHECK_THROW((void)ref::speed_kept(*cable, 1.5, 0.999 * turns, stretch), std::invalid_argument);
    }
  }
}

BOOST_AUTO_TEST_CASE(wrong_cables_are_refused) {
  BOOST_CHECK_THROW((void)ref::draw({8.0, {{0.0, 2.0}, {0.5, 1.0}}, 0.0}, 1.0, 1.0), std::invalid_argument);
  BOOST_CHECK_THROW((void)ref::draw({8.0, {{0.1, 2.0}}, 0.0}, 1.0, 1.0), std::invalid_argument);
  BOOST_CHECK_THROW((void)ref::draw(straight, 0.0, 1.0), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
