#include "tests/bench/structure.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <functional>
#include <memory>

#include "solver/dynamics/rigid_body_system.hpp"
#include "solver/integrate/integrator_list.hpp"
#include "solver/run/simulate.hpp"
#include "solver/run/snapshot.hpp"
#include "solver/scenes/fence_scene.hpp"
#include "tests/bench/fences.hpp"
#include "tests/bench/timing.hpp"

namespace talus::bench {
namespace {

constexpr long steps = 25000;  // 0.05 s
constexpr int repetitions = 9;

/// A scene that is run, or evaluated repeatedly in its initial state.
struct Compiled {
  Scene scene;
  Dynamics dynamics;
  Workspace work;
  Rates rates;

  explicit Compiled(const scenes::Fence& fence)
      : scene{scenes::fence_scene(fence).scene},
        dynamics{scene.model},
        work{dynamics.workspace()},
        rates{scene.initial} {}

  void run() const {
    RigidBodySystem system{dynamics, false};
    Integrator method = scene.integrator;
    State state = scene.initial;
    const double step = scene.plan.step, end = step * static_cast<double>(steps);
    const Outcome outcome = simulate(system, method, state, {step, end, end, false});
    if (!outcome) fmt::print("  {}\n", outcome.message);
    benchmark::DoNotOptimize(state);
  }

  void look(bool everywhere) {
    for (long n = 0; n < steps; ++n) {
      everywhere ? dynamics.update_all(scene.initial, work) : dynamics.update(scene.initial, work);
      dynamics.rates(scene.initial, work, rates, false);
    }
    benchmark::DoNotOptimize(rates);
  }
};

/// Two tasks; the second one does less.
struct Pair {
  std::string what;
  std::function<void()> more, less;
};

class Pairs {
 public:
  void add(std::string what, const scenes::Fence& more, const scenes::Fence& less) {
    const auto a = std::make_shared<Compiled>(more), b = std::make_shared<Compiled>(less);
    pairs_.push_back({std::move(what), [a] { a->run(); }, [b] { b->run(); }});
  }
  void add_looks(std::string what, const scenes::Fence& fence) {
    const auto at = std::make_shared<Compiled>(fence);
    pairs_.push_back({std::move(what), [at] { at->look(true); }, [at] { at->look(false); }});
  }

  void print() const {
    std::vector<Task> tasks;
    for (const Pair& pair : pairs_) {
      tasks.push_back({pair.what + "/more", pair.more});
      tasks.push_back({pair.what + "/less", pair.less});
    }
    const std::vector<Timing> timings = time_tasks(tasks, repetitions);
    fmt::print("\nWhat is left out: microseconds a step of 0.05 s (median of {} interleaved runs)\n", repetitions);
    fmt::print("{:64} {:>9} {:>9} {:>7}\n", "", "with", "without", "ratio");
    const double per_step = 1e6 / static_cast<double>(steps);
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      const double more = timings[2 * i].median, less = timings[2 * i + 1].median;
      fmt::print("{:64} {:>9.3f} {:>9.3f} {:>6.2f}x\n", pairs_[i].what, more * per_step, less * per_step, more / less);
    }
  }

 private:
  std::vector<Pair> pairs_;
};

}  // namespace

void print_structure_savings() {
  Pairs pairs;
  for (const int columns : {101, 1001}) {
    const auto fence = [columns](Sleep sleep) { return long_fence(columns, 1, sleep); };
    pairs.add(fmt::format("{} columns, all awake: sleep exact", columns), fence(Sleep::off), fence(Sleep::exact));
    pairs.add(fmt::format("{} columns, all awake: sleep by default", columns), fence(Sleep::off), fence(Sleep::on));
  }
  pairs.add("sleep by default, 1,001 columns: 101, as tight", long_fence(1001, 1, Sleep::on, Sag::as_tight),
            long_fence(101, 1, Sleep::on, Sag::as_tight));
  pairs.add("sleep by default, 1,001 columns: 101, with sag in proportion", long_fence(1001, 1, Sleep::on),
            long_fence(101, 1, Sleep::on));
  // One evaluation of the initial state, with the rock just off the fence.
  scenes::Fence apart = long_fence(13, 2, Sleep::off);
  apart.rocks.front().position.x += 0.1;
  pairs.add_looks("2 layers, every gap of every pair: those within reach", apart);
  const scenes::Fence usual = long_fence(13, 1, Sleep::off);
  scenes::Fence bare = usual, finer = usual;
  bare.connections = 1;
  finer.rocks.front().points = 13;
  pairs.add("13 columns, bottom cables, slack or not: none (not left out)", usual, bare);
  pairs.add("13 columns, 48 nodes on the rock: 12 (not left out)", finer, usual);
  pairs.print();
}

}  // namespace talus::bench
