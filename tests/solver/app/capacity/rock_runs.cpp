#include "solver/app/capacity/rock_runs.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <filesystem>

#include "solver/app/sweep/sweep_base.hpp"

BOOST_AUTO_TEST_SUITE(rock_runs_tests)

using namespace talus;
using namespace talus::app;

// Table 2: an ellipsoid of 0.953951 ft, 5.127408 slug/ft^3 and 34 rad/s, in US units.
BOOST_AUTO_TEST_CASE(energy_at_the_start_has_that_of_the_spin) {
  const auto file = std::filesystem::path{TALUS_CASES} / "capacity" / "fence.toml";
  const RockRuns rocks{parse_toml(base_text(file), file.string()), file.string(), CapacityFile{}};
  constexpr double foot = 0.3048, slug = 14.593902937206365, radius = 0.953951 * foot;
  const double mass = 5.127408 * slug / (foot * foot * foot) * 4.0 / 3.0 * std::acos(-1.0) * std::pow(radius, 3);
  BOOST_TEST(rocks.own().mass == mass, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(rocks.own().speed == 65.0 * foot, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(rocks.own().spin == 34.0, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(rocks.own().along == 0.0);
  // Eight times the mass has twice the radius.
  const Rock rock{.mass = 8.0 * mass, .speed = 3.0, .height = 1.0, .spin = 5.0};
  const double inertia = 0.4 * 8.0 * mass * std::pow(2.0 * radius, 2);
  BOOST_TEST(rocks.start_energy(rock) == 0.5 * 8.0 * mass * 9.0 + 0.5 * inertia * 25.0,
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(rock.kinetic_energy() == 36.0 * mass, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_SUITE_END()
