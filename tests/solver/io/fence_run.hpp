#pragma once

#include "solver/dynamics/rigid_body_system.hpp"
#include "solver/integrate/integrator_list.hpp"
#include "solver/io/read_scene_file.hpp"
#include "solver/run/simulate.hpp"
#include "solver/run/snapshot.hpp"

namespace talus {

/// Runs the first steps of a fence with one observer.
inline void run_fence(const FenceInput& input, const Dynamics& dynamics, long steps, const Observer& observer) {
  RigidBodySystem system{dynamics, false};
  Integrator integrator = input.made.scene.integrator;
  State state = input.made.scene.initial;
  RunPlan plan = input.made.scene.plan;
  plan.end = static_cast<double>(steps) * plan.step;
  const Observer observers[] = {observer};
  static_cast<void>(simulate(system, integrator, state, plan, observers));
}

}  // namespace talus
