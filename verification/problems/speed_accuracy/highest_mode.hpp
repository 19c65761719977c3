#pragma once

#include <vector>

#include "solver/dynamics/dynamics.hpp"
#include "solver/scenes/scene.hpp"

/// The fastest vibration about a state in which nothing moves, from the solver's forces alone, and how runs of the
/// solver carry it.
namespace talus::verification::problems {

struct HighestMode {
  double frequency{};         ///< w [rad/T]; NaN if nothing pulls back
  std::vector<double> shape;  ///< of the coordinates; sum of inertia times square 1
};

/// By power iteration on the stiffness, which is taken as differences of the forces at `distance` [L] to both sides of
/// the state. The state drifts there, so that what follows the motion (the springs of friction) does.
[[nodiscard]] HighestMode highest_mode(const Dynamics& dynamics, const State& rest, double distance, int iterations);

/// ln growth per step of that mode in a run by velocity Verlet from `start` [L] along it, between 1e2 and 1e5 times the
/// start; 0 if it does not pass 1.5 times its start in `steps` steps, NaN if it comes to neither.
[[nodiscard]] double mode_growth(const Dynamics& dynamics, const State& rest, const HighestMode& mode, double start,
                                 double step, long steps);

}  // namespace talus::verification::problems
