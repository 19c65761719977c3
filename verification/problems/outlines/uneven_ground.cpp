#include "solver/geometry/penetration.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::uneven_ground {
namespace {

constexpr double radius = 0.5, mass = 2.0, gravity = 10.0;
constexpr double sine = 0.6, cosine = 0.8, tangent = 0.75;

/// A body, a disc unless a shape is given, on fixed ground; contact 0 is between it and the first ground body.
Scene disc_on(const std::vector<Body>& ground, Vec2 position, const LinearSpringDashpot& law,
              const CoulombFriction& friction, Mobility mobility, double inertia, const Shape& shape = Circle{radius}) {
  SceneBuilder builder;
  builder.gravity({0.0, -gravity});
  const BodyId disc = builder.add(Body{.name = "disc",
                                       .mobility = mobility,
                                       .mass = mass,
                                       .inertia = mobility == Mobility::free ? inertia : 0.0,
                                       .shape = shape,
                                       .p_WB = position});
  for (const Body& body : ground) {
    const BodyId below = builder.add(body);
    const bool is_disc = std::holds_alternative<Circle>(shape);
    builder.add({.name = "on_" + body.name,
                 .a = disc,
                 .b = below,
                 .law = law,
                 .method = is_disc ? ContactMethod::resultant : ContactMethod::nodes,
                 .friction = friction});
  }
  return builder.at_rest("Disc on uneven ground");
}

Body fixed_body(const Shape& shape, double angle = 0.0) {
  return {.name = "ground", .mobility = Mobility::fixed, .shape = shape, .angle = angle};
}

constexpr double disc_inertia = 0.5 * mass * radius * radius;

State run(const Scene& scene, double step, double end, Findings& findings) {
  return run_scene(scene, VelocityVerlet{}, {step, end, 1e9, false}, findings).state;
}

/// A disc and a rectangle bounce, slip and turn down a slope of three segments: the same bits as on a half-plane.
void check_straight(Findings& findings, const Setup& setup) {
  const double lift = setup.has("bent_ground") ? 1e-12 : 0.0;
  const Terrain straight{{{-0.3, 0.0}, {0.4, 0.0}, {1.1, lift}, {1.6, 2.0 * lift}}};
  int differ = 0, compared = 0;
  for (const Shape& body : {Shape{Circle{radius}}, Shape{Rectangle{radius, 0.3}}}) {
    for (const double angle : {-0.3, -0.6, -1.0}) {
      std::array<State, 2> ends;
      for (std::size_t i = 0; i < 2; ++i) {
        const Shape ground = i == 0 ? Shape{HalfPlane{}} : Shape{straight};
        const Scene scene = disc_on({fixed_body(ground, angle)}, {0.0, 0.9}, {2e4, 20.0, EndRule::clamped}, {0.3, 1e4},
                                    Mobility::free, disc_inertia, body);
        ends[i] = run(scene, 1.0 / 8192.0, 1.0, findings);
      }
      const auto compare = [&](const std::vector<double>& one, const std::vector<double>& other) {
        for (std::size_t i = 0; i < one.size(); ++i) {
          ++compared;
          if (one[i] != other[i]) ++differ;
        }
      };
      compare(ends[0].q, ends[1].q);
      compare(ends[0].v, ends[1].v);
      compare(ends[0].z, ends[1].z);
    }
  }
  findings.expect_exact(
      {"straight_terrain", "numbers that differ between straight terrain and a half-plane"}, differ, 0.0,
      "above a segment on the body's x axis the height is the body's y, and the normal is (0, 1), without rounding");
  findings.expect_exact("numbers compared", compared, 51.0,
                        "three runs each, of 3 positions, 3 velocities and a stretch, or those of four corners");
}

/// A disc rolls over a crest: compares its speed down the slope with the rigid disc's, and checks the energy balance.
void check_crest(Findings& findings, const Setup& setup) {
  const double stiffness = 1e6 * mass, overlap = mass * gravity / stiffness, start_speed = 0.5;
  const double drop = setup.has("slope_too_flat") ? 0.745 : tangent;
  const Terrain crest{{{-1.0, 0.0}, {0.0, 0.0}, {1.0, -drop}}};
  Scene scene = disc_on({fixed_body(crest)}, {-0.2, radius - overlap}, {stiffness, 0.0}, {5.0, stiffness},
                        Mobility::free, disc_inertia);
  scene.initial.v = {start_speed, 0.0, -start_speed / (radius - 0.5 * overlap)};
  std::optional<RunLedger> ledger;
  Series speed{"solver", {}, {}, Style::points}, exact{"rigid", {}, {}, Style::lines};
  double worst = std::nan(""), balance_error = 0.0;  // NaN until the crest is reached
  const Watcher watch = [&](const State& seen, const StepInfo&) {
    if (!ledger) ledger.emplace(scene.model, seen);  // first state with updated modes: contact closed
    keep_largest(balance_error, (*ledger)(seen).energy_balance_error);
    const double s = cosine * seen.q[0] - sine * seen.q[1];
    if (s < 0.0) return;
    const double v = cosine * seen.v[0] - sine * seen.v[1];
    const double fallen = radius * (1.0 - cosine) + s * sine;
    const double rigid = std::sqrt(start_speed * start_speed + 4.0 / 3.0 * gravity * fallen);
    if (!(std::abs(v - rigid) <= std::abs(worst))) worst = v - rigid;
    if (!speed.x.empty() && s - speed.x.back() < 0.04) return;
    speed.add(s, v);
    exact.add(s, rigid);
  };
  const double step = 4e-5;
  if (!run_scene(scene, VelocityVerlet{}, {step, 1.0, 1e9, false}, findings, watch).finished) worst = std::nan("");
  const double first = std::sqrt(start_speed * start_speed + 4.0 / 3.0 * gravity * radius * (1.0 - cosine));
  findings.expect_model({"slope_speed", "speed down the slope beyond a crest, largest error"}, worst, 0.0,
                        overlap * (2.0 / 3.0 * gravity / first + 2.0 / (6.0 * radius)),
                        "the overlap changes heights and the rolling radius by at most its own value: 2 g d/(3 v), "
                        "largest where the disc is slowest, and v d/(6 r), with v up to 2",
                        "m/s");
  findings.expect_truncation({"crest_energy", "energy balance over the crest: largest error"}, balance_error, 0.0,
                             4.6 * step * step, 2.0,
                             "leapfrog conserves H + h^2 (v V'' v/12 - F^2/(24 m)), whose second part changes by a few "
                             "J/s^2 with the forces of 20 N; measured: 4.6 h^2 at steps from 2e-5 to 4e-5",
                             "J");
  if (setup.coarse || exact.x.empty()) return;
  findings.figure({.name = "crest",
                   .title = "Speed beyond a crest",
                   .caption = "Speed of the disc's centre along the slope against the distance from the crest.",
                   .x = {.label = "distance down the slope", .unit = "m"},
                   .y = {.label = "speed", .unit = "m/s"},
                   .series = {exact, speed}});
}

/// Final state of a disc that falls into a notch, or between two separate slopes, and comes to rest.
State rest_in_notch(bool two, const Setup& setup, double step, Findings& findings) {
  const double stiffness = 2000.0, low = setup.has("lopsided_notch") ? 0.7 : tangent;
  const std::vector<Body> notch{fixed_body(Terrain{{{-4.0, 3.0}, {0.0, 0.0}, {4.0, 4.0 * low}}})};
  Body left = fixed_body(Terrain{{{-4.0, 3.0}, {4.0, -3.0}}}), right = fixed_body(Terrain{{{-4.0, -3.0}, {4.0, 3.0}}});
  left.name = "left";
  right.name = "right";
  const Scene scene =
      disc_on(two ? std::vector<Body>{left, right} : notch, {0.0, radius / cosine + 0.02},
              {stiffness, 2.0 * 0.5 * std::sqrt(stiffness * mass)}, {0.0, stiffness}, Mobility::particle, 0.0);
  return run(scene, step, 4.0, findings);
}

void check_notch(Findings& findings, const Setup& setup) {
  const double stiffness = 2000.0, step = 1.0 / 1024.0;
  const auto depth = [](const State& end) { return radius - cosine * end.q[1]; };
  const State one = rest_in_notch(false, setup, step, findings), two = rest_in_notch(true, setup, step, findings);
  const double slowest = 3.0 * gravity * tangent * step;
  findings.expect_truncation({"notch_position", "position across the notch"}, one.q[0], 0.0,
                             slowest * slowest / (2.0 * gravity * tangent), 2.0,
                             "measured: the disc oscillates at about three times g tan a h, at all steps from 1/1024 "
                             "to 1/16384; the displacement within which the sides reverse that speed",
                             "m");
  findings.expect_truncation({"notch_overlap", "overlap in the notch, over m g/(k cos a)"},
                             depth(one) * stiffness * cosine / (mass * gravity), 1.0, 6.0 * step, 2.0,
                             "measured: six times the step, due to the dashpot's lag");
  Convergence overlaps;
  for (const double count : {2048.0, 4096.0, 8192.0, 16384.0}) {
    const double rest = depth(rest_in_notch(false, setup, 1.0 / count, findings));
    overlaps.add(1.0 / count, std::abs(rest * stiffness * cosine / (mass * gravity) - 1.0));
  }
  findings.expect_order({"order_in_notch", "order of the overlap in the notch"}, overlaps, 0.9, 1.1,
                        "the dashpot uses a velocity that results from a force whose direction alternates in each "
                        "step: first order; the phase of the oscillation at the end changes the order by up to 0.1");
  findings.expect_round_off(
      {"two_slopes", "overlap between two slopes, over m g/(2 k cos a)"},
      depth(two) * 2.0 * stiffness * cosine / (mass * gravity), 1.0, 3e-13,
      "a disc stops where it moves by less than half a unit in the last place of its position, 5.5e-17, in a step: it "
      "is short of rest by c/k times that over the step, 1.8e-15, over an overlap of 0.006");
  findings.expect_round_off("position across between two slopes", two.q[0], 0.0, 1e-15,
                            "both sides push with the same numbers except for the last digit of their normals", "m");
}

/// Overlap of outlines with a peak that pierces their lowest point, as searched for contacts that nodes do not see: its
/// depth in the outline, because each outline is above the slopes beside it.
void check_peak(Findings& findings) {
  constexpr double depth = 0.125, half_height = 0.5;
  const Terrain peak{{{-1.0, -tangent}, {0.0, 0.0}, {1.0, -tangent}}};
  double worst = 0.0;
  for (const Shape& shape : {Shape{Circle{half_height}}, Shape{Rectangle{0.75, half_height}}}) {
    for (const double angle : {0.0, 0.7}) {
      Pose ground, body;
      ground.p_WB = {3.0, -2.0}, ground.R_WB = body.R_WB = rotation(angle);
      body.p_WB = ground.p_WB + ground.R_WB * Vec2{0.0, half_height - depth};
      keep_worst(worst, penetration(shape, body, peak, ground) - depth);
      keep_worst(worst, penetration(peak, ground, shape, body) - depth);
    }
  }
  findings.expect_round_off("overlap of a disc and a rectangle pierced by a peak, largest error", worst, 0.0, 2e-15,
                            "positions of 3 m, rounded to 2.2e-16, turned into the outline's frame: four roundings",
                            "m");
}

/// Overlap of outlines with each segment of a valley, the last one too: the depth along the normal of the segment.
void check_segments(Findings& findings) {
  constexpr double depth = 0.125, radius = 0.5;
  const std::vector<Vec2> points{{-3.0, 1.5}, {-1.0, 0.0}, {1.0, 0.0}, {3.0, 1.0}};
  double worst = 0.0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Vec2 along = points[i + 1] - points[i];
    const Vec2 normal = (1.0 / norm(along)) * Vec2{-along.y, along.x};
    Pose ground, body;
    ground.p_WB = {3.0, -2.0}, ground.R_WB = rotation(0.2);
    body.p_WB = ground.p_WB + ground.R_WB * (0.5 * (points[i] + points[i + 1]) + (radius - depth) * normal);
    keep_worst(worst, penetration(Circle{radius}, body, Terrain{points}, ground) - depth);
  }
  // A plane that is displaced and turned.
  Pose plane, disc;
  plane.p_WB = {3.0, -2.0}, plane.R_WB = rotation(0.2);
  disc.p_WB = plane.p_WB + plane.R_WB * Vec2{0.7, radius - depth};
  keep_worst(worst, penetration(Circle{radius}, disc, HalfPlane{}, plane) - depth);
  findings.expect_round_off(
      {"each_segment", "overlap of a disc with each segment of a valley and with a plane, largest error"}, worst, 0.0,
      4e-15, "positions of 3 m, rounded to 2.2e-16, turned twice: eight roundings", "m");
}

