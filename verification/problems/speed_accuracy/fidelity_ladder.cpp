#include "verification/problems/speed_accuracy/fidelity_levels.hpp"
#include "verification/problems/speed_accuracy/fidelity_rungs.hpp"
#include "verification/reference/impacts/bed_of_springs.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::fidelity_ladder {
namespace {

constexpr int phases = 16;  // of the first node from the line of impact
constexpr int per_node = 12;

/// The bed of springs with the same stored energy as the linear spring at the overlap that Table 2 allows, and the same
/// ratio of dashpot to spring.
reference::BedOfSprings bed_for(const FenceNumbers& n, const reference::Impact& linear, double depth) {
  reference::BedOfSprings bed{n.rock_radius, 1.0, linear.damping / linear.stiffness};
  bed.stiffness = 0.5 * linear.stiffness * depth * depth / reference::bed_energy(bed, depth);
  return bed;
}

/// Rock and column, free and touching, with `nodes` nodes of the rock, or with one resultant if `nodes` is 0.
Scene struck_column(const FenceNumbers& n, const LinearSpringDashpot& law, int nodes, double turned) {
  SceneBuilder builder{us};
  const BodyId rock = builder.add_free("rock", n.rock_mass, 0.4 * n.rock_mass * n.rock_radius * n.rock_radius,
                                       Circle{n.rock_radius}, {n.half_width + n.rock_radius, 0.0}, turned);
  const BodyId column = builder.add_free("column", n.column_mass, n.column_inertia, Rectangle{n.half_width, 4.0});
  builder.add(Contact{.name = "impact",
                      .a = rock,
                      .b = column,
                      .law = law,
                      .method = nodes == 0 ? ContactMethod::resultant : ContactMethod::nodes,
                      .nodes = {std::max(nodes, 12), 4}});
  Scene scene = builder.at_rest("Rock against a free column");
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
    probe.evaluate(state);
    found.push = std::max(found.push, probe.forces().contacts[0]);
  };
  const double interval = end / 2000.0;
  const RunEnd run =
      run_scene(scene, make_integrator("stormer_cowell", 1e-7), {interval, end, interval, false}, findings, watch);
  found.exit = -run.state.v[0];
  found.evaluations = static_cast<double>(run.evaluations);
  return found;
}

/// Relative errors over all phases with a given number of nodes.
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

/// Checks the impact on a free column by the formula, one resultant, and 12 to 192 nodes against the bed of springs.
/// Fault `stiffness_per_node`.
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
  const double end = 3.0 * events.contact_time;  // a bed is softer at first, so that its contact lasts longer

  Table table{.name = "contacts",
              .caption =
                  "The contact alone, compared with the bed of springs: root mean square and largest error over 16 "
                  "rotations of the rock. The formula uses e = 0.4, which the bed's dashpots, in the same ratio to the "
                  "springs, do not give.",
              .columns = {"contact", "evaluations", "springs", "speed, rms", "largest", "peak force, rms", "largest"}};
  const double formula = speed_by_formula(n, n.column_mass);
  table.rows.push_back(
      {"formula", "0", "0", fmt::format("{:.2} %", 100.0 * std::abs(formula / exact.exit - 1.0)), "", "-", "-"});
  const Blow single =
      blow(struck_column(n, {linear.stiffness, linear.damping, EndRule::clamped}, 0, 0.0), end, findings);
  findings.expect_truncation({"resultant_speed", "one resultant: speed against the formula"}, single.exit, formula,
                             6.5e-7, 1.0,
                             "a prediction may have an error of 1e-7 of the largest speed; the corrected value is more "
                             "accurate by one order: a tenth",
                             "ft/s");
  findings.expect({"resultant_force", "one resultant: peak force against its closed form"}, single.push,
                  events.largest_force,
                  Tolerance::truncation(2e-5, 1.0,
                                        "sampled every 0.0015 of the contact time, up to half of that beside the peak: "
                                        "(w h)^2/8 with w h = 0.0045 is 3e-6; the steps add 1e-7 of the speed")
                      .relative(),
                  "lb");
  Series speeds{.label = "speed, nodes"}, pushes{.label = "peak force, nodes"};
  Convergence speed_errors, push_errors;
  table.rows.push_back(cells("one resultant | {:.0f} | 1 | {:.2} % |  | {:.3} % | ", single.evaluations,
                             100.0 * std::abs(single.exit / exact.exit - 1.0),
                             100.0 * std::abs(single.push / exact.push - 1.0)));
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
  findings.expect_order({"order_of_force", "order of the peak force in the node spacing"}, push_errors, 0.7, 1.3,
                        "first order: the dashpot of the next node sets in with a jump of c v or not; less where only "
                        "a few nodes form the peak");
  findings.expect_order(
      {"order_of_speed", "order of the speed in the node spacing"}, speed_errors, 2.2, 3.3,
      "5/2: a node at the rim dissipates c v^2 over a short time, and v there falls with the root of its overlap; 3 "
      "where the rock's spin, of order 3/2 because its nodes are not symmetric, takes more");
  if (setup.coarse) return;
  const double single_miss = std::abs(single.exit / exact.exit - 1.0);
  findings.expect_between(
      {"twelve_nodes", "12 nodes: speed error over that of one resultant"}, coarsest / single_miss, 1.0, 10.0,
      "their spacing, 0.50 ft, is more than half of the 0.68 ft of outline in contact: one or two nodes act. From the "
      "spacing alone the speed is uncertain by a few times (0.50/0.68)^(5/2) of the dashpot's contribution, a tenth");
  findings.table(table);
  findings.figure(
      {.name = "contacts",
       .title = "Error of a contact model against its cost",
       .caption =
           "12 to 192 nodes (rms over 16 rotations of the rock) and one resultant, compared with the bed of springs.",
       .x = {.label = "force evaluations times springs", .log = true},
       .y = {.label = "error", .unit = "1", .log = true},
       .series = {speeds,
                  pushes,
                  {"speed, one resultant", {single.evaluations}, {single_miss}, Style::crosses},
                  {"peak force, one resultant",
                   {single.evaluations},
                   {std::abs(single.push / exact.push - 1.0)},
                   Style::crosses}}});
}

