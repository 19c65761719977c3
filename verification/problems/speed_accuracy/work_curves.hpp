#pragma once

#include "verification/problems/speed_accuracy/work_scenes.hpp"
#include "verification/study/toolkit.hpp"

/// Error against force evaluations of one method on one scene, and the cost of an accuracy.
namespace talus::verification::problems {

/// Names of the compared methods, from the solver's list. For a method with step control the tolerance is multiplied by
/// the scene's ratio from point to point; the steps of the others are halved. A method in closed form has one point, or
/// none on a scene without closed form.
inline constexpr std::array work_methods{"central_difference",
                                         "velocity_verlet",
                                         "euler_cromer",
                                         "euler",
                                         "taylor",
                                         "rk4",
                                         "blanes_moan4",
                                         "odeint_abm8",
                                         "odeint_dopri5",
                                         "odeint_fehlberg78",
                                         "odeint_bulirsch_stoer",
                                         "stormer_cowell",
                                         "exact"};

/// One point of a curve.
struct CurvePoint {
  double setting{};              ///< mean length of a step [T], or mean tolerance
  std::vector<double> rms, max;  ///< errors of each quantity, over the runs; infinite or NaN if a run failed
  double evaluations{};          ///< mean
  int failed{};                  ///< number of runs that failed or had an error above 1
};

struct WorkCurve {
  std::string method;
  std::vector<CurvePoint> points;  ///< coarse to fine
};

/// Computes the curve of a method. Runs of a point that do not differ in phase have steps, or tolerances, spread evenly
/// up to those of the next point. The curve ends when a point would cost more than the scene's budget, or when the
/// errors have reached the scene's floor.
[[nodiscard]] WorkCurve work_curve(const WorkScene& scene, const std::string& method, Findings& findings);

/// Evaluations from which on the errors of a curve remain below `error`: interpolated on logarithmic scales between the
/// last point above it and the next; those of the first point if all are below; infinite if the last is above.
[[nodiscard]] double cost_of(const WorkCurve& curve, std::size_t quantity, double error);

/// Points of a curve with errors between `minimum` and `maximum`, against 1/evaluations, which give its order in the
/// step.
[[nodiscard]] Convergence between_errors(const WorkCurve& curve, std::size_t quantity, double minimum, double maximum);

}  // namespace talus::verification::problems
