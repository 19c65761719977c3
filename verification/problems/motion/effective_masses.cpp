#include "solver/dynamics/effective_mass.hpp"
#include "solver/stability/contact_range.hpp"
#include "solver/stability/step_advice.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::effective_masses {
namespace {

constexpr double mass = 1.7, inertia = 0.45, stiffness = 250.0, damping = 3.0;
constexpr Vec2 at{0.5, 0.6}, pin_of_body{0.3, -0.2};
constexpr double tilt = 0.35, half_width = 0.7, half_height = 0.35;

/// Attachment point of a cable on the body, and the anchor at which the cable ends.
struct Line {
  Vec2 point;   ///< in body coordinates [L]
  Vec2 anchor;  ///< world [L]
};
constexpr std::array lines{Line{{-0.5, 0.2}, {-1.4, 2.1}}, Line{{0.4, 0.3}, {1.9, -1.2}}};

/// Position of the centre of mass and angle of the body, for coordinates that start from zero. They are written here
/// for each mobility, from what the pin and the guide allow.
struct BodyPose {
  Vec2 centre;
  double angle{};
};

std::size_t coordinates_of(Mobility mobility) {
  return (has_x(mobility) ? 1u : 0u) + (has_y(mobility) ? 1u : 0u) + (turns(mobility) ? 1u : 0u);
}

Vec2 turned(Vec2 p, double angle) {
  return {std::cos(angle) * p.x - std::sin(angle) * p.y, std::sin(angle) * p.x + std::cos(angle) * p.y};
}

BodyPose pose_of(Mobility mobility, const std::vector<double>& q) {
  BodyPose pose{at, tilt};
  std::size_t next = 0;
  if (has_x(mobility)) pose.centre.x += q[next++];
  if (has_y(mobility)) pose.centre.y += q[next++];
  if (turns(mobility)) pose.angle += q[next];
  const Vec2 pin = at + turned(pin_of_body, tilt), arm = turned(pin_of_body, pose.angle);
  if (mobility == Mobility::pinned) pose.centre = pin - arm;
  if (mobility == Mobility::guided_x) pose.centre.y = pin.y - arm.y;
  if (mobility == Mobility::guided_y) pose.centre.x = pin.x - arm.x;
  return pose;
}

Vec2 direction(const Line& line) {
  const Vec2 along = line.anchor - (at + turned(line.point, tilt));
  return (1.0 / norm(along)) * along;
}

/// Velocity of the point on one line, along that line, for a unit impulse on another line [1/M]: sum of g_1 g_2/M over
/// the coordinates. The derivatives g of the points and those of the kinetic energy are central differences of the
/// position.
double mobility_between(Mobility mobility, const Line& one, const Line& two) {
  constexpr double step = 1e-5;
  double sum = 0.0;
  const std::size_t count = coordinates_of(mobility);
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<double> q(count, 0.0);
    q[i] = step;
    const BodyPose after = pose_of(mobility, q);
    q[i] = -step;
    const BodyPose before = pose_of(mobility, q);
    const auto change = [&](const Line& line) {
      const Vec2 moved =
          after.centre + turned(line.point, after.angle) - before.centre - turned(line.point, before.angle);
      return dot(moved, direction(line)) / (2.0 * step);
    };
    const Vec2 centre = (0.5 / step) * (after.centre - before.centre);
    const double turn = (0.5 / step) * (after.angle - before.angle);
    sum += change(one) * change(two) / (mass * dot(centre, centre) + inertia * turn * turn);
  }
  return sum;
}

