/// Recorder: columns that are watched have the values, rows and extremes of a recorder of all columns.
#include "solver/run/history.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "solver/dynamics/rigid_body_system.hpp"
#include "solver/io/read_scene_file.hpp"
#include "solver/run/simulate.hpp"

BOOST_AUTO_TEST_SUITE(history_tests)

namespace {

using namespace talus;

/// A rock that hits columns on cables, with an energy balance.
Scene fence() {
  Scene read = read_scene(std::filesystem::path{TALUS_CASES} / "fence/table_2.toml");
  read.plan.end = read.initial.t + 500.0 * read.plan.step;
  read.plan.interval = 30.0 * read.plan.step;
  return read;
}

std::vector<double> numbers(const Extreme& of) {
  return {of.minimum, of.minimum_time, of.maximum, of.maximum_time};
}

}  // namespace

BOOST_AUTO_TEST_CASE(watched_columns_are_those_of_a_whole_record) {
  const Scene scene = fence();
  const Dynamics dynamics{scene.model};
  const std::size_t columns = history_columns(scene.model, true).size();
  std::vector<std::vector<std::size_t>> lists{{}, {0}, {1, columns / 2, columns - 1}};
  for (std::size_t column = 0; column < columns; column += 3)
    lists.push_back({column});
  RigidBodySystem system{dynamics, true};
  State state = scene.initial;
  system.begin(state);
  Recorder whole{dynamics, state};
  std::vector<Recorder> recorders;
  for (const std::vector<std::size_t>& list : lists)
    recorders.emplace_back(dynamics, state, true, list);
  long different = 0;
  const Observer observer = [&](const Snapshot& seen, const StepInfo& info) {
    whole(seen, info);
    for (std::size_t i = 0; i < lists.size(); ++i) {
      recorders[i](seen, info);
      for (const std::size_t column : lists[i])
        different += recorders[i].row()[column] == whole.row()[column] ? 0 : 1;
    }
  };
  Integrator integrator = scene.integrator;
  const Outcome outcome = simulate(system, integrator, state, scene.plan, {&observer, 1});
  BOOST_TEST_REQUIRE(static_cast<bool>(outcome), outcome.message);
  BOOST_TEST(different == 0);
  for (std::size_t i = 0; i < lists.size(); ++i) {
    BOOST_TEST((recorders[i].history().rows == whole.history().rows));
    for (const std::size_t column : lists[i])
      BOOST_TEST((numbers(recorders[i].extreme(column)) == numbers(whole.extreme(column))));
    BOOST_TEST(recorders[i].accounts().energy_balance_error == whole.accounts().energy_balance_error);
  }
  BOOST_CHECK_THROW(static_cast<void>(recorders[1].extreme(1)), std::logic_error);
  BOOST_CHECK_THROW(static_cast<void>(recorders[0].extreme(0)), std::logic_error);
}

BOOST_AUTO_TEST_SUITE_END()
