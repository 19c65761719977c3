#include "verification/reference/impacts/rayleigh_wave.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>

BOOST_AUTO_TEST_SUITE(rayleigh_wave_tests)

using namespace talus::verification::reference;

// nu = 1/4 has the root q = 2 - 2/sqrt(3) (Rayleigh 1885); nu = 0 gives q = 3 - sqrt(5).
BOOST_AUTO_TEST_CASE(known_roots) {
  BOOST_TEST(surface_wave_speed(0.25) == std::sqrt(2.0 - 2.0 / std::numbers::sqrt3),
             boost::test_tools::tolerance(1e-14));
  BOOST_TEST(surface_wave_speed(0.0) == std::sqrt(3.0 - std::sqrt(5.0)), boost::test_tools::tolerance(1e-14));
}

// Without its squares, Rayleigh's equation reads (2 - q)^2 = 4 sqrt(1 - q) sqrt(1 - b q).
BOOST_AUTO_TEST_CASE(equation_before_squaring) {
  for (const double nu : {0.05, 0.2, 0.3, 0.45, 0.5}) {
    const double q = std::pow(surface_wave_speed(nu), 2), b = (1.0 - 2.0 * nu) / (2.0 - 2.0 * nu);
    BOOST_TEST(std::pow(2.0 - q, 2) == 4.0 * std::sqrt(1.0 - q) * std::sqrt(1.0 - b * q),
               boost::test_tools::tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_CASE(material_of_steel) {
  const ElasticMaterial steel{210e9, 0.3};
  BOOST_TEST(steel.shear_modulus() == 80.76923076923077e9, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(steel.contact_modulus() == 115.38461538461539e9, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(steel.contact_shear_modulus() == 23.755656108597285e9, boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(wrong_ratio_is_refused) {
  BOOST_CHECK_THROW(static_cast<void>(surface_wave_speed(0.51)), std::invalid_argument);
  BOOST_CHECK_THROW(static_cast<void>(surface_wave_speed(-0.01)), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
