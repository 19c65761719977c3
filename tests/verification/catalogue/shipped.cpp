/// The shipped catalogue.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <set>

#include "verification/catalogue/catalogue.hpp"

BOOST_AUTO_TEST_SUITE(shipped_tests)

using namespace talus::verification;

namespace {

const Catalogue& catalogue() {
  static const Catalogue read = read_catalogue(TALUS_CATALOGUE);
  return read;
}

}  // namespace

BOOST_AUTO_TEST_CASE(requirements_are_unique_and_hold_all_equations) {
  std::set<std::string> ids;
  for (const auto& requirement : catalogue().requirements) {
    BOOST_TEST(ids.insert(requirement.id).second, requirement.id);
    BOOST_TEST(!requirement.text.empty());
  }
  for (int i = 1; i <= 30; ++i)
    BOOST_TEST(ids.count("Eq. " + std::to_string(i)) == 1u);
  for (const char* id : {"B6", "F7", "law.linear_spring_dashpot", "integrator.velocity_verlet", "shape.circle",
                         "end_rule.attractive", "method.nodes", "mechanism.friction", "regime.elastic_plastic.yielding",
                         "regime.tension_only.slack", "regime.friction.sticking", "pair.circle.half_plane"})
    BOOST_TEST(ids.count(id) == 1u, id);
  for (const char* id : {"regime.hertz.open", "pair.half_plane.circle", "pair.half_plane.terrain"})
    BOOST_TEST(ids.count(id) == 0u, id);
}

BOOST_AUTO_TEST_CASE(integrators_and_nothing_else_declare_an_order) {
  for (const auto& requirement : catalogue().requirements) {
    // An exact method has no error that could have an order.
    const bool has_order = requirement.group == "integrator" && requirement.id != "integrator.exact";
    BOOST_TEST((requirement.order > 0) == has_order, requirement.id);
    if (requirement.id == "integrator.rk4") BOOST_TEST(requirement.order == 4);
  }
}

BOOST_AUTO_TEST_CASE(a_case_has_the_family_of_most_of_its_problems) {
  BOOST_TEST(catalogue().family_of("", {"A3", "E1", "E2", "Eq. 1"}) == "E: outlines in contact");
  BOOST_TEST(catalogue().family_of("", {"B1", "A1"}) == "A: motion and bodies");  // of equal numbers the first
  BOOST_TEST(catalogue().family_of("the fence", {"B1"}) == "the fence");
  BOOST_TEST(catalogue().family_of("", {"Eq. 1", "end_rule.clamped", "Z1"}) == "");
}

BOOST_AUTO_TEST_CASE(what_other_codes_check_is_all_there) {
  const auto of_suite = [](const std::string& suite) {
    return std::count_if(catalogue().peers.begin(), catalogue().peers.end(),
                         [&](const PeerCheck& peer) { return peer.suite == suite; });
  };
  BOOST_TEST(of_suite("mfix") == 6);       // DEM01 to DEM06
  BOOST_TEST(of_suite("chung2011") == 8);  // tests 1 to 8
  BOOST_TEST(of_suite("lammps") == 15);
  BOOST_TEST(catalogue().errata.size() == 21u);
}

// The numbers printed by the errata, computed from the data of validation problem 2 (pivoted cylinder).
BOOST_AUTO_TEST_CASE(the_numbers_of_the_errata_are_right) {
  const double m = 14.92, l = 8.0, i_g = 85.42, M = 37.23, e = 0.5, v0 = 5.0;
  const double g = 32.174;
  const double quarter = l * l / 4.0;
  const double printed_28 = M * (1.0 + e) * quarter / (i_g + (M + m) * quarter);
  BOOST_TEST(printed_28 == 0.9714, boost::test_tools::tolerance(5e-5));
  BOOST_TEST(printed_28 * v0 == 4.857, boost::test_tools::tolerance(1e-4));
  const double w1 = 2.0 * printed_28 * v0 / l;
  const double i_p = i_g + m * quarter;
  const auto angle = [&](double factor) { return std::acos(1.0 - w1 * w1 * i_p / (factor * m * g * l)); };
  BOOST_TEST(angle(2.0) == 0.3546, boost::test_tools::tolerance(2e-4));
  BOOST_TEST(angle(1.0) == 0.5042, boost::test_tools::tolerance(2e-4));
  BOOST_TEST(i_p / quarter == 20.26, boost::test_tools::tolerance(1e-4));
  const auto inertia = [&](double mass, double r) { return mass * (3.0 * r * r + l * l) / 12.0; };
  BOOST_TEST(inertia(m, 1.2) == 84.94, boost::test_tools::tolerance(1e-4));
  BOOST_TEST(inertia(m, 1.25) == 85.40, boost::test_tools::tolerance(1e-4));
  BOOST_TEST(inertia(14.9226, 1.25) == i_g, boost::test_tools::tolerance(1e-4));
  // Eq. 21 with the particle masses on the pivoted body: xi = c/(2 sqrt(k m_eff)), e = exp(-pi xi/sqrt(1 - xi^2)).
  const double L = std::log(1.0 / e), pi = std::acos(-1.0);
  const double particles = m * M / (m + M), pivoted = (i_p / quarter) * M / (i_p / quarter + M);
  const double xi = L / std::sqrt(pi * pi + L * L) * std::sqrt(particles / pivoted);
  BOOST_TEST(std::exp(-pi * xi / std::sqrt(1.0 - xi * xi)) == 0.537, boost::test_tools::tolerance(1e-3));
}

// The numbers of the errata of the fence, computed from Table 1 (gravity of the decks).
BOOST_AUTO_TEST_CASE(the_numbers_of_the_errata_of_the_fence_are_right) {
  const double g = 32.18, d = 2.5, pi = std::acos(-1.0);
  BOOST_TEST(0.76 * g == 24.5, boost::test_tools::tolerance(2e-3));
  BOOST_TEST(0.38 * g == 12.2, boost::test_tools::tolerance(3e-3));
  BOOST_TEST(4.0 * std::pow(std::sin(13.0 * pi / 28.0), 2) == 3.95, boost::test_tools::tolerance(1e-3));
  // The segment next to the centre: half a column's weight W at the horizontal tension W/f sum (i + 1/2) d_i.
  const double weight = 0.38 * g * pi * 1.25 * 1.25 * 8.0;
  const double horizontal = weight / 5.5 * (d * (0.5 + 1.5 + 2.5 + 3.5 + 4.5 + 5.5) + 12.5 * 6.5);
  const double length = d * std::sqrt(1.0 + std::pow(0.5 * weight / horizontal, 2));
  const double start = horizontal * length / d;
  BOOST_TEST(start == 11026.0, boost::test_tools::tolerance(1e-4));
  const double k = 2e7 * 1.076 / length;
  const auto joint = [&](double tension) {
    const double l = length + (tension - start) / k;
    return 2.0 * tension * std::sqrt(l * l - d * d) / l;
  };
  BOOST_TEST(joint(2.62e5) == 8.01e4, boost::test_tools::tolerance(1e-3));
  BOOST_TEST(joint(2.83e5) == 9.02e4, boost::test_tools::tolerance(4e-3));
  BOOST_TEST(joint(2.66e5) == 8.18e4, boost::test_tools::tolerance(4e-3));
  BOOST_TEST(joint(2.87e5) == 9.21e4, boost::test_tools::tolerance(4e-3));
}

BOOST_AUTO_TEST_SUITE_END()
