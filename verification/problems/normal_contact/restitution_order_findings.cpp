#include "verification/problems/normal_contact/restitution_order_findings.hpp"

#include <fmt/format.h>

#include <string>
#include <vector>

#include "solver/integrate/integrator_list.hpp"
#include "verification/check/convergence.hpp"
#include "verification/study/disc_bounce.hpp"

namespace talus::verification::problems {
namespace {

Convergence restitution_errors(const Bounce& b, const Integrator& integrator, const std::vector<double>& steps,
                               Findings& findings, bool commensurate = false) {
  Convergence convergence;
  for (const double n : steps) {
    const ImpactErrors found =
        impact_errors([&b](double gap) { return disc_at(b, gap); }, b.exact, n, integrator, findings, commensurate);
    convergence.add(1.0 / n, found.restitution.rms());
  }
  return convergence;
}

/// The curves of e = .5 under one end rule: every method, and what is predicted for the leapfrog ones.
void check_damped(EndRule rule, const std::vector<double>& steps, Figure& figure, Findings& findings,
                  const Setup& setup) {
  const Bounce b = bounce(0.5, rule, setup);
  for (const Integrator& integrator :
       {Integrator{VelocityVerlet{}}, Integrator{CentralDifference{}}, Integrator{RungeKutta4{}}}) {
    const std::string label = fmt::format("e = 0.5, {}, {}", word_for(rule), talus::name(integrator));
    const Convergence found = restitution_errors(b, integrator, steps, findings);
    findings.expect_order("order of e, " + label.substr(9), found, 0.93, 1.07,
                          "the dashpot's force jumps at touch, a step resolves the jump to half a step; the next "
                          "power, w h = .2 of the first at 16 steps, tilts the fit by up to .05, uneven phases of the "
                          "end (6 % of a rms) by .02");
    figure.series.push_back({label, found.steps(), found.errors(), Style::points});
  }
  Series predicted{.label = fmt::format("predicted, {}", word_for(rule)), .x = {}, .y = {}, .style = Style::lines};
  for (const double n : steps)
    predicted.add(1.0 / n, predicted_restitution_error(b, n));
  figure.series.push_back(predicted);
}

/// Contact time and largest overlap at 64 steps. The leapfrog's period is short by (w h)^2/24; the largest sample lies
/// within half a step of the turn and the energy inside is that of the touch: (w h)^2/2 [s (1 - s) - u (1 - u)] with
/// the shares u of the touch and s of half a step before the turn, of the same root mean square as the error of e.
void check_undamped_contact(const Bounce& elastic, Findings& findings) {
  constexpr double steps = 64.0;
  const ImpactErrors found = impact_errors([&elastic](double gap) { return disc_at(elastic, gap); }, elastic.exact,
                                           steps, VelocityVerlet{}, findings);
  const double wh = reduced_step(elastic.exact, steps);
  findings.expect("rms error of the undamped contact time, 64 steps", found.contact_time.rms(), wh * wh / 24.0,
                  Tolerance::model(0.01,
                                   "the leapfrog's own period; the next power is (w h)^2 = .002 of it, and the mean "
                                   "over steps of different lengths as much")
                      .relative());
  findings.expect(
      "rms error of the undamped largest overlap, 64 steps", found.largest_depth.rms(),
      second_order_constant / std::pow(steps + 0.5, 2),
      Tolerance::model(uneven_end, "shares of a step at touch and turn, spread over 64 uneven pairs").relative());
}

/// The curves of e = 1, and the slopes to compare with.
void check_undamped(const std::vector<double>& steps, Figure& figure, Findings& findings, const Setup& setup) {
  const Bounce elastic = bounce(1.0, EndRule::attractive, setup);
  check_undamped_contact(elastic, findings);
  for (const Integrator& integrator : {Integrator{VelocityVerlet{}}, Integrator{RungeKutta4{}}}) {
    const Convergence found = restitution_errors(elastic, integrator, steps, findings, setup.has("commensurate_step"));
    findings.expect_order(fmt::format("order of e, undamped, {}", talus::name(integrator)), found, 1.85, 2.15,
                          "the force is continuous; its slope jumps at touch and end, which costs h^2");
    figure.series.push_back(
        {fmt::format("e = 1, {}", talus::name(integrator)), found.steps(), found.errors(), Style::points});
    if (figure.slopes.empty()) {
      findings.expect(
          "rms error of e = 1 at 16 steps per contact", found.errors().front(), second_order_constant / (16.5 * 16.5),
          Tolerance::model(uneven_end,
                           "pi^2/(2 sqrt(90) N^2) from the shares of a step at touch and end; the next term, "
                           "(w h)^2, is 4 % of it, the end's 64 uneven phases leave 6 %")
              .relative());
      figure.slopes = {{1.0, 1.0 / 40.0, 0.06, "h"}, {2.0, 1.0 / 64.0, 0.1 * second_order_constant / 4096.0, "h^2"}};
    }
  }
}

}  // namespace

void check_restitution_orders(Findings& findings, const Setup& setup) {
  Figure figure{.name = "error_of_e",
                .title = "Error of the restitution against the step",
                .caption =
                    "Root mean square over 64 phases with a step of its own each. Points: the solver. Lines: the "
                    "error predicted from lag and jumps (damped); nothing is fitted. With a dashpot every "
                    "method is of first order, without one of second.",
                .x = {.label = "step / contact time", .log = true},
                .y = {.label = "relative error of e", .log = true}};
  const auto steps = doublings(16.0, setup.coarse ? 3 : 6);
  for (const EndRule rule : {EndRule::attractive, EndRule::clamped})
    check_damped(rule, steps, figure, findings, setup);
  check_undamped(steps, figure, findings, setup);
  findings.figure(figure);
}

}  // namespace talus::verification::problems