/// Overlap of superquadrics with a plane and a slope, which are displaced and turned. The point of the outline that is
/// farthest along (1/a, 1/b), in its axes, is (a, b)/2^(1/n), because x/a + y/b is largest where both powers are equal.
void check_superquadrics(Findings& findings) {
  constexpr double a = 0.75, b = 0.5, depth = 0.125;
  double worst = 0.0;
  for (const double n : {2.0, 4.0, 9.0}) {
    Pose ground, body;
    ground.p_WB = {3.0, -2.0}, ground.R_WB = rotation(0.2);
    body.R_WB = rotation(0.2 + 0.5 * std::numbers::pi - std::atan2(1.0 / b, 1.0 / a));
    const double height = 2.0 * std::pow(0.5, 1.0 / n) / std::hypot(1.0 / a, 1.0 / b) - depth;
    body.p_WB = ground.p_WB + ground.R_WB * Vec2{0.7, height};
    for (const Shape& under : {Shape{HalfPlane{}}, Shape{Terrain{{{-4.0, 0.0}, {4.0, 0.0}}}}})
      keep_worst(worst, penetration(Superquadric{a, b, n}, body, under, ground) - depth);
  }
  findings.expect_round_off("overlap of superquadrics with a plane and with a slope, largest error", worst, 0.0, 8e-15,
                            "as for a disc, with a power and a root for each half axis: sixteen roundings", "m");
}