/// Checks the free pair and the hung column against the formula.
void check_formula(Findings& findings, const Setup& setup) {
  const FenceNumbers n = fence_numbers(ladder_fence(0.0));
  const auto mass = [&](double with_arm) { return setup.has("arm_forgotten") ? n.column_mass : with_arm; };
  for (const double height : {0.0, 1.5}) {
    const FenceNumbers here = fence_numbers(ladder_fence(height));
    findings.expect_truncation(fmt::format("free pair, {} ft off centre: speed against the formula", height),
                               passage(free_pair(here, height), tight, findings).exit,
                               speed_by_formula(here, mass(free_column_mass(here, height))), 65.0 * tight, 1.0,
                               "exact for a free pair; one step may have an error of 1e-10 of the largest speed",
                               "ft/s");
  }
  findings.expect_model(
      {"hung_column", "hung column: speed against the formula with I_p/h^2"},
      passage(hung_column(n, 0.0), tight, findings).exit, speed_by_formula(n, mass(hung_column_mass(n, 0.0))), 0.18,
      "during the contact the column rotates by 0.0115 rad, which moves the line of force 2.2 ft x 0.0115 closer to "
      "the pin: 0.39 % of h, 0.78 % of the mass, 0.18 ft/s if it applied from the start",
      "ft/s");
}

/// Checks the largest tension of the particle on cables against the value from its energy.
void check_particles(Findings& findings, const Setup& setup) {
  const FenceNumbers n = fence_numbers(ladder_fence(0.0));
  const double mass = n.column_mass;
  const double struck = (1.0 + n.restitution) * n.speed * n.rock_mass / (n.rock_mass + mass);
  for (const Held held : {Held::neighbours, Held::ends}) {
    const double length = held == Held::ends ? n.half_span : n.segment;
    findings.expect(
        fmt::format("particle on cables to the {}: largest tension against its energy",
                    held == Held::ends ? "ends" : "neighbours"),
        passage(particle_on_cables(n, 0.0, held, setup), tight, findings).pull,
        std::sqrt(n.first_tension * n.first_tension + 0.5 * n.cable_modulus / length * mass * struck * struck),
        Tolerance::model(
            5e-4,
            "the contact transmits the small effect of the cables during it: an impulse of 0.8 lb s compared with the "
            "column's 754, of which the column gives back at most a half, the part transmitted to the rock")
            .relative(),
        "lb");
  }
}

/// Speed lost to the cables during the contact, from the closed form of the free pair: their impulse over the sum of
/// both masses [L/T].
double speed_taken_by_cables(const FenceNumbers& n) {
  const reference::Impact impact = soft_impact(n, n.column_mass);
  const double last = reference::impact_events(impact, reference::EndRule::clamped).contact_time;
  const double both = n.rock_mass + n.column_mass, ratio = n.rock_mass / both;
  constexpr int parts = 1000;
  double impulse = 0.0;
  for (int i = 0; i < parts; ++i) {
    const double t = (i + 0.5) * last / parts;
    const double x = ratio * (n.speed * t - reference::depth_at(impact, t).depth);
    const double length = std::hypot(n.segment, x);
    const double tension = n.first_tension + n.cable_modulus / n.segment * (length - n.segment);
    impulse += 2.0 * tension * x / length * last / parts;
  }
  return impulse / both;
}