/// Largest mobility of the body along any normal of its outline, by a search: at a corner the normals lie between those
/// of its sides, and along a side the mobility is largest at an end.
double largest_mobility(Mobility mobility) {
  constexpr int directions = 400;
  double largest = 0.0;
  for (const double x : {1.0, -1.0}) {
    for (const double y : {1.0, -1.0}) {
      const Vec2 corner{x * half_width, y * half_height};
      for (int i = 0; i <= directions + 2; ++i) {
        // The last two are the axes along which a body slides.
        const double angle = i <= directions       ? 0.5 * std::numbers::pi * i / directions
                             : i == directions + 1 ? tilt
                                                   : 0.5 * std::numbers::pi - tilt;
        const Vec2 normal = turned({x * std::cos(angle), y * std::sin(angle)}, tilt);
        const Line line{corner, at + turned(corner, tilt) + normal};
        largest = std::max(largest, mobility_between(mobility, line, line));
      }
    }
  }
  return largest;
}

/// A body attached to one cable or to both.
Scene scene_of(Mobility mobility, std::size_t cables, const Setup& setup) {
  SceneBuilder builder;
  Body body{.name = "body",
            .mobility = mobility,
            .mass = mass,
            .inertia = inertia,
            .shape = Rectangle{half_width, half_height}};
  body.p_WB = at, body.angle = tilt, body.p_BPin = pin_of_body;
  if (setup.has("pin_forgotten")) body.p_BPin = {};
  const BodyId id = builder.add(body);
  for (std::size_t c = 0; c < cables; ++c) {
    const Line& line = lines[c];
    builder.add_cable(fmt::format("cable_{}", c), {{}, {line.anchor.x, line.anchor.y}},
                      {id, {line.point.x, line.point.y}}, norm(line.anchor - (at + turned(line.point, tilt))) - 0.1,
                      TensionOnly{stiffness, damping});
  }
  return builder.at_rest("Held body");
}

const Tolerance by_differences =
    Tolerance::truncation(2e-11, 3.0,
                          "central differences of positions of about 1 with h = 1e-5: h^2/6 = 1.7e-11 times third "
                          "derivatives, and rounding of 1e-16/h")
        .relative();

void check(Mobility mobility, Findings& findings, const Setup& setup, Table& table) {
  const std::string name{name_of(mobility)};
  const Scene scene = scene_of(mobility, 2, setup);
  record_use(scene.model);
  const Dynamics dynamics{scene.model};
  const PointMobility points{scene.model};
  const Pose now = pose(scene.model, scene.initial, BodyId{});
  const auto line = [&](const Line& of) { return ImpulseLine{at + turned(of.point, tilt), direction(of)}; };
  const std::array<std::array<double, 2>, 2> exact{
      {{mobility_between(mobility, lines[0], lines[0]), mobility_between(mobility, lines[0], lines[1])},
       {mobility_between(mobility, lines[1], lines[0]), mobility_between(mobility, lines[1], lines[1])}}};
  const auto group = findings.in(fmt::format("mobility.{}", name));
  findings.expect({"impulses", fmt::format("mobility along a line, {}", name)},
                  points.between(BodyId{}, now, line(lines[0]), line(lines[0])), exact[0][0], by_differences, "1/kg");
  findings.expect_truncation({"impulses", fmt::format("mobility between two lines, {}", name)},
                             points.between(BodyId{}, now, line(lines[0]), line(lines[1])), exact[0][1], 2e-11, 3.0,
                             "central differences with h = 1e-5, as for the mobility along one line", "1/kg");
  const StepAdvice advice = advise_step(dynamics, scene.initial);
  for (std::size_t c = 0; c < 2; ++c) {
    const SpringAdvice& spring = advice.springs[c];
    findings.expect({"springs", fmt::format("frequency of {}, {}", spring.name, name)}, spring.frequency,
                    std::sqrt(stiffness * exact[c][c]), by_differences, "rad/s");
    findings.expect({"springs", fmt::format("damping ratio of {}, {}", spring.name, name)}, spring.damping_ratio,
                    0.5 * damping * std::sqrt(exact[c][c] / stiffness), by_differences);
  }
  // Modes of two springs: eigenvalues of k times the matrix of mobilities between them; at most one for each
  // coordinate.
  const double trace = exact[0][0] + exact[1][1], determinant = exact[0][0] * exact[1][1] - exact[0][1] * exact[1][0];
  const double root = std::sqrt(std::max(0.0, 0.25 * trace * trace - determinant));
  const double fast = std::sqrt(stiffness * (0.5 * trace + root));
  findings.expect_exact({"modes", fmt::format("number of natural modes, {}", name)},
                        static_cast<double>(advice.modes.size()),
                        static_cast<double>(std::min<std::size_t>(2, coordinates_of(mobility))),
                        "two springs, but no more modes than coordinates");
  findings.expect({"modes", fmt::format("fastest mode, {}", name)}, advice.modes.back().frequency, fast, by_differences,
                  "rad/s");
  if (coordinates_of(mobility) > 1) {
    findings.expect({"modes", fmt::format("slowest mode, {}", name)}, advice.modes.front().frequency,
                    std::sqrt(stiffness * (0.5 * trace - root)), by_differences, "rad/s");
  }
  // Pulled by one cable alone, the point starts with the acceleration tension times mobility.
  const Scene pulled = scene_of(mobility, 1, setup);
  constexpr double h = 1e-5;
  const RunEnd run = run_steps(pulled, make_integrator("rk4"), h, 1, findings);
  const Pose then = pose(pulled.model, run.state, BodyId{});
  const Vec2 arm = turned(lines[0].point, tilt);
  const double started = dot(then.v_WB + cross(then.w_WB, arm), direction(lines[0])) / h;
  findings.expect({"forces", fmt::format("initial acceleration by a cable tension, {}", name)}, started,
                  0.1 * stiffness * exact[0][0],
                  Tolerance::truncation(0.5 * damping * exact[0][0] * h + 2e-11, 3.0,
                                        "the dashpot reduces it by the fraction c h/(2 m_eff) within the first step")
                      .relative(),
                  "m/s^2");
  table.rows.push_back(cells("{} | {:.6f} | {:.6f} | {:.4f} | {:.4f}", name, 1.0 / exact[0][0], 1.0 / exact[1][1],
                             advice.modes.front().frequency, advice.modes.back().frequency));
}

