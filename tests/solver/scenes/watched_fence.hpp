#pragma once

#include <algorithm>
#include <functional>

#include "solver/dynamics/rigid_body_system.hpp"
#include "solver/integrate/integrator_list.hpp"
#include "solver/run/simulate.hpp"
#include "solver/run/snapshot.hpp"
#include "solver/scenes/fence_summary.hpp"
#include "tests/solver/scenes/sample_fence.hpp"

namespace talus::scenes {

/// sample2 as a full model of one layer, with modern methods.
inline Fence modern_sample2() {
  Fence fence = sample2(1);
  fence.options.symmetry = FenceSymmetry::full;
  fence.options.start = FenceStart::plain;
  fence.options.integrator = "velocity_verlet";
  return fence;
}

/// A fence with its summary, run or fed with states made by hand.
struct Watched {
  explicit Watched(const Fence& given, FenceResults results = FenceResults::all)
      : fence{given},
        made{fence_scene(fence)},
        dynamics{made.scene.model},
        system{dynamics, true},
        watch{fence, made, dynamics, results} {
    state = made.scene.initial;
    system.begin(state);
  }

  Outcome run(double end) {
    RunPlan plan = made.scene.plan;
    plan.end = end;
    Integrator integrator = made.scene.integrator;
    const Observer observers[] = {[this](const Snapshot& seen, const StepInfo& info) {
      watch(seen, info);
      also(seen.state());
    }};
    return simulate(system, integrator, state, plan, observers);
  }
  /// Shows a state made by hand.
  void show(State seen, double time) {
    seen.t = time;
    watch(Snapshot{dynamics, seen}, {shown++, 0, true, false, false, &seen});
  }
  const FenceSummary& summary() const { return watch.summary(); }
  std::size_t first(const char* body) const {
    return dynamics.layout().first[index(*find_body(made.scene.model, body))];
  }
  double mass(const char* body) const {
    return made.scene.model.bodies[index(*find_body(made.scene.model, body))].mass;
  }

  Fence fence;
  FenceScene made;
  Dynamics dynamics;
  RigidBodySystem system;
  FenceMonitor watch;
  State state;
  std::function<void(const State&)> also{[](const State&) {}};
  long shown{0};
};

inline const ColumnRecord& column(const Watched& run, const char* name) {
  const BodyId body = *find_body(run.made.scene.model, name);
  return *std::find_if(run.summary().columns.begin(), run.summary().columns.end(),
                       [body](const ColumnRecord& c) { return c.body == body; });
}

}  // namespace talus::scenes
