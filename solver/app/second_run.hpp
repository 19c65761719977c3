#pragma once

#include "solver/app/scene_run.hpp"

namespace talus::app {

/// How much the rocks' velocities are changed for the repeat.
inline constexpr double repeat_change = 1e-3;

/// The fence's run once more with the rocks' velocities at the start multiplied by 1 + repeat_change: whether the
/// verdict stands. Nothing is written. `stop` ends it, with a failure in the result.
[[nodiscard]] RunQuality::Repeat repeat_run(const SceneFile& file, const RunRecord& record, const StopCondition& stop);

/// The scene's run once more by located events ("auto"), after a run whose results are unusable. Nothing is written.
/// It is given up after 20 times the evaluations of that run, and a million at least.
[[nodiscard]] RunQuality::Repair repair_run(const SceneFile& file, const RunRecord& record, const StopCondition& stop);

}  // namespace talus::app
