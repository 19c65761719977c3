#include "verification/problems/smooth_motion_findings.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <string_view>

#include "solver/integrate/integrator_list.hpp"
#include "solver/scenes/pivoted_cylinder.hpp"
#include "solver/scenes/two_cable.hpp"
#include "verification/problems/scene_run.hpp"
#include "verification/reference/pivoted_cylinder.hpp"
#include "verification/reference/two_cable.hpp"

namespace talus::verification::problems {
namespace {

Integrator verlet(const Setup& setup) {
  return make_integrator(setup.has("euler_cromer_for_verlet") ? "euler_cromer" : "velocity_verlet");
}

}  // namespace

void check_smooth(Findings& findings, const Setup& setup) {
  const reference::TwoCable cable_problem;
  const double v1 = reference::rigid_impact(cable_problem).particle;
  const reference::TwoCableMotion cable_motion{cable_problem, v1};
  Scene cables = scenes::two_cable({.contact = LinearSpringDashpot{1.0, 0.0, EndRule::attractive}});
  cables.initial.q[2] = -100.0;  // the striker is out of the way
  cables.initial.v = {v1, 0.0, 0.0, 0.0};
  const reference::PivotedCylinder column_problem;
  const double w1 = reference::rigid_impact(column_problem).angular;
  const auto column_motion = reference::swing(column_problem, w1);
  Scene column = scenes::pivoted_cylinder({.rock_radius = column_problem.rock_radius,
                                           .gravity = column_problem.gravity,
                                           .contact = LinearSpringDashpot{1.0, 0.0, EndRule::attractive}});
  column.initial.q[1] = -100.0;
  column.initial.v = {w1, 0.0, 0.0, 0.0};
  Figure figure{.name = "smooth",
                .title = "Smooth motion after the impacts",
                .caption =
                    "Error of position and velocity (over their largest, in quadrature) after 1.3 quarter periods of "
                    "the particle on its cables "
                    "and of the column's swing: the declared orders, down to round-off.",
                .x = {"step over time", "1", true},
                .y = {"relative error", "1", true},
                .series = {}};
  for (const bool on_cables : {true, false}) {
    if (setup.coarse && !on_cables) continue;
    const double duration = on_cables ? 1.3 * cable_motion.time_to_turning() : 0.325 * column_motion.period();
    const double position = on_cables ? cable_motion.at(duration).position : column_motion.at(duration).angle;
    const double velocity = on_cables ? cable_motion.at(duration).velocity : column_motion.at(duration).rate;
    const double scale = on_cables ? cable_motion.largest_distance() : column_motion.amplitude();
    const double start = on_cables ? v1 : w1;
    const std::string scene = on_cables ? "particle on cables" : "column's swing";
    for (const char* method : {"velocity_verlet", "central_difference", "rk4", "euler_cromer"}) {
      const bool fourth = std::string_view{method} == "rk4";
      const bool first = std::string_view{method} == "euler_cromer";
      if (setup.coarse && std::string_view{method} != "velocity_verlet") continue;
      const Integrator integrator =
          std::string_view{method} == "velocity_verlet" ? verlet(setup) : make_integrator(method);
      Convergence gated;
      Series series{.label = scene + ", " + method, .x = {}, .y = {}};
      for (long steps = 16; steps <= (setup.coarse ? 4096 : 65536); steps *= 2) {
        const RunEnd end =
            run_steps(on_cables ? cables : column, integrator, duration / static_cast<double>(steps), steps);
        series.x.push_back(1.0 / static_cast<double>(steps));
        series.y.push_back(std::hypot((end.state.q[0] - position) / scale, (end.state.v[0] - velocity) / start));
        if (steps >= (fourth ? 32 : 64) && !(fourth && steps > 512)) gated.add(series.x.back(), series.y.back());
        if (series.y.back() < 1e-15) break;
      }
      const int order = fourth ? 4 : first ? 1 : 2;
      const double admitted = fourth ? 0.03 : first ? 7.5e-4 : setup.coarse ? 1.1e-4 : 5e-5;
      const char* why =
          fourth ? "smooth motion: the declared order. Between 16 and 32 steps it is .084 off (column: .006), half of "
                   "that with each doubling, which tilts the line from 32 to 512 by .019: that and half again"
          : first
              ? "smooth motion: the declared order. Between 32 and 64 steps it is .0068 off (particle: .0041), half "
                "of that with each doubling, which tilts the line from 64 on by 5e-4: that and half again"
              : "smooth motion: the declared order. Between 32 and 64 steps it is .0017 off (column: .0006), a "
                "quarter of that with each doubling, which tilts the line from 64 on by 3.1e-5 (to 4096 only: "
                "7e-5): that and half again";
      findings.expect_order(fmt::format("{}: order of {}", scene, method), gated, order - admitted, order + admitted,
                            why);
      if (on_cables && method != std::string_view{"central_difference"})
        figure.slopes.push_back(
            {static_cast<double>(order), series.x[3], 2.0 * series.y[3], fmt::format("h^{}", order)});
      figure.series.push_back(series);
    }
  }
  if (!setup.coarse) findings.figure(figure);
}

}  // namespace talus::verification::problems
