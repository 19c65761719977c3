/// A step allocates no heap memory once its buffers exist.
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <string>

#include "solver/dynamics/rigid_body_system.hpp"
#include "solver/integrate/integrator_list.hpp"
#include "solver/io/fence1993/read_deck.hpp"
#include "solver/io/read_scene_file.hpp"
#include "solver/run/energy_ledger.hpp"
#include "solver/scenes/fence_scene.hpp"
#include "tests/solver/run/counted_memory.hpp"

BOOST_AUTO_TEST_SUITE(allocations_tests)

using namespace talus;

namespace {

/// Number of allocations in `count` steps, after as many steps.
long taken_in_steps(const Scene& scene, Integrator integrator, double step, int count) {
  const Dynamics dynamics{scene.model};
  RigidBodySystem system{dynamics, false};
  State state = scene.initial;
  system.begin(state);
  return std::visit(
      [&](auto& method) {
        method.start(system, state, step);
        for (int n = 0; n < count; ++n)
          method.step(system, state, step);
        const long before = taken;
        for (int n = 0; n < count; ++n)
          method.step(system, state, step);
        return taken - before;
      },
      integrator);
}

Scene fence(const char* file, Sleep sleep) {
  scenes::Fence fence = read_deck(std::string{TALUS_CASES "/fence/"} + file);
  fence.options.sleep = sleep;
  return scenes::fence_scene(fence).scene;
}

}  // namespace

BOOST_AUTO_TEST_CASE(what_is_taken_is_counted) {
  const long before = taken;
  ::operator delete(::operator new(8));  // called by name, so that no compiler removes it
  BOOST_TEST(taken == before + 1);
}

BOOST_AUTO_TEST_CASE(steps_of_a_fence_take_no_memory) {
  for (const char* file : {"table_2.DAT", "sample2.DAT"}) {
    const Scene scene = fence(file, Sleep::off);
    for (const std::string& name : integrator_names()) {
      // The library's extrapolation itself makes three allocations per step.
      if (needs_closed_form(name) || name == Odeint<OdeintMethod::bulirsch_stoer>::name) continue;
      // The rock hits from the first step on; in the counted steps cables become taut.
      const double tolerance = needs_tolerance(name) ? 1e-7 : 0.0;
      const long found = taken_in_steps(scene, make_integrator(name, tolerance), 4e-6, 2000);
      BOOST_TEST(found == 0, file << ", " << name << ": " << found);
    }
  }
}

BOOST_AUTO_TEST_CASE(exact_segments_take_no_memory) {
  const Scene scene = read_scene_file(std::filesystem::path{TALUS_CASES "/damped_disc.toml"}).scene;
  BOOST_TEST(taken_in_steps(scene, make_integrator("exact"), 1e-2, 200) == 0);
}

BOOST_AUTO_TEST_CASE(columns_that_wake_take_little) {
  // The lists of active elements are rebuilt only when a column wakes.
  const Scene scene = fence("table_2.DAT", Sleep::on);
  const long found = taken_in_steps(scene, scene.integrator, 2e-6, 5000);
  BOOST_TEST(found < 5000, found);
}

BOOST_AUTO_TEST_CASE(balances_of_states_without_a_snapshot_take_no_memory) {
  const Scene scene = fence("table_2.DAT", Sleep::off);
  const Dynamics dynamics{scene.model};
  State state = scene.initial;
  RigidBodySystem{dynamics, false}.begin(state);
  EnergyLedger ledger{dynamics, state};
  static_cast<void>(ledger.accounts(state));
  const long before = taken;
  for (int n = 0; n < 10; ++n)
    static_cast<void>(ledger.accounts(state));
  BOOST_TEST(taken == before);
}

BOOST_AUTO_TEST_SUITE_END()
