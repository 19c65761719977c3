#include "verification/reference/many_bodies/struck_row.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::cradle {
namespace {

constexpr double disc_radius = 4.0;

Scene row_scene(const reference::StruckRow& row, double lead, const Setup& setup) {
  SceneBuilder builder;
  std::array<BodyId, 3> discs{};
  const double farther = setup.has("third_disc_farther") ? 1e-3 : 0.0;
  for (int i = 0; i < 3; ++i) {
    const double x = 2.0 * disc_radius * i - (i == 0 ? lead : 0.0) + (i == 2 ? row.gap + farther : 0.0);
    discs[static_cast<std::size_t>(i)] = builder.add_particle(
        fmt::format("disc{}", i + 1), i == 1 && setup.has("middle_heavier") ? 1.01 * row.mass : row.mass, {x, 0.0},
        Circle{disc_radius});
  }
  const double second = setup.has("second_contact_stiffer") ? 1.02 : 1.0;
  const LinearSpringDashpot law{row.stiffness, 0.0, EndRule::clamped};
  builder.add_contact("first", discs[0], discs[1], law);
  builder.add_contact("second", discs[1], discs[2], LinearSpringDashpot{second * row.stiffness, 0.0, EndRule::clamped});
  Scene scene = builder.at_rest("Three discs in a row");
  set_velocity(scene.model, scene.initial, discs[0], {row.speed, 0.0}, 0.0);
  return scene;
}

struct RowRun {
  std::array<double, 3> velocity{};
  double momentum_error{};
  double energy_error{};  ///< relative
};

RowRun run_row(const reference::StruckRow& row, const Phase& phase, double end, Findings& findings,
               const Setup& setup) {
  const Scene scene = row_scene(row, phase.lead() * row.speed, setup);
  const State state =
      run_scene(scene, VelocityVerlet{}, {phase.step, phase.lead() + end, phase.step, false}, findings).state;
  const std::array v{state.v[0], state.v[2], state.v[4]};
  return {v, v[0] + v[1] + v[2] - row.speed, (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) / (row.speed * row.speed) - 1.0};
}

/// Root-mean-square error of the three velocities over 64 phases, relative to v.
double velocity_error(const reference::StruckRow& row, double steps, Findings& findings, const Setup& setup) {
  const reference::RowRebound exact = reference::rebound(row);
  PhaseError error;
  for (const Phase& phase : offset_phases(std::numbers::pi, steps)) {
    const RowRun found = run_row(row, phase, exact.end_time + 4.0 * phase.step, findings, setup);
    for (std::size_t d = 0; d < 3; ++d)
      error.add((found.velocity[d] - exact.velocity[d]) / row.speed);
  }
  return error.rms();
}

constexpr reference::StruckRow touching{1.0, 1.0, 1.0, 0.0};

void check_gaps(Findings& findings, const Setup& setup) {
  const double limit = std::numbers::pi / (2.0 * std::sqrt(2.0));
  Table table{.name = "speeds",
              .caption =
                  "Exact speeds after the impact, and the solver's errors at 100 steps per $\\pi\\sqrt{m/k}$ (root "
                  "mean square over 64 phases and three discs).",
              .columns = {"gap", "v1", "v2", "v3", "error"}};
  for (const double gap : {0.0, 0.1, 0.4, 1.2}) {
    if (setup.coarse && gap > 0.1) break;
    const reference::StruckRow row{1.0, 1.0, 1.0, gap};
    const auto exact = reference::rebound(row).velocity;
    const double error = velocity_error(row, 100.0, findings, setup);
    table.rows.push_back(cells("{:g} | {:.5f} | {:.5f} | {:.5f} | {:.2e}", gap, exact[0], exact[1], exact[2], error));
    findings.expect_truncation({"speeds", fmt::format("speeds of the three discs, gap {:g}, rms error", gap)}, error,
                               0.0, 0.7 / (100.5 * 100.5), 1.5,
                               "measured over four octaves of steps at gap 0: 0.69 divided by the square of the number "
                               "of steps; the errors at other gaps are slightly smaller");
  }
  findings.table(table);
  const auto beyond = reference::rebound({1.0, 1.0, 1.0, 1.001 * limit}).velocity;
  const auto within = reference::rebound({1.0, 1.0, 1.0, 0.9 * limit}).velocity;
  findings.expect_round_off("exact speed of the first disc, gap above pi v/(2 w)", beyond[0], 0.0, 1e-45,
                            "zero in 50 digits, of numbers up to one, in a few dozen operations");
  findings.expect_true("exact speed of the first disc is not zero, gap below pi v/(2 w)", std::abs(within[0]) > 1e-6,
                       "the second disc meets the third while the first still pushes it");
}

void check_order(Findings& findings, const Setup& setup) {
  const Convergence found = convergence(doublings(16.0, setup.coarse ? 3 : 5), [&](double n) {
    return std::pair{1.0 / n, velocity_error(touching, n, findings, setup)};
  });
  findings.expect_order(
      {"order_touching", "order of the error of the speeds, touching discs"}, found, 1.9, 2.1,
      "the forces are continuous; their slopes jump at touch and opening, which gives an error of h^2");
  findings.figure({.name = "error",
                   .title = "Error of the speeds against the step",
                   .caption = "Three discs that touch, root mean square over 64 phases.",
                   .x = {.label = "step / (pi sqrt(m/k))", .log = true},
                   .y = {.label = "error / v", .log = true},
                   .series = {{"solver", found.steps(), found.errors(), Style::points}},
                   .slopes = {{2.0, 1.0 / 64.0, 1e-4, "h^2"}}});
}

void check_accounts(Findings& findings, const Setup& setup) {
  const RowRun found = run_row(touching, {0, std::numbers::pi / 100.4, 0.3}, 8.0, findings, setup);
  findings.expect_round_off("momentum error of the three discs", found.momentum_error, 0.0, 4e-15,
                            "at most 512 half kicks round three speeds below 1, each by 3.2e-17 rms: sqrt(1536) x "
                            "3.2e-17 = 1.3e-15, three times that for the worst");
}

void show_speeds(Findings& findings, const Setup& setup) {
  std::array<Series, 3> lines{Series{"1", {}, {}, Style::lines}, Series{"2", {}, {}, Style::lines},
                              Series{"3", {}, {}, Style::lines}};
  Series points{"solver", {}, {}, Style::points};
  for (double gap = 0.0; gap < 1.41; gap += 0.05) {
    const auto exact = reference::rebound({1.0, 1.0, 1.0, gap}).velocity;
    for (std::size_t d = 0; d < 3; ++d)
      lines[d].add(gap, exact[d]);
  }
  for (double gap = 0.0; gap < 1.41; gap += 0.2) {
    const RowRun found = run_row({1.0, 1.0, 1.0, gap}, {0, 0.02, 0.3}, 8.0, findings, setup);
    for (const double v : found.velocity)
      points.add(gap, v);
  }
  findings.figure({.name = "gaps",
                   .title = "Soft discs transfer the full speed only across a gap",
                   .caption = "Speeds after the impact against the gap between second and third disc.",
                   .x = {.label = "gap / (v sqrt(m/k))"},
                   .y = {.label = "speed / v"},
                   .series = {lines[0], lines[1], lines[2], points},
                   .lines = {{'x', std::numbers::pi / (2.0 * std::sqrt(2.0)), "rigid balls"}}});
}

void run(Findings& findings, const Setup& setup) {
  check_gaps(findings, setup);
  check_order(findings, setup);
  check_accounts(findings, setup);
  if (!setup.coarse) show_speeds(findings, setup);
}

}  // namespace

Case definition() {
  return {
      .id = "cradle",
      .title = "Newton's cradle of three discs",
      .requirements = {{"B8", {"speeds", "order_touching", "momentum error of the three discs"}},
                       {"law.linear_spring_dashpot, shape.circle", {"speeds"}},
                       {"integrator.velocity_verlet", {"order_touching"}},
                       {"pair.circle.circle", {"speeds"}}},
      .main_checks = {"speeds of the three discs, gap 0, rms error", "order_touching"},
      .source = "Herrmann & Seitz, Am. J. Phys. 50 (1982) 977",
      .faults = {{"middle_heavier", "the middle disc is 1 % heavier", "speeds of the three discs, gap 0, rms error"},
                 {"second_contact_stiffer", "the second contact is 2 % stiffer", "order_touching"},
                 {"third_disc_farther", "the third disc is farther away by 0.001",
                  "speeds of the three discs, gap 0.1, rms error"}},
      .run = run};
}

}  // namespace talus::verification::problems::cradle
