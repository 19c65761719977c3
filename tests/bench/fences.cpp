#include "tests/bench/fences.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "solver/dynamics/rigid_body_system.hpp"
#include "solver/integrate/integrator_list.hpp"
#include "solver/io/fence1993/read_deck.hpp"
#include "solver/run/simulate.hpp"
#include "solver/scenes/fence_scene.hpp"
#include "tests/bench/timing.hpp"

namespace talus::bench {
namespace {

constexpr long steps = 100000;
constexpr int repetitions = 5;

struct Named {
  std::string name;
  Scene scene;
  bool ledger{};
};

}  // namespace

scenes::Fence long_fence(int columns, int layers, Sleep sleep, Sag sag) {
  scenes::Fence deck = read_deck(TALUS_CASES "/fence/table_2.DAT");
  const double ratio = 1.0 + (columns - deck.columns) * deck.spacing / deck.span;
  deck.sag *= sag == Sag::as_tight ? ratio * ratio : ratio;
  deck.span *= ratio;
  deck.columns = columns;
  deck.layers = layers;
  deck.layer_spacing = 2.6;
  deck.layer_overlap = 0.5;
  deck.options.sleep = sleep;
  return deck;
}

void print_fence_costs() {
  std::vector<Named> fences;
  const auto fence = [](int columns, int layers, Sleep sleep = Sleep::off) {
    return scenes::fence_scene(long_fence(columns, layers, sleep)).scene;
  };
  for (const int layers : {1, 2})
    fences.push_back({fmt::format("13 columns, {} layer{}", layers, layers == 1 ? "" : "s"), fence(13, layers), false});
  fences.push_back({"13 columns, 1 layer, ledger", fence(13, 1), true});
  for (const Sleep sleep : {Sleep::off, Sleep::exact, Sleep::on}) {
    for (const int columns : {13, 101, 1001}) {
      fences.push_back({fmt::format("{} columns, sleep {}", columns, name_of(sleep)), fence(columns, 1, sleep), false});
    }
  }
  std::vector<std::unique_ptr<Dynamics>> dynamics;
  std::vector<Task> tasks;
  for (const Named& named : fences) {
    dynamics.push_back(std::make_unique<Dynamics>(named.scene.model));
    tasks.push_back({named.name, [&named, &compiled = *dynamics.back()] {
                       RigidBodySystem system{compiled, named.ledger};
                       Integrator integrator = named.scene.integrator;
                       State state = named.scene.initial;
                       RunPlan plan = named.scene.plan;
                       plan.end = plan.step * static_cast<double>(steps);
                       const Outcome outcome = simulate(system, integrator, state, plan);
                       if (!outcome) fmt::print("  {}\n", outcome.message);
                       benchmark::DoNotOptimize(state);
                     }});
  }
  const std::vector<Timing> timings = time_tasks(tasks, repetitions);
  fmt::print("\nMicroseconds a step of the 1993 fence, mean over {} steps of 2e-6 s (median of {} interleaved runs)\n",
             steps, repetitions);
  fmt::print("{:32} {:>8} {:>8} {:>24}\n", "fence", "bodies", "median", "least .. largest");
  const double per_step = 1e6 / static_cast<double>(steps);
  for (std::size_t i = 0; i < fences.size(); ++i) {
    fmt::print("{:32} {:>8} {:>8.3f} {:>11.3f} .. {:>9.3f}   ({:.2f}x)\n", fences[i].name,
               fences[i].scene.model.bodies.size() - 1, timings[i].median * per_step, timings[i].smallest * per_step,
               timings[i].largest * per_step, timings[i].median / timings[0].median);
  }
}

}  // namespace talus::bench