void check_fences(Findings& findings, const Setup& setup) {
  Scene half_scene = fence_of(0.0, 1, scenes::FenceSymmetry::half);
  if (setup.has("half_column")) {
    Body& centre = half_scene.model.bodies[index(*find_body(half_scene.model, "column1"))];
    centre.mass *= 0.5, centre.inertia *= 0.5;
  }
  const Scene full_scene = fence_of(0.0, 1, scenes::FenceSymmetry::full);
  const Passage half = passage(half_scene, tight, findings), full = passage(full_scene, tight, findings);
  double apart = 0.0;
  for (const Body& body : half_scene.model.bodies) {
    const auto position = [&](const Scene& scene, const State& state) {
      return pose(scene.model, state, *find_body(scene.model, body.name)).p_WB;
    };
    keep_largest(apart, norm(position(half_scene, half.end) - position(full_scene, full.end)));
  }
  findings.expect_exact({"half_against_full", "half fence against the full one at 0.2 s, largest distance"}, apart, 0.0,
                        "T + T is 2 T, and the steps are chosen by the largest errors, which are equal", "ft");
  if (setup.coarse) return;
  const FenceNumbers n = fence_numbers(ladder_fence(0.0));
  const double taken = speed_taken_by_cables(n);
  findings.expect_between(
      "fence: error of the formula's speed after the first contact over the speed taken by the cables",
      (speed_by_formula(n, n.column_mass) - full.first) / taken, 0.05, 1.0 + n.restitution,
      "(1 + e) times what the cables take if all of it came before the contact, nothing if all came after it; it grows "
      "with the third power of time, so that most of it comes late");
  const Passage two = passage(fence_of(0.0, 2, scenes::FenceSymmetry::half), tight, findings);
  findings.expect_exact("two layers: speed after the first contact against one layer", two.first, full.first,
                        "the columns, 0.1 ft apart, touch after the contact has ended; until then the back layer is in "
                        "bit-exact equilibrium, and the steps are those of one layer",
                        "ft/s");
  const double ends = passage(particle_on_cables(n, 0.0, Held::ends, {}), tight, findings).pull;
  const double neighbours = passage(particle_on_cables(n, 0.0, Held::neighbours, {}), tight, findings).pull;
  findings.expect_between(
      {"cable_tension", "fence: largest tension of a top cable, between those of the two particles"}, full.pull, ends,
      neighbours, "neighbours are neither fixed nor massless", "lb");
}

void run(Findings& findings, const Setup& setup) {
  if (setup.needs("against the formula")) check_formula(findings, setup);
  if (setup.needs("particle on cables")) check_particles(findings, setup);
  if (setup.needs("half fence")) check_fences(findings, setup);
  if (!setup.coarse) check_rungs(findings, setup);
  if (setup.needs("order of the peak force")) check_contact_ladder(findings, setup);
}

}  // namespace

Case definition() {
  return {
      .id = "fidelity_ladder",
      .title = "Fidelity ladder: error and cost of simplified models",
      .family = "speed and accuracy",
      .requirements =
          {{"integrator.stormer_cowell",
            {"half fence against the full one at 0.2 s, largest distance",
             "steps: speed at 0.2 s, tolerance 1e-7 against 1e-10, largest difference of all levels"}},
           {"method.nodes", {"order of the peak force in the node spacing", "order of the speed in the node spacing"}},
           {"method.resultant",
            {"peak force of the rock: free pair over the full fence", "one resultant: speed against the formula",
             "one resultant: peak force against its closed form", "12 nodes: speed error over that of one resultant"}},
           {"pair.circle.rectangle",
            {"one resultant: speed against the formula", "one resultant: peak force against its closed form",
             "order of the peak force in the node spacing", "order of the speed in the node spacing",
             "12 nodes: speed error over that of one resultant"}}},
      .main_checks = {"free pair, 1.5 ft off centre: speed against the formula",
                      "hung column: speed against the formula with I_p/h^2",
                      "particle on cables to the neighbours: largest tension against its energy",
                      "half fence against the full one at 0.2 s, largest distance",
                      "fence: largest tension of a top cable, between those of the two particles",
                      "speed at 0.2 s: digits gained by 7 columns that move in place of 5",
                      "12 nodes: speed error over that of one resultant", "order of the peak force in the node spacing",
                      "order of the speed in the node spacing"},
      .source = "Mustoe & Huttelmaier 1993, Table 2",
      .faults = {{"arm_forgotten", "the hung column's mass instead of I_p/h^2", "hung_column"},
                 {"cable_stiffness_halved", "cables of the particle with half the stiffness",
                  "particle on cables to the neighbours: largest tension against its energy"},
                 {"half_column", "a half fence with half of its central column", "half_against_full"},
                 {"stiffness_per_node", "spring and dashpot of a node independent of the number of nodes, as in 1993",
                  "order_of_force"}},
      .full_seconds = 4.0,
      .run = run};
}

}  // namespace talus::verification::problems::fidelity_ladder
