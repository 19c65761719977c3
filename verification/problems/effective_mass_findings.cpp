#include "verification/problems/effective_mass_findings.hpp"

#include <algorithm>
#include <cmath>

#include "solver/model/model_builder.hpp"
#include "verification/problems/disc_bounce.hpp"
#include "verification/problems/struck_bar.hpp"

namespace talus::verification::problems {
namespace {

Scene two_discs(double mass, double other, double frame, const LinearSpringDashpot& law, double gap) {
  ModelBuilder builder;
  const Body like{.name = "left", .mobility = Mobility::particle, .mass = mass, .shape = Circle{4.0}};
  Body right = like;
  right.name = "right";
  right.mass = other;
  right.p_WB = {8.0 + gap, 0.0};
  const BodyId a = builder.add(like);
  const BodyId b = builder.add(right);
  builder.add(Contact{.name = "impact", .a = a, .b = b, .law = law});
  Scene scene{.title = "Two discs", .model = builder.build()};
  scene.initial = rest_state(scene.model);
  set_velocity(scene.model, scene.initial, a, {1.0 + frame, 0.0}, 0.0);
  set_velocity(scene.model, scene.initial, b, {frame, 0.0}, 0.0);
  return scene;
}

/// Effective mass of disc and bar when the line of impact passes at that distance from the pin or the centre of mass.
double mass_at(const StruckBar& bar, double distance) {
  const double about_pin = inertia(bar) + bar.mass * bar.half_height * bar.half_height;
  return reference::effective_mass(1.0 / bar.disc_mass,
                                   bar.pinned ? reference::pivoted_mobility(about_pin, distance)
                                              : reference::free_mobility(bar.mass, inertia(bar), distance));
}

/// What Eq. 21 as printed takes.
double two_masses(const StruckBar& bar) { return reference::effective_mass(1.0 / bar.disc_mass, 1.0 / bar.mass); }

/// Errors of e = .5 with a dashpot made for `mass`.
ImpactErrors bar_errors(StruckBar bar, double mass, Findings& findings) {
  constexpr double stiffness = 1e12;  // overlap 1e-6 of the bar's size: what is left is the step
  const double xi = reference::damping_ratio(0.5, reference::EndRule::attractive);
  const double true_mass = mass_at(bar, arm(bar));
  bar.law = dashpot_of(xi, stiffness, mass, EndRule::attractive);
  const auto exact = reference::impact_events(
      {stiffness, dashpot_of(xi, stiffness, true_mass, EndRule::attractive).damping, true_mass, 1.0},
      reference::EndRule::attractive);
  const auto at = [bar](double gap) mutable {
    bar.gap = gap;
    return struck_bar(bar);
  };
  return impact_errors(at, exact, production_steps, VelocityVerlet{}, findings);
}

Series closed_form_of_two_masses(bool pinned, const std::string& kind) {
  Series line{.label = kind + ", closed form of the two masses", .x = {}, .y = {}, .style = Style::lines};
  const double xi = reference::damping_ratio(0.5, reference::EndRule::attractive);
  const StruckBar bar{.pinned = pinned};
  for (double a = 0.0; a <= (pinned ? 8.0 : 4.0); a += 0.25) {
    line.x.push_back(a);
    line.y.push_back(
        reference::restitution(xi * std::sqrt(two_masses(bar) / mass_at(bar, a)), reference::EndRule::attractive));
  }
  return line;
}

}  // namespace

void check_masses(Findings& findings, const Setup& setup) {
  double worst = 0.0, bound = 0.0, drift = 0.0;
  for (const double ratio : {0.01, 0.1, 1.0, 10.0, 100.0}) {
    const double mass = ratio / (1.0 + ratio);  // effective mass of masses 1 and ratio
    const Bounce b = bounce(0.5, EndRule::clamped, setup);
    const LinearSpringDashpot law = dashpot_of(b.xi, mass, setup.has("masses_added") ? 1.0 + ratio : mass, b.rule);
    double centre = 0.0;
    const auto at = [&](double gap) { return two_discs(1.0, ratio, 3.0, law, gap); };
    const ImpactErrors found = impact_errors(at, b.exact, production_steps, VelocityVerlet{}, findings);
    const FollowedImpact impact =
        impact_at_phase(at, VelocityVerlet{}, b.exact.contact_time,
                        offset_step(b.exact.contact_time, production_steps, 0), 0.5, findings);
    const State& end = impact.at_end;
    centre = (end.v[0] + ratio * end.v[2]) / (1.0 + ratio);
    worst = std::max(worst, found.restitution.rms());
    bound = predicted_restitution_error(b, production_steps);
    drift = std::max(drift, std::abs(centre - (3.0 + 1.0 / (1.0 + ratio))));
  }
  findings.expect("rms relative error of e, mass ratios 1/100 ... 100", worst, 0.0,
                  Tolerance::truncation(bound, bound_factor, "e depends on xi alone, hence the same predicted error"));
  findings.expect("velocity of the common centre of mass", drift, 0.0,
                  Tolerance::round_off(2e-14,
                                       "110 equal and opposite kicks, each rounded at speeds up to 5: sqrt(110) "
                                       "x 4.4e-16 = 5e-15, four times that for the worst"));
}

void check_levers(Findings& findings, const Setup& setup) {
  Figure figure{.name = "levers",
                .title = "Off-centre and pivoted impacts",
                .caption =
                    "Restitution for the wanted .5. Filled: damping from the effective mass at the contact point. "
                    "Crosses: Eq. 21 with the two masses; the lines are what its damping ratio gives there.",
                .x = {.label = "lever arm from the centre of mass or the pin"},
                .y = {.label = "restitution", .min = 0.4},
                .series = {},
                .lines = {{'y', 0.5, "wanted"}}};
  for (const bool pinned : {false, true}) {
    const std::string kind = pinned ? "pivoted" : "off centre";
    Series right{.label = kind + ", effective mass", .x = {}, .y = {}, .style = Style::points};
    Series naive{.label = kind + ", two masses", .x = {}, .y = {}, .style = Style::crosses};
    double worst = 0.0;
    for (const double height : {-3.5, -2.0, -0.5, 1.0, 2.5}) {
      const StruckBar bar{.pinned = pinned, .height = height};
      const bool forgotten = setup.has(pinned ? "pin_forgotten" : "arm_forgotten");
      const ImpactErrors found = bar_errors(bar, forgotten ? two_masses(bar) : mass_at(bar, arm(bar)), findings);
      worst = std::max(worst, found.restitution.rms());
      if (setup.coarse) continue;
      right.x.push_back(arm(bar));
      right.y.push_back(found.mean_restitution);
      naive.x.push_back(arm(bar));
      naive.y.push_back(bar_errors(bar, two_masses(bar), findings).mean_restitution);
    }
    findings.expect(
        "rms relative error of e, " + kind, worst, 0.0,
        Tolerance::truncation(
            predicted_restitution_error(bounce(0.5, EndRule::attractive, {}), production_steps), bound_factor,
            "the predicted error of a central impact; the overlap is 1e-6 of the bar, so that its turning "
            "during contact is not seen"));
    figure.series.insert(figure.series.end(), {right, naive, closed_form_of_two_masses(pinned, kind)});
  }
  if (!setup.coarse) findings.figure(figure);
}

}  // namespace talus::verification::problems