/// Checks friction between two free discs: 1/m = 1/m_1 + 1/m_2 + r_1^2/I_1 + r_2^2/I_2 along the tangent, also while
/// they are apart, for the contact that they will have; and the same for two squares with facing sides.
/// `follows`: the dashpot is that of the normal law times k_s/k, the default of a scene.
void check_friction(bool squares, double gap, bool follows, Findings& findings) {
  constexpr double k_s = 180.0;
  const double c_s = follows ? damping * k_s / stiffness : 2.5;
  constexpr std::array<double, 2> masses{1.7, 0.6}, inertias{0.45, 0.08}, radii{0.7, 0.4};
  const Vec2 along{std::cos(0.9), std::sin(0.9)};
  SceneBuilder builder;
  std::array<BodyId, 2> discs;
  for (std::size_t i = 0; i < 2; ++i) {
    Body body{.name = fmt::format("disc_{}", i),
              .mobility = Mobility::free,
              .mass = masses[i],
              .inertia = inertias[i],
              .shape = squares ? Shape{Rectangle{radii[i], radii[i]}} : Shape{Circle{radii[i]}}};
    body.angle = squares ? 0.9 : 0.0;
    body.p_WB = at + (i == 0 ? 0.0 : radii[0] + radii[1] + gap) * along;
    discs[i] = builder.add(body);
  }
  builder.add_contact("touch", discs[0], discs[1], LinearSpringDashpot{stiffness, damping},
                      follows ? CoulombFriction{0.5, k_s, 0.0, true} : CoulombFriction{0.5, k_s, c_s});
  Scene scene = builder.at_rest("Two discs");
  record_use(scene.model);
  const Dynamics dynamics{scene.model};
  double inverse = 0.0;
  for (std::size_t i = 0; i < 2; ++i)
    inverse += 1.0 / masses[i] + radii[i] * radii[i] / inertias[i];
  int end = 0;  // two squares touch at both ends of their sides
  for (const SpringAdvice& spring : advise_step(dynamics, scene.initial).springs) {
    if (spring.name != "touch friction") continue;
    const auto rounding = Tolerance::round_off(2e-15,
                                               "a sum of four quotients, from positions of about 1: some twenty "
                                               "roundings of 1.1e-16 if all have the same sign")
                              .relative();
    if (gap > 0.0) {
      findings.expect(
          {"springs",
           squares ? fmt::format("frequency of the friction spring between two squares 10 m apart, end {}", ++end)
                   : "frequency of the friction spring between two discs 10 m apart"},
          spring.frequency, std::sqrt(k_s * inverse),
          Tolerance::round_off(4e-15,
                               "positions of about 10 m, which determine the levers of 0.7 and 0.4 m: three roundings "
                               "of 8.9e-16 over 0.4, halved by the square root")
              .relative(),
          "rad/s");
      continue;
    }
    const std::string dashpot = follows ? ", dashpot that follows from the normal one" : "";
    findings.expect({"springs", "frequency of the friction spring between two discs" + dashpot}, spring.frequency,
                    std::sqrt(k_s * inverse), rounding, "rad/s");
    findings.expect({"springs", "damping ratio of the friction spring between two discs" + dashpot},
                    spring.damping_ratio, 0.5 * c_s * std::sqrt(inverse / k_s), rounding);
  }
}

