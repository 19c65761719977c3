#pragma once

#include <array>
#include <string>
#include <vector>

#include "verification/check/convergence.hpp"
#include "verification/problems/speed_accuracy/work_scenes.hpp"

/// Error against force evaluations of one method on one scene, and what an accuracy costs by it.
namespace talus::verification::problems {

/// Names of the methods that are compared, of the solver's list. A method that takes a tolerance has one, which the
/// scene's ratio multiplies from point to point; the steps of others are halved. A method in closed form has one point,
/// and no curve on a scene that has no closed form.
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
[[nodiscard]] WorkCurve work_curve(const WorkScene& scene, const std::string& method, Findings& findings);

/// Evaluations at which a curve passes `error` for good: by a straight line in logarithms between the last point above
/// it and the next; those of the first point if all are below; infinite if the last is above.
[[nodiscard]] double cost_of(const WorkCurve& curve, std::size_t quantity, double error);

/// The order in the step that a curve shows between two errors: of 1/evaluations.
[[nodiscard]] Convergence between_errors(const WorkCurve& curve, std::size_t quantity, double least, double most);

}  // namespace talus::verification::problems
