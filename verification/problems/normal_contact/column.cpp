#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "solver/model/model_builder.hpp"
#include "solver/run/simulate.hpp"
#include "solver/scenes/scene.hpp"
#include "verification/check/case.hpp"
#include "verification/reference/pressed_discs.hpp"

namespace talus::verification::problems {

Case column();

namespace {

constexpr int discs = 10;
constexpr double mass = 2.0, gravity = 1.0, stiffness = 512.0, unit_time = 0.0625;  // sqrt(m/k)

enum class Start { apart, pressed };

Scene column_scene(Start start, const Setup& setup) {
  ModelBuilder builder;
  builder.gravity({0.0, -gravity});
  const double xi = 0.5;
  const LinearSpringDashpot law{stiffness, 2.0 * xi * std::sqrt(stiffness * mass), EndRule::clamped};
  BodyId below = builder.add(Body{.name = "ground", .mobility = Mobility::fixed, .shape = HalfPlane{}});
  const double spacing = start == Start::apart ? 2.001 : 1.93;
  for (int i = 0; i < discs; ++i) {
    const bool lighter = setup.has("top_disc_lighter") && i == discs - 1;
    const BodyId disc = builder.add(Body{.name = fmt::format("disc{}", i + 1),
                                         .mobility = Mobility::particle,
                                         .mass = lighter ? (1.0 - 1e-9) * mass : mass,
                                         .shape = Circle{1.0},
                                         .p_WB = {0.0, 1.0 + spacing * i}});
    LinearSpringDashpot own = law;
    if (setup.has("one_contact_softer") && i == 4) own.stiffness *= 1.0 - 1e-9;
    builder.add(Contact{.name = fmt::format("contact{}", i + 1), .a = below, .b = disc, .law = own});
    below = disc;
  }
  Scene scene{.title = "Column of discs", .model = builder.build()};
  scene.initial = rest_state(scene.model);
  return scene;
}

struct Standing {
  std::vector<double> overlaps;  ///< from the ground up
  std::vector<double> forces;
  std::vector<double> time, base;  ///< force on the ground, a hundred times
};

Standing settle(Start start, Findings& findings, const Setup& setup) {
  const Scene scene = column_scene(start, setup);
  const Dynamics dynamics{scene.model};
  RigidBodySystem system{dynamics, false};
  const double w1 = reference::column_frequency(discs, mass, stiffness);
  const double rate = 0.5 * w1 * w1 * unit_time;
  const double end = (setup.has("stopped_early") ? 10.0 : 30.0) / rate, step = 0.2 * unit_time;
  State state = scene.initial;
  Workspace work = dynamics.workspace();
  LawForces forces;
  Standing found;
  const Observer observer = [&](const State& seen, const StepInfo& info) {
    if (!info.due) return;
    dynamics.update_all(seen, work);
    dynamics.forces(seen, work, forces);
    found.time.push_back(seen.t);
    found.base.push_back(forces.contacts[0]);
  };
  Integrator verlet = VelocityVerlet{};
  const Outcome outcome = simulate(system, verlet, state, {step, end, end / 400.0, false}, {&observer, 1});
  findings.count(static_cast<std::uint64_t>(system.evaluations()));
  dynamics.update_all(state, work);
  dynamics.forces(state, work, forces);
  for (int i = 0; i < discs; ++i)
    found.overlaps.push_back(outcome ? dynamics.contact_depth(work, static_cast<ContactId>(i)) : NAN);
  found.forces = forces.contacts;
  return found;
}

void run(Findings& findings, const Setup& setup) {
  const auto exact = reference::column_overlaps(discs, mass, gravity, stiffness);
  Series history[2] = {{"set down apart", {}, {}, Style::lines}, {"pressed together", {}, {}, Style::lines}};
  Series overlaps{"solver", {}, {}, Style::points}, line{"exact", {}, {}, Style::lines};
  for (const Start start : {Start::apart, Start::pressed}) {
    const char* word = start == Start::apart ? "set down apart" : "pressed together";
    const Standing found = settle(start, findings, setup);
    double worst = 0.0, worst_force = 0.0;
    for (std::size_t i = 0; i < discs; ++i) {
      const double error = found.overlaps[i] - exact[i], force = found.forces[i] - stiffness * exact[i];
      if (!(std::abs(error) <= std::abs(worst))) worst = error;
      if (!(std::abs(force) <= std::abs(worst_force))) worst_force = force;
      if (start == Start::apart) {
        overlaps.x.push_back(static_cast<double>(i) + 1.0);
        overlaps.y.push_back(found.overlaps[i]);
        line.x.push_back(static_cast<double>(i) + 1.0);
        line.y.push_back(exact[i]);
      }
    }
    findings.expect(fmt::format("overlaps of ten contacts, {}, largest error", word), worst, 0.0,
                    Tolerance::round_off(1.2e-14,
                                         "positions up to 20 are rounded to 3.6e-15; a disc stays where less than that "
                                         "is left to go in a step, three of which are admitted"));
    findings.expect(fmt::format("forces of ten contacts, {}, largest error", word), worst_force, 0.0,
                    Tolerance::round_off(512.0 * 1.2e-14, "k times that of the overlaps"));
    Series& base = history[start == Start::apart ? 0 : 1];
    for (std::size_t i = 0; i < found.time.size() && found.time[i] < 30.0; ++i) {
      base.x.push_back(found.time[i]);
      base.y.push_back(found.base[i]);
    }
  }
  if (setup.coarse) return;
  findings.figure({.name = "overlaps",
                   .title = "A column at rest",
                   .caption = "Overlaps from the ground up.",
                   .x = {.label = "contact"},
                   .y = {.label = "overlap", .min = 0.0},
                   .series = {line, overlaps}});
  findings.figure({.name = "settling",
                   .title = "On the way to rest",
                   .caption = "Force on the ground against time from both starts; the line is the weight.",
                   .x = {.label = "time"},
                   .y = {.label = "force on the ground"},
                   .series = {history[0], history[1]},
                   .lines = {{'y', discs * mass * gravity, "weight"}}});
}

}  // namespace

Case column() {
  return {.id = "column",
          .title = "A column at rest",
          .requirements = {{"B9", {"overlaps of ten contacts", "forces of ten contacts"}},
                           {"law.linear_spring_dashpot", {"forces of ten contacts"}},
                           {"end_rule.clamped", {"forces of ten contacts"}},
                           {"shape.circle", {"overlaps"}},
                           {"shape.half_plane", {"overlaps"}},
                           {"pair.circle.circle", {"overlaps"}},
                           {"pair.circle.half_plane", {"overlaps"}}},
          .main_checks = {"overlaps of ten contacts, set down apart, largest error"},
          .source = "Textbook statics",
          .faults = {{"top_disc_lighter", "the top disc lighter by 1e-9",
                      "overlaps of ten contacts, set down apart, largest error"},
                     {"one_contact_softer", "one contact softer by 1e-9",
                      "overlaps of ten contacts, pressed together, largest error"},
                     {"stopped_early", "a third of the time to come to rest",
                      "forces of ten contacts, set down apart, largest error"}},
          .run = run};
}

}  // namespace talus::verification::problems
