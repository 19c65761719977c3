#pragma once

#include <functional>
#include <string>
#include <vector>

#include "solver/integrate/integrator_list.hpp"
#include "solver/scenes/scene.hpp"
#include "verification/check/case.hpp"

/// The scenes on which the integrators are compared, each with a reference that shares no code with the solver or, of
/// the fence, is certified by other methods.
namespace talus::verification::problems {

/// Relative errors of a scene's quantities, NaN where the run failed, and what it cost.
struct WorkRun {
  std::vector<double> errors;
  double evaluations{};
};

struct WorkScene {
  std::string name;                     ///< one word or more, as in checks
  std::vector<std::string> quantities;  ///< what the errors are of
  std::vector<Scene> scenes;            ///< that runs take turns with: alike but for where in a step events fall
  double duration{};
  long spans{};              ///< equal spans of time that a run is divided into; of a method by tolerance, its outputs
  int runs{1};               ///< of which a point is the root mean square
  double budget{};           ///< evaluations that the finest point may cost, all runs together
  double tolerance_ratio{};  ///< from point to point
  double frequency{};        ///< highest, undamped: what the limit of the leapfrog methods is drawn for [rad/T]
  double floor{};            ///< error below which the reference cannot tell
  /// Run number `run` with so many steps in each span.
  std::function<WorkRun(const Integrator&, long steps, int run, Findings&)> measure;

  /// Force evaluations of a leapfrog method at its undamped limit, h omega = 2.
  [[nodiscard]] double evaluations_at_limit() const { return 0.5 * frequency * duration; }
};

/// Three smooth motions, then impacts and bounces, undamped and damped, then the fence of Table 2 to .2 s. Faults
/// `other_amplitude` (the pendulum is let go a thousandth of a radian higher), `commensurate` (all contacts fall on the
/// same places within a step). `fence`: without it, all but the fence.
[[nodiscard]] std::vector<WorkScene> work_scenes(const Setup& setup, bool fence);

}  // namespace talus::verification::problems
