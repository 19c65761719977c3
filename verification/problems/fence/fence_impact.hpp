#pragma once

#include <cstddef>
#include <vector>

#include "solver/scenes/fence.hpp"

/// Run of a fence with the scheme of the 1993 program, and the results that the report's tables and figures show.
namespace talus::verification::problems {

/// Forces evaluated in one step, in feet, pounds and seconds.
struct FenceSample {
  double time{};     ///< of the coordinates [s]
  double joint{};    ///< force in the top joint of the first layer's central column: sum of both segments' pulls [lb]
  double top{};      ///< tension of the top cable's segment beside it [lb]
  double bottom{};   ///< the same of the bottom cable; 0 if there is none [lb]
  double speed{};    ///< x velocity of the rock, or of the rocks' centre of mass [ft/s]
  double stretch{};  ///< plastic stretch of the top cable's segment [ft]
};

struct FenceRun {
  FenceSample peaks;                 ///< maxima over all steps; `time` is that of the largest joint force,
                                     ///< `speed` the last value
  double bottom_any{};               ///< largest tension of any segment of the first layer's bottom cable [lb]
  double top_any{};                  ///< the same of the top cable [lb]
  double energy{};                   ///< kinetic energy of the rocks at the end over that at the start
  std::vector<FenceSample> history;  ///< one sample in `every` steps
  long evaluations{};                ///< number of force evaluations
};

/// Runs a fence of the half model over `fence.steps` steps. The forces are those that the integrator evaluates, once
/// per step, at coordinates half a step later: the only forces available to a program that records during the run.
/// `every` > 0: one sample of the history in `every` steps. A run that is not finite at its end gives NaN for all
/// peaks.
[[nodiscard]] FenceRun run_fence(const scenes::Fence& fence, long every = 0);

}  // namespace talus::verification::problems
