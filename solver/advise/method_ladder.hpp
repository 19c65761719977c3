#pragma once

#include <vector>

#include "solver/advise/pilot.hpp"

namespace talus {

/// One integrator from coarse to fine: by its number of steps, or by its tolerance.
struct MethodLadder {
  std::string integrator;
  bool by_tolerance{};
  long coarsest{};  ///< steps at height 0

  /// The method at a height >= 0: 2^height times the coarsest steps, or a tolerance of 10^-(1 + height), which is
  /// looked at `outputs` times.
  [[nodiscard]] RunMethod at(double height, long outputs) const;
  /// Height above which there is nothing to be had: for tolerances of less than 1e-13.
  [[nodiscard]] double top() const;
};

/// The ladders of these integrators: fixed steps where a method can take them, tolerances where it can keep them.
/// `resolving`: steps that resolve the scene, see resolving_steps(); the coarsest is an eighth of them.
[[nodiscard]] std::vector<MethodLadder> method_ladders(const std::vector<std::string>& integrators, long resolving);

/// Steps that see all that a scene can do: four in half a period of its fastest spring by itself, none so long that a
/// body passes another unseen, and 64 at least.
[[nodiscard]] double resolving_steps(const Dynamics& dynamics, const Scene& scene);

}  // namespace talus
