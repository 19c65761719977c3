#include <span>

#include "solver/run/failure_log.hpp"
#include "solver/scenes/fence_scene.hpp"
#include "solver/scenes/fence_summary.hpp"
#include "verification/problems/fence/rock_passages.hpp"
#include "verification/problems/fence/watched_summary.hpp"
#include "verification/reference/cables/cable_draw.hpp"
#include "verification/study/scenes/cable_scenes.hpp"
#include "verification/study/scenes/fence_table.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::second_rock {
namespace {

// ---- one cable, two masses ----

constexpr double mass = 1.0, stiffness = 1.0, tolerance = 1e-11;
constexpr double first_speed = 1.1, second_speed = 1.9;

struct Cable {
  const char* name;
  reference::YieldingCable exact;
  ElasticPlastic law;
};

std::vector<Cable> cables() {
  return {
      {"perfectly plastic", {stiffness, {{0.0, 0.5}}, 0.0}, {.stiffness = stiffness, .yield = 0.5}},
      {"linear hardening", {stiffness, {{0.0, 0.5}}, 0.25}, {.stiffness = stiffness, .yield = 0.5, .hardening = 0.25}},
      {"tabulated hardening",
       {stiffness, {{0.0, 0.5}, {0.4, 0.7}, {1.0, 0.7}, {1.5, 1.2}}, 0.1},
       {.stiffness = stiffness, .yield = 0.5, .hardening = 0.1, .table = {{0.4, 0.7}, {1.0, 0.7}, {1.5, 1.2}}}}};
}

/// Runs a second mass on a cable with the plastic elongation `stretch` by a first one, which is not in the scene.
CableRunResult throw_second(const ElasticPlastic& law, double stretch, Findings& findings, const Setup& setup) {
  const ElasticPlastic carried = setup.has("cable_like_new") ? law : law.drawn_before(stretch);
  const Scene scene = thrown_mass(carried, mass, second_speed);
  return run_cables(scene, scene.initial, make_integrator("stormer_cowell", tolerance), {1.0, 30.0, true}, findings);
}

void check_carried_cables(Findings& findings, const Setup& setup) {
  for (const auto& [name, exact, law] : cables()) {
    const double before = reference::draw(exact, mass, first_speed).stretch;
    const reference::CableDraw second = reference::draw(exact, mass, second_speed, before);
    const CableRunResult run = throw_second(law, before, findings, setup);
    const Tolerance to_tolerance =
        Tolerance::truncation(5.0 * tolerance * second_speed, 1.0,
                              "local errors below 1e-11 of speed and distance travelled, about ten of one sign");
    findings.expect({"second_exit", fmt::format("exit speed of the second mass, {}", name)}, -run.end.v[0],
                    second.exit_speed, to_tolerance, "m/s");
    findings.expect({"second_stretch", fmt::format("plastic elongation by both masses, {}", name)},
                    before + run.end.z[0], second.stretch, to_tolerance, "m");
    // The rupture elongation counts from the original length.
    for (const double ratio : {0.999, 1.001}) {
      ElasticPlastic weak = law;
      weak.rupture = ratio * second.stretch;
      const bool broke = throw_second(weak, before, findings, setup).end.mode[0] == ElasticPlastic::broken;
      findings.expect_true(
          {"second_rupture", fmt::format("rupture at {:g} of the plastic elongation by both masses, {}", ratio, name)},
          broke == (ratio < 1.0),
          "the elongation is known to 1e-10, and the two limits differ from it by a thousandth");
    }
  }
}

/// Checks that a cable that yields for less than a step is reported, at any phase.
void check_short_yield(Findings& findings) {
  const double yield = 0.5, speed = 1.0005 * yield;
  const Scene scene = thrown_mass(ElasticPlastic{.stiffness = stiffness, .yield = yield}, mass, speed);
  const Dynamics dynamics{scene.model};
  int drawn = 0, reported = 0, seen_yielding = 0;
  for (int i = 0; i < 64; ++i) {
    Scene from = scene;
    const double step = 0.05;
    from.initial.q[0] -= (i + 0.5) / 64.0 * step * speed;
    FailureLog log{dynamics};
    bool yields = false;
    const RunEnd run = run_scene(from, VelocityVerlet{}, {step, 5.0, 5.0, false}, findings,
                                 [&](const State& state, const StepInfo& info) {
                                   log(state, info);
                                   yields = yields || state.mode[0] == ElasticPlastic::yielding;
                                 });
    drawn += run.state.z[0] > 0.0 ? 1 : 0;
    reported += log.failures().empty() ? 0 : 1;
    seen_yielding += yields ? 1 : 0;
  }
  findings.expect_exact("number of phases with a reported yield against those with a plastic elongation", reported,
                        drawn, "counts over 64 phases");
  findings.expect_true("existence of phases without a yielding state at any step", drawn > 0 && seen_yielding < drawn,
                       "the cable yields for 0.63 of a step: acos(1/1.0005) = 0.0316 in steps of 0.05");
}

// ---- the cables of a fence ----

scenes::Fence two_sided_fence() {
  scenes::Fence fence = published_fence("table_2.DAT");
  fence.options = scenes::current_options();
  fence.options.symmetry = scenes::FenceSymmetry::full;
  fence.options.integrator = "velocity_verlet";
  fence.options.tolerance = 0.0;
  fence.limit_top = 4e4, fence.limit_bottom = 2e4;
  return fence;
}

const ElasticPlastic& law_of(const talus::Cable& cable) { return std::get<ElasticPlastic>(cable.law); }

/// Tension of a yielding cable at an elongation.
double drawn_tension(const ElasticPlastic& law, double elongation) {
  const double memory = 0.0;
  return law({elongation, 1.0}, std::span{&memory, 1}, ElasticPlastic::yielding).total();
}

void check_fence_cables(Findings& findings, const Setup& setup) {
  constexpr double hardening = 0.2, rupture = 0.03;
  scenes::Fence fence = two_sided_fence();
  fence.options.hardening = setup.has("other_hardening") ? 0.201 : hardening, fence.options.rupture = rupture;
  double tangent = 0.0, strain = 0.0, strands = 0.0;
  const Model hard = scenes::fence_scene(fence).scene.model;
  for (const talus::Cable& cable : hard.cables) {
    const ElasticPlastic& law = law_of(cable);
    const Vec3 a = reference_point(hard, cable.a), b = reference_point(hard, cable.b);
    const bool top = cable.name.starts_with("top");
    const double steel = fence.young * (top ? fence.area_top : 2.0 * fence.area_bottom);
    keep_worst(strands, law.stiffness * norm(Vec3{b.x - a.x, b.y - a.y, b.z - a.z}) / steel - 1.0);
    const double e = 1.5 * law.yield / law.stiffness, de = 0.5 * e;
    const double slope = (drawn_tension(law, e + de) - drawn_tension(law, e)) / de;
    keep_worst(tangent, slope / (hardening * law.stiffness) - 1.0);
    keep_worst(strain, law.rupture / (rupture * cable.rest_length) - 1.0);
  }
  const Tolerance same =
      Tolerance::round_off(3e-15, "a dozen operations, 1.1e-16 each, doubled by a difference of half of each term");
  findings.expect(
      {"tangent",
       "tangent stiffness of yielding cables against the given fraction of Young's modulus, worst relative error"},
      tangent, 0.0, same);
  findings.expect("stiffness times length of cables against E A (two strands at the bottom), worst relative error",
                  strands, 0.0, same);
  findings.expect("rupture elongation of cables against the given strain, worst relative error", strain, 0.0, same);

  // Yield forces by a table of strains, and the part of the table that remains after an impact.
  fence = two_sided_fence();
  fence.options.table = {{0.002, 1.25}, {0.006, 1.5}};
  const scenes::FenceScene made = scenes::fence_scene(fence);
  fence.stretched_cables = {{"top1", 0.004}, {"top-1", 0.004}, {"top2", 0.012}, {"top-2", 0.012}};
  const scenes::FenceScene next = scenes::fence_scene(fence);
  double table = 0.0, carried = 0.0, length = 0.0, balance = 0.0;
  for (std::size_t c = 0; c < made.scene.model.cables.size(); ++c) {
    const talus::Cable &cable = made.scene.model.cables[c], &later = next.scene.model.cables[c];
    const double l = cable.rest_length, y = law_of(cable).yield;
    const reference::YieldingCable exact{
        law_of(cable).stiffness, {{0.0, y}, {0.002 * l, 1.25 * y}, {0.006 * l, 1.5 * y}}, 0.0};
    const auto listed = std::ranges::find(fence.stretched_cables, cable.name, &scenes::StretchedCable::cable);
    const double stretch = listed == fence.stretched_cables.end() ? 0.0 : listed->stretch;
    keep_worst(length, later.rest_length - (l + stretch));
    for (const double more : {0.0, 0.0015, 0.003, 0.02}) {
      const double p = stretch + more * l;
      const double elongation = reference::yield_elongation(exact, p), force = reference::yield_force(exact, p);
      keep_worst(table, drawn_tension(law_of(cable), elongation) / force - 1.0);
      keep_worst(carried, drawn_tension(law_of(later), elongation - stretch) / force - 1.0);
    }
  }
  findings.expect("yield force from a table of strains, worst relative error", table, 0.0, same);
  findings.expect_round_off("yield force for the next rock, worst relative error", carried, 0.0, 5e-15,
                            "an elongation of 0.01 ft is a difference of two elongations of 0.03 ft: a dozen "
                            "operations, 1.1e-16 each, times three");
  findings.expect_round_off(
      "rest length for the next rock against first rest length plus plastic elongation, worst error", length, 0.0,
      1e-15, "one rounding of a length of 2.5 ft", "ft");
  // Equilibrium of the columns on the longer cables: pulls, from lengths in space, and weights.
  const Model& model = next.scene.model;
  std::vector<double> up(model.bodies.size(), 0.0);
  for (const talus::Cable& cable : model.cables) {
    const Vec3 a = reference_point(model, cable.a), b = reference_point(model, cable.b);
    const Vec3 line{b.x - a.x, b.y - a.y, b.z - a.z};
    const double tension = std::max(0.0, law_of(cable).stiffness * (norm(line) - cable.rest_length));
    if (cable.a.body) up[index(*cable.a.body)] += tension * line.y / norm(line);
    if (cable.b.body) up[index(*cable.b.body)] -= tension * line.y / norm(line);
  }
  double lower = 0.0;
  for (const scenes::FenceMember& member : next.members) {
    if (!member.body || member.layer == 0) continue;
    const std::size_t body = index(*member.body);
    keep_worst(balance, up[body] / (model.bodies[body].mass * fence.gravity) - 1.0);
    lower = std::max(lower, made.scene.model.bodies[body].p_WB.y - model.bodies[body].p_WB.y);
  }
  findings.expect_round_off(
      {"stretched_equilibrium",
       "vertical cable force over weight of the columns on stretched cables, worst relative error"},
      balance, 0.0, 5e-11,
      "Newton's method, whose last step squares the error, ends at the round-off of the tensions, 1e-8 lb or 2e-11 of "
      "a weight (case fence_layouts)");
  findings.expect_true("columns lower on stretched cables", lower > 0.05,
                       "the cable over 55 ft is longer by 0.008 ft and 0.024 ft");
}

// ---- the contacts of two rocks ----

struct Solid {
  double mass{}, inertia{};
};
Solid ball(double radius, double density) {
  const double m = 4.0 / 3.0 * std::numbers::pi * std::pow(radius, 3) * density;
  return {m, 0.4 * m * radius * radius};
}
Solid upright_cylinder(double radius, double half_height, double density) {
  const double m = 2.0 * std::numbers::pi * radius * radius * half_height * density;
  return {m, m * (3.0 * radius * radius + 4.0 * half_height * half_height) / 12.0};
}
double together(double a, double b) { return 1.0 / (1.0 / a + 1.0 / b); }

/// The fence of Table 2 with a second, smaller and slower rock, which hits higher.
scenes::Fence fence_of_two(const Setup& setup) {
  scenes::Fence fence = two_sided_fence();
  scenes::FenceElement other = fence.rocks.front();
  other.a = other.b = 0.7, other.density *= setup.has("denser_rock") ? 1.001 : 1.0;
  other.position = {2.1, 2.6}, other.along = 1.0, other.velocity = {-30.0, 2.0};
  fence.rocks.push_back(other);
  fence.rock_overlap = 0.0, fence.friction = 0.3;
  fence.options.shear_ratio = 0.4;
  fence.options.contact = scenes::FenceContact::nodes;
  return fence;
}

void check_two_rocks(Findings& findings, const Setup& setup) {
  const scenes::Fence fence = fence_of_two(setup);
  const scenes::Fence stated = fence_of_two({});
  const Model model = scenes::fence_scene(fence).scene.model;
  const double speed = norm(stated.rocks[0].velocity), e = stated.restitution;
  const auto contact = [&](const std::string& name) { return model.contacts[index(*find_contact(model, name))]; };
  const auto law = [&](const std::string& name) { return std::get<LinearSpringDashpot>(contact(name).law); };
  const auto spring = [&](double factor, double m, double overlap) {
    return factor * m * speed * speed / (overlap * overlap);
  };
  // e = exp(-2 xi acos(xi)/sqrt(1 - xi^2)) by bisection: clamped end rule.
  double low = 0.0, high = 1.0;
  for (int i = 0; i < 60; ++i) {
    const double xi = 0.5 * (low + high);
    (std::exp(-2.0 * xi * std::acos(xi) / std::sqrt(1.0 - xi * xi)) > e ? low : high) = xi;
  }
  const Solid column = upright_cylinder(stated.column.a, stated.column.b, stated.column.density);
  double stiff = 0.0, damped = 0.0, shear = 0.0;
  for (std::size_t i = 0; i < 2; ++i) {
    const scenes::FenceElement& element = stated.rocks[i];
    const Solid rock = ball(element.a, element.density);
    const std::string name = fmt::format("rock{}", i + 1);
    const double overlap = stated.penetration * element.a;
    const double k = spring(1.0, together(rock.mass, column.mass), overlap);
    const double arm = element.position.y - model.bodies[index(*find_body(model, "column1"))].p_WB.y;
    const double felt = 1.0 / (1.0 / rock.mass + 1.0 / column.mass + arm * arm / column.inertia);
    keep_worst(stiff, law(name + "-column1").stiffness / k - 1.0);
    keep_worst(stiff, law(name + "-ground").stiffness / spring(2.0, rock.mass, overlap) - 1.0);
    keep_worst(damped, law(name + "-column1").damping / (2.0 * low * std::sqrt(k * felt)) - 1.0);
    keep_worst(shear, std::get<CoulombFriction>(*contact(name + "-column1").friction).stiffness / (0.4 * k) - 1.0);
  }
  const Solid one = ball(stated.rocks[0].a, stated.rocks[0].density), other = ball(0.7, stated.rocks[1].density);
  keep_worst(
      stiff,
      law("rock1-rock2").stiffness / spring(1.0, together(one.mass, other.mass), stated.penetration * 0.7) - 1.0);
  // Two layers: the contact of two equal columns is computed for half the mass of one.
  scenes::Fence layers = fence;
  layers.layers = 2, layers.layer_overlap = 0.05;
  const Model behind = scenes::fence_scene(layers).scene.model;
  const auto& pair =
      std::get<LinearSpringDashpot>(behind.contacts[index(*find_contact(behind, "column1-back_column1"))].law);
  keep_worst(stiff, pair.stiffness / spring(1.0, 0.5 * column.mass, 0.05) - 1.0);
  layers.layer_overlap = 0.0;
  const Model by_width = scenes::fence_scene(layers).scene.model;
  const auto& usual =
      std::get<LinearSpringDashpot>(by_width.contacts[index(*find_contact(by_width, "column1-back_column1"))].law);
  keep_worst(stiff, usual.stiffness / spring(1.0, 0.5 * column.mass, stated.penetration * stated.column.a) - 1.0);
  const Tolerance same =
      Tolerance::round_off(5e-15, "about thirty operations, 1.1e-16 each, and the damping ratio from a bisection");
  findings.expect("stiffness of each rock's contacts, worst relative error", stiff, 0.0, same);
  findings.expect("dashpot of each rock's contact at its impact height, worst relative error", damped, 0.0, same);
  findings.expect("shear stiffness of each rock's contact, worst relative error", shear, 0.0, same);
}

// ---- a run with two rocks, and its summary ----

/// Checks the summary of a run: the first rock hits the fence, which has no bottom cable; the second flies over it from
/// behind.
void check_summary(Findings& findings, const Setup& setup) {
  scenes::Fence fence = two_sided_fence();
  fence.connections = 1;
  scenes::FenceElement other = fence.rocks.front();
  other.position = {-3.0, 12.0}, other.velocity = {150.0, 0.0}, other.along = 1.0;
  fence.rocks.push_back(other);
  const scenes::FenceScene made = scenes::fence_scene(fence);
  const Dynamics dynamics{made.scene.model};
  WatchedSummary watch{fence, made, dynamics, 0.03};  // resumed after the second rock's passage
  constexpr double step = 2e-5, end = 0.045;
  const State start = first_state(made.scene);
  const RunEnd run = run_scene(made.scene, VelocityVerlet{}, {step, end, end, true}, findings, std::ref(watch));
  const scenes::FenceSummary &summary = watch.summary(), &later = watch.resumed();
  findings.expect_true("verdict on the second rock in a summary resumed after its passage",
                       later.rocks[1].verdict == scenes::Verdict::passed_over &&
                           later.rocks[1].passed_time == summary.rocks[1].passed_time,
                       "the passage precedes the interruption");
  findings.expect_exact("number of values that differ between resumed and uninterrupted summary, run with two rocks",
                        watch.resumed_differences(), 0.0, "the saved state is exact to the last bit");
  double farthest = 0.0;
  for (const scenes::ColumnRecord& column : summary.columns) {
    const auto x = [&](const State& state) { return pose(made.scene.model, state, column.body).p_WB.x; };
    keep_largest(farthest, x(summary.at_travel) - x(start));
  }
  findings.expect_exact("largest displacement of the columns in the state recorded for it", farthest, summary.travel,
                        "the same difference of two numbers", "ft");
  findings.expect_true("passage of the second rock over the fence from behind",
                       summary.rocks[1].verdict == scenes::Verdict::passed_over && !summary.rocks[1].touched,
                       "it flies 8 ft above the columns, in the direction opposite to the first rock");
  findings.expect_truncation("time of the passage of the second rock", summary.rocks[1].passed_time, 3.0 / 150.0, step,
                             1.0, "recorded at the first step after the passage", "s");
  // Momentum change of all bodies against the impulse on the anchors, and of a column against that of its hanger.
  const Model& model = made.scene.model;
  Vec2 change, of_column;
  double weight = 0.0, on_column = 0.0;
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    const Body& body = model.bodies[i];
    if (body.mobility == Mobility::fixed) continue;
    const auto id = static_cast<BodyId>(i);
    const Vec2 gained = body.mass * (pose(model, run.state, id).v_WB - pose(model, start, id).v_WB);
    change += gained - end * body.force, weight += body.mass * fence.gravity;
    if (body.name == "column-3") of_column = gained - end * body.force, on_column = body.mass * fence.gravity;
  }
  Vec2 anchors;
  for (const scenes::AnchorRecord& anchor : summary.anchors) {
    if (setup.has("one_anchor_alone") && anchor.joint != summary.anchors.front().joint) continue;
    anchors += Vec2{anchor.force.impulse.x, anchor.force.impulse.y};
  }
  const BodyId third = *find_body(model, "column-3");
  const auto hung = std::ranges::find(summary.columns, third, &scenes::ColumnRecord::body);
  const Vec2 hanger{hung->hanger.impulse.x, hung->hanger.impulse.y};
  const auto sums = [](const char* reason) { return Tolerance::round_off(2.5e-13, reason); };
  const char* const reason =
      "velocity Verlet integrates forces to the momentum by the same trapezoidal rule: 2250 sums, each rounded by "
      "1.1e-16 of the sum: 2.5e-13 if all have the same sign";
  const double thrown = summary.rocks[0].mass * norm(fence.rocks[0].velocity);
  findings.expect(
      {"momentum_balance", "balance of the momentum across the fence with the impulse on the anchors, relative error"},
      (change.x + anchors.x) / thrown, 0.0, sums(reason));
  findings.expect("balance of the vertical momentum with weights and impulse on the anchors, relative error",
                  (change.y + weight * end + anchors.y) / (weight * end), 0.0, sums(reason));
  findings.expect("balance of a column's momentum with its weight and the impulse of its hanger, relative error",
                  norm(of_column + Vec2{0.0, on_column * end} - hanger) / norm(hanger), 0.0, sums(reason));
}

