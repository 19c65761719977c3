#pragma once

#include <algorithm>
#include <functional>

#include "solver/run/simulate.hpp"
#include "solver/scenes/fence_summary.hpp"

namespace talus::scenes {

/// sample2 of the manual (Mustoe & Huttelmaier 1993, Appendix II.5.1) as a full model of one layer, its rock high above
/// the ground.
inline Fence sample2() {
  Fence fence;
  fence.title = "sample2";
  fence.steps = 200, fence.print_every = 60, fence.history_every = 30;
  fence.penetration = 0.05, fence.gravity = 32.18;
  fence.ground = {.solid = ElementSolid::block, .a = 10.0, .b = 0.5, .density = 0.1, .position = {0.0, -5.0}};
  fence.ground.held = {true, true, true};
  FenceElement rock{.points = 4, .a = 1.201, .b = 1.201, .density = 5.13, .position = {2.451, 0.0}};
  rock.velocity = {-65.0, 0.0};
  rock.spin = 34.0;
  fence.rocks = {rock};
  fence.column = {.type = ElementType::column, .solid = ElementSolid::cylinder, .a = 1.25, .b = 4.0, .density = 0.76};
  fence.span = 55.0, fence.sag = 5.5, fence.spacing = 2.5;
  fence.young = 2e7 * 144.0, fence.area_top = 1.076 / 144.0, fence.area_bottom = 0.25 / 144.0;
  fence.y_top = 6.67, fence.y_bottom = -4.0;
  fence.columns = 13, fence.restitution = 0.4, fence.slack = 0.5;
  fence.limit_top = fence.limit_bottom = 1e8;
  fence.layers = 1, fence.layer_spacing = 2.6, fence.rock_overlap = 0.6, fence.layer_overlap = 0.5;
  fence.options.symmetry = FenceSymmetry::full;
  fence.options.start = FenceStart::plain;
  fence.options.integrator = "velocity_verlet";
  return fence;
}

/// A fence with its watch, run or fed by hand.
struct Watched {
  explicit Watched(const Fence& given)
      : fence{given},
        made{fence_scene(fence)},
        dynamics{made.scene.model},
        system{dynamics, true},
        watch{fence, made, dynamics} {
    state = made.scene.initial;
    system.settle(state);
  }

  Outcome run(double end) {
    RunPlan plan = made.scene.plan;
    plan.end = end;
    Integrator integrator = made.scene.integrator;
    const Observer observers[] = {[this](const State& seen, const StepInfo& info) {
      watch(seen, info);
      also(seen);
    }};
    return simulate(system, integrator, state, plan, observers);
  }
  /// Shows a state made by hand.
  void show(State seen, double time) {
    seen.t = time;
    watch(seen, {shown++, 0, true, false, &seen});
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
  FenceWatch watch;
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
