#include <type_traits>

#include "solver/granular/disc_system.hpp"
#include "solver/granular/fast_disc_system.hpp"
#include "solver/integrate/euler_cromer.hpp"
#include "verification/reference/friction/oblique_impact.hpp"
#include "verification/study/impacts/oblique_runs.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::spinning_discs {
namespace {

constexpr double first_mass = 1.0, second_mass = 0.25;
constexpr double reduced_mass = first_mass * second_mass / (first_mass + second_mass);
constexpr double kappa = 2.0 / 7.0, mu = oblique_friction;
constexpr double first_radius = oblique_radius, second_radius = 0.5 * oblique_radius;

/// Two discs that touch at the origin at t = 0, the first moving to the right at unit speed. Spins are given as rim
/// speeds.
Scene met_discs(double second, double second_r, double first_rim, double second_rim, const Setup& setup) {
  SceneBuilder builder;
  const auto disc = [&](const char* name, double mass, double radius, double x) {
    return builder.add_free(name, mass, 0.5 * mass * radius * radius, Circle{radius}, {x, 0.0});
  };
  const BodyId a = disc("first", first_mass, first_radius, -first_radius);
  const BodyId b = disc("second", second, second_r, second_r);
  builder.add_contact("impact", a, b, LinearSpringDashpot{1.0, 0.0, EndRule::clamped},
                      CoulombFriction{setup.has("friction_halved") ? 0.5 * mu : mu, kappa});
  Scene scene = builder.at_rest();
  const double sense = setup.has("second_spin_reversed") ? -1.0 : 1.0;
  set_velocity(scene.model, scene.initial, a, {1.0, 0.0}, first_rim / first_radius);
  set_velocity(scene.model, scene.initial, b, {0.0, 0.0}, sense * second_rim / second_r);
  return scene;
}

reference::ObliqueImpact equivalent(double slip_rate) {
  return {.normal = {1.0, 0.0, reduced_mass, 1.0},
          .tangential_stiffness = kappa,
          .friction = mu,
          .mobility = 3.0,
          .slip_rate = slip_rate};
}

State end_of(Scene scene, double contact_time, double step, std::size_t phase, Findings& findings) {
  go_back(scene.initial, even_phases(fewest_phases)[phase] * step);
  const double steps = std::ceil(1.2 * contact_time / step) + 2.0;
  return run_scene(scene, VelocityVerlet{}, {step, step * steps, 1e9, true}, findings).state;
}

/// Slip rate, positive if the first rim moves up past the second, as at touch.
double slip_rate(const State& end) { return end.v[1] + first_radius * end.v[2] - end.v[4] + second_radius * end.v[5]; }

const double contact_time = std::numbers::pi * std::sqrt(reduced_mass);

struct Met {
  double mean{};
  double error{};  ///< rms error of the slip rate over the phases
  double
      impulse_difference{};  ///< largest relative difference between the impulses J computed from speeds and from spins
};

Met meet(double ratio, double count, const Setup& setup, Findings& findings) {
  const double before = ratio * mu / kappa;
  const reference::ObliqueRebound exact = reference::rebound(equivalent(before), reference::EndRule::clamped);
  const Scene scene = met_discs(second_mass, second_radius, 0.75 * before, 0.25 * before, setup);
  Met met;
  for (std::size_t phase = 0; phase < fewest_phases; ++phase) {
    const State end = end_of(scene, contact_time, offset_step(contact_time, count, phase), phase, findings);
    const double found = slip_rate(end), error = found - exact.slip_rate;
    met.mean += found / static_cast<double>(fewest_phases);
    met.error += error * error / static_cast<double>(fewest_phases);
    const double first = first_mass * end.v[1], second = second_mass * end.v[4];
    const double turned_first = 0.5 * first_mass * first_radius * (scene.initial.v[2] - end.v[2]);
    const double turned_second = 0.5 * second_mass * second_radius * (scene.initial.v[5] - end.v[5]);
    for (const double other : {-first, turned_first, turned_second})
      keep_largest(met.impulse_difference, other / second - 1.0);
  }
  met.error = std::sqrt(met.error);
  return met;
}

void check_unlike(Findings& findings, const Setup& setup) {
  Table table{.name = "spins",
              .caption =
                  "Slip rate after the impact of discs of different size over that before: exact and solver (velocity "
                  "Verlet, 100 steps per contact, mean of 64 phases). The unit of $v$ is $\\mu v_n k_n/k_s$.",
              .columns = {"v", "exact", "solver", "rms error over v_n"}};
  double farthest = 0.0, impulse_difference = 0.0;
  for (const double ratio : {0.25, 0.75, 1.5, 2.5, 4.0}) {
    const Met met = meet(ratio, 100.0, setup, findings);
    keep_largest(farthest, met.error), keep_largest(impulse_difference, met.impulse_difference);
    const double before = ratio * mu / kappa;
    const double exact = reference::rebound(equivalent(before), reference::EndRule::clamped).slip_rate;
    table.rows.push_back(cells("{:g} | {:.5f} | {:.5f} | {:.1e}", ratio, exact / before, met.mean / before, met.error));
  }
  const double h = std::numbers::pi / 100.0;
  findings.expect_truncation(
      {"unequal_spins", "rms error of the slip rate of discs of different size, largest of 5 spins"}, farthest, 0.0,
      0.054 * h * h, 1.2, "measured constant 0.054 (w h)^2, and a fifth for other phases");
  findings.expect_model(
      "impulses from speeds and spins of both discs, largest relative difference", impulse_difference, 0.0,
      0.5 * std::sqrt(reduced_mass) * (1.0 / first_radius + 1.0 / second_radius),
      "friction acts half-way through the overlap, at r - d/2 of each disc; d is at most that of the undamped impact");
  Convergence convergence;
  for (const double count : {50.0, 100.0, 200.0, 400.0})
    convergence.add(std::numbers::pi / count, meet(0.75, count, setup, findings).error);
  findings.expect_order({"order_slip_rate_unlike", "order of the slip rate of discs of different size"}, convergence,
                        1.85, 2.35,
                        "second order; stick and slip alternate within the contact, and their ends are kinks");
  if (!setup.coarse) findings.table(table);
}

/// Two equal rough discs released from rest with an overlap, in both disc engines: they separate without spin.
void check_let_go(Findings& findings) {
  const LinearSpringDashpot law{1e3, 0.0};
  const CoulombFriction friction{0.5, 300.0};
  double aside = 0.0, uneven = 0.0;
  const auto run = [&]<class System>(std::type_identity<System>) {
    DiscShapes shapes;
    Discs discs;
    for (const double side : {-1.0, 1.0}) {
      shapes.add(0.5, 1.0);
      discs.add(0.49 * side, 0.0, 0.0, 0.0);
    }
    System system{shapes, {}, law, 0.1, friction};
    system.begin(discs);
    const EulerCromerOf<Discs> method;
    for (int i = 0; i < 200; ++i)
      method.step(system, discs, 1e-3);
    for (const std::size_t i : {0U, 1U}) {
      keep_worst(aside, discs.vy[i]), keep_worst(aside, discs.spin[i]);
      // The kinetic energy of both, m v^2, equals the stored energy k d^2/2.
      const double speed = 0.02 * std::sqrt(0.5 * 1e3);
      keep_worst(uneven, std::abs(discs.vx[i]) / speed - 1.0);
    }
  };
  run(std::type_identity<DiscSystem<LinearSpringDashpot, CoulombFriction>>{});
  run(std::type_identity<FastDiscSystem<LinearSpringDashpot, CoulombFriction>>{});
  findings.expect_exact("rough discs released from rest: spin and lateral speed", aside, 0.0,
                        "the contact does not slip", "m/s, rad/s");
  const double wh = std::sqrt(2e3) * 1e-3;
  findings.expect_truncation("rough discs released from rest: relative error of the speed sqrt(k/(2 m)) d", uneven, 0.0,
                             wh * wh / 8.0, 1.2,
                             "the speed amplitude by symplectic Euler has an error of (w h)^2/8: its velocities are "
                             "those of half a step before");
}

void check_rolling(Findings& findings, const Setup& setup) {
  const Scene scene = met_discs(first_mass, first_radius, 2.0, -2.0, setup);
  const double time = std::numbers::pi * std::sqrt(0.5);
  const State end = end_of(scene, time, offset_step(time, 100.0, 5), 5, findings);
  const double changed = worst_of({std::abs(end.v[1]), std::abs(end.v[4]), std::abs(end.v[2] - scene.initial.v[2]),
                                   std::abs(end.v[5] - scene.initial.v[5])});
  findings.expect_round_off({"opposite_spins", "change of lateral speeds and spins of equal discs with opposite spins"},
                            changed, 0.0, 8.0 * 2.2e-16,
                            "rim speeds of 2, each a rounded product: a slip rate of 2 eps times 2 during the contact "
                            "time of 2.2, at k_s = 2/7, acts on each mass");
  findings.expect_truncation({"transferred_speed", "speed transferred to the struck one of two equal discs"}, end.v[3],
                             1.0, 0.06 * std::pow(std::numbers::pi / 100.0, 2), 1.2,
                             "undamped leapfrog contact: |e - 1| up to 0.12 (w h)^2, half of it for each disc");
}

void run(Findings& findings, const Setup& setup) {
  check_unlike(findings, setup);
  check_rolling(findings, setup);
  if (!setup.coarse) check_let_go(findings);
}

}  // namespace

Case definition() {
  return {.id = "spinning_discs",
          .title = "Impacts of spinning discs",
          .requirements = {{"C6", {"unequal_spins", "order_slip_rate_unlike"}},
                           {"Eq. 18", {"unequal_spins", "order_slip_rate_unlike", "opposite_spins"}},
                           {"law.linear_spring_dashpot", {"unequal_spins", "order_slip_rate_unlike"}},
                           {"shape.circle, pair.circle.circle",
                            {"unequal_spins", "order_slip_rate_unlike", "opposite_spins", "transferred_speed"}},
                           {"integrator.velocity_verlet", {"order_slip_rate_unlike"}}},
          .main_checks = {"unequal_spins", "impulses from speeds and spins of both discs, largest relative difference",
                          "order of the slip rate of discs of different size", "opposite_spins"},
          .source = "Chung & Ooi 2011, tests 7 and 8 (for spheres)",
          .faults = {{"friction_halved", "half the coefficient of friction", "unequal_spins"},
                     {"second_spin_reversed", "second spin with the wrong sign", "opposite_spins"}},
          .run = run};
}

}  // namespace talus::verification::problems::spinning_discs
