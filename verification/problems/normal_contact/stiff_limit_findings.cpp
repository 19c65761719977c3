#include "verification/problems/normal_contact/stiff_limit_findings.hpp"

#include <cmath>

#include "verification/check/convergence.hpp"
#include "verification/problems/normal_contact/falling_disc.hpp"
#include "verification/reference/restitution.hpp"
#include "verification/study/phases.hpp"

namespace talus::verification::problems {
namespace {

/// 1 - h1/(e^2 h0) of a bounce from just above the plane, mean over 64 phases.
double mean_drop(const Fall& fall, double steps, Findings& findings, const Setup& setup) {
  const double speed = std::sqrt(2.0 * gravity * fall_height);
  const double e = reference::restitution(fall.xi, same(fall.rule));
  double mean = 0.0;
  for (const Phase& phase : offset_phases(contact_time(fall), steps)) {
    // Taken back along the fall from its end at the plane: speed v - g t at the gap v t - g t^2/2.
    const double lead = phase.lead();
    const Scene scene = falling_disc(fall, lead * (speed - 0.5 * gravity * lead), speed - gravity * lead, setup);
    const double h1 = apexes(scene, phase.step, 1, findings).front();
    mean += (1.0 - h1 / (e * e * fall_height)) / static_cast<double>(fewest_phases);
  }
  return mean;
}

/// The same with what the dashpot's lag takes, first order in the step, taken out by half the step.
double measured_drop(const Fall& fall, Findings& findings, const Setup& setup) {
  return 2.0 * mean_drop(fall, 400.0, findings, setup) - mean_drop(fall, 200.0, findings, setup);
}

}  // namespace

void check_stiff_limit(Findings& findings, const Setup& setup) {
  constexpr double xi = 0.2;
  const double e = reference::restitution(xi, reference::EndRule::clamped);
  const double speed = std::sqrt(2.0 * gravity * fall_height);
  const double contact_angle = 2.0 * reference::contact_angle(xi);  // w T
  Convergence found;
  Series line{"first order", {}, {}, Style::lines}, exact{"exact", {}, {}, Style::lines};
  double worst = 0.0;
  for (const double w : {20.0, 63.2, 200.0, 632.0}) {
    if (setup.coarse && w < 200.0) continue;
    const Fall fall{xi, EndRule::clamped, w};
    const double drop = measured_drop(fall, findings, setup);
    const double apex = reference::bounces(exact_fall(fall, fall_height, 0.0), 1).front().apex_gap;
    const double truth = 1.0 - apex / (e * e * fall_height);
    found.add(w * w, drop);
    const double difference = drop - truth;
    if (!(std::abs(difference) <= std::abs(worst))) worst = difference;
    line.add(w * w, 4.0 * xi * (1.0 + e) / e * gravity / (w * speed));
    exact.add(w * w, truth);
  }
  findings.expect(
      "height lost beyond e^2, mean of 64 phases, largest error of four stiffnesses", worst, 0.0,
      Tolerance::truncation(0.17 * std::pow(contact_angle / 400.0, 2), 1.5,
                            "the lag of the dashpot is taken out, the jump's mean vanishes over even phases "
                            "of the touch; what is left is of second order, measured, the same at every "
                            "stiffness"));
  findings.expect_order(
      "order of the rigid limit in the stiffness", found, -0.515, -0.485,
      "G falls with the square root of the stiffness; G^2, .035 of it at the softest, bends the line");
  findings.expect("height lost beyond e^2 at the stiffest over the first-order term",
                  found.errors().back() / line.y.back(), 1.0,
                  Tolerance::model(0.02, "the next power of G, .001, and the error above, 8e-6 of .0025"));
  findings.figure({.name = "stiff_limit",
                   .title = "Towards the rigid limit",
                   .caption = "What the first height lacks of $e^2 h_0$, $\\xi = .2$, against the stiffness.",
                   .x = {.label = "stiffness", .log = true},
                   .y = {.label = "1 - h1/(e^2 h0)", .log = true},
                   .series = {{"solver", found.steps(), found.errors(), Style::points}, exact, line},
                   .slopes = {{-0.5, 4e4, 3e-3, "k^(-1/2)"}}});
}

}  // namespace talus::verification::problems
