#pragma once

#include "verification/study/toolkit.hpp"

/// The fence of Table 2 hit by the rock of 600 lb, slack 0.5, as in its deck in cases/fence: speed of the rock and
/// largest tension at a given time.
namespace talus::verification::problems {

/// The scene, and the index of the coordinate along which the rock moves.
struct FenceHit {
  Scene scene;
  std::size_t rock{};
};

[[nodiscard]] FenceHit fence_hit();

struct FenceExit {
  double speed{};    ///< of the rock at the end [ft/s]; NaN if the run failed
  double tension{};  ///< largest of any cable at the compared times [lb]
  double evaluations{};
  long events{};  ///< number of located events
};

/// Equal time intervals (spans) of a run, and the number of steps in each; for methods that choose their own steps,
/// these are the outputs. Values are compared at the end of each span.
struct FenceSteps {
  double end{};  ///< of the run [s]
  long spans{};
  long steps{1};
};

[[nodiscard]] FenceExit run_fence(const FenceHit& hit, Integrator integrator, const FenceSteps& plan,
                                  Findings& findings);

}  // namespace talus::verification::problems
