#pragma once

#include <string>
#include <vector>

#include "verification/check/convergence.hpp"
#include "verification/problems/speed_accuracy/work_scenes.hpp"

/// Error against force evaluations of one method on one scene, and what an accuracy costs by it.
namespace talus::verification::problems {

/// How a method's steps are told.
enum class StepChoice {
  by_length,     ///< halved from point to point
  by_tolerance,  ///< multiplied by the scene's ratio from point to point
  none,          ///< one point: the method has neither
};

struct WorkMethod {
  const char* name;
  StepChoice steps;
};

/// The methods that are compared: one line for each. A method that needs motion in closed form has no
/// curve on a scene that has none.
[[nodiscard]] const std::vector<WorkMethod>& work_methods();

/// One point of a curve.
struct CurvePoint {
  double setting{};              ///< mean length of a step [T], or tolerance
  std::vector<double> rms, max;  ///< of each quantity, over the runs; infinite or NaN if a run failed
  double evaluations{};          ///< mean
  int failed{};                  ///< runs that failed, or ended with an error above 1
};

struct WorkCurve {
  std::string method;
  std::vector<CurvePoint> points;  ///< coarse to fine
};

/// Runs of a point that are no phases of their own have steps, or tolerances, spread evenly up to the next point's.
/// Goes on until a point would cost more than the scene's budget, or errors have come to its floor.
[[nodiscard]] WorkCurve work_curve(const WorkScene& scene, const WorkMethod& method, Findings& findings);

/// Evaluations at which a curve passes `error` for good: by a straight line in logarithms between the last point above
/// it and the next; those of the first point if all are below; infinite if the last is above.
[[nodiscard]] double cost_of(const WorkCurve& curve, std::size_t quantity, double error);

/// The order in the step that a curve shows between two errors: of 1/evaluations.
[[nodiscard]] Convergence between_errors(const WorkCurve& curve, std::size_t quantity, double least, double most);

}  // namespace talus::verification::problems
