#include "verification/reference/motion/pendulum.hpp"

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <boost/multiprecision/cpp_dec_float.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "verification/reference/mathematics/high_precision.hpp"
#include "verification/reference/mathematics/jacobi.hpp"

BOOST_AUTO_TEST_SUITE(pendulum_tests)

namespace ref = talus::verification::reference;
using ref::PendulumMotion;
using ref::Real50;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double degree = std::numbers::pi / 180.0;
constexpr double amplitudes[] = {0.1, 1.0, 10.0, 45.0, 90.0, 120.0, 150.0, 170.0, 179.0};

}  // namespace

BOOST_AUTO_TEST_CASE(agm_matches_boost_at_50_digits) {
  const Real50 tolerance("1e-47");
  for (const char* text : {"0.001", "0.3", "0.5", "0.9", "0.999"}) {
    const Real50 k(text);
    const ref::ArithmeticGeometricMean<Real50> mean({k, sqrt((1 - k) * (1 + k))});
    const auto complete = mean.complete();
    BOOST_TEST((abs(complete.first - boost::math::ellint_1(k)) < tolerance));
    BOOST_TEST((abs(complete.second - boost::math::ellint_2(k)) < tolerance));
    for (const char* time : {"0.1", "1.3", "7.9"}) {
      Real50 cn;
      Real50 dn;
      const Real50 sn = boost::math::jacobi_elliptic(k, Real50(time), &cn, &dn);
      const auto f = mean.at(Real50(time));
      BOOST_TEST((abs(f.sn - sn) < tolerance));
      BOOST_TEST((abs(f.cn - cn) < tolerance));
      BOOST_TEST((abs(f.dn - dn) < tolerance));
    }
  }
}

BOOST_AUTO_TEST_CASE(decimal_arithmetic_gives_the_same_period) {
  using Decimal =
      boost::multiprecision::number<boost::multiprecision::cpp_dec_float<50>, boost::multiprecision::et_off>;
  for (const double a : amplitudes) {
    const Decimal half = Decimal(a * degree) / 2;
    const Decimal period = 4 * boost::math::ellint_1(Decimal(sin(half)));
    const Decimal ours(PendulumMotion::from_rest(1.0, a * degree).period_45_digits());
    BOOST_TEST((abs(ours / period - 1) < Decimal("1e-43")));  // at 179 deg, k near 1: boost's form loses four digits
  }
}

BOOST_AUTO_TEST_CASE(period_of_a_right_angle_in_gamma_functions) {
  // Lemniscate: K(1/sqrt 2) = Gamma(1/4)^2/(4 sqrt(pi)).
  const double gamma = std::tgamma(0.25);
  const double period = gamma * gamma / std::sqrt(std::numbers::pi);
  BOOST_TEST(std::abs(PendulumMotion::from_rest(1.0, std::numbers::pi / 2.0).period() / period - 1.0) < 8 * eps);
}

BOOST_AUTO_TEST_CASE(small_swings_and_energy) {
  // T = 2 pi/w0 (1 + A^2/16 + 11 A^4/3072 + 173 A^6/737280 + ...).
  const double a = 0.1;
  const double series = 1.0 + a * a / 16.0 + 11.0 * std::pow(a, 4) / 3072.0 + 173.0 * std::pow(a, 6) / 737280.0;
  const double period = PendulumMotion::from_rest(2.0, a).period();
  BOOST_TEST(std::abs(period / (std::numbers::pi * series) - 1.0) < 1e-11);  // next term 1.6e-5 A^8 = 2e-13
  for (const double degrees : amplitudes) {
    const PendulumMotion motion = PendulumMotion::from_rest(1.7, degrees * degree);
    for (int i = 0; i <= 40; ++i) {
      const ref::PendulumState s = motion.at(0.37 * i);
      const double half = std::sin(s.angle / 2.0);
      const double energy = s.rate * s.rate / 2.0 + 2.0 * 1.7 * 1.7 * half * half;
      BOOST_TEST(std::abs(energy / motion.energy() - 1.0) < 8 * eps);
    }
  }
}

