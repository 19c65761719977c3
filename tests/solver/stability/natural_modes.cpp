/// Natural modes (solver/stability/step_advice.hpp): frequencies are the same bits with and without shapes.
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <vector>

#include "solver/dynamics/dynamics.hpp"
#include "solver/io/read_scene_file.hpp"
#include "solver/stability/step_advice.hpp"

BOOST_AUTO_TEST_SUITE(natural_modes_tests)

using namespace talus;

BOOST_AUTO_TEST_CASE(frequencies_do_not_depend_on_whether_shapes_are_computed) {
  for (const char* const file : {"fence/table_2.toml", "two_cable.toml", "cable_pendulum.toml"}) {
    BOOST_TEST_CONTEXT(file) {
      const Scene scene = read_scene(std::filesystem::path{TALUS_CASES} / file);
      const Dynamics dynamics{scene.model};
      std::vector<Spring> found = springs(dynamics, scene.initial);
      for (Spring& spring : found)
        spring.damping = 0.0;
      const std::vector<NaturalMode> without = natural_modes(dynamics, found);
      // So small that no damping ratio is noticeable, but shapes are computed.
      for (Spring& spring : found)
        spring.damping = 1e-300;
      const std::vector<NaturalMode> with = natural_modes(dynamics, found);
      BOOST_TEST_REQUIRE(without.size() == with.size());
      BOOST_TEST(!without.empty());
      for (std::size_t i = 0; i < with.size(); ++i) {
        BOOST_TEST(without[i].frequency == with[i].frequency);
        BOOST_TEST(without[i].damping_ratio == 0.0);
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
