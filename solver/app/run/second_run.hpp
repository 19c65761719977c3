#pragma once

#include "solver/app/run/scene_run.hpp"

namespace talus::app {

/// Relative change of the rocks' initial velocities in repeat_run().
inline constexpr double repeat_change = 1e-3;

/// Repeats a fence's run with the rocks' initial velocities multiplied by 1 + repeat_change, to test whether the
/// verdict changes. No files are written. `stop` ends the repeat, with a failure in the result.
[[nodiscard]] RunQuality::Repeat repeat_run(const SceneFile& file, const RunRecord& record, const StopCondition& stop);

/// Repeats a scene's run with located events (integrator "auto"), after a run whose results are unusable. No files are
/// written. The repeat is aborted after 20 times the evaluations of that run, or a million if that is more.
[[nodiscard]] RunQuality::Repair repair_run(const SceneFile& file, const RunRecord& record, const StopCondition& stop);

}  // namespace talus::app
