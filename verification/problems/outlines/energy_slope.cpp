#include <random>

#include "verification/study/scenes/touching_pair.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::energy_slope {
namespace {

constexpr double stiffness = 1000.0, nudge = 1e-5;

std::vector<TouchingPair> pairs() {
  const Circle disc{0.4};
  const Rectangle box{0.5, 0.35};
  const Superquadric ellipse{0.6, 0.35, 2.0}, stone{0.5, 0.4, 5.0};
  const Terrain hills{{{-2.0, -0.1}, {-0.3, 0.1}, {0.4, -0.05}, {2.0, 0.2}}};
  const auto by_nodes = ContactMethod::nodes;
  return {{"disc, disc", disc, Circle{0.3}},
          {"disc, rectangle", disc, box},
          {"disc, ellipse", disc, ellipse},
          {"disc, superellipse n = 5", disc, stone},
          {"disc, plane", disc, HalfPlane{}},
          {"disc, terrain", disc, hills},
          {"rectangle, plane", box, HalfPlane{}},
          {"superellipse n = 5, plane", stone, HalfPlane{}},
          {"ellipse, superellipse n = 5", ellipse, stone},
          {"superellipses n = 20", Superquadric{0.5, 0.35, 20.0}, Superquadric{0.4, 0.6, 20.0}},
          {"rectangle, superellipse n = 5", box, stone},
          {"rectangle, rectangle", Rectangle{0.4, 0.3}, box},
          {"slender rectangles", Rectangle{0.7, 0.08}, Rectangle{0.1, 0.8}},
          {"nodes: rectangle, rectangle", Rectangle{0.4, 0.3}, box, by_nodes},
          {"nodes: superellipses", ellipse, stone, by_nodes},
          {"nodes: disc, rectangle", disc, box, by_nodes},
          {"nodes: superellipse, terrain", stone, hills, by_nodes},
          {"nodes, side faces: disc, superellipse", disc, stone, by_nodes, NodeDepth::side_face},
          {"nodes, smoother: disc, superellipse", disc, stone, by_nodes, NodeDepth::smoother},
          {"nodes, centroid rays: superellipses", ellipse, stone, by_nodes, NodeDepth::centroid_ray}};
}

/// True if the rule's force should derive from an energy on any path; the other rules of 1993 are only measured.
bool has_potential(const TouchingPair& pair) { return pair.rule == NodeDepth::nearest; }

Model cable_model() {
  SceneBuilder builder{si};
  const auto body = [&](const char* name) { return builder.add_free(name, 1.0, 1.0, Circle{0.1}); };
  const BodyId a = body("a"), b = body("b");
  builder.add_cable("cable", {a, {0.3, -0.2, 0.0}}, {b, {-0.1, 0.4, 0.3}}, 0.2, TensionOnly{stiffness, 0.0});
  return builder.build();
}

/// Differences between force and slope of the energy, relative to the largest force, at positions with contact.
struct Mismatch {
  int positions{}, mismatched{};  ///< number of positions; those that differ by more than 1e-6
  double largest{};
};

/// Positions with a kink of V within the steps (another face, another node) are skipped: V has no slope at a kink.
Mismatch mismatch(const Model& model, double reach, const Setup& setup) {
  record_use(model);
  Potential potential{model};
  std::mt19937_64 random{11};
  std::uniform_real_distribution<double> coordinate{-reach, reach}, any{-3.0, 3.0};
  std::vector<double> found;
  for (int i = 0; i < (setup.coarse ? 12 : 30); ++i) {
    State state = rest_state(model);
    for (std::size_t k = 0; k < state.q.size(); ++k)
      state.q[k] = k % 3 == 2 ? any(random) : coordinate(random);
    potential.evaluate(state);
    const std::vector<double> forces = potential.forces(state);
    double largest = 0.0;
    for (std::size_t k = 0; k < forces.size(); ++k)
      keep_largest(largest, forces[k]);
    if (largest < 0.02 * stiffness * reach) continue;
    double worst = 0.0;
    bool smooth = true;
    for (std::size_t k = 0; k < forces.size(); ++k) {
      State other = state;
      const auto energy_at = [&](double offset) {
        other.q[k] = state.q[k] + offset;
        other.mode = state.mode;
        potential.evaluate(other);
        smooth = smooth && other.mode == state.mode;
        return potential.energy(other);
      };
      const double up = energy_at(nudge), down = energy_at(-nudge);
      const double far_up = energy_at(2.0 * nudge), far_down = energy_at(-2.0 * nudge);
      const double slope = (up - down) / (2.0 * nudge), wide = (far_up - far_down) / (4.0 * nudge);
      // With a kink within reach the slope changes with the step by far more than delta^2.
      smooth = smooth && std::abs(slope - wide) < 1e-4 * largest;
      const double force = setup.has("moments_halved") && k % 3 == 2 ? 0.5 * forces[k] : forces[k];
      keep_largest(worst, force + (setup.has("energy_off") ? 1.001 : 1.0) * slope);
    }
    if (smooth) found.push_back(worst / largest);
  }
  Mismatch sum{static_cast<int>(found.size()), 0, 0.0};
  for (const double one : found) {
    sum.mismatched += one > 1e-6 ? 1 : 0;
    keep_largest(sum.largest, one);
  }
  return sum;
}

std::vector<TouchingPair> sliding_pairs() {
  const Rectangle square{0.3, 0.3}, box{CornerLoop::corner.x, CornerLoop::corner.y};
  const Superquadric rounded{0.3, 0.3, 20.0}, column{CornerLoop::corner.x, CornerLoop::corner.y, 20.0};
  const auto by_nodes = ContactMethod::nodes;
  return {{"rectangles", square, box},
          {"nodes: rectangles", square, box, by_nodes},
          {"n = 20", rounded, column},
          {"rectangle, n = 20", square, column},
          {"nodes: n = 20", rounded, column, by_nodes},
          {"nodes, side faces: n = 20", rounded, column, by_nodes, NodeDepth::side_face},
          {"nodes, smoother: n = 20", rounded, column, by_nodes, NodeDepth::smoother},
          {"nodes, centroid rays: n = 20", rounded, column, by_nodes, NodeDepth::centroid_ray}};
}

void check_loops(Findings& findings, const Setup& setup) {
  Table table{.name = "loops",
              .caption =
                  "A square moved round the corner of another one and back, without friction and dashpot: work of the "
                  "contact force over the largest stored energy.",
              .columns = {"outlines and rule", "work/energy", "with half as many steps"}};
  Figure figure{.name = "loop",
                .title = "Stored energy on a path round a corner",
                .caption = "Energy stored in the contact on the path round the corner, for each rule.",
                .x = {.label = "position on the path", .unit = "degrees"},
                .y = {.label = "energy", .unit = "J"}};
  double worst = 0.0;
  const double moments = setup.has("moments_halved") ? 0.5 : 1.0;
  for (const TouchingPair& pair : sliding_pairs()) {
    if (setup.coarse && std::holds_alternative<Superquadric>(pair.a)) continue;
    const int steps = setup.coarse ? 500 : 800;
    const CornerLoop loop = round_corner(pair_model(pair, stiffness), steps, moments),
                     half = round_corner(pair_model(pair, stiffness), steps / 2, moments);
    table.rows.push_back(
        {pair.name, fmt::format("{:.1e}", loop.work / loop.energy), fmt::format("{:.1e}", half.work / half.energy)});
    figure.series.push_back({pair.name, loop.angle, loop.stored, Style::lines});
    const double step = 2.0 * std::numbers::pi * CornerLoop::radius / steps;
    const double depth = std::sqrt(2.0 * loop.energy / stiffness);
    if (has_potential(pair)) keep_largest(worst, loop.work / loop.energy / (2.0 * step / depth));
  }
  findings.expect_truncation(
      {"round_a_corner", "work on a closed path round a corner, over force times step: largest of all outlines"}, worst,
      0.0, 2.0, 1.0,
      "the trapezoidal rule errs by up to half a step times the jump of the force at each kink of the path; about four "
      "kinks, of either sign");
  if (setup.coarse) return;
  findings.table(table);
  findings.figure(figure);
}

void check_slopes(Findings& findings, const Setup& setup) {
  Table table{
      .name = "slopes",
      .caption =
          "Forces compared with the gradient of the stored energy: positions tested at which the outlines overlap, "
          "positions at which the two differ by more than 1e-6, and the largest difference over the largest force.",
      .columns = {"outlines and rule", "positions", "differ", "largest"}};
  double of_resultants = 0.0, of_nodes = 0.0, smoother = 0.0, rays = 0.0;
  for (const TouchingPair& pair : pairs()) {
    if (setup.coarse && std::holds_alternative<Superquadric>(pair.b)) continue;
    const Mismatch m = mismatch(pair_model(pair, stiffness), 0.6, setup);
    table.rows.push_back(
        {pair.name, fmt::format("{}", m.positions), fmt::format("{}", m.mismatched), fmt::format("{:.1e}", m.largest)});
    double& worst = pair.method == ContactMethod::nodes ? of_nodes : of_resultants;
    const double fraction = static_cast<double>(m.mismatched) / m.positions;
    if (pair.rule == NodeDepth::smoother) smoother = fraction;
    if (pair.rule == NodeDepth::centroid_ray) rays = fraction;
    if (pair.rule == NodeDepth::nearest || pair.rule == NodeDepth::side_face) keep_largest(worst, m.largest);
  }
  const Mismatch cable = mismatch(cable_model(), 0.6, setup);
  table.rows.push_back(
      cells("cable between two bodies | {} | {} | {:.1e}", cable.positions, cable.mismatched, cable.largest));
  const auto bound = [](double measured) {
    return Tolerance::truncation(measured, 3.0,
                                 "measured: delta^2/6 times the third derivative at the sharpest corners of the "
                                 "positions tested; the rounding error u V/delta is less than a tenth of it");
  };
  findings.expect({"slope", "force against the energy gradient, resultants: largest error"}, of_resultants, 0.0,
                  bound(3e-8));
  findings.expect({"slope_by_nodes", "force against the energy gradient, nodes: largest error"}, of_nodes, 0.0,
                  bound(3e-8));
  findings.expect({"gradient_cable", "force against the energy gradient, cable: largest error"}, cable.largest, 0.0,
                  bound(7e-10));
  if (setup.coarse) return;
  findings.expect_between("fraction of positions without a potential, rule of the smoother outline", smoother, 0.1, 0.5,
                          "positions at which a node's normal is used: a known property of the rule, and measured");
  findings.expect_exact("fraction of positions without a potential, centroid-ray rule", rays, 1.0,
                        "all positions except on the axes: a known property of the 1993 rule");
  findings.table(table);
}

/// Compares the force of one node of a disc in a disc of radius 1, by the rule of the smoother outline, with the closed
/// form. The node lies `depth` below the other disc; its normal is turned by `angle` from that of the other disc there.
void check_smoother(Findings& findings) {
  constexpr double depth = 0.01, turned = 0.4;
  double worst = 0.0;
  for (const double radius : {1.2, 0.8}) {
    Model model = pair_model({"", Circle{radius}, Circle{1.0}, ContactMethod::nodes, NodeDepth::smoother}, stiffness);
    model.contacts.front().nodes = {3, 3};  // the others are outside
    record_use(model);
    Potential potential{model};
    for (const double degrees : {0.0, 30.0, -50.0, 62.0}) {
      const double angle = degrees * std::numbers::pi / 180.0;
      const Vec2 radial = rotation(turned) * Vec2{1.0, 0.0}, across = rotation(turned + angle) * Vec2{1.0, 0.0};
      const Vec2 node = (1.0 - depth) * radial, centre = node + radius * across;
      State state = rest_state(model);
      // The first node of a disc is on its x axis. The nearest nodes of the other disc are 60 degrees off the centres.
      state.q = {centre.x, centre.y, turned + angle + std::numbers::pi,
                 0.0,      0.0,      std::atan2(centre.y, centre.x) + std::numbers::pi / 3.0};
      potential.evaluate(state);
      const bool is_node_normal = radius > 1.0 && std::abs(degrees) <= 60.0;
      const Vec2 push = is_node_normal ? stiffness * depth / std::cos(angle) * across : stiffness * depth * radial;
      const std::vector<double> exact{push.x, push.y, cross(node - centre, push), -push.x, -push.y, -cross(node, push)};
      keep_worst(worst, worst_error(potential.forces(state), exact) / (stiffness * depth));
    }
  }
  findings.expect_round_off(
      {"smoother", "force and moment of a node by the rule of the smoother outline, largest error over k d"}, worst,
      0.0, 1e-12, "positions of up to 2 are rounded to 2e-16, 2e-14 of the overlap; some twenty operations");
}

void run(Findings& findings, const Setup& setup) {
  check_slopes(findings, setup);
  check_loops(findings, setup);
  check_smoother(findings);
}

}  // namespace