BOOST_AUTO_TEST_CASE(initial_values_symmetry_and_equation) {
  for (const double degrees : amplitudes) {
    const double a = degrees * degree;
    const PendulumMotion motion = PendulumMotion::from_rest(1.0, a);
    BOOST_TEST(std::abs(motion.at(0.0).angle / a - 1.0) <= eps);
    BOOST_TEST(motion.at(0.0).rate == 0.0);
    BOOST_TEST(std::abs(motion.at(motion.period() / 4.0).angle) < 4 * eps * motion.period());
    // x'' = -sin x by a fourth-order central difference of x'; its truncation is h^4/30 x^(6) < 1e-11.
    const double h = 1e-3;
    for (int i = 1; i < 20; ++i) {
      const double t = motion.period() * i / 20.0;
      const double rate = (8.0 * (motion.at(t + h).rate - motion.at(t - h).rate) -
                           (motion.at(t + 2 * h).rate - motion.at(t - 2 * h).rate)) /
                          (12.0 * h);
      BOOST_TEST(std::abs(rate + std::sin(motion.at(t).angle)) < 1e-10);
    }
  }
}

BOOST_AUTO_TEST_CASE(long_double_agrees_with_50_digits) {
  for (const double degrees : amplitudes) {
    const PendulumMotion motion = PendulumMotion::from_rest(1.0, degrees * degree);
    for (const double t : {0.3, 1.1, 4.7, 100.3, 62831.9}) {
      const ref::PendulumState fast = motion.at(t);
      const ref::PendulumState slow = motion.at_50_digits(t);
      // The round-off of long double grows with the phase: 62832 2^-64 times the slope of the motion, at most 2, and 2
      // eps.
      const double bound = 2 * eps + 1e-18 * t * 10.0;
      BOOST_TEST(std::abs(fast.angle - slow.angle) < bound);
      BOOST_TEST(std::abs(fast.rate - slow.rate) < bound);
    }
  }
}

BOOST_AUTO_TEST_CASE(from_the_bottom) {
  const double w0 = 1.3;
  // Libration: the same motion as from rest, a quarter period later.
  const PendulumMotion swing = PendulumMotion::from_bottom(w0, 1.9);
  const PendulumMotion rest = PendulumMotion::from_rest(w0, swing.amplitude());
  BOOST_TEST(std::abs(swing.period() / rest.period() - 1.0) < 8 * eps);
  for (const double t : {0.0, 0.2, 1.9, 3.3}) {
    const double late = t + 0.75 * rest.period();
    BOOST_TEST(std::abs(swing.at(t).angle - rest.at(late).angle) < 20 * eps);
    BOOST_TEST(std::abs(swing.at(t).rate - rest.at(late).rate) < 20 * eps);
  }
  // Rotation: energy, one turn per period, the equation.
  const PendulumMotion turn = PendulumMotion::from_bottom(w0, 3.1);
  BOOST_TEST(std::abs(turn.at(turn.period()).angle - 2.0 * std::numbers::pi) < 20 * eps);
  for (const double t : {0.4, 1.7, 5.5}) {
    const ref::PendulumState s = turn.at(t);
    const double half = std::sin(s.angle / 2.0);
    BOOST_TEST(std::abs((s.rate * s.rate / 2.0 + 2.0 * w0 * w0 * half * half) / turn.energy() - 1.0) < 10 * eps);
    const double h = 1e-4;
    BOOST_TEST(std::abs((turn.at(t + h).angle - turn.at(t - h).angle) / (2.0 * h) - s.rate) < 1e-7);
  }
  // Separatrix, and motions close to it on both sides.
  const PendulumMotion edge = PendulumMotion::from_bottom(w0, 2.0 * w0);
  BOOST_TEST(std::isinf(edge.period()));
  for (const double factor : {1.0 - 1e-12, 1.0 + 1e-12}) {
    const PendulumMotion near = PendulumMotion::from_bottom(w0, 2.0 * w0 * factor);
    BOOST_TEST(std::abs(near.at(1.5).angle - edge.at(1.5).angle) < 1e-10);
    BOOST_TEST(std::abs(near.at(1.5).rate - edge.at(1.5).rate) < 1e-10);
  }
}

BOOST_AUTO_TEST_CASE(bad_parameters) {
  BOOST_CHECK_THROW((void)PendulumMotion::from_rest(1.0, 3.2), std::invalid_argument);
  BOOST_CHECK_THROW((void)PendulumMotion::from_rest(0.0, 1.0), std::invalid_argument);
  BOOST_CHECK_THROW((void)PendulumMotion::from_bottom(1.0, 0.0), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
