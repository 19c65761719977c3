#include <boost/test/unit_test.hpp>
#include <string>

#include "solver/dynamics/dynamics.hpp"
#include "solver/io/output/run_record.hpp"
#include "solver/io/scene/read_scene.hpp"
#include "tests/solver/io/disc_grid.hpp"
#include "tests/solver/run/counted_memory.hpp"

BOOST_AUTO_TEST_SUITE(reading_cost_tests)

// Reading and compiling a scene requires memory in proportion to its bodies; data built for each pair of bodies, or
// searched once per body, would take four times as much for twice the bodies. Times are measured by `talus_bench`.

using namespace talus;

namespace {

/// Bytes that an action allocates.
template <class Action>
double cost(Action&& action) {
  const std::size_t before = taken_bytes;
  action();
  return static_cast<double>(taken_bytes - before);
}

}  // namespace

BOOST_AUTO_TEST_CASE(costs_grow_in_proportion_to_bodies) {
  constexpr int discs = 5000;  // too many for a table of all pairs of bodies
  const std::string once = disc_grid(discs), twice = disc_grid(2 * discs);
  const auto ratio = [&](auto&& action) { return cost([&] { action(twice); }) / cost([&] { action(once); }); };
  // Vectors that double their capacity may do so once more for the longer scene.
  BOOST_TEST(ratio([](const std::string& text) { static_cast<void>(read_scene(text, "s.toml")); }) < 2.3);
  const Scene half = read_scene(once, "s.toml"), all = read_scene(twice, "s.toml");
  const auto compiled = [](const Scene& scene) {
    return cost([&] {
      const Dynamics dynamics{scene.model};
      Workspace work = dynamics.workspace();
      dynamics.update(scene.initial, work);
      static_cast<void>(body_states(scene.model, scene.initial));
    });
  };
  BOOST_TEST(compiled(all) / compiled(half) < 2.3);
}

BOOST_AUTO_TEST_SUITE_END()
