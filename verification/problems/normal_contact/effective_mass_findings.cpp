#include "verification/problems/normal_contact/effective_mass_findings.hpp"

#include "solver/integrate/velocity_verlet.hpp"
#include "solver/laws/linear_spring_dashpot.hpp"
#include "verification/study/impacts/disc_bounce.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems {
namespace {

/// An upright bar at rest, struck on its side by a disc away from its centre of mass, without friction or gravity.
///
///        o   pin of a pinned bar (0, b)           y
///       +-+                                       |
///       | |  <- disc from -x at height `height`   +-- x,  origin at the bar's centre of mass
///       +-+
struct StruckBar {
  bool pinned{false};      ///< at the middle of its top; free otherwise
  double height{};         ///< of the disc's line of flight above the bar's centre [L]
  double mass{3.0};        ///< of the bar [M]
  double half_width{0.5};  ///< a [L]
  double half_height{4};   ///< b [L]
  double disc_mass{2.0};   ///< [M]
  double speed{1.0};       ///< of the disc [L/T]
  double gap{};            ///< between disc and bar at t = 0 [L]
  LinearSpringDashpot law{};
};

/// Inertia of the bar about its centre of mass, m (a^2 + b^2)/3 [M L^2].
double inertia(const StruckBar& bar) {
  return bar.mass * (bar.half_width * bar.half_width + bar.half_height * bar.half_height) / 3.0;
}

/// Distance of the line of impact from the pin or, of a free bar, from the centre of mass [L].
double arm(const StruckBar& bar) { return std::abs(bar.pinned ? bar.half_height - bar.height : bar.height); }

/// Bodies "bar" and "disc" (a particle of radius 1), contact "impact". Integrator and plan are set by the caller.
Scene struck_bar(const StruckBar& bar) {
  constexpr double radius = 1.0;
  SceneBuilder builder;
  const BodyId struck = builder.add(Body{.name = "bar",
                                         .mobility = bar.pinned ? Mobility::pinned : Mobility::free,
                                         .mass = bar.mass,
                                         .inertia = inertia(bar),
                                         .shape = Rectangle{bar.half_width, bar.half_height},
                                         .p_BPin = {0.0, bar.half_height}});
  const BodyId disc =
      builder.add_particle("disc", bar.disc_mass, {-(bar.half_width + radius + bar.gap), bar.height}, Circle{radius});
  builder.add_contact("impact", disc, struck, bar.law);
  Scene scene = builder.at_rest("Bar struck by a disc");
  set_velocity(scene.model, scene.initial, disc, {bar.speed, 0.0}, 0.0);
  return scene;
}

Scene two_discs(double mass, double other, double frame, const LinearSpringDashpot& law, double gap) {
  SceneBuilder builder;
  const Body like{.name = "left", .mobility = Mobility::particle, .mass = mass, .shape = Circle{4.0}};
  Body right = like;
  right.name = "right";
  right.mass = other;
  right.p_WB = {8.0 + gap, 0.0};
  const BodyId a = builder.add(like);
  const BodyId b = builder.add(right);
  builder.add_contact("impact", a, b, law);
  Scene scene = builder.at_rest("Two discs");
  set_velocity(scene.model, scene.initial, a, {1.0 + frame, 0.0}, 0.0);
  set_velocity(scene.model, scene.initial, b, {frame, 0.0}, 0.0);
  return scene;
}

/// Two discs whose forces use the second disc's velocity times `sign`: -1 turns the rate of the overlap into the sum of
/// the velocities, as Eq. 20 is printed. Forces depend on the velocities through that rate only.
struct SignedDiscs {
  RigidBodySystem* system{};
  double sign{1.0};

  [[nodiscard]] State seen(State state) const {
    state.v[2] *= sign;
    state.v[3] *= sign;
    return state;
  }
  void drift(State& state, double h) const { drift_coordinates(state, h); }
  void update_modes(State& state) const {
    State turned = seen(state);
    system->update_modes(turned);
    state.mode = turned.mode;
  }
  void derivative(const State& state, Rates& rates) const { system->derivative(seen(state), rates); }
  void evaluate(State& state, Rates& rates) const {
    update_modes(state);
    derivative(state, rates);
  }
};

/// Separation speed of two discs of masses 1 and 2 in a moving frame, relative to the approach speed.
double restitution_in_frame(double frame, bool plus, Findings& findings) {
  const LinearSpringDashpot law =
      dashpot_of(reference::damping_ratio(0.5, reference::EndRule::attractive), 1.0, 2.0 / 3.0, EndRule::attractive);
  const Scene scene = two_discs(1.0, 2.0, frame, law, 0.01);
  const Dynamics dynamics{scene.model};
  RigidBodySystem discs{dynamics, false};
  SignedDiscs system{&discs, plus ? -1.0 : 1.0};
  VelocityVerlet method;
  State state = scene.initial;
  constexpr double step = 1.0 / 37.0;  // about 100 per contact
  method.start(system, state, step);
  while (state.t < 6.0)
    method.step(system, state, step);
  findings.count(discs.evaluations());
  return state.v[2] - state.v[0];
}

/// Effective mass of disc and bar with the line of impact at `distance` from the pin or the centre of mass.
double mass_at(const StruckBar& bar, double distance) {
  const double about_pin = inertia(bar) + bar.mass * bar.half_height * bar.half_height;
  return reference::effective_mass(1.0 / bar.disc_mass,
                                   bar.pinned ? reference::pivoted_mobility(about_pin, distance)
                                              : reference::free_mobility(bar.mass, inertia(bar), distance));
}

/// The error that is farther from the predicted one; `other` if either is NaN.
double farther(double error, double other, double predicted) {
  return std::isnan(error) || std::abs(other - predicted) < std::abs(error - predicted) ? error : other;
}

/// Effective mass of the two masses, which Eq. 21 uses as printed.
double two_masses(const StruckBar& bar) { return reference::effective_mass(1.0 / bar.disc_mass, 1.0 / bar.mass); }

/// Errors of e = 0.5 with a dashpot designed for the effective mass `mass`.
ImpactErrors bar_errors(StruckBar bar, double mass, Findings& findings) {
  constexpr double stiffness = 1e12;  // overlap 1e-6 of the bar's size: only the step's error remains
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
  Series line{.label = kind + ", closed form of the two masses", .style = Style::lines};
  const double xi = reference::damping_ratio(0.5, reference::EndRule::attractive);
  const StruckBar bar{.pinned = pinned};
  for (double a = 0.0; a <= (pinned ? 8.0 : 4.0); a += 0.25)
    line.add(a,
             reference::restitution(xi * std::sqrt(two_masses(bar) / mass_at(bar, a)), reference::EndRule::attractive));
  return line;
}

}  // namespace

