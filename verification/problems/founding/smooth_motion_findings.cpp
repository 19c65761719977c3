#include "verification/problems/founding/smooth_motion_findings.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <string_view>

#include "solver/integrate/integrator_list.hpp"
#include "solver/scenes/pivoted_cylinder.hpp"
#include "solver/scenes/two_cable.hpp"
#include "verification/reference/pivoted_cylinder.hpp"
#include "verification/reference/two_cable.hpp"
#include "verification/study/scene_run.hpp"

namespace talus::verification::problems {
namespace {

Integrator verlet(const Setup& setup) {
  return make_integrator(setup.has("euler_cromer_for_verlet") ? "euler_cromer" : "velocity_verlet");
}

/// A smooth motion after an impact, and where it is at the end.
struct SmoothMotion {
  std::string name;
  Scene scene;
  double duration;
  double position, velocity;  ///< at the end, exact
  double scale, start;        ///< largest position, and velocity, which is largest at the start
};

SmoothMotion particle_on_cables() {
  const reference::TwoCable problem;
  const double v1 = reference::rigid_impact(problem).particle;
  const reference::TwoCableMotion motion{problem, v1};
  Scene cables = scenes::two_cable({.contact = LinearSpringDashpot{1.0, 0.0, EndRule::attractive}});
  cables.initial.q[2] = -100.0;  // the striker is out of the way
  cables.initial.v = {v1, 0.0, 0.0, 0.0};
  const double duration = 1.3 * motion.time_to_turning();
  const auto end = motion.at(duration);
  return {"particle on cables", cables, duration, end.position, end.velocity, motion.largest_distance(), v1};
}

SmoothMotion column_swing() {
  const reference::PivotedCylinder problem;
  const double w1 = reference::rigid_impact(problem).angular;
  const auto motion = reference::swing(problem, w1);
  Scene column = scenes::pivoted_cylinder({.rock_radius = problem.rock_radius,
                                           .gravity = problem.gravity,
                                           .contact = LinearSpringDashpot{1.0, 0.0, EndRule::attractive}});
  column.initial.q[1] = -100.0;  // the rock is out of the way
  column.initial.v = {w1, 0.0, 0.0, 0.0};
  const double duration = 0.325 * motion.period();
  const auto end = motion.at(duration);
  return {"column's swing", column, duration, end.angle, end.rate, motion.amplitude(), w1};
}

/// The order of one method on one motion; its curve, and the slope to compare with.
void study(const SmoothMotion& motion, const std::string& method, bool with_slope, Figure& figure, Findings& findings,
           const Setup& setup) {
  const bool fourth = method == "rk4";
  const bool first = method == "euler_cromer";
  const Integrator integrator = method == "velocity_verlet" ? verlet(setup) : make_integrator(method);
  Convergence gated;
  Series series{.label = motion.name + ", " + method};
  for (long steps = 16; steps <= (setup.coarse ? 4096 : 65536); steps *= 2) {
    const RunEnd end = run_steps(motion.scene, integrator, motion.duration / static_cast<double>(steps), steps);
    series.add(1.0 / static_cast<double>(steps), std::hypot((end.state.q[0] - motion.position) / motion.scale,
                                                            (end.state.v[0] - motion.velocity) / motion.start));
    if (steps >= (fourth ? 32 : 64) && !(fourth && steps > 512)) gated.add(series.x.back(), series.y.back());
    if (series.y.back() < 1e-15) break;
  }
  const int order = fourth ? 4 : first ? 1 : 2;
  const double admitted = fourth ? 0.03 : first ? 7.5e-4 : setup.coarse ? 1.1e-4 : 5e-5;
  const char* why =
      fourth  ? "smooth motion: the declared order. Between 16 and 32 steps it is .084 off (column: .006), half of "
                "that with each doubling, which tilts the line from 32 to 512 by .019: that and half again"
      : first ? "smooth motion: the declared order. Between 32 and 64 steps it is .0068 off (particle: .0041), half "
                "of that with each doubling, which tilts the line from 64 on by 5e-4: that and half again"
              : "smooth motion: the declared order. Between 32 and 64 steps it is .0017 off (column: .0006), a "
                "quarter of that with each doubling, which tilts the line from 64 on by 3.1e-5 (to 4096 only: "
                "7e-5): that and half again";
  findings.expect_order(fmt::format("{}: order of {}", motion.name, method), gated, order - admitted, order + admitted,
                        why);
  if (with_slope && method != "central_difference")
    figure.slopes.push_back({static_cast<double>(order), series.x[3], 2.0 * series.y[3], fmt::format("h^{}", order)});
  figure.series.push_back(series);
}

}  // namespace

void check_smooth(Findings& findings, const Setup& setup) {
  Figure figure{.name = "smooth",
                .title = "Smooth motion after the impacts",
                .caption =
                    "Error of position and velocity (over their largest, in quadrature) after 1.3 quarter periods of "
                    "the particle on its cables and of the column's swing: the declared orders, down to round-off.",
                .x = {"step over time", "1", true},
                .y = {"relative error", "1", true}};
  for (const bool on_cables : {true, false}) {
    if (setup.coarse && !on_cables) continue;
    const SmoothMotion motion = on_cables ? particle_on_cables() : column_swing();
    for (const char* method : {"velocity_verlet", "central_difference", "rk4", "euler_cromer"}) {
      if (setup.coarse && std::string_view{method} != "velocity_verlet") continue;
      study(motion, method, on_cables, figure, findings, setup);
    }
  }
  if (!setup.coarse) findings.figure(figure);
}

}  // namespace talus::verification::problems
