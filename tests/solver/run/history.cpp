/// Recorder: selected columns have the values, rows and extremes of a record of all columns.
#include "solver/run/history.hpp"

#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <optional>
#include <utility>
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

std::vector<double> numbers(const Extreme& of) { return {of.minimum, of.minimum_time, of.maximum, of.maximum_time}; }

/// The record of a separate run; `steps`: of each step the compared columns.
struct Recorded {
  std::vector<std::vector<double>> steps{}, history{}, extremes{};
  Accounts accounts{};
};

/// `columns`: those to compare. The run is stopped and its recorder resumed by another one after 250 steps.
Recorded recorded(const Scene& scene, const RecordedColumns& request, const std::vector<std::size_t>& columns) {
  const Dynamics dynamics{scene.model};
  RigidBodySystem system{dynamics, true};
  State state = scene.initial;
  system.begin(state);
  std::optional<Recorder> recorder{std::in_place, dynamics, state, true, request};
  const State start = state;
  Recorded found;
  const Observer observer = [&](const Snapshot& seen, const StepInfo& info) {
    (*recorder)(seen, info);
    std::vector<double>& values = found.steps.emplace_back();
    for (const std::size_t column : columns)
      values.push_back(recorder->row()[column]);
    if (info.step != 250) return;
    Archive saving;
    recorder->serialize(saving);
    recorder.emplace(dynamics, start, true, request);
    Archive putting_back{saving.items()};
    recorder->serialize(putting_back);
  };
  Integrator integrator = scene.integrator;
  const Outcome outcome = simulate(system, integrator, state, scene.plan, {&observer, 1});
  BOOST_TEST_REQUIRE(static_cast<bool>(outcome), outcome.message);
  found.history = recorder->history().rows, found.accounts = recorder->accounts();
  for (const std::size_t column : columns)
    found.extremes.push_back(numbers(recorder->extreme(column)));
  return found;
}

}  // namespace

BOOST_AUTO_TEST_CASE(recorded_columns_are_those_of_a_full_record) {
  const Scene scene = fence();
  const std::size_t columns = history_columns(scene.model, true).size();
  std::vector<std::vector<std::size_t>> lists{{}, {0}, {1, columns / 2, columns - 1}};
  for (std::size_t column = 0; column < columns; column += 3)
    lists.push_back({column});
  for (const std::vector<std::size_t>& list : lists) {
    BOOST_TEST_CONTEXT(list.size() << " columns, the first: " << (list.empty() ? columns : list.front())) {
      const Recorded some = recorded(scene, list, list), all = recorded(scene, {}, list);
      BOOST_TEST((some.steps == all.steps));
      BOOST_TEST((some.history == all.history));
      BOOST_TEST((some.extremes == all.extremes));
      BOOST_TEST(some.accounts.energy_balance_error == all.accounts.energy_balance_error);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
