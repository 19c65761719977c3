#pragma once

#include "verification/study/toolkit.hpp"

/// The scenes on which the integrators are compared. Each has a reference that shares no code with the solver or, for
/// the fence, is certified by other methods.
namespace talus::verification::problems {

/// Relative errors of a scene's quantities, NaN if the run failed, and its cost.
struct WorkRun {
  std::vector<double> errors;
  double evaluations{};
};

struct WorkScene {
  std::string name;                     ///< one or more words, as in the names of checks
  std::vector<std::string> quantities;  ///< names of the quantities whose errors are measured
  std::vector<Scene> scenes;            ///< one for each phase of the events within a step, or one in all
  double duration{};
  long spans{};              ///< number of equal time intervals of a run; for methods with step control, its outputs
  int runs{1};               ///< number of runs over which a point is the root mean square
  double budget{};           ///< evaluations allowed for the finest point, all runs together
  double tolerance_ratio{};  ///< factor from point to point
  double frequency{};        ///< highest, undamped, for which the limit of the leapfrog methods is drawn [rad/T]
  double floor{};            ///< error below which the reference cannot resolve differences
  /// Run number `run` with `steps` steps in each span.
  std::function<WorkRun(const Integrator&, long steps, int run, Findings&)> measure;

  /// Force evaluations of a leapfrog method at its undamped limit, h omega = 2.
  [[nodiscard]] double evaluations_at_limit() const { return 0.5 * frequency * duration; }
};

/// Three smooth motions, then bounces and impacts, undamped and damped, and, if `fence`, the fence of Table 2 to 0.2 s.
/// Faults `other_amplitude` (the pendulum starts 0.001 rad higher), `commensurate` (all contacts begin and end at the
/// same phases of a step).
[[nodiscard]] std::vector<WorkScene> work_scenes(const Setup& setup, bool fence);

}  // namespace talus::verification::problems
