#include <random>

#include "verification/reference/impacts/restitution.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::colliding_discs {
namespace {

constexpr double stiffness = 1000.0, friction = 0.4, shear_ratio = 0.6;
constexpr double masses[] = {1.3, 0.7}, radii[] = {0.31, 0.24}, approach = 1.7;

double damping(double xi, double effective_mass) { return 2.0 * xi * std::sqrt(stiffness * effective_mass); }

/// Energy balance error of a run, and the largest changes of its momenta.
struct Ledger {
  double left_over{};  ///< final energy balance error, relative to the initial kinetic energy
  double largest{};    ///< largest absolute value over all steps
  double momentum{}, moment{};
};

Ledger run_ledger(const Scene& scene, double step, double end, const Setup& setup, Findings& findings) {
  RunLedger ledger{scene.model, first_state(scene)};
  const Accounts start = ledger(scene.initial);
  Ledger found;
  const Watcher account = [&](State seen, const StepInfo&) {
    if (setup.has("dashpot_not_booked")) seen.work[static_cast<std::size_t>(Mechanism::contact_damping)] = 0.0;
    const Accounts now = ledger(seen);
    const Vec2 drift = now.momenta.linear - start.momenta.linear;
    found.left_over = now.energy_balance_error / start.energies.kinetic;
    keep_largest(found.largest, found.left_over);
    keep_largest(found.momentum, drift.x), keep_largest(found.momentum, drift.y);
    keep_largest(found.moment, now.momenta.angular - start.momenta.angular);
  };
  if (!run_scene(scene, VelocityVerlet{}, {step, end, end, true}, findings, account).finished)
    found.largest = std::nan("");
  return found;
}

Contact touch(std::string name, BodyId a, BodyId b, double dashpot) {
  return {.name = std::move(name), .a = a, .b = b, .law = LinearSpringDashpot{stiffness, dashpot, EndRule::clamped}};
}

/// Two discs that approach head on, initially `gap` apart [L].
Scene two_discs(double xi, double gap) {
  SceneBuilder builder{si};
  const auto disc = [&](int i, double x) {
    return builder.add_free(fmt::format("disc{}", i), masses[i], 0.5 * masses[i] * radii[i] * radii[i],
                            Circle{radii[i]}, {x, 0.0});
  };
  const BodyId a = disc(0, 0.0), b = disc(1, radii[0] + radii[1] + gap);
  const double effective = masses[0] * masses[1] / (masses[0] + masses[1]);
  builder.add(touch("touch", a, b, damping(xi, effective)));
  Scene scene = builder.at_rest("Two discs");
  // Centre of mass at rest: the kinetic energy is that of approach.
  set_velocity(scene.model, scene.initial, a, {approach * masses[1] / (masses[0] + masses[1]), 0.0}, 0.0);
  set_velocity(scene.model, scene.initial, b, {-approach * masses[0] / (masses[0] + masses[1]), 0.0}, 0.0);
  return scene;
}

/// Twenty discs on two rings that fly inwards.
Scene twenty_discs(double xi, double mu, const Setup& setup) {
  SceneBuilder builder{si};
  if (setup.has("a_little_weight")) builder.gravity({1e-12, 0.0});
  std::mt19937_64 random{20};
  std::uniform_real_distribution<double> fraction{0.0, 1.0};
  std::vector<BodyId> ids;
  std::vector<Vec2> speeds;
  for (int i = 0; i < 20; ++i) {
    const double radius = 0.2 + 0.15 * fraction(random), mass = 12.0 * radius * radius;
    const double angle = 2.0 * std::numbers::pi * (i % 10 + 0.3 * fraction(random) + (i < 10 ? 0.0 : 0.4)) / 10.0;
    const double far = i < 10 ? 1.5 : 2.6;
    const Vec2 out{std::cos(angle), std::sin(angle)};
    ids.push_back(
        builder.add_free(fmt::format("disc{}", i), mass, 0.5 * mass * radius * radius, Circle{radius}, far * out));
    // Drawn in separate statements, because a compiler may evaluate either of two operands first.
    const Vec2 aside{0.3 * fraction(random), -0.2};
    speeds.push_back(-(1.0 + fraction(random)) * out + aside);
  }
  for (std::size_t i = 0; i < 20; ++i) {
    for (std::size_t j = i + 1; j < 20; ++j) {
      Contact contact = touch(fmt::format("{}-{}", i, j), ids[i], ids[j], damping(xi, 0.45));
      if (mu > 0.0) contact.friction = CoulombFriction{mu, shear_ratio * stiffness};
      builder.add(std::move(contact));
    }
  }
  Scene scene = builder.at_rest("Twenty discs");
  for (std::size_t i = 0; i < 20; ++i)
    set_velocity(scene.model, scene.initial, ids[i], speeds[i], 2.0 * fraction(random) - 1.0);
  return scene;
}

/// Checks the energy balance error of two discs: rms and mean over the phases of touch and release.
void check_two(Findings& findings, const Setup& setup, double xi, Figure& figure) {
  const double effective = masses[0] * masses[1] / (masses[0] + masses[1]);
  const double omega = std::sqrt(stiffness / effective);
  const reference::ImpactEvents events =
      reference::impact_events({stiffness, damping(xi, effective), effective, approach}, reference::EndRule::clamped);
  const double e = events.restitution;
  const std::string what = xi > 0.0 ? fmt::format("damped, xi = {:g}", xi) : "undamped";
  Convergence errors;
  double ratio = 0.0;
  Series points{what + ", two discs", {}, {}, Style::points}, line{what + ", predicted", {}, {}, Style::lines};
  for (const double count : doublings(setup.coarse ? 64.0 : 32.0, setup.coarse ? 3 : 5)) {
    PhaseError error;
    double sum = 0.0;
    for (const auto& [i, step, onset] :
         offset_phases(events.contact_time, count, fewest_phases, setup.has("commensurate_step"))) {
      const double touch_after = (2.0 + even_phases(fewest_phases)[i * 27 % fewest_phases]) * step;
      const Ledger found = run_ledger(two_discs(xi, approach * touch_after), step,
                                      touch_after + events.contact_time + 3.0 * step, setup, findings);
      error.add(found.left_over);
      sum += found.left_over / (xi * omega * step * (1.0 - 3.0 * e * e)) / static_cast<double>(fewest_phases);
    }
    const double step = events.contact_time / (count + 0.5), wh = omega * step;
    errors.add(1.0 / (count + 0.5), error.rms());
    points.add(wh, error.rms());
    line.add(wh, xi > 0.0 ? xi * wh * std::abs(1.0 - 3.0 * e * e) : wh * wh / std::sqrt(90.0));
    ratio = xi > 0.0 ? sum : error.rms() / line.y.back();
  }
  figure.series.push_back(points);
  figure.series.push_back(line);
  if (xi > 0.0) {
    findings.expect_order({"order_undamped", "order of the energy balance error, two discs, " + what}, errors.last(3),
                          0.93, 1.06, "the dashpot's power is recorded with the velocity before the kick");
    findings.expect_between(
        {"energy_undamped/" + what, "energy balance error, two discs, " + what + ", relative to its prediction"}, ratio,
        0.95, 1.05, "xi w h (1 - 3 e^2); the next term is smaller by a factor of w h times a number of order one");
  } else {
    findings.expect_order({"order_elastic", "order of the energy balance error, two discs, undamped"}, errors.last(3),
                          1.98, 2.02, "touch and release fall within a step, each with an error of (w h)^2");
    findings.expect_between(
        {"energy_elastic", "energy balance error, two discs, undamped, relative to its prediction"}, ratio, 0.9, 1.1,
        "(w h)^2/sqrt(90) for uniform phases; 64 phases of touch and release are uniform to a few per cent");
  }
}

/// Checks momentum, angular momentum and the order of the energy balance error of twenty discs.
void check_twenty(Findings& findings, const Setup& setup, double xi, double mu, Figure& figure) {
  const Scene scene = twenty_discs(xi, mu, setup);
  const std::string what = mu > 0.0 ? "damped, with friction" : xi > 0.0 ? "damped" : "undamped";
  const double end = 1.0, coarsest = 0.004;
  Convergence errors;
  Ledger last;
  double step = coarsest;
  for (int i = 0; i < (setup.coarse ? 1 : 4); ++i, step *= 0.5) {
    last = run_ledger(scene, step / 1.0123, end, setup, findings);
    errors.add(step, last.largest);
  }
  double momentum = 0.0, moment = 0.0;
  for (std::size_t i = 0; i < 20; ++i) {
    const double speed = norm(Vec2{scene.initial.v[3 * i], scene.initial.v[3 * i + 1]});
    momentum += scene.model.bodies[i].mass * speed;
    moment += scene.model.bodies[i].mass * speed * 2.6;
  }
  const double rounding = 4.0 * std::sqrt(end / step) * 0x1p-53;
  const std::string reason =
      "each step rounds each momentum at random by u of its size: sqrt(n) u, times four for the worst of all steps, "
      "the sums and the moments";
  findings.expect_round_off({"momentum/" + what, "largest change of momentum, twenty discs, " + what}, last.momentum,
                            0.0, rounding * momentum / std::sqrt(20.0),
                            reason + "; the twenty discs are rounded independently", "kg m/s");
  findings.expect_round_off({"moment_of_momentum/" + what, "largest change of angular momentum, twenty discs, " + what},
                            last.moment, 0.0, rounding * moment, reason, "kg m^2/s");
  if (setup.coarse) return;
  Series points{what + ", twenty discs", {}, {}, Style::linespoints};
  for (std::size_t i = 0; i < errors.size(); ++i)
    points.add(std::sqrt(stiffness / 0.45) * errors.steps()[i], errors.errors()[i]);
  figure.series.push_back(points);
  const bool second = xi == 0.0;
  findings.expect_order(
      {"order_twenty_discs/" + what, "order of the largest energy balance error, twenty discs, " + what}, errors,
      second ? 1.7 : 0.8, second ? 2.3 : 1.2,
      "one run instead of a mean over phases: the largest error of some forty contacts");
}

void run(Findings& findings, const Setup& setup) {
  Figure figure{.name = "left_over",
                .title = "Energy balance error of velocity Verlet",
                .caption =
                    "Relative to the initial kinetic energy. Two discs: root mean square over 64 phases (points) and "
                    "predictions with the constants derived above (lines); twenty discs: largest error of one run.",
                .x = {.label = "w h", .log = true},
                .y = {.label = "energy balance error", .log = true}};
  check_two(findings, setup, 0.0, figure);
  check_two(findings, setup, 0.1, figure);
  if (!setup.coarse) check_two(findings, setup, 0.4, figure);
  check_twenty(findings, setup, 0.0, 0.0, figure);
  if (setup.coarse) return;
  check_twenty(findings, setup, 0.2, 0.0, figure);
  check_twenty(findings, setup, 0.2, friction, figure);
  findings.figure(figure);
}

}  // namespace

