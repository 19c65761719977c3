#pragma once

#include "verification/problems/speed_accuracy/fidelity_levels.hpp"

/// Comparison of all levels of fidelity: their results and costs.
namespace talus::verification::problems {

/// Tolerances of the steps: `tight` for results that are compared, `usual` for runs whose cost is reported.
inline constexpr double tight = 1e-10, usual = 1e-7;

/// The fence of ladder_fence() with one or two layers, as a half or a full model.
[[nodiscard]] Scene fence_of(double height, int layers, scenes::FenceSymmetry symmetry);

/// Runs all levels at three heights; in the full tier it also measures their times, which no check uses.
void check_rungs(Findings& findings, const Setup& setup);

}  // namespace talus::verification::problems