/// Checks a rock that flies over both layers of a fence: it has passed when it is beyond the second one.
void check_second_layer(Findings& findings) {
  constexpr double step = 5e-5, end = 0.04, speed = 150.0, start = 3.0, spacing = 2.6;
  scenes::Fence fence = two_sided_fence();
  fence.layers = 2, fence.layer_spacing = spacing, fence.connections = 1;
  fence.rocks[0].position = {start, 12.0}, fence.rocks[0].velocity = {-speed, 0.0};
  const scenes::FenceScene made = scenes::fence_scene(fence);
  const Dynamics dynamics{made.scene.model};
  WatchedSummary watch{fence, made, dynamics, end};
  (void)run_scene(made.scene, VelocityVerlet{}, {step, end, end, true}, findings, std::ref(watch));
  const scenes::RockPassage& rock = watch.summary().rocks[0];
  findings.expect_true("passage over both layers of the second rock's fence",
                       rock.verdict == scenes::Verdict::passed_over, "it flies 8 ft above the columns");
  findings.expect_truncation("time of the passage over the second layer, second rock's fence", rock.passed_time,
                             (start + spacing) / speed, step, 1.0, "recorded at the first step after the passage", "s");
}

/// Checks verdicts for a rock that hits the lower end of a column and passes below it, with hangers that hold, that
/// cannot break, and that break. The ground slopes, and the outermost columns have other joints.
void check_verdicts(Findings& findings, const Setup& setup) {
  using scenes::Verdict;
  double resumed = 0.0, heights = 0.0, tensions = 0.0, hangers = 0.0;
  constexpr double step = 2e-5;
  double touch = 0.0, limits = 0.0;
  const auto verdict_of = [&](double strength, int connections, double stop) {
    scenes::Fence fence = two_sided_fence();
    fence.connections = connections, fence.options.hanger_strength = strength;
    fence.limit_top = fence.limit_bottom = 1e9, fence.options.strength_top = 5e8;
    fence.ground.position = {1.0, -20.0}, fence.ground.angle = 0.03, fence.rocks[0].position.y = -4.5;
    fence.changed_columns = {
        {7, fence.column.a, fence.column.b, fence.column.density, fence.y_top - 0.3, fence.y_bottom + 0.4}};
    const scenes::FenceScene made = scenes::fence_scene(fence);
    const Dynamics dynamics{made.scene.model};
    WatchedSummary watch{fence, made, dynamics, stop};
    (void)run_scene(made.scene, VelocityVerlet{}, {step, 0.1, 0.01, false}, findings, std::ref(watch));
    resumed += watch.resumed_differences();
    keep_worst(heights, watch.height_error()), keep_worst(tensions, watch.tension_error());
    keep_worst(hangers, watch.hanger_error());
    for (const scenes::SegmentRecord& segment : watch.summary().segments)
      keep_worst(limits, segment.limit - (segment.top ? 5e8 : 1e9));
    const scenes::RockPassage& rock = watch.summary().rocks[0];
    touch = rock.touch_time;
    return rock.touched ? rock.verdict : Verdict::undecided;
  };
  findings.expect_true(
      {"low_rock", "verdict on a low rock with hangers of 1.2 times a column's weight: breaks through"},
      verdict_of(setup.has("hangers_hold") ? 1e9 : 580.0, 2, 0.02) == Verdict::broke_through,
      "the struck column loads its hanger with more");
  // Resumed at the step before touch, and while the rock pushes the column.
  const double before = touch - 1.5 * step, within = touch + 5.0 * step;
  findings.expect_true(
      "verdict on a low rock that hits the lower end of a column: passes under the fence",
      verdict_of(0.0, 2, before) == Verdict::passed_under && verdict_of(1e9, 1, within) == Verdict::passed_under,
      "no cable reaches a limit, and the hangers have no limit or one of 1e9 lb");
  // A light rock that rebounds: resumed between its turning point and its exit.
  scenes::Fence fence = two_sided_fence();
  fence.rocks[0].density *= 0.05;
  fence.ground_profile = {{-90.0, -9.5}, {90.0, -9.5}};
  const scenes::FenceScene made = scenes::fence_scene(fence);
  const Dynamics dynamics{made.scene.model};
  WatchedSummary watch{fence, made, dynamics, 1.6e-3};
  (void)run_scene(made.scene, VelocityVerlet{}, {step, 5e-3, 1e-3, false}, findings, std::ref(watch));
  resumed += watch.resumed_differences();
  keep_worst(heights, watch.height_error());
  const scenes::RockPassage& light = watch.summary().rocks[0];
  findings.expect_true("verdict on a light rock: stopped, turning before the interruption and leaving after it",
                       light.verdict == Verdict::stopped && light.turned && light.braking_time < 1.6e-3 && light.left &&
                           light.exit_time > 1.6e-3,
                       "it turns after a little more than a third of the contact, which takes pi 0.06 ft/65 ft/s = 2.9 "
                       "ms without a dashpot");
  findings.expect_exact("tensions at which cables yield or break, worst error", limits, 0.0,
                        "the smaller of two numbers", "lb");
  findings.expect_exact("number of values that differ between resumed and uninterrupted summaries, runs with one rock",
                        resumed, 0.0, "the saved state is exact to the last bit");
  findings.expect_round_off("heights of the lowest top joint, the highest bottom joint and the rock, worst error",
                            heights, 0.0, 1e-13, "a dozen operations on lengths of 25 ft", "ft");
  findings.expect_exact("largest tensions of top and bottom cable in the rows of the history, worst error", tensions,
                        0.0, "the same tensions", "lb");
  findings.expect_exact("largest hanger force in the rows of the history, worst error", hangers, 0.0,
                        "the same sums of cable forces", "lb");
}