/// Checks the spring of a contact by Hunt & Crossley's law, F = k d (d/r)^(n - 1) (1 + a dd/dt), at its reference
/// overlap r: the derivatives of F with respect to d and dd/dt are n k and a k r.
void check_power_law(Findings& findings) {
  constexpr double disc_mass = 0.6, reference_overlap = 0.02, hysteresis = 0.3;
  const auto rounding =
      Tolerance::round_off(2e-15, "about ten products, quotients and roots, each rounded by 1.1e-16").relative();
  for (const double n : {1.5, 3.0}) {
    SceneBuilder builder;
    const BodyId plane = builder.add_fixed("plane", HalfPlane{});
    const BodyId disc = builder.add_particle("disc", disc_mass, {0.0, 0.5}, Circle{0.5});
    builder.add_contact("touch", disc, plane, HuntCrossley{stiffness, reference_overlap, n, hysteresis});
    const Scene scene = builder.at_rest("Disc on a plane");
    record_use(scene.model);
    const Dynamics dynamics{scene.model};
    const SpringAdvice spring = advise_step(dynamics, scene.initial).springs.front();
    const std::string law = fmt::format("contact by hunt_crossley, n = {:g}", n);
    const double frequency = std::sqrt(n * stiffness / disc_mass);
    findings.expect({"springs", "frequency of a " + law}, spring.frequency, frequency, rounding, "rad/s");
    findings.expect({"springs", "damping ratio of a " + law}, spring.damping_ratio,
                    hysteresis * stiffness * reference_overlap / (2.0 * disc_mass * frequency), rounding);
    findings.expect({"springs", "duration of a " + law}, spring.contact_time, std::numbers::pi / frequency, rounding,
                    "s");
  }
}

