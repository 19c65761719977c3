#include "verification/problems/speed_accuracy/contact_ladder_findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/model/model_builder.hpp"
#include "verification/problems/speed_accuracy/fidelity_levels.hpp"
#include "verification/reference/bed_of_springs.hpp"
#include "verification/study/scene_run.hpp"

namespace talus::verification::problems {
namespace {

constexpr int phases = 16;  // of the first node from the line of impact
constexpr int per_node = 12;

/// The bed that holds the spring's energy at the depth that Table 2 allows, with the dashpot's share the same.
reference::BedOfSprings bed_for(const FenceNumbers& n, const reference::Impact& linear, double depth) {
  reference::BedOfSprings bed{n.rock_radius, 1.0, linear.damping / linear.stiffness};
  bed.stiffness = 0.5 * linear.stiffness * depth * depth / reference::bed_energy(bed, depth);
  return bed;
}

/// Rock and column, free and touching, by so many nodes of the rock or by one resultant (none).
Scene struck_column(const FenceNumbers& n, const LinearSpringDashpot& law, int nodes, double turned) {
  ModelBuilder builder{us};
  const BodyId rock = builder.add(Body{.name = "rock",
                                       .mobility = Mobility::free,
                                       .mass = n.rock_mass,
                                       .inertia = 0.4 * n.rock_mass * n.rock_radius * n.rock_radius,
                                       .shape = Circle{n.rock_radius},
                                       .p_WB = {n.half_width + n.rock_radius, 0.0},
                                       .angle = turned});
  const BodyId column = builder.add(Body{.name = "column",
                                         .mobility = Mobility::free,
                                         .mass = n.column_mass,
                                         .inertia = n.column_inertia,
                                         .shape = Rectangle{n.half_width, 4.0}});
  builder.add(Contact{.name = "impact",
                      .a = rock,
                      .b = column,
                      .law = law,
                      .method = nodes == 0 ? ContactMethod::resultant : ContactMethod::nodes,
                      .nodes = {std::max(nodes, 12), 4}});
  Scene scene{.title = "Rock against a free column", .model = builder.build()};
  scene.initial = rest_state(scene.model);
  set_velocity(scene.model, scene.initial, rock, {-n.speed, 0.0}, 0.0);
  return scene;
}

struct Blow {
  double exit{};  ///< speed of the rock [ft/s]
  double push{};  ///< largest force [lb]
  double evaluations{};
};

Blow blow(const Scene& scene, double end, Findings& findings) {
  Probe probe{scene.model};
  Blow found;
  const Watcher watch = [&](const State& state, const StepInfo&) {
    probe.look(state);
    found.push = std::max(found.push, probe.forces().contacts[0]);
  };
  const double interval = end / 2000.0;
  const RunEnd run =
      run_scene(scene, make_integrator("stormer_cowell", 1e-7), {interval, end, interval, false}, findings, watch);
  found.exit = -run.state.v[0];
  found.evaluations = static_cast<double>(run.evaluations);
  return found;
}

/// Misses of all phases with so many nodes.
struct Nodes {
  PhaseError exit, push;
  double evaluations{};  ///< mean
};

struct Exact {
  double exit{};
  double push{};
};

Nodes blows(const FenceNumbers& n, const reference::BedOfSprings& bed, const Exact& exact, int count, double end,
            const Setup& setup, Findings& findings) {
  const int sharing = setup.has("stiffness_per_node") ? per_node : count;
  const double stiffness = bed.stiffness * 2.0 * std::numbers::pi * n.rock_radius / sharing;
  const LinearSpringDashpot law{stiffness, bed.relaxation * stiffness, EndRule::clamped};
  Nodes found;
  for (const double phase : even_phases(phases)) {
    const Blow now = blow(struck_column(n, law, count, 2.0 * std::numbers::pi * phase / count), end, findings);
    found.exit.add(now.exit / exact.exit - 1.0);
    found.push.add(now.push / exact.push - 1.0);
    found.evaluations += now.evaluations / phases;
  }
  return found;
}

}  // namespace

void check_contact_ladder(Findings& findings, const Setup& setup) {
  const scenes::Fence fence = ladder_fence(0.0);
  const FenceNumbers n = fence_numbers(fence);
  const reference::Impact linear = soft_impact(n, n.column_mass);
  const reference::BedOfSprings bed = bed_for(n, linear, fence.rock_overlap);
  const reference::BedImpact impact = reference::bed_impact(bed, linear.effective_mass, n.speed);
  FenceNumbers like_bed = n;
  like_bed.restitution = impact.restitution;
  const Exact exact{speed_by_formula(like_bed, n.column_mass), impact.largest_force};
  const reference::ImpactEvents events = reference::impact_events(linear, reference::EndRule::clamped);
  const double end = 3.0 * events.contact_time;  // a bed is softer at first and lasts longer

  Table table{.name = "contacts",
              .caption =
                  "The contact alone, against the bed of springs: root mean square and largest miss over 16 "
                  "turns of the rock. The formula takes e = .4, which the bed's dashpots, of the same share, do "
                  "not give.",
              .columns = {"contact", "evaluations", "springs", "speed, rms", "largest", "push, rms", "largest"}};
  const double formula = speed_by_formula(n, n.column_mass);
  table.rows.push_back(
      {"formula", "0", "0", fmt::format("{:.2} %", 100.0 * std::abs(formula / exact.exit - 1.0)), "", "-", "-"});
  const Blow single =
      blow(struck_column(n, {linear.stiffness, linear.damping, EndRule::clamped}, 0, 0.0), end, findings);
  findings.expect("one resultant: speed, by the formula", single.exit, formula,
                  Tolerance::truncation(6.5e-7, 1.0,
                                        "a prediction may miss 1e-7 of the largest speed; what is corrected is of an "
                                        "order more: a tenth"),
                  "ft/s");
  findings.expect("one resultant: push, by its closed form", single.push, events.largest_force,
                  Tolerance::truncation(2e-5, 1.0,
                                        "read every .0015 of the contact time, up to half of that beside the peak: "
                                        "(w h)^2/8 with w h = .0045 is 3e-6; the steps' own 1e-7 at the speed's share")
                      .relative(),
                  "lb");
  Series speeds{.label = "speed, nodes"}, pushes{.label = "push, nodes"};
  Convergence speed_errors, push_errors;
  table.rows.push_back({"one resultant", fmt::format("{:.0f}", single.evaluations), "1",
                        fmt::format("{:.2} %", 100.0 * std::abs(single.exit / exact.exit - 1.0)), "",
                        fmt::format("{:.3} %", 100.0 * std::abs(single.push / exact.push - 1.0)), ""});
  double coarsest = 0.0;
  for (const int count : {12, 24, 48, 96, 192}) {
    if (setup.coarse && count == 12) continue;
    const Nodes found = blows(n, bed, exact, count, end, setup, findings);
    if (count == 12) {
      coarsest = found.exit.rms();
    } else {
      speed_errors.add(1.0 / count, found.exit.rms());
      push_errors.add(1.0 / count, found.push.rms());
    }
    speeds.add(found.evaluations * count, found.exit.rms());
    pushes.add(found.evaluations * count, found.push.rms());
    table.rows.push_back(
        {fmt::format("{} nodes", count), fmt::format("{:.0f}", found.evaluations), fmt::format("{}", count),
         fmt::format("{:.2} %", 100.0 * found.exit.rms()), fmt::format("{:.2} %", 100.0 * found.exit.max()),
         fmt::format("{:.3} %", 100.0 * found.push.rms()), fmt::format("{:.3} %", 100.0 * found.push.max())});
  }
  findings.expect_order(
      "order of the push in the spacing of the nodes", push_errors, 0.7, 1.3,
      "1: the next node's dashpot sets in with a jump of c v or not; less where only a few of the teeth "
      "share the top");
  findings.expect_order("order of the speed in the spacing of the nodes", speed_errors, 2.2, 3.3,
                        "5/2: what a node at the rim takes is c v^2 over a short time, and v there falls with the root "
                        "of its depth; 3 where the rock's spin, of order 3/2 by its lopsided nodes, takes more");
  if (setup.coarse) return;
  const double single_miss = std::abs(single.exit / exact.exit - 1.0);
  findings.expect_between("12 nodes: miss of the speed over that of one resultant", coarsest / single_miss, 1.0, 10.0,
                          "their spacing, .50 ft, is more than half of the .68 ft of outline that touches: one or two "
                          "nodes act. By the spacing alone the speed is uncertain by a few times (.50/.68)^(5/2) of "
                          "the dashpot's share of it, a tenth");
  findings.table(table);
  findings.figure(
      {.name = "contacts",
       .title = "What a contact misses against what it costs",
       .caption = "12 to 192 nodes (rms over 16 turns of the rock), and one resultant, from the bed of "
                  "springs.",
       .x = {.label = "force evaluations times springs", .log = true},
       .y = {.label = "miss", .unit = "1", .log = true},
       .series = {
           speeds,
           pushes,
           {"speed, one resultant", {single.evaluations}, {single_miss}, Style::crosses},
           {"push, one resultant", {single.evaluations}, {std::abs(single.push / exact.push - 1.0)}, Style::crosses}}});
}

}  // namespace talus::verification::problems