void run(Findings& findings, const Setup& setup) {
  if (setup.needs("mass")) check_carried_cables(findings, setup);
  if (setup.needs("phases")) check_short_yield(findings);
  if (setup.needs("cables") || setup.needs("next rock")) check_fence_cables(findings, setup);
  if (setup.needs("each rock")) check_two_rocks(findings, setup);
  if (setup.needs("anchors") || setup.needs("second rock")) check_summary(findings, setup);
  if (setup.needs("layer")) check_second_layer(findings);
  if (setup.needs("rock with hangers")) check_verdicts(findings, setup);
  if (setup.needs("from behind")) check_passages(findings, setup);
}

}  // namespace

Case definition() {
  return {
      .id = "second_rock",
      .title = "Second impact on a deformed fence",
      .family = "the fence",
      .requirements = {{"law.elastic_plastic", {"second_exit", "second_stretch", "second_rupture"}},
                       {"mechanism.cable_yield, regime.elastic_plastic.yielding", {"second_exit", "second_stretch"}},
                       {"regime.elastic_plastic.broken", {"second_rupture"}},
                       {"integrator.stormer_cowell", {"second_exit", "second_stretch", "second_rupture"}}},
      .main_checks = {"exit speed of the second mass, tabulated hardening",
                      "rupture at 0.999 of the plastic elongation by both masses, linear hardening",
                      "yield force for the next rock, worst relative error", "stretched_equilibrium",
                      "momentum_balance"},
      .source = "Mustoe & Huttelmaier 1993, sections 2.4 and 3.5, Eq. 21; energy balance of reference::draw",
      .faults = {{"cable_like_new", "cable of the second mass without the plastic elongation by the first",
                  "exit speed of the second mass, linear hardening"},
                 {"other_hardening", "a tangent modulus of 0.201 instead of 0.2", "tangent"},
                 {"denser_rock", "second rock denser by a thousandth",
                  "stiffness of each rock's contacts, worst relative error"},
                 {"hangers_hold", "hangers that never break", "low_rock"},
                 {"spin_not_mirrored", "a rock from behind that turns as the one in front", "from_behind"},
                 {"one_anchor_alone", "impulse on one anchor only", "momentum_balance"}},
      .run = run};
}

}  // namespace talus::verification::problems::second_rock
