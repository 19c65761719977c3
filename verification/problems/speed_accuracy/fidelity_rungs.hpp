#pragma once

#include "verification/problems/speed_accuracy/fidelity_levels.hpp"

/// The whole ladder of fidelity: every level's answers and costs side by side.
namespace talus::verification::problems {

/// Tolerances of the steps: of answers that are compared, and of those whose cost is told.
inline constexpr double tight = 1e-10, usual = 1e-7;

/// The fence of the ladder with one or two layers, half or whole.
[[nodiscard]] Scene fence_of(double height, int layers, scenes::FenceSymmetry symmetry);

/// Runs all levels at three heights; in the full tier it also times them, which nothing is gated on.
void check_rungs(Findings& findings, const Setup& setup);

}  // namespace talus::verification::problems