void run_all(Findings& findings, const Setup& setup) {
  check_straight(findings, setup);
  check_crest(findings, setup);
  check_notch(findings, setup);
  if (!setup.coarse) check_peak(findings), check_segments(findings), check_superquadrics(findings);
}

}  // namespace

Case definition() {
  return {.id = "uneven_ground",
          .title = "Uneven ground: slope, crest and notch",
          .family = "E: outlines in contact",
          .requirements = {{"shape.terrain, shape.circle",
                            {"straight_terrain", "slope_speed", "crest_energy", "notch_position", "notch_overlap",
                             "order_in_notch"}},
                           {"pair.circle.terrain",
                            {"straight_terrain", "slope_speed", "crest_energy", "notch_position", "notch_overlap",
                             "order_in_notch", "two_slopes", "position across between two slopes"}},
                           {"shape.rectangle, pair.rectangle.terrain", {"straight_terrain"}},
                           {"C2", {"slope_speed", "crest_energy"}},
                           {"law.linear_spring_dashpot",
                            {"straight_terrain", "notch_position", "notch_overlap", "order_in_notch"}},
                           {"mechanism.friction", {"crest_energy"}}},
          .main_checks = {"straight_terrain", "slope_speed", "crest_energy", "notch_position", "notch_overlap",
                          "two_slopes"},
          .source = "Textbook mechanics, derived here",
          .faults = {{"bent_ground", "ground bent by 1e-12 at its joints", "straight_terrain"},
                     {"slope_too_flat", "a slope beyond the crest 0.7 % too flat", "slope_speed"},
                     {"lopsided_notch", "one side of the notch flatter", "notch_position"}},
          .run = run_all};
}

}  // namespace talus::verification::problems::uneven_ground
