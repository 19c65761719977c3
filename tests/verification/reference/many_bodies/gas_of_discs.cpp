#include "verification/reference/many_bodies/gas_of_discs.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>

BOOST_AUTO_TEST_SUITE(gas_of_discs_tests)

using namespace talus::verification::reference;

namespace {

constexpr double pi = std::numbers::pi;
const GasOfDiscs heavy{.solid_fraction = 0.3, .restitution = 0.8, .diameter = 0.4, .mass = 3.0};

/// Sum over the collisions of a disc, per time: n d chi int dk int q f(q) w(q) dq, with f the distribution of the
/// closing speed of two discs of temperature T, whose variance is 2 T/m.
template <class Weight>
double over_collisions(const GasOfDiscs& gas, double temperature, Weight&& weight) {
  const double s = std::sqrt(2.0 * temperature / gas.mass), step = 1e-3 * s;
  double sum = 0.0;
  for (double q = 0.5 * step; q < 12.0 * s; q += step)
    sum += step * q * weight(q) * std::exp(-0.5 * q * q / (s * s)) / (s * std::sqrt(2.0 * pi));
  return 2.0 * pi * number_density(gas) * gas.diameter * contact_density(gas.solid_fraction) * sum;
}

}  // namespace

BOOST_AUTO_TEST_CASE(discs_collide_lose_and_press_as_sums_over_speeds_say) {
  const double t = 0.7, e = heavy.restitution, n = number_density(heavy);
  BOOST_TEST(n * pi * 0.04 == 0.3, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(contact_density(0.3) == (1.0 - 0.13125) / 0.49, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(collision_rate(heavy, t) == over_collisions(heavy, t, [](double) { return 1.0; }),
             boost::test_tools::tolerance(1e-6));
  // Half of the energy loss of a pair, m (1 - e^2) q^2/4, belongs to each disc.
  const double lost =
      over_collisions(heavy, t, [&](double q) { return 0.5 * 0.25 * heavy.mass * (1.0 - e * e) * q * q; });
  BOOST_TEST(2.0 * t * cooling_rate(heavy, t) == lost, boost::test_tools::tolerance(1e-6));
  // An impulse m (1 + e) q/2 acts over the distance d, half of which belongs to each disc; averaged over two
  // directions.
  const double virial = n * over_collisions(heavy, t, [&](double q) {
                          return 0.5 * 0.5 * heavy.diameter * 0.5 * heavy.mass * (1.0 + e) * q;
                        });
  BOOST_TEST(pressure(heavy, t) == n * t + virial, boost::test_tools::tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(temperature_falls_by_its_rate) {
  const double step = 1e-4;
  for (const double t : {0.1, 3.0}) {
    const double now = haff_temperature(heavy, 2.0, t);
    const double slope =
        (haff_temperature(heavy, 2.0, t + step) - haff_temperature(heavy, 2.0, t - step)) / (2.0 * step);
    BOOST_TEST(slope == -2.0 * now * cooling_rate(heavy, now), boost::test_tools::tolerance(1e-6));
  }
  BOOST_TEST(haff_temperature(heavy, 2.0, 0.0) == 2.0);
}

BOOST_AUTO_TEST_CASE(hard_discs_stand_for_soft_ones) {
  const double t = 0.7, k = 3e3, step = 1e-5;
  double less = 0.0;
  for (double x = 0.5 * step; x < 0.2; x += step)
    less += step * std::exp(-0.5 * k * x * x / t);
  const GasOfDiscs hard = hardened(heavy, t, k);
  BOOST_TEST(heavy.diameter - hard.diameter == less, boost::test_tools::tolerance(1e-6));
  BOOST_TEST(number_density(hard) == number_density(heavy), boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(shear_heats_as_much_as_collisions_lose) {
  for (const double e : {0.99, 0.9, 0.6}) {
    for (const double phi : {0.01, 0.3, 0.5}) {
      const GasOfDiscs gas{phi, e, 0.4, 3.0};
      const SteadyShear steady = gaussian_shear(gas, 1.7);
      BOOST_TEST(steady.loss == 1.7 * steady.shear, boost::test_tools::tolerance(1e-9));
      BOOST_TEST(steady.difference > 0.0);
      const SteadyShear simple = newtonian_shear(gas, 1.7);
      const double lost = 2.0 * number_density(gas) * simple.temperature * cooling_rate(gas, simple.temperature);
      BOOST_TEST(simple.loss == lost, boost::test_tools::tolerance(1e-12));
      // The result scales with the units of length, mass and time.
      const SteadyShear unit = gaussian_shear({phi, e, 1.0, 1.0}, 1.0);
      BOOST_TEST(steady.temperature == unit.temperature * 3.0 * 0.16 * 1.7 * 1.7, boost::test_tools::tolerance(1e-12));
      BOOST_TEST(steady.friction() == unit.friction(), boost::test_tools::tolerance(1e-12));
    }
  }
}

BOOST_AUTO_TEST_CASE(elastic_discs_have_the_viscosity_of_enskog) {
  // Both closures converge as 1 - e goes to 0; their difference is proportional to it.
  for (const double phi : {0.01, 0.1, 0.3, 0.5}) {
    double apart[2];
    for (int i = 0; i < 2; ++i) {
      const GasOfDiscs gas{phi, i == 0 ? 0.99 : 0.999};
      const SteadyShear full = gaussian_shear(gas, 1.0), simple = newtonian_shear(gas, 1.0);
      apart[i] = full.temperature / simple.temperature - 1.0;
      BOOST_TEST(full.friction() / simple.friction() == 1.0, boost::test_tools::tolerance(0.03 * (i == 0 ? 1.0 : 0.1)));
      BOOST_TEST(full.pressure == pressure(gas, full.temperature),
                 boost::test_tools::tolerance(0.03 * (i == 0 ? 1.0 : 0.1)));
    }
    BOOST_TEST(apart[0] / apart[1] == 10.0, boost::test_tools::tolerance(0.1));
  }
}

BOOST_AUTO_TEST_CASE(dilute_discs_in_shear_solve_the_moments_of_boltzmanns_equation) {
  // To first order in the anisotropy, and for discs of negligible size, collisions change K_xy at the rate -nu K_xy and
  // K_yy at -nu (K_yy - T) - z T, with z = 2/tau and nu = (1 + e) (7 - 3 e)/8 collisions of a disc: K_yy = T (1 - z/nu)
  // is steady, so is -K_xy = rate K_yy/nu, and the heating rate K_xy balances z T.
  const GasOfDiscs gas{1e-3, 0.98};
  const SteadyShear steady = gaussian_shear(gas, 1.0);
  const double e = gas.restitution, w = collision_rate(gas, steady.temperature);
  const double z = 0.5 * (1.0 - e * e) * w, nu = (1.0 + e) * (7.0 - 3.0 * e) / 8.0 * w;
  const double yy = 1.0 - z / nu;
  BOOST_TEST(steady.friction() == yy / nu, boost::test_tools::tolerance(0.02));
  BOOST_TEST(z == steady.friction(), boost::test_tools::tolerance(0.02));
}

BOOST_AUTO_TEST_CASE(gases_that_cannot_be) {
  BOOST_CHECK_THROW((void)number_density({0.8, 0.9, 1.0, 1.0}), std::invalid_argument);
  BOOST_CHECK_THROW((void)pressure({0.1, 0.0, 1.0, 1.0}, 1.0), std::invalid_argument);
  BOOST_CHECK_THROW((void)gaussian_shear({0.1, 0.9, -1.0, 1.0}, 1.0), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