/// Checks the smallest effective mass of a contact over all positions, between the body and a disc that cannot turn.
/// The bound of a guided body holds for all its angles and is not reached at this one.
void check_bound(Mobility mobility, Findings& findings, const Setup& setup) {
  constexpr double disc_mass = 0.6;
  SceneBuilder builder;
  Body body = scene_of(mobility, 0, setup).model.bodies.front();
  if (setup.has("sides_exchanged")) body.shape = Rectangle{half_height, half_width};
  const BodyId hit = builder.add(body);
  const BodyId disc = builder.add_particle("disc", disc_mass, {3.0, 3.0}, Circle{0.1});
  builder.add_contact("touch", hit, disc, LinearSpringDashpot{stiffness, damping});
  const Model model = builder.build();
  const ContactRange range = contact_ranges(Dynamics{model}).front();
  const double found = range.smallest_mass;
  const double exact = 1.0 / (1.0 / disc_mass + largest_mobility(mobility));
  // The normal that goes through the centre and, if the body has one, its pin, or across its guide: only a body that
  // moves along x and y yields.
  const bool is_plane = mobility == Mobility::free || mobility == Mobility::particle;
  findings.expect({"bounds", fmt::format("largest effective mass of a contact, {}", name_of(mobility))},
                  range.largest_mass, is_plane ? 1.0 / (1.0 / disc_mass + 1.0 / mass) : disc_mass,
                  Tolerance::round_off(1e-15, "a sum and two quotients").relative(), "kg");
  const std::string name = fmt::format("smallest effective mass of a contact, {}", name_of(mobility));
  const bool is_guided = mobility == Mobility::guided_x || mobility == Mobility::guided_y;
  if (is_guided) {
    findings.expect_true({"bounds", name + ", at most that of a search over the outline"}, found <= exact,
                         fmt::format("{:.6f} against {:.6f} kg", found, exact));
  } else {
    findings.expect({"bounds", name}, found, exact, by_differences, "kg");
  }
}

/// A slender body whose pin is outside of its outline: the largest lever is that of the upper corner on the side of the
/// pin, along the normal across the line to the pin, which lies between those of the corner's sides.
void check_outer_pin(Findings& findings) {
  constexpr double disc_mass = 0.6, half_side = 0.1, half_length = 0.5;
  constexpr Vec2 pin{0.6, -half_length};
  SceneBuilder builder;
  const BodyId hit = builder.add({.name = "body",
                                  .mobility = Mobility::pinned,
                                  .mass = mass,
                                  .inertia = inertia,
                                  .shape = Rectangle{half_side, half_length},
                                  .p_BPin = pin});
  const BodyId disc = builder.add_particle("disc", disc_mass, {3.0, 3.0}, Circle{0.1});
  builder.add_contact("touch", hit, disc, LinearSpringDashpot{stiffness, damping});
  const double lever = std::hypot(pin.x - half_side, 2.0 * half_length);
  const double exact = 1.0 / (1.0 / disc_mass + lever * lever / (inertia + mass * (pin.x * pin.x + pin.y * pin.y)));
  findings.expect({"bounds", "smallest effective mass of a contact, pinned outside of the outline"},
                  contact_ranges(Dynamics{builder.build()}).front().smallest_mass, exact,
                  Tolerance::round_off(1e-14, "some ten operations"), "kg");
}

void run(Findings& findings, const Setup& setup) {
  check_outer_pin(findings);
  check_power_law(findings);
  for (const double gap : {0.0, 10.0})
    check_friction(false, gap, false, findings);
  check_friction(false, 0.0, true, findings);
  check_friction(true, 10.0, false, findings);
  Table table{.name = "masses",
              .caption = "Effective masses [kg] along each cable; slowest and fastest mode [rad/s] with both cables.",
              .columns = {"mobility", "first cable", "second cable", "slowest mode", "fastest mode"}};
  for (const Mobility mobility : {Mobility::free, Mobility::particle, Mobility::pinned, Mobility::sliding_x,
                                  Mobility::sliding_y, Mobility::guided_x, Mobility::guided_y})
    check(mobility, findings, setup, table), check_bound(mobility, findings, setup);
  findings.table(table);
}

}  // namespace

Case definition() {
  return {.id = "effective_masses",
          .title = "Effective masses and natural modes for seven mobilities",
          .requirements = {{"A9", {"impulses", "springs", "modes", "forces", "bounds"}}},
          .main_checks = {"frequency of cable_0, guided_x", "fastest mode, pinned",
                          "frequency of the friction spring between two discs"},
          .source = "Lagrange's equations, derived here",
          .faults = {{"pin_forgotten", "the pin is placed at the centre of mass", "frequency of cable_0, guided_x"},
                     {"sides_exchanged", "half width and half height of the body are exchanged",
                      "smallest effective mass of a contact, pinned"}},
          .run = run};
}

}  // namespace talus::verification::problems::effective_masses
