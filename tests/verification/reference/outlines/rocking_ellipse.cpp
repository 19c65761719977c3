#include "verification/reference/outlines/rocking_ellipse.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

BOOST_AUTO_TEST_SUITE(rocking_ellipse_tests)

namespace ref = talus::verification::reference;

namespace {

constexpr ref::RockingEllipse ellipse{1.0, 0.6, 9.81};

/// Acceleration from the equation of motion M q'' + M' q'^2/2 + g h' = 0, slopes by central differences.
double acceleration(double q, double rate) {
  const auto h = [](double at) { return ref::centre_height(ellipse, at); };
  const double d = 1e-4;
  const auto slope = [&](double at) { return (h(at + d) - h(at - d)) / (2.0 * d); };
  const auto mass = [&](double at) { return (1.0 + 0.36) / 4.0 + h(at) * h(at) + slope(at) * slope(at); };
  return -(0.5 * (mass(q + d) - mass(q - d)) / (2.0 * d) * rate * rate + ellipse.gravity * slope(q)) / mass(q);
}

/// Quarter period by leapfrog steps from rest at the amplitude to the first passage of q = 0.
double quarter_by_steps(double amplitude, double step) {
  double q = amplitude, v = 0.0, t = 0.0;
  while (true) {
    const double middle = v + 0.5 * step * acceleration(q, v);
    const double next = q + step * middle;
    v = middle + 0.5 * step * acceleration(next, middle);
    if (next <= 0.0) return t + step * q / (q - next);
    q = next;
    t += step;
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(small_swings) {
  const double w = ref::small_rocking_frequency(ellipse);
  BOOST_TEST(w * w == 9.81 * (1.0 / 0.6 - 0.6) / (0.36 + 0.34), boost::test_tools::tolerance(1e-14));
  const double rest = 2.0 * std::numbers::pi / w;
  BOOST_TEST(std::abs(ref::rocking_period(ellipse, 1e-4) / rest - 1.0) < 1e-7);
  // Values of the catalogue of cases, to their last digit.
  BOOST_TEST(std::abs(ref::rocking_period(ellipse, 0.02) / rest - 1.0 - 4.9e-4) < 0.05e-4);
  BOOST_TEST(std::abs(ref::rocking_period(ellipse, 0.05) / rest - 1.0 - 3.0e-3) < 0.1e-3);
}

BOOST_AUTO_TEST_CASE(large_swings_by_their_equation) {
  for (const double amplitude : {0.1, 0.5, 1.0})
    BOOST_TEST(4.0 * quarter_by_steps(amplitude, 1e-4) == ref::rocking_period(ellipse, amplitude),
               boost::test_tools::tolerance(1e-5));
}

BOOST_AUTO_TEST_CASE(the_centre_goes_as_it_rolls) {
  BOOST_TEST(ref::centre_height(ellipse, 0.0) == 0.6);
  BOOST_TEST(ref::centre_height(ellipse, 0.5 * std::numbers::pi) == 1.0, boost::test_tools::tolerance(1e-15));
  // In half a turn a circle rolls half its circumference.
  BOOST_TEST(ref::centre_displacement({0.5, 0.5, 1.0}, std::numbers::pi) == -0.5 * std::numbers::pi,
             boost::test_tools::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(shift_by_the_two_springs) {
  // Two unknowns, slip u = x + b q and q: m x'' = -k_s u, I q'' = -k_s (b - d/2) u - m g (a^2/b - b) q.
  const double m = 2.0, g = 9.81, kn = 2e5, ks = 3e5, b = 0.6, inertia = m * 0.34;
  const double arm = b - 0.5 * m * g / kn, k = m * g * (1.0 / b - b);
  // Frequencies of [x, q]: det(K - w^2 M) = 0.
  const double A = m * inertia, B = -(m * (k + ks * arm * arm) + inertia * ks),
               C = ks * (k + ks * arm * arm) - ks * ks * arm * arm;
  const double low = 2.0 * C / (-B + std::sqrt(B * B - 4.0 * A * C));
  const double shift = std::sqrt(low) / ref::small_rocking_frequency(ellipse) - 1.0;
  BOOST_TEST(shift == ref::frequency_shift(ellipse, m, kn, ks), boost::test_tools::tolerance(1e-3));
}

BOOST_AUTO_TEST_SUITE_END()
