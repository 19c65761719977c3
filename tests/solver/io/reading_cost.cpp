#define BOOST_TEST_MODULE reading_cost
#include <boost/test/unit_test.hpp>
#include <string>

#include "solver/dynamics/dynamics.hpp"
#include "solver/io/output/run_record.hpp"
#include "solver/io/scene/read_scene.hpp"
#include "tests/solver/io/disc_grid.hpp"
#include "tests/solver/run/counted_memory.hpp"

// Reading a scene, and compiling it, takes memory in proportion to its bodies: what is built once for each body, or for
// each two of them, takes four times as much for twice as many. `talus_bench` has the seconds.

using namespace talus;

namespace {

/// Bytes that an action asks for.
template <class Action>
double cost(Action&& action) {
  const std::size_t before = taken_bytes;
  action();
  return static_cast<double>(taken_bytes - before);
}

}  // namespace

BOOST_AUTO_TEST_CASE(costs_grow_in_proportion_to_bodies) {
  constexpr int discs = 5000;  // more than a table of every two bodies is made for
  const std::string once = disc_grid(discs), twice = disc_grid(2 * discs);
  const auto ratio = [&](auto&& action) { return cost([&] { action(twice); }) / cost([&] { action(once); }); };
  // Vectors that double their room may do so once more for the longer scene.
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