Case definition() {
  return {.id = "energy_slope",
          .title = "Contact force as gradient of the stored energy",
          .requirements = {{"E6",
                            {"slope", "slope_by_nodes", "gradient_cable",
                             "fraction of positions without a potential, rule of the smoother outline",
                             "fraction of positions without a potential, centroid-ray rule"}},
                           {"E8", {"round_a_corner"}},
                           {"law.linear_spring_dashpot", {"slope"}},
                           {"law.tension_only", {"gradient_cable"}},
                           {"method.resultant", {"slope", "round_a_corner"}},
                           {"method.nodes", {"slope_by_nodes", "round_a_corner"}},
                           {"shape.circle", {"slope"}},
                           {"shape.rectangle", {"slope", "round_a_corner"}},
                           {"shape.superquadric", {"slope", "slope_by_nodes"}},
                           {"shape.half_plane, shape.terrain, pair.circle.circle, pair.circle.superquadric", {"slope"}},
                           {"pair.circle.half_plane, pair.circle.terrain, pair.rectangle.half_plane", {"slope"}},
                           {"pair.superquadric.half_plane", {"slope"}},
                           {"pair.circle.rectangle, pair.rectangle.rectangle", {"slope", "slope_by_nodes"}},
                           {"pair.superquadric.superquadric, pair.superquadric.terrain", {"slope_by_nodes"}}},
          .main_checks = {"force against the energy gradient, resultants: largest error",
                          "force against the energy gradient, nodes: largest error", "round_a_corner"},
          .source = "Feng & Owen 2004",
          .faults = {{"moments_halved", "half of the moment applied", "round_a_corner"},
                     {"energy_off", "a stored energy 0.1 % too large",
                      "force against the energy gradient, nodes: largest error"}},
          .run = run};
}

}  // namespace talus::verification::problems::energy_slope
