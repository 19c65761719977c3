/// Data that observers see of a run (solver/run/snapshot.hpp): evaluated once, and equal to a separate evaluation by
/// Dynamics.
#include "solver/run/snapshot.hpp"
#include "solver/dynamics/rigid_body_system.hpp"
#include "solver/integrate/integrator_list.hpp"
#include "solver/io/read_scene_file.hpp"
#include "solver/run/extremes.hpp"
#include "solver/run/run_state.hpp"
#include "solver/run/simulate.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <vector>

BOOST_AUTO_TEST_SUITE(snapshot_tests)

namespace {

using namespace talus;

/// Scenes with breaking hangers, sleeping bodies, sliding, and velocities that belong to another time than the
/// coordinates.
const std::vector<const char*> files{"fence/table_2.toml", "fence/appendix_two_layers.DAT",
                                     "fence/sample2.DAT",  "sliding_block.toml",
                                     "two_cable.toml",     "cable_pendulum.toml"};

Scene scene(const char* name) {
  Scene read = read_scene(std::filesystem::path{TALUS_CASES} / name);
  read.plan.end = read.initial.t + 600.0 * read.plan.step;
  return read;
}

/// Compares all data of a snapshot with the evaluation of its state by Dynamics, with every gap of every pair.
void is_that_of_the_state(const Snapshot& seen) {
  const Dynamics& dynamics = seen.dynamics();
  const State& state = seen.state();
  Workspace work = dynamics.workspace();
  LawForces forces;
  Rates rates{state};
  dynamics.update_all(state, work);
  dynamics.forces(state, work, forces);
  const Energies energies = dynamics.energies(state, work);
  const Momenta momenta = dynamics.momenta(work);
  dynamics.rates(state, work, rates, false);
  for (std::size_t c = 0; c < dynamics.model().contacts.size(); ++c) {
    const auto contact = static_cast<ContactId>(c);
    BOOST_TEST(seen.depths()[c] == dynamics.contact_depth(work, contact));
    BOOST_TEST(seen.forces().contacts[c] == forces.contacts[c]);
  }
  for (std::size_t c = 0; c < dynamics.model().cables.size(); ++c) {
    BOOST_TEST(seen.geometry().paths.length[c] == work.paths.length[c]);
    BOOST_TEST(seen.forces().tensions[c] == forces.tensions[c]);
    BOOST_TEST(!std::signbit(seen.forces().tensions[c]));
  }
  for (std::size_t j = 0; j < dynamics.cables().joints().size(); ++j) {
    BOOST_TEST(seen.pulls().joints.force(j).x == work.joints.force(j).x);
    BOOST_TEST(seen.pulls().joints.force(j).y == work.joints.force(j).y);
  }
  for (std::size_t b = 0; b < dynamics.model().bodies.size(); ++b) {
    BOOST_TEST(seen.geometry().poses.vx[b] == work.poses.vx[b]);
    BOOST_TEST(seen.geometry().poses.sine[b] == work.poses.sine[b]);
    BOOST_TEST(seen.loads().wrenches[b].force.x == work.wrenches[b].force.x);
    BOOST_TEST(seen.loads().wrenches[b].moment == work.wrenches[b].moment);
  }
  BOOST_TEST(seen.energies().total() == energies.total());
  BOOST_TEST(seen.momenta().angular == momenta.angular);
  BOOST_TEST(seen.momenta().linear.x == momenta.linear.x);
}

}  // namespace

