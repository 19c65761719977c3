#include "solver/calibrate/rayleigh_time.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

BOOST_AUTO_TEST_SUITE(rayleigh_time_tests)

using namespace talus;

namespace {
const auto near = boost::test_tools::tolerance(1e-14);
}

BOOST_AUTO_TEST_CASE(material_of_steel) {
  // E = 210 GPa, nu = 0.3: E' = E/(2 (1 - nu^2)), G = E/(2 (1 + nu)).
  const Material steel = material_of(210e9 / 1.82, 0.3);
  BOOST_TEST(steel.shear_modulus == 210e9 / 2.6, near);
  BOOST_TEST(steel.effective_shear_modulus() == 210e9 / 2.6 / 3.4, near);
}

BOOST_AUTO_TEST_CASE(both_moduli_give_the_material) {
  for (const double ratio : {0.0, 0.17, 0.25, 0.5}) {
    const Material given = material_of(3.0, ratio);
    const auto found = material_of_moduli(3.0, given.effective_shear_modulus());
    BOOST_REQUIRE(found.has_value());
    BOOST_TEST(std::abs(found->poisson_ratio - ratio) < 1e-14);
    BOOST_TEST(found->shear_modulus == given.shear_modulus, near);
  }
}

BOOST_AUTO_TEST_CASE(no_material_has_other_moduli) {
  BOOST_TEST(!material_of_moduli(1.0, 0.2501).has_value());
  BOOST_TEST(!material_of_moduli(1.0, 0.1666).has_value());
  BOOST_TEST(!material_of_moduli(1.0, 0.7).has_value());
}

BOOST_AUTO_TEST_CASE(time_of_a_sphere) {
  const Material material{4.0, 0.25};
  BOOST_TEST(rayleigh_time(material, 9.0, 2.0) == std::numbers::pi * 2.0 * 1.5 / (0.8766 + 0.1631 * 0.25), near);
  BOOST_TEST(rayleigh_time(material, 9.0, 6.0) == 3.0 * rayleigh_time(material, 9.0, 2.0), near);
}

BOOST_AUTO_TEST_SUITE_END()
