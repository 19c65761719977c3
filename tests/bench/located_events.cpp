#include "tests/bench/located_events.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "solver/dynamics/rigid_body_system.hpp"
#include "solver/integrate/integrator_list.hpp"
#include "solver/scenes/fence_scene.hpp"
#include "tests/bench/fences.hpp"
#include "tests/bench/timing.hpp"

namespace talus::bench {
namespace {

constexpr int repetitions = 25;

/// The motion of a scene without event location: its modes do not end.
class Unguarded {
 public:
  explicit Unguarded(const Dynamics& dynamics) : system_{dynamics, false} {}
  void drift(State& state, double h) { system_.drift(state, h); }
  void update_modes(State& state) { system_.update_modes(state); }
  void derivative(const State& state, Rates& out) { system_.derivative(state, out); }
  void evaluate(State& state, Rates& out) { system_.evaluate(state, out); }
  bool keeps_accounts() const { return false; }
  bool moves_memory() const { return system_.moves_memory(); }
  long evaluations() const { return system_.evaluations(); }

 private:
  RigidBodySystem system_;
};

/// Evaluates every guard at each step.
class AllGuards : public RigidBodySystem {
 public:
  explicit AllGuards(const Dynamics& dynamics) : RigidBodySystem{dynamics, false} {}
  GuardBounds guards(const State& state, bool same, double, std::vector<double>& out) {
    return RigidBodySystem::guards(state, same, std::numeric_limits<double>::infinity(), out);
  }
};

class NextGuards : public RigidBodySystem {
 public:
  explicit NextGuards(const Dynamics& dynamics) : RigidBodySystem{dynamics, false} {}
};

/// Evaluations and events of a run to its end.
struct Counts {
  long evaluations{};
  long events{};
};
template <class System>
Counts run(const Scene& scene, const Dynamics& dynamics, double tolerance, double end) {
  System system{dynamics};
  StormerCowell method;
  method.tolerance = tolerance;
  State state = scene.initial;
  method.start(system, state, end);
  method.step(system, state, end);
  benchmark::DoNotOptimize(state);
  return {system.evaluations(), method.events()};
}

/// A fence that is not hit and whose columns oscillate slightly, so that no mode ends.
Scene swinging(int columns) {
  scenes::Fence fence = long_fence(columns, 1, Sleep::off);
  fence.rocks.front().position.x += 100.0;
  Scene scene = scenes::fence_scene(fence).scene;
  for (std::size_t i = 0; i < scene.initial.v.size(); ++i)
    scene.initial.v[i] = 1e-3 * std::sin(static_cast<double>(i));
  return scene;
}

struct Row {
  std::string what;
  Scene scene;
  double tolerance{}, end{};
  bool without{};  ///< compare with no guards; otherwise with all guards
};

}  // namespace

void print_event_costs() {
  std::vector<Row> rows;
  for (const int columns : {13, 101})
    rows.push_back({fmt::format("{} columns that move", columns), swinging(columns), 1e-9, 0.05, true});
  for (const double tolerance : {3e-5, 1e-9}) {
    rows.push_back({fmt::format("Table 2 to 0.2 s, tolerance {:g}", tolerance),
                    scenes::fence_scene(long_fence(13, 1, Sleep::off)).scene, tolerance, 0.2, false});
  }
  std::vector<std::unique_ptr<Dynamics>> dynamics;
  std::vector<Task> tasks;
  std::vector<std::array<Counts, 2>> counts;
  for (const Row& row : rows) {
    dynamics.push_back(std::make_unique<Dynamics>(row.scene.model));
    const auto with = [&row, &by = *dynamics.back()] { return run<NextGuards>(row.scene, by, row.tolerance, row.end); };
    const auto other = [&row, &by = *dynamics.back()] {
      return row.without ? run<Unguarded>(row.scene, by, row.tolerance, row.end)
                         : run<AllGuards>(row.scene, by, row.tolerance, row.end);
    };
    counts.push_back({with(), other()});
    tasks.push_back({row.what + "/located", [with] { with(); }});
    tasks.push_back({row.what + "/other", [other] { other(); }});
  }
  const std::vector<Timing> timings = time_tasks(tasks, repetitions);
  fmt::print("\nLocated events by stormer_cowell (median of {} interleaved runs)\n", repetitions);
  fmt::print("{:36} {:>7} {:>12} {:>9} {:>8} {:>24} {:>8} {:>8}\n", "", "events", "evaluations", "ms", "ns/eval.",
             "beside it", "ns/eval.", "ratio");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double with = timings[2 * i].median / static_cast<double>(counts[i][0].evaluations);
    const double other = timings[2 * i + 1].median / static_cast<double>(counts[i][1].evaluations);
    fmt::print("{:36} {:>7} {:>12} {:>9.3f} {:>8.0f} {:>24} {:>8.0f} {:>7.2f}x\n", rows[i].what, counts[i][0].events,
               counts[i][0].evaluations, timings[2 * i].median * 1e3, with * 1e9,
               rows[i].without ? "events not looked for" : "all guards at each step", other * 1e9, with / other);
  }
}

}  // namespace talus::bench
