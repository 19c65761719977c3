#include "verification/study/scenes/moved_scene.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::dropped_square {
namespace {

constexpr double half_side = 0.5, stiffness = 1e4, speed = 1.0, step = 1.0371e-4;

enum class Target { plane, square };

/// A square turned by `angle` that falls on a plane, or on the top of a fixed block; not yet touching.
Scene fall(double angle, Target target, ContactMethod method, double aside, const Setup& setup) {
  SceneBuilder builder{si};
  const double reach = half_side * (std::abs(std::cos(angle)) + std::abs(std::sin(angle)));
  const BodyId square = builder.add_free("square", 1.0, 1.0 / 6.0,
                                         setup.has("one_point") ? Shape{Superquadric{half_side, half_side, 4000.0}}
                                                                : Shape{Rectangle{half_side, half_side}},
                                         {aside, reach + 0.01}, angle);
  const BodyId below =
      target == Target::plane
          ? builder.add_fixed("plane", HalfPlane{})
          : builder.add_fixed("block", Rectangle{setup.has("wider_to_the_left") && angle > 0.0 ? 0.2 : 0.75, 0.5},
                              {0.0, -0.5});
  builder.add(Contact{.name = "touch",
                      .a = square,
                      .b = below,
                      .law = LinearSpringDashpot{stiffness, 0.0, EndRule::clamped},
                      .method = method,
                      .friction = CoulombFriction{0.2, 0.5 * stiffness}});
  Scene scene = builder.at_rest("A square falls");
  set_velocity(scene.model, scene.initial, square, {0.0, -speed}, setup.has("a_little_spin") ? 1e-13 : 0.0);
  return scene;
}

State after(const Scene& scene, Findings& findings) {
  return run_steps(scene, VelocityVerlet{}, step, 1500, findings).state;
}

const char* name_of(Target target) { return target == Target::plane ? "plane" : "block"; }
const char* name_of(ContactMethod method) { return method == ContactMethod::nodes ? "nodes" : "resultant"; }
std::string claim_of(ContactMethod method) { return fmt::format("method.{}", name_of(method)); }

/// Compares falls to the left with their mirror images to the right at many angles, including corner and edge.
void check_mirror(Findings& findings, const Setup& setup) {
  const double corner = 0.25 * std::numbers::pi;
  for (const Target target : {Target::plane, Target::square}) {
    for (const ContactMethod method : {ContactMethod::resultant, ContactMethod::nodes}) {
      const auto group = findings.in(name_of(target)), claim = findings.in(claim_of(method));
      double differing = 0.0;
      for (const double angle : {0.0, 1e-9, 1e-4, 0.3, corner - 1e-9, corner, corner + 1e-9, 1.1}) {
        if (setup.coarse && angle != 0.3) continue;
        for (const double aside : {0.0, 0.31, 0.75}) {
          State left = after(fall(angle, target, method, aside, setup), findings);
          const State right = after(fall(-angle, target, method, -aside, setup), findings);
          left.q = {-left.q[0], left.q[1], -left.q[2]};
          left.v = {-left.v[0], left.v[1], -left.v[2]};
          const Difference apart = difference(left, right);
          keep_largest(differing, apart.position), keep_largest(differing, apart.velocity);
        }
      }
      findings.expect_round_off(
          {"mirror", fmt::format("difference between mirror-image falls, {}, {}", name_of(target), name_of(method))},
          differing, 0.0, 4.0 * std::sqrt(300.0) * 0x1p-53,
          "corners and nodes are summed in the order of their list, which rounds mirror images differently in each of "
          "about 300 steps in contact",
          "m, m/s");
    }
  }
}

/// Checks that falls without a tilt keep their symmetry.
void check_even(Findings& findings, const Setup& setup) {
  for (const Target target : {Target::plane, Target::square}) {
    for (const ContactMethod method : {ContactMethod::resultant, ContactMethod::nodes}) {
      const auto group = findings.in(name_of(target)), claim = findings.in(claim_of(method));
      const State end = after(fall(0.0, target, method, 0.0, setup), findings);
      findings.expect_exact(
          {"flat_falls", fmt::format("spin of a square that fell flat, {}, {}", name_of(target), name_of(method))},
          std::abs(end.v[2]) + std::abs(end.v[0]), 0.0,
          "both halves have identical numbers, so that their moments cancel", "rad/s");
    }
  }
}

/// Order of the spin after the fall in the tilt, as the tilt goes to zero.
void check_offsets(Findings& findings, const Setup& setup) {
  const double corner = 0.25 * std::numbers::pi;
  Figure figure{
      .name = "offsets",
      .title = "Spin after a nearly symmetric fall",
      .caption =
          "Spin of the square after its fall on a plane against its tilt from the symmetric position. It tends to zero "
          "with the tilt both on the corner and on the edge, where the side is supported at both ends.",
      .x = {.label = "tilt", .unit = "rad", .log = true},
      .y = {.label = "spin", .unit = "rad/s", .log = true}};
  struct Fall {
    const char* name;
    double angle;
    ContactMethod method;
  };
  const Fall falls[] = {{"on a corner, resultant", corner, ContactMethod::resultant},
                        {"on the edge, resultant", 0.0, ContactMethod::resultant},
                        {"on the edge, nodes", 0.0, ContactMethod::nodes}};
  for (const Fall& one : falls) {
    if (setup.coarse && &one != &falls[1]) continue;
    Series series{one.name, {}, {}, Style::linespoints};
    const double even = after(fall(one.angle, Target::plane, one.method, 0.0, setup), findings).v[2];
    for (double tilt = 1e-12; tilt < 2e-3; tilt *= 10.0) {
      const State end = after(fall(one.angle + tilt, Target::plane, one.method, 0.0, setup), findings);
      series.add(tilt, std::max(std::abs(end.v[2] - even), 1e-17));
    }
    figure.series.push_back(series);
    Convergence spins;
    for (std::size_t i = 1; i < 9; ++i)
      spins.add(series.x[i], series.y[i]);
    const auto group = findings.in("plane"), claim = findings.in(claim_of(one.method));
    findings.expect_order({"tilts", fmt::format("order of the spin in the tilt, {}", one.name)}, spins, 0.999, 1.0005,
                          "the spin is proportional to the tilt");
  }
  findings.figure(figure);
}

void run(Findings& findings, const Setup& setup) {
  check_mirror(findings, setup);
  check_even(findings, setup);
  check_offsets(findings, setup);
}

}  // namespace

Case definition() {
  return {
      .id = "dropped_square",
      .title = "Square dropped on edge and corner",
      .requirements = {{"E7", {"mirror", "flat_falls", "tilts"}},
                       {"shape.rectangle", {"mirror"}},
                       {"shape.half_plane", {"plane"}},
                       {"Eq. 18", {"mirror"}},
                       {"pair.rectangle.half_plane", {"plane"}},
                       {"pair.rectangle.rectangle", {"block"}}},
      .main_checks = {"difference between mirror-image falls, plane, resultant",
                      "spin of a square that fell flat, block, resultant",
                      "order of the spin in the tilt, on a corner, resultant",
                      "order of the spin in the tilt, on the edge, resultant"},
      .source = "Housner 1963",
      .faults = {{"wider_to_the_left", "a block of another width when the square is tilted to the left",
                  "difference between mirror-image falls, block, resultant"},
                 {"one_point", "a side in contact at one point only, its deeper end",
                  "order of the spin in the tilt, on the edge, resultant"},
                 {"a_little_spin", "an initial spin of 1e-13", "spin of a square that fell flat, plane, resultant"}},
      .run = run};
}

}  // namespace talus::verification::problems::dropped_square
