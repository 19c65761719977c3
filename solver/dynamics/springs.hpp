#pragma once

#include <vector>

#include "solver/dynamics/dynamics.hpp"

namespace talus {

/// One spring of a scene as it stands: how it stretches with each coordinate. Step limits and modes are made of these.
struct Spring {
  double stiffness{};       ///< tangent stiffness while it acts [F/L]
  double damping{};         ///< [F T/L]
  double deformation{};     ///< overlap or elongation now [L]
  double effective_mass{};  ///< 1 / sum(gradient_i^2 / inertia_i) [M]: the inertia that its ends feel along its line
  std::vector<double> gradient;  ///< d(deformation)/dq_i, one for each coordinate
};

/// All contact instances of a scene, then all cables, then the friction of contact instances that have it, each as the
/// spring that it is while it acts, whether or not it does now.
[[nodiscard]] std::vector<Spring> springs(const Dynamics& dynamics, const State& state);
/// Those of them that act in the state, of which `work` is the geometry.
[[nodiscard]] std::vector<Spring> acting_springs(const Dynamics& dynamics, const State& state, const Workspace& work);

}  // namespace talus
