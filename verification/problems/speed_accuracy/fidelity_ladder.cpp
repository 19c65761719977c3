#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "verification/check/case.hpp"
#include "verification/problems/speed_accuracy/contact_ladder_findings.hpp"
#include "verification/problems/speed_accuracy/fidelity_levels.hpp"
#include "verification/problems/speed_accuracy/fidelity_rungs.hpp"

namespace talus::verification::problems {

Case fidelity_ladder();

namespace {

/// The formula against the free pair and the column on its pin.
void check_formula(Findings& findings, const Setup& setup) {
  const FenceNumbers n = fence_numbers(ladder_fence(0.0));
  const auto mass = [&](double with_arm) { return setup.has("arm_forgotten") ? n.column_mass : with_arm; };
  for (const double height : {0.0, 1.5}) {
    const FenceNumbers here = fence_numbers(ladder_fence(height));
    findings.expect(fmt::format("free pair, {} ft off centre: speed, by the formula", height),
                    passage(free_pair(here, height), tight, findings).exit,
                    speed_by_formula(here, mass(free_column_mass(here, height))),
                    Tolerance::truncation(65.0 * tight, 1.0,
                                          "exact for a free pair; a tolerance of 1e-10 of the largest speed is what "
                                          "a step may miss"),
                    "ft/s");
  }
  findings.expect("hung column: speed, by the formula with I_p/h^2", passage(hung_column(n, 0.0), tight, findings).exit,
                  speed_by_formula(n, mass(hung_column_mass(n, 0.0))),
                  Tolerance::model(0.18,
                                   "while it is hit the column turns by .0115 rad, and its face takes the line of "
                                   "force 2.2 ft x .0115 nearer to the pin: .39 % of h, .78 % of the mass, .18 ft/s "
                                   "if it were so from the start"),
                  "ft/s");
}

/// The particle's largest tension against its energy.
void check_particles(Findings& findings, const Setup& setup) {
  const FenceNumbers n = fence_numbers(ladder_fence(0.0));
  const double mass = n.column_mass;
  const double struck = (1.0 + n.restitution) * n.speed * n.rock_mass / (n.rock_mass + mass);
  for (const Held held : {Held::neighbours, Held::ends}) {
    const double length = held == Held::ends ? n.half_span : n.segment;
    findings.expect(
        fmt::format("particle on cables to the {}: largest tension, by its energy",
                    held == Held::ends ? "ends" : "neighbours"),
        passage(particle_on_cables(n, 0.0, held, setup), tight, findings).pull,
        std::sqrt(n.first_tension * n.first_tension + 0.5 * n.cable_modulus / length * mass * struck * struck),
        Tolerance::model(
            5e-4,
            "the contact hands on the little that the cables take while it lasts: an impulse of .8 lb s to "
            "the column's 754, of which it gives back what it hands on to the rock, at most a half")
            .relative(),
        "lb");
  }
}

/// What the cables take while the contact lasts, from the closed form of the free pair: their impulse over both masses
/// [L/T].
double speed_taken_by_cables(const FenceNumbers& n) {
  const reference::Impact impact = soft_impact(n, n.column_mass);
  const double last = reference::impact_events(impact, reference::EndRule::clamped).contact_time;
  const double both = n.rock_mass + n.column_mass, share = n.rock_mass / both;
  constexpr int parts = 1000;
  double impulse = 0.0;
  for (int i = 0; i < parts; ++i) {
    const double t = (i + 0.5) * last / parts;
    const double x = share * (n.speed * t - reference::depth_at(impact, t).depth);
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
    const auto place = [&](const Scene& scene, const State& state) {
      return pose(scene.model, state, *find_body(scene.model, body.name)).p_WB;
    };
    apart = std::max(apart, norm(place(half_scene, half.end) - place(full_scene, full.end)));
  }
  findings.expect("half fence from the full one at .2 s, largest distance", apart, 0.0,
                  Tolerance::exact("T + T is 2 T, and the steps are chosen by the largest errors, which are the same"),
                  "ft");
  if (setup.coarse) return;
  const FenceNumbers n = fence_numbers(ladder_fence(0.0));
  const double taken = speed_taken_by_cables(n);
  findings.expect_between("fence: speed after the first contact, miss of the formula over what the cables take",
                          (speed_by_formula(n, n.column_mass) - full.first) / taken, 0.05, 1.0 + n.restitution,
                          "all that they take, (1 + e) times over, had it come before the contact, and nothing had it "
                          "come after; it grows with the third power of time, so that most of it is late");
  const Passage two = passage(fence_of(0.0, 2, scenes::FenceSymmetry::half), tight, findings);
  findings.expect(
      "two layers: speed after the first contact, from one layer's", two.first, full.first,
      Tolerance::exact("the columns, .1 ft apart, touch when it is over; until then the back layer stands in "
                       "balance to the last bit, and the steps are those of one layer"),
      "ft/s");
  const double ends = passage(particle_on_cables(n, 0.0, Held::ends, {}), tight, findings).pull;
  const double neighbours = passage(particle_on_cables(n, 0.0, Held::neighbours, {}), tight, findings).pull;
  findings.expect_between("fence: largest tension of a top cable, between those of the two particles", full.pull, ends,
                          neighbours, "neighbours neither stand still nor follow without mass", "lb");
}

void run(Findings& findings, const Setup& setup) {
  check_formula(findings, setup);
  check_particles(findings, setup);
  check_fences(findings, setup);
  if (!setup.coarse) check_rungs(findings, setup);
  check_contact_ladder(findings, setup);
}

}  // namespace

Case fidelity_ladder() {
  return {.id = "fidelity_ladder",
          .title = "No more model than a question needs",
          .family = "speed and accuracy",
          .requirements = {{"integrator.stormer_cowell", {"half fence from the full one", "steps: speed at .2 s"}},
                           {"method.nodes", {"spacing of the nodes"}},
                           {"method.resultant", {"one resultant"}},
                           {"pair.circle.rectangle", {"one resultant", "spacing of the nodes"}}},
          .main_checks = {"free pair, 1.5 ft off centre: speed, by the formula",
                          "hung column: speed, by the formula with I_p/h^2",
                          "particle on cables to the neighbours: largest tension, by its energy",
                          "half fence from the full one at .2 s, largest distance",
                          "fence: largest tension of a top cable, between those of the two particles",
                          "speed at .2 s: digits gained by 7 columns that move in place of 5",
                          "12 nodes: miss of the speed over that of one resultant",
                          "order of the push in the spacing of the nodes",
                          "order of the speed in the spacing of the nodes"},
          .source = "Mustoe & Huttelmaier 1993, Table 2",
          .faults = {{"arm_forgotten", "the hung column's mass in place of I_p/h^2",
                      "hung column: speed, by the formula with I_p/h^2"},
                     {"cable_stiffness_halved", "the particle's cables half as stiff",
                      "particle on cables to the neighbours: largest tension, by its energy"},
                     {"half_column", "the half fence with half its central column",
                      "half fence from the full one at .2 s, largest distance"},
                     {"stiffness_per_node", "the whole spring and dashpot at each of so many nodes, as in 1993",
                      "order of the push in the spacing of the nodes"}},
          .run = run};
}

}  // namespace talus::verification::problems