BOOST_AUTO_TEST_CASE(it_is_that_of_its_state_at_every_step) {
  for (const char* const name : files) {
    BOOST_TEST_CONTEXT(name) {
      const Scene run = scene(name);
      const Dynamics dynamics{run.model};
      RigidBodySystem system{dynamics, run.plan.ledger};
      Integrator method = run.integrator;
      State state = run.initial;
      long shown = 0;
      // In a different order at each step: no stage invalidates another.
      const Observer observer = [&](const Snapshot& seen, const StepInfo& info) {
        if (info.step % 7 == 1) static_cast<void>(seen.loads()), static_cast<void>(seen.pulls());
        if (info.step % 7 == 2) static_cast<void>(seen.pulls()), static_cast<void>(seen.loads());
        if (info.step % 7 == 3) static_cast<void>(seen.energies());
        if (info.step % 7 == 4) return;  // no data are requested
        is_that_of_the_state(seen);
        ++shown;
      };
      BOOST_TEST(static_cast<bool>(simulate(system, method, state, run.plan, {&observer, 1})));
      BOOST_TEST(shown > 500);
    }
  }
}

/// Observers do not change the run, whatever they request.
BOOST_AUTO_TEST_CASE(a_run_does_not_depend_on_its_observers) {
  for (const char* const name : files) {
    BOOST_TEST_CONTEXT(name) {
      const Scene run = scene(name);
      const Dynamics dynamics{run.model};
      const auto end = [&](std::span<const Observer> observers) {
        RigidBodySystem system{dynamics, run.plan.ledger};
        Integrator method = run.integrator;
        State state = run.initial;
        BOOST_TEST(static_cast<bool>(simulate(system, method, state, run.plan, observers)));
        return state;
      };
      const Observer all = [](const Snapshot& seen, const StepInfo&) {
        static_cast<void>(seen.loads()), static_cast<void>(seen.forces()), static_cast<void>(seen.energies());
      };
      const Observer one = [](const State&, const StepInfo&) {};
      const State alone = end({});
      BOOST_TEST((end({&all, 1}) == alone));
      BOOST_TEST((end({&one, 1}) == alone));
    }
  }
}

/// A snapshot that the caller keeps shows the last state that was requested, also after a run that diverged.
BOOST_AUTO_TEST_CASE(it_outlasts_the_run) {
  const Scene run = scene("two_cable.toml");
  const Dynamics dynamics{run.model};
  RigidBodySystem system{dynamics, run.plan.ledger};
  RunState run_state = initial_run_state(run.integrator, run.initial);
  Snapshot seen{dynamics};
  double last = 0.0;
  const Observer observer = [&](const Snapshot& snapshot, const StepInfo& info) {
    last = snapshot.state().t;
    if (info.step == 300) run_state.state.v[0] = std::numeric_limits<double>::infinity();
  };
  BOOST_TEST(!simulate(system, run_state, run.plan, {&observer, 1}, {}, &seen));
  BOOST_TEST(seen.state().t == last);
  BOOST_TEST(std::isfinite(seen.state().v[0]));
}

/// Extremes compared with those found one by one, for row sizes that are not multiples of a pack, with NaNs.
BOOST_AUTO_TEST_CASE(extremes_are_the_first_of_all_times) {
  for (const std::size_t count : {1U, 7U, 8U, 13U, 41U}) {
    Extremes extremes;
    std::vector<Extreme> expected(count);
    for (int step = 0; step < 50; ++step) {
      std::vector<double> row(count);
      for (std::size_t i = 0; i < count; ++i) {
        row[i] = std::round(4.0 * std::sin(0.7 * step + static_cast<double>(i)));  // equal values occur again
        if (step > 0 && (step + static_cast<int>(i)) % 11 == 0) row[i] = std::nan("");
        Extreme& e = expected[i];
        if (step == 0) e = {row[i], 0.0, row[i], 0.0};
        if (row[i] < e.minimum) e.minimum = row[i], e.minimum_time = step;
        if (row[i] > e.maximum) e.maximum = row[i], e.maximum_time = step;
      }
      extremes.add(step, row);
    }
    BOOST_REQUIRE(extremes.size() == count);
    for (std::size_t i = 0; i < count; ++i) {
      BOOST_TEST(extremes[i].minimum == expected[i].minimum);
      BOOST_TEST(extremes[i].minimum_time == expected[i].minimum_time);
      BOOST_TEST(extremes[i].maximum == expected[i].maximum);
      BOOST_TEST(extremes[i].maximum_time == expected[i].maximum_time);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
