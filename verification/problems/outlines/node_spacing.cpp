#include "verification/reference/outlines/superellipse.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::node_spacing {
namespace {

constexpr double radius = 0.7, stiffness = 1000.0;

Model disc_of_nodes(int nodes, ContactMethod method, const Setup& setup) {
  SceneBuilder builder{si};
  const BodyId disc = builder.add_free("disc", 1.0, 1.0, Circle{setup.has("radius_off") ? 1.001 * radius : radius});
  const BodyId plane = builder.add_fixed("plane", HalfPlane{});
  builder.add(Contact{.name = "touch",
                      .a = disc,
                      .b = plane,
                      .law = LinearSpringDashpot{stiffness, 0.0, EndRule::clamped},
                      .method = method,
                      .nodes = {setup.has("a_node_left_out") ? nodes - 1 : nodes, 3}});
  return builder.build();
}

/// Overlap and force of a disc that is moved along the plane as if it rolled.
struct Rolled {
  double deepest{}, shallowest{1e9};  ///< overlap of the deepest node [L]
  double force_error{};               ///< largest difference from the sum over the nodes [F]
  std::vector<double> turned, force;
};

Rolled roll(int nodes, double overlap, ContactMethod method, const Setup& setup) {
  const Model model = disc_of_nodes(nodes, method, setup);
  record_use(model);
  const Dynamics dynamics{model};
  Workspace work = dynamics.workspace();
  Rolled rolled;
  const int steps = 2 * 96;  // over two node spacings; every 48th position is exactly at or midway between nodes
  for (int i = 0; i <= steps; ++i) {
    const double angle = 4.0 * std::numbers::pi / nodes * i / steps;
    State state = rest_state(model);
    state.q = {-radius * angle, radius - overlap, angle};
    dynamics.update_all(state, work);
    dynamics.update_modes(state, work);
    const double depth = dynamics.contact_depth(work, ContactId{0});
    rolled.deepest = std::max(rolled.deepest, depth);
    rolled.shallowest = std::min(rolled.shallowest, depth);
    LawForces forces;
    dynamics.forces(state, work, forces);
    double sum = 0.0;
    for (int j = 0; j < nodes; ++j)
      sum += stiffness * std::max(0.0, overlap - radius * (1.0 + std::sin(angle + 2.0 * std::numbers::pi * j / nodes)));
    if (method == ContactMethod::resultant) sum = stiffness * overlap;
    keep_largest(rolled.force_error, forces.contacts[0] - sum);
    rolled.turned.push_back(angle * nodes / (2.0 * std::numbers::pi));
    rolled.force.push_back(forces.contacts[0] / (stiffness * overlap));
  }
  return rolled;
}

void check_rolling(Findings& findings, const Setup& setup) {
  Convergence ripples;
  Figure figure{.name = "force",
                .title = "Contact force of a rolling disc of nodes",
                .caption =
                    "Force relative to that of the circle while the disc turns from node to node, at a constant "
                    "overlap of three times the ripple or a fiftieth of the radius.",
                .x = {.label = "rotation in node spacings"},
                .y = {.label = "force over k d"}};
  double farthest = 0.0, ratio = 0.0;
  for (const double count : doublings(8.0, 6)) {
    const int nodes = static_cast<int>(count);
    const double exact = radius * (1.0 - std::cos(std::numbers::pi / count));
    const Rolled rolled = roll(nodes, 3.0 * exact, ContactMethod::nodes, setup);
    const double ripple = rolled.deepest - rolled.shallowest;
    ripples.add(1.0 / count, ripple);
    keep_largest(ratio, std::abs(ripple - exact) / radius);
    keep_largest(farthest, rolled.force_error);
    if (nodes == 16) figure.series.push_back({"16 nodes", rolled.turned, rolled.force, Style::lines});
    if (nodes != 64 || setup.coarse) continue;
    const Rolled deep = roll(nodes, 0.02 * radius, ContactMethod::nodes, setup);
    figure.series.push_back({"64 nodes, d = r/50", deep.turned, deep.force, Style::lines});
  }
  const std::string rounding = "a dozen roundings of lengths up to r";
  findings.expect_round_off(
      {"ripple", "ripple of the overlap against r (1 - cos(pi/M)), over r: largest error, 8 to 256 nodes"}, ratio, 0.0,
      12.0 * 0x1p-53, rounding);
  findings.expect_round_off({"sum_over_nodes", "force against the sum over the nodes: largest error"}, farthest, 0.0,
                            36.0 * 0x1p-53 * radius * stiffness, rounding + ", for three nodes", "N");
  findings.expect_order({"order_of_ripple", "order of the ripple in 1/nodes"}, ripples.last(4), 1.999, 2.0005,
                        "second order; the next order is pi^2/(12 M^2) of it, 1e-3 at 32 nodes");
  const Rolled whole = roll(16, 0.01, ContactMethod::resultant, setup);
  findings.expect_exact({"ripple_of_resultant", "ripple of one resultant"}, whole.deepest - whole.shallowest, 0.0,
                        "the disc's angle does not enter", "m");
  if (!setup.coarse) findings.figure(figure);
}

/// A disc of 100 nodes at the upper side of a plank, turned so that each node in turn is the lowest. Compares the
/// overlap of the contact with that of the deepest node, which is its distance from the nearest side of the plank.
void check_deepest(Findings& findings) {
  constexpr int nodes = 100;
  constexpr double half_width = 2.0, half_height = 0.3, overlap = 0.04;
  SceneBuilder builder{si};
  const BodyId disc = builder.add_free("disc", 1.0, 1.0, Circle{radius});
  const BodyId plank = builder.add_fixed("plank", Rectangle{half_width, half_height});
  builder.add(Contact{.name = "touch",
                      .a = disc,
                      .b = plank,
                      .law = LinearSpringDashpot{stiffness, 0.0, EndRule::clamped},
                      .method = ContactMethod::nodes,
                      .nodes = {nodes, 3}});
  const Model model = builder.build();
  record_use(model);
  const Dynamics dynamics{model};
  Workspace work = dynamics.workspace();
  double worst = 0.0;
  for (int turn = 0; turn < nodes; ++turn) {
    State state = rest_state(model);
    const double angle = 2.0 * std::numbers::pi * (turn + 0.2) / nodes;
    state.q = {0.3, half_height + radius - overlap, angle};
    dynamics.update_all(state, work);
    double deepest = -1.0;
    for (int j = 0; j < nodes; ++j) {
      const double at = angle + 2.0 * std::numbers::pi * j / nodes;
      deepest = std::max(deepest, std::min(half_width - std::abs(state.q[0] + radius * std::cos(at)),
                                           half_height - std::abs(state.q[1] + radius * std::sin(at))));
    }
    keep_worst(worst, dynamics.contact_depth(work, ContactId{0}) - deepest);
  }
  findings.expect_round_off("largest overlap of 100 nodes with a plank: largest error over 100 rotations", worst, 0.0,
                            12.0 * 0x1p-53, "a dozen roundings of lengths of about 1", "m");
}

void check_curvature(Findings& findings, const Setup& setup) {
  Table table{.name = "corners",
              .caption =
                  "Curvature at 45 degrees for a = b = 1, and number of nodes as in 1993 (evenly spaced in the "
                  "parametric angle) for which the chord beside the corner deviates from it by less than a hundredth "
                  "of the corner's radius.",
              .columns = {"n", "curvature", "radius", "nodes"}};
  double farthest = 0.0;
  for (const double n : {2.0, 3.0, 4.0, 8.0, 12.0, 20.0, 50.0}) {
    const Superquadric shape{1.0, 1.0, setup.has("exponent_off") ? 1.0001 * n : n};
    const double x = std::pow(2.0, -1.0 / n);
    record_shape(shape);
    const double found = curvature(shape, {x, -x}), exact = reference::corner_curvature(1.0, n);
    keep_largest(farthest, std::abs(found / exact - 1.0) / n);
    int nodes = 4;
    for (; nodes < 100000; nodes += 4) {
      const std::vector<Vec2> points = boundary_nodes(Shape{shape}, nodes);
      // With an even number of nodes in a quadrant the corner lies at the middle of a chord.
      const std::size_t before = static_cast<std::size_t>(nodes) / 8;
      if (nodes % 8 != 0) continue;
      const Vec2 chord = points[before] - points[before - 1];
      if (dot(chord, chord) * exact * exact / 8.0 < 0.01) break;
    }
    table.rows.push_back(cells("{:g} | {:.4f} | {:.4f} | {}", n, exact, 1.0 / exact, nodes));
  }
  findings.expect_round_off(
      {"corner_curvature", "curvature at the corner against its formula, over n: largest relative error, n = 2 to 50"},
      farthest, 0.0, 4.0 * 0x1p-53, "powers amplify the rounding of x by a factor of n; a few such roundings");
  // Away from the diagonal of an outline with unequal axes: compared with the turn of the outward normal along it.
  double turned = 0.0;
  for (const double n : {2.0, 3.0, 8.0}) {
    const Superquadric shape{1.0, 0.4, n};
    for (const double t : {0.4, 0.7, 1.1}) {
      constexpr double h = 1e-5;
      const Vec2 before = boundary_point(shape, t - h), after = boundary_point(shape, t + h);
      const double turn = std::asin(cross(outward_normal(shape, before), outward_normal(shape, after)));
      keep_largest(turned, curvature(shape, boundary_point(shape, t)) * norm(after - before) / turn - 1.0);
    }
  }
  findings.expect_truncation(
      "curvature with unequal axes against the rotation of the normal: largest relative error", turned, 0.0, 3.5e-10,
      1.2,
      "3.48 h^2 at n = 8, the same with h = 1e-2, 1e-3 and 1e-4, plus a rounding of 1e-16 over the rotation of 1e-5");
  if (!setup.coarse) findings.table(table);
}

/// Two turned circles that are apart: the overlap is negative, that of the node nearest to the other circle.
void check_apart(Findings& findings, const Setup& setup) {
  constexpr std::array<double, 2> radii{1.0, 0.6}, angles{0.3, -0.8};
  constexpr std::array<int, 2> nodes{5, 3};
  SceneBuilder builder;
  std::array<BodyId, 2> bodies{};
  for (std::size_t i = 0; i < 2; ++i) {
    bodies[i] =
        builder.add_free(i == 0 ? "large" : "small", 1.0, 1.0, Circle{radii[i]}, {5.0 * static_cast<double>(i), 0.0});
  }
  builder.add(Contact{.name = "apart",
                      .a = bodies[0],
                      .b = bodies[1],
                      .law = LinearSpringDashpot{1.0, 0.0},
                      .method = ContactMethod::nodes,
                      .nodes = nodes});
  const Model model = builder.build();
  Probe probe{model};
  double worst = 0.0;
  for (int turn = 0; turn < 12; ++turn) {
    const double direction = 0.5 * turn, distance = 2.5 + 0.3 * turn;
    const std::array<Vec2, 2> centres{Vec2{0.0, 0.0}, distance * Vec2{std::cos(direction), std::sin(direction)}};
    State state = rest_state(model);
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 2; ++i) {
      const double angle = angles[i] + 0.1 * turn;
      state.q[3 * i] = centres[i].x, state.q[3 * i + 1] = centres[i].y;
      state.q[3 * i + 2] = i == 0 && setup.has("angle_off") ? 0.0 : angle;
      for (int k = 0; k < nodes[i]; ++k) {
        const double at = angle + 2.0 * std::numbers::pi * k / nodes[i];
        const Vec2 node = centres[i] + radii[i] * Vec2{std::cos(at), std::sin(at)};
        nearest = std::min(nearest, norm(node - centres[1 - i]) - radii[1 - i]);
      }
    }
    probe.evaluate(state);
    keep_worst(worst, probe.overlap(0) + nearest);
  }
  findings.expect_round_off({"apart", "overlap of turned circles that are apart, by their nodes: largest error"}, worst,
                            0.0, 4e-15, "distances of up to 6 in a few roundings");
}

