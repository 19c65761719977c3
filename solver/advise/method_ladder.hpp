#pragma once

#include <vector>

#include "solver/advise/pilot.hpp"

namespace talus {

/// Sequence of runs (rungs) of one integrator from coarse to fine, by its number of steps or by its tolerance.
struct MethodLadder {
  std::string integrator;
  bool by_tolerance{};
  long coarsest{};  ///< steps at height 0

  /// The method at a height >= 0: 2^height times the coarsest number of steps, or a tolerance of 10^-(1 + height) with
  /// `outputs` output intervals.
  [[nodiscard]] RunMethod at(double height, long outputs) const;
  /// Largest useful height: a tolerance of 1e-13, unbounded for fixed steps.
  [[nodiscard]] double top() const;
};

/// The ladders of these integrators: one with fixed steps if the method supports them, one with tolerances if it has
/// step control. `resolving`: number of steps that resolves the scene, see resolving_steps(); the coarsest rung has an
/// eighth of it, at least 8.
[[nodiscard]] std::vector<MethodLadder> method_ladders(const std::vector<std::string>& integrators, long resolving);

/// Number of steps that resolves a scene: four per half period of its fastest spring, taken alone; each short enough
/// that no body passes another undetected; at least 64.
[[nodiscard]] double resolving_steps(const Dynamics& dynamics, const Scene& scene);

}  // namespace talus
