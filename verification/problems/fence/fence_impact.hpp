#pragma once

#include <cstddef>
#include <vector>

#include "solver/scenes/fence.hpp"

/// A fence run as the program of 1993 ran it, and what its tables and figures show of the run.
namespace talus::verification::problems {

/// The forces that a step sees. In feet, pounds and seconds.
struct FenceSample {
  double time{};     ///< at which the coordinates stand [s]
  double joint{};    ///< force in the top joint of the first layer's central column: both segments' pull [lb]
  double top{};      ///< tension of the top cable's segment beside it [lb]
  double bottom{};   ///< the same of the bottom cable; 0 if there is none [lb]
  double speed{};    ///< x velocity of the rock, or of the rocks' centre of mass [ft/s]
  double stretch{};  ///< plastic stretch of the top cable's segment [ft]
};

struct FenceRun {
  FenceSample peaks;                 ///< largest of each over all steps; `time` that of the largest joint force,
                                     ///< `speed` the last
  double bottom_any{};               ///< largest tension of any segment of the first layer's bottom cable [lb]
  double top_any{};                  ///< the same of the top cable [lb]
  double energy{};                   ///< kinetic energy of the rocks at the end over that at the start
  std::vector<FenceSample> history;  ///< one in `every` steps
  long evaluations{};                ///< of the forces
};

/// Runs a fence of the half model over `fence.steps` steps. The forces are those that the method itself evaluates, once
/// a step, at coordinates half a step on, which is what a program that keeps them as it goes can know. `every` > 0: one
/// sample of the history in so many steps. A run that is not finite at its end gives NaN for all peaks.
[[nodiscard]] FenceRun run_fence(const scenes::Fence& fence, long every = 0);

}  // namespace talus::verification::problems