void run(Findings& findings, const Setup& setup) {
  if (setup.needs("apart")) check_apart(findings, setup);
  if (!setup.coarse) check_deepest(findings);
  check_rolling(findings, setup);
  check_curvature(findings, setup);
}

}  // namespace

Case definition() {
  return {.id = "node_spacing",
          .title = "Boundary nodes: spacing and sharp corners",
          .requirements = {{"E4", {"ripple", "sum_over_nodes", "order_of_ripple", "ripple_of_resultant"}},
                           {"E5", {"corner_curvature"}},
                           {"method.nodes", {"ripple", "sum_over_nodes", "apart"}},
                           {"method.resultant", {"ripple_of_resultant"}},
                           {"shape.circle", {"ripple", "order_of_ripple", "ripple_of_resultant"}},
                           {"shape.superquadric", {"corner_curvature"}}},
          .main_checks = {"ripple", "order_of_ripple", "corner_curvature"},
          .source = "Mustoe & Huttelmaier 1993, section 3.5",
          .faults = {{"a_node_left_out", "one node too few", "sum_over_nodes"},
                     {"angle_off", "one of two circles that are apart is not turned", "apart"},
                     {"radius_off", "a radius 0.1 % too large", "ripple"},
                     {"exponent_off", "an exponent 0.01 % too large", "corner_curvature"}},
          .run = run};
}

}  // namespace talus::verification::problems::node_spacing