void check_masses(Findings& findings, const Setup& setup) {
  const double predicted = predicted_restitution_error(bounce(0.5, EndRule::clamped, {}), production_steps);
  double worst = predicted, drift = 0.0;
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
    worst = farther(worst, found.restitution.rms(), predicted);
    keep_largest(drift, centre - (3.0 + 1.0 / (1.0 + ratio)));
  }
  findings.expect({"mass_ratios", "rms relative error of e, mass ratios 1/100 ... 100"}, worst, predicted,
                  near_prediction(EndRule::clamped));
  findings.expect_round_off({"centre_of_mass", "velocity of the common centre of mass, largest error"}, drift, 0.0,
                            2e-14,
                            "110 equal and opposite kicks, each rounded at speeds up to 5: sqrt(110) x 4.4e-16 = "
                            "5e-15, times four for the worst");
}

void check_frames(Findings& findings, const Setup& setup) {
  const bool plus = setup.has("closing_rate_with_plus");
  const Pose left{.p_WB = {-4.0, 0.0}, .R_WB = {}, .v_WB = {3.0, -7.0}};
  Pose right{.p_WB = {4.0, 0.0}, .R_WB = {}, .v_WB = left.v_WB};
  if (plus) right.v_WB = -right.v_WB;
  findings.expect_exact("closing rate of two discs that move together", depth_rate({0.0, {1.0, 0.0}, {}}, left, right),
                        0.0, "Eq. 20 with the minus sign: the difference of two equal numbers");
  const double at_rest = restitution_in_frame(0.0, plus, findings);
  double change = 0.0;
  for (const double frame : {-7.0, 3.0, 20.0}) {
    const double found = restitution_in_frame(frame, plus, findings) - at_rest;
    keep_worst(change, found);
  }
  findings.expect_round_off({"moving_frames", "closing rate in moving frames, change of e"}, change, 0.0, 4e-13,
                            "220 steps that round positions up to 130 to 1.4e-14 and speeds up to 21 to 1.8e-15: "
                            "sqrt(220) x 1.4e-14 = 2e-13, times two for the worst");
}

void check_levers(Findings& findings, const Setup& setup) {
  Figure figure{.name = "levers",
                .title = "Off-centre and pivoted impacts",
                .caption =
                    "Restitution where 0.5 is wanted. Filled: damping from the effective mass at the contact point. "
                    "Crosses: Eq. 21 with the two masses; lines: closed form for its damping ratio.",
                .x = {.label = "lever arm from the centre of mass or the pin"},
                .y = {.label = "restitution", .min = 0.4},
                .series = {},
                .lines = {{'y', 0.5, "wanted"}}};
  for (const bool pinned : {false, true}) {
    const std::string kind = pinned ? "pivoted" : "off centre";
    Series right{.label = kind + ", effective mass", .style = Style::points};
    Series naive{.label = kind + ", two masses", .style = Style::crosses};
    const double predicted = predicted_restitution_error(bounce(0.5, EndRule::attractive, {}), production_steps);
    double worst = predicted;
    for (const double height : {-3.5, -2.0, -0.5, 1.0, 2.5}) {
      const StruckBar bar{.pinned = pinned, .height = height};
      const bool forgotten = setup.has(pinned ? "pin_forgotten" : "arm_forgotten");
      const ImpactErrors found = bar_errors(bar, forgotten ? two_masses(bar) : mass_at(bar, arm(bar)), findings);
      worst = farther(worst, found.restitution.rms(), predicted);
      if (setup.coarse) continue;
      right.add(arm(bar), found.mean_restitution);
      naive.add(arm(bar), bar_errors(bar, two_masses(bar), findings).mean_restitution);
    }
    // The overlap is 1e-6 of the bar: its rotation during contact is negligible, as in a central impact.
    findings.expect({"rms_error_of_pairs", "rms relative error of e, " + kind}, worst, predicted,
                    near_prediction(EndRule::attractive));
    figure.series.insert(figure.series.end(), {right, naive, closed_form_of_two_masses(pinned, kind)});
  }
  if (!setup.coarse) findings.figure(figure);
}

}  // namespace talus::verification::problems
