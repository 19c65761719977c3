#include "verification/reference/many_bodies/pressed_discs.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::column {
namespace {

constexpr int discs = 10;
constexpr double mass = 2.0, gravity = 1.0, stiffness = 512.0, unit_time = 0.0625;  // sqrt(m/k)

Scene column_scene(double spacing, const Setup& setup) {
  SceneBuilder builder;
  builder.gravity({0.0, -gravity});
  BodyId below = builder.add_fixed("ground", HalfPlane{});
  for (int i = 1; i <= discs; ++i) {
    const double lighter = setup.has("top_disc_lighter") && i == discs ? 1.0 - 1e-9 : 1.0;
    const double softer = setup.has("one_contact_softer") && i == 5 ? 1.0 - 1e-9 : 1.0;
    const LinearSpringDashpot law{softer * stiffness, std::sqrt(stiffness * mass), EndRule::clamped};
    const Vec2 position{0.0, 1.0 + spacing * (i - 1)};
    const BodyId disc = builder.add_particle(fmt::format("disc{}", i), lighter * mass, position, Circle{1.0});
    builder.add_contact(fmt::format("contact{}", i), below, disc, law);
    below = disc;
  }
  return builder.at_rest("Column of discs");
}

/// Runs the column until it is at rest, checks overlaps and forces there, and returns the force on the ground over
/// time.
Series check_rest(const std::string& start, double spacing, Findings& findings, const Setup& setup) {
  const Scene scene = column_scene(spacing, setup);
  const double w1 = reference::column_frequency(discs, mass, stiffness), rate = 0.5 * w1 * w1 * unit_time;
  const double end = (setup.has("stopped_early") ? 10.0 : 30.0) / rate;
  Series base{.label = start, .style = Style::lines};
  Probe probe{scene.model};
  const Watcher watch = [&](const State& state, const StepInfo& info) {
    if (!info.due || state.t >= 30.0) return;
    probe.evaluate(state);
    base.add(state.t, probe.forces().contacts[0]);
  };
  const RunEnd run = run_scene(scene, VelocityVerlet{}, {0.2 * unit_time, end, end / 400.0, false}, findings, watch);
  probe.evaluate(run.state);
  std::vector<double> overlaps, exact = reference::column_overlaps(discs, mass, gravity, stiffness), forces = exact;
  for (std::size_t i = 0; i < discs; ++i)
    overlaps.push_back(probe.overlap(i)), forces[i] *= stiffness;
  expect_each(findings, {"overlaps/" + start, fmt::format("overlaps of ten contacts, {}, largest error", start)},
              overlaps, exact,
              Tolerance::round_off(1.2e-14,
                                   "positions up to 20 are rounded to 3.6e-15; a disc stops once its displacement in a "
                                   "step is smaller than that; three times that is allowed"));
  expect_each(findings, {"forces/" + start, fmt::format("forces of ten contacts, {}, largest error", start)},
              probe.forces().contacts, forces,
              Tolerance::round_off(512.0 * 1.2e-14, "k times the bound of the overlaps"));
  if (start == "set down apart" && !setup.coarse) {
    const std::vector<double> contacts = multiples(1.0, 1, discs);
    findings.figure({.name = "overlaps",
                     .title = "A column at rest",
                     .caption = "Overlaps of the contacts, numbered from the ground up.",
                     .x = {.label = "contact"},
                     .y = {.label = "overlap", .min = 0.0},
                     .series = {as_line(points("exact", contacts, exact)), points("solver", contacts, overlaps)}});
  }
  return base;
}

void run(Findings& findings, const Setup& setup) {
  const Series apart = check_rest("set down apart", 2.001, findings, setup);
  const Series pressed = check_rest("pressed together", 1.93, findings, setup);
  if (setup.coarse) return;
  findings.figure({.name = "settling",
                   .title = "Approach to rest",
                   .caption = "Force on the ground against time from both initial states; the line is the weight.",
                   .x = {.label = "time"},
                   .y = {.label = "force on the ground"},
                   .series = {apart, pressed},
                   .lines = {{'y', discs * mass * gravity, "weight"}}});
}

}  // namespace

Case definition() {
  return {
      .id = "column",
      .title = "Column of discs at rest",
      .requirements = {{"B9", {"overlaps", "forces"}},
                       {"pair.circle.circle, pair.circle.half_plane, shape.circle, shape.half_plane", {"overlaps"}}},
      .checks_of_runs = {"overlaps", "forces"},
      .main_checks = {"overlaps/set down apart"},
      .source = "Textbook statics",
      .faults = {{"top_disc_lighter", "the top disc is lighter by 1e-9", "overlaps/set down apart"},
                 {"one_contact_softer", "one contact is softer by 1e-9", "overlaps/pressed together"},
                 {"stopped_early", "the run ends after a third of the time", "forces/set down apart"}},
      .run = run};
}

}  // namespace talus::verification::problems::column