Case definition() {
  return {
      .id = "colliding_discs",
      .title = "Momentum and energy of colliding discs",
      .requirements = {{"A4",
                        {"order_elastic", "energy_elastic", "order_undamped", "energy_undamped", "momentum",
                         "moment_of_momentum", "order_twenty_discs"}},
                       {"law.linear_spring_dashpot",
                        {"order_elastic", "energy_elastic", "order_undamped", "energy_undamped", "order_twenty_discs"}},
                       {"end_rule.clamped", {"order_undamped", "energy_undamped"}},
                       {"Eq. 18",
                        {"momentum/damped, with friction", "moment_of_momentum/damped, with friction",
                         "order_twenty_discs/damped, with friction"}},
                       {"mechanism.contact_damping", {"order_undamped", "energy_undamped"}},
                       {"mechanism.friction",
                        {"momentum/damped, with friction", "moment_of_momentum/damped, with friction",
                         "order_twenty_discs/damped, with friction"}},
                       {"shape.circle, method.resultant", {"momentum", "moment_of_momentum", "order_twenty_discs"}},
                       {"integrator.velocity_verlet",
                        {"order_elastic", "energy_elastic", "order_undamped", "energy_undamped", "order_twenty_discs"}},
                       {"pair.circle.circle",
                        {"order_elastic", "energy_elastic", "order_undamped", "energy_undamped", "momentum",
                         "moment_of_momentum", "order_twenty_discs"}}},
      .main_checks = {"energy_elastic", "energy_undamped/damped, xi = 0.1", "momentum/damped, with friction",
                      "moment_of_momentum/damped, with friction"},
      .source = "Hairer, Lubich & Wanner 2006, chapter IX; Schwager & Poeschel 2007",
      .faults = {{"dashpot_not_booked", "the work of the dashpot is omitted from the energy balance",
                  "energy_undamped/damped, xi = 0.1"},
                 {"commensurate_step", "the contact time is a multiple of the step", "energy_elastic"},
                 {"a_little_weight", "gravity of 1e-12 m/s^2", "momentum/undamped"}},
      .run = run};
}

}  // namespace talus::verification::problems::colliding_discs
