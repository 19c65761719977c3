#pragma once

#include <vector>

#include "solver/dynamics/dynamics.hpp"

namespace talus {

/// One spring of a scene, linearised in a state: derivatives of its deformation with respect to the coordinates. Step
/// limits and modes are computed from these.
struct Spring {
  double stiffness{};            ///< tangent stiffness while it acts [F/L]
  double damping{};              ///< [F T/L]
  double deformation{};          ///< overlap or elongation in the state [L]
  double effective_mass{};       ///< 1 / sum(gradient_i^2 / inertia_i) [M]: inertia of its ends along its line
  std::vector<double> gradient;  ///< d(deformation)/dq_i, one for each coordinate
};

/// Springs of all contact instances of a scene, then of all cables, then of the friction of contact instances that have
/// it, each as it is while it acts, whether or not it acts in the state.
[[nodiscard]] std::vector<Spring> springs(const Dynamics& dynamics, const State& state);
/// Springs that act in the state, of which `work` is the geometry.
[[nodiscard]] std::vector<Spring> acting_springs(const Dynamics& dynamics, const State& state, const Workspace& work);

}  // namespace talus
