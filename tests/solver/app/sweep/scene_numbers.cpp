/// Names of numbers of a run: those that a scene has, and the messages for others.
#include "solver/app/sweep/scene_numbers.hpp"

#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <string>

#include "solver/base/error.hpp"
#include "solver/io/fence_file.hpp"
#include "solver/io/scene/read_scene.hpp"

BOOST_AUTO_TEST_SUITE(scene_numbers_tests)

using namespace talus;

namespace {

SceneFile pivoted_cylinder() {
  return read_scene_file(read_text(std::filesystem::path{TALUS_CASES} / "pivoted_cylinder.toml"), "pivoted_cylinder");
}

std::string message(const std::string& name) {
  const SceneFile file = pivoted_cylinder();
  try {
    static_cast<void>(app::SceneNumbers{file, {name}});
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

}  // namespace

BOOST_AUTO_TEST_CASE(numbers_have_the_dimension_of_what_they_are) {
  const SceneFile file = pivoted_cylinder();
  const app::SceneNumbers numbers{file,
                                  {"column.spin.max", "column.spin.peak[2]", "column.spin.peak_time[0]",
                                   "impact.impact[0].peak_force", "impact.force.max", "energy.kinetic.peak[0]"}};
  const auto& outputs = numbers.outputs();
  BOOST_REQUIRE(outputs.size() == 6U);
  BOOST_TEST((outputs[0].dimension == dimension::angular_velocity));
  BOOST_TEST((outputs[1].dimension == dimension::angular_velocity));
  BOOST_TEST((outputs[2].dimension == dimension::time));
  BOOST_TEST((outputs[3].dimension == dimension::force));
  BOOST_TEST((outputs[4].dimension == dimension::force));
  BOOST_TEST((outputs[5].dimension == dimension::energy));
}

BOOST_AUTO_TEST_CASE(other_names_are_refused) {
  BOOST_TEST(message("impact.impct[0].touch_time") == "contact 'impct' is not known; nearest: impact; known: impact");
  BOOST_TEST(message("impact.impact[0].touch").starts_with("number of an impact 'touch' is not known"));
  BOOST_TEST(message("column.spin.peak") ==
             "found \"column.spin.peak\"; give a local maximum with its index from 0, column.spin.peak[0], or "
             "its time, column.spin.peak_time[0]");
  BOOST_TEST(message("column.spn.peak[0]").starts_with("column 'column.spn' is not known"));
  BOOST_TEST(message("column.spin.peak[99999999999999999999]").starts_with("found "));
  for (const char* const name :
       {"impact.impact.touch_time", "impact.impact[0]", "impact.impact[-1].touch_time", "impact.impact.peak_force"})
    BOOST_TEST(message(name) == "found \"" + std::string{name} +
                                    "\"; give an impact with its index from 0, and a number of it, e.g. "
                                    "impact.impact[0].touch_time");
}

BOOST_AUTO_TEST_SUITE_END()
