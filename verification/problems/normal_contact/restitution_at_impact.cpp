#include "solver/dynamics/springs.hpp"
#include "solver/io/scene/read_scene.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::restitution_at_impact {
namespace {

constexpr double wanted = 0.6;

/// Speed of separation of the bodies' contact points along the normal; < 0 on approach.
using NormalSpeed = std::function<double(const Model&, const State&)>;

struct Impact {
  const char* name;
  std::string bodies;  ///< TOML
  double end{};        ///< [s]
  std::size_t impacts{1};
  NormalSpeed speed;
  /// Bound of an error that is not caused by changes during contact: that of the method where nothing changes, or of
  /// the tilt of a side that lands nearly flat. 0: the error is proportional to the contact time.
  double bound{};
  const char* why{};
};

Vec2 point_velocity(const Pose& pose, Vec2 p) {
  return pose.v_WB + Vec2{-pose.w_WB * (p.y - pose.p_WB.y), pose.w_WB * (p.x - pose.p_WB.x)};
}

Pose of(const Model& model, const State& state, int body) { return pose(model, state, static_cast<BodyId>(body)); }

/// A pinned bob whose edge meets a wall at x = 0.05; the wall's normal is -x.
double bob_speed(const Model& model, const State& state) {
  const Pose bob = of(model, state, 0);
  return -point_velocity(bob, bob.p_WB + Vec2{0.05, 0.0}).x;
}
/// The lowest corner of a rectangle of half sides 0.3 and 0.1 over level ground.
double corner_speed(const Model& model, const State& state) {
  const Pose box = of(model, state, 0);
  Vec2 lowest{0.0, 1e9};
  for (const Vec2 corner : {Vec2{0.3, 0.1}, Vec2{-0.3, 0.1}, Vec2{0.3, -0.1}, Vec2{-0.3, -0.1}}) {
    const Vec2 p = box.p_WB + box.R_WB * corner;
    if (p.y < lowest.y) lowest = p;
  }
  return point_velocity(box, lowest).y;
}
/// The lowest point of an ellipse of half axes 0.3 and 0.15: where its gradient points down.
double ellipse_speed(const Model& model, const State& state) {
  const Pose body = of(model, state, 0);
  const Vec2 down = Vec2{-body.R_WB.sine, -body.R_WB.cosine};
  const double a = 0.3, b = 0.15, size = std::hypot(a * down.x, b * down.y);
  return point_velocity(body, body.p_WB + body.R_WB * Vec2{a * a * down.x / size, b * b * down.y / size}).y;
}
/// A disc of radius 0.1 at the left side of a bar of half width 0.05.
double bar_speed(const Model& model, const State& state) {
  const Pose disc = of(model, state, 0), bar = of(model, state, 1);
  const Vec2 n = bar.R_WB * Vec2{1.0, 0.0};  // from the disc into the bar
  const double along = dot(disc.p_WB - bar.p_WB, bar.R_WB * Vec2{0.0, 1.0});
  const Vec2 on_bar = bar.p_WB + bar.R_WB * Vec2{-0.05, along};
  return dot(point_velocity(bar, on_bar) - point_velocity(disc, disc.p_WB + 0.1 * n), n);
}
double height_speed(const Model& model, const State& state) { return of(model, state, 0).v_WB.y; }

constexpr std::string_view ground = R"(
[[body]]
name = "other"
mobility = "fixed"
shape = { kind = "half_plane" }
position = ["0 m", "0 m"]
)";

constexpr std::string_view disc = R"(
[[body]]
name = "one"
mobility = "free"
mass = "2 kg"
inertia = "0.01 kg m^2"
shape = { kind = "circle", radius = "0.1 m" }
)";

constexpr std::string_view box = R"(
[[body]]
name = "one"
mobility = "free"
mass = "3 kg"
inertia = "0.1 kg m^2"
shape = { kind = "rectangle", half_width = "0.3 m", half_height = "0.1 m" }
)";

constexpr std::string_view bob = R"(
[[body]]
name = "one"
mobility = "pinned"
mass = "1 kg"
inertia = "0.0004 kg m^2"
pin = ["0 m", "1 m"]
position = ["-0.5 m", "-0.8660254037844386 m"]
angle = "-30 deg"
spin = "3 rad/s"
shape = { kind = "circle", radius = "0.05 m" }
[[body]]
name = "other"
mobility = "fixed"
shape = { kind = "half_plane" }
position = ["0.35 m", "0 m"]
angle = "90 deg"
)";

constexpr std::string_view bar = R"(
[[body]]
name = "other"
mobility = "free"
mass = "2 kg"
inertia = "0.1 kg m^2"
shape = { kind = "rectangle", half_width = "0.05 m", half_height = "0.5 m" }
position = ["0 m", "0 m"]
spin = "2 rad/s"
)";

constexpr std::string_view ellipse = R"(
[[body]]
name = "one"
mobility = "free"
mass = "2 kg"
inertia = "0.05625 kg m^2"
shape = { kind = "superquadric", half_width = "0.3 m", half_height = "0.15 m", exponent = 2 }
position = ["0 m", "0.8 m"]
angle = "50 deg"
spin = "1 rad/s"
)";

std::vector<Impact> impacts() {
  const auto joined = [](std::string_view first, std::string_view start, std::string_view second) {
    return fmt::format("{}{}{}", first, start, second);
  };
  const char* of_method = "a linear oscillator, integrated with a tolerance of 1e-12";
  const std::string_view down = "position = [\"0 m\", \"0.2 m\"]\nvelocity = [\"0 m/s\", \"-2 m/s\"]";
  return {
      {"central", joined(disc, down, ground), 0.3, 1, height_speed, 3e-12, of_method},
      {"flat side", joined(box, down, ground), 0.3, 1, height_speed, 3e-12, of_method},
      {"side that lands nearly flat", joined(box, std::string{down} + "\nangle = \"1e-6 deg\"", ground), 0.3, 1,
       height_speed, 3e-5,
       "a tilt of 1.7e-8 rad lets one end touch 1e-8 m before the other, up to 3e-5 of the overlap at the largest "
       "stiffness"},
      {"pinned bob, another pose", std::string{bob}, 0.6, 1, bob_speed},
      {"corner",
       joined(box,
              "position = [\"0 m\", \"0.5 m\"]\nangle = \"35 deg\"\nvelocity = [\"0.5 m/s\", \"-2 m/s\"]\nspin = \"-2 "
              "rad/s\"",
              ground),
       0.4, 1, corner_speed},
      {"disc on a bar that has turned",
       joined(disc, "position = [\"-0.5 m\", \"0.25 m\"]\nvelocity = [\"2 m/s\", \"0 m/s\"]", bar), 0.5, 1, bar_speed},
      {"tumbling ellipse, three impacts", joined(ellipse, "", ground), 3.0, 3, ellipse_speed}};
}

/// Planted fault: a dashpot that does not change, from the initial effective mass of the contact or from the masses of
/// the bodies as particles.
void fix_dashpot(Scene& scene, bool rotation) {
  auto& law = std::get<LinearSpringDashpot>(scene.model.contacts[0].law);
  double mass = 0.0;
  if (rotation) {
    const Dynamics dynamics{scene.model};
    mass = springs(dynamics, scene.initial)[0].effective_mass;
  } else {
    double inverse = 0.0;
    for (const Body& one : scene.model.bodies)
      inverse += one.mobility == Mobility::fixed ? 0.0 : 1.0 / one.mass;
    mass = 1.0 / inverse;
  }
  law.damping = 2.0 * law.damping_ratio * std::sqrt(law.stiffness * mass);
  law.damping_ratio = 0.0;
}

/// Restitution of each impact: normal speed of the contact points after the impact over that before it.
std::vector<double> restitutions(const Impact& impact, double stiffness, const Setup& setup, Findings& findings) {
  const std::string text = fmt::format(R"(
title = "Restitution at impact"
units = "SI"
gravity = ["0 m/s^2", "{} m/s^2"]
{}
[[contact]]
name = "hit"
between = ["one", "other"]
law = "linear_spring_dashpot"
stiffness = "{} N/m"
restitution = {}
[run]
integrator = "stormer_cowell"
tolerance = 1e-12
end = "{} s"
ledger = "off"
)",
                                       impact.impacts > 1 ? -9.81 : 0.0, impact.bodies, stiffness, wanted, impact.end);
  Scene scene = read_scene(text, "restitution_at_impact");
  if (setup.has("mass_of_the_start")) fix_dashpot(scene, true);
  if (setup.has("mass_of_particles")) fix_dashpot(scene, false);
  if (setup.has("ends_apart"))
    std::get<LinearSpringDashpot>(scene.model.contacts[0].law).damping_ratio *= std::sqrt(2.0);
  // The bodies' motion between two outputs is ballistic: 0.02 of a contact time is enough.
  scene.plan.step = 0.02 * std::acos(-1.0) * std::sqrt(0.3 / stiffness);
  std::vector<double> found;
  double before = 0.0, apart = 0.0;
  bool touching = false;
  const auto instances = static_cast<std::ptrdiff_t>(Dynamics{scene.model}.contacts().size());
  const Watcher watch = [&](const State& state, const StepInfo&) {
    const bool acts =
        std::any_of(state.mode.begin(), state.mode.begin() + instances, [](Mode mode) { return mode != 0; });
    const double speed = impact.speed(scene.model, state);
    if (acts && !touching) before = apart;
    if (!acts && touching) found.push_back(-speed / before);
    if (!acts) apart = speed;
    touching = acts;
  };
  run_scene(scene, findings, watch, [&](const State&) { return found.size() == impact.impacts; });
  return found;
}

void run(Findings& findings, const Setup& setup) {
  Figure figure{.name = "errors",
                .title = "Error of the restitution at impact",
                .caption =
                    "Largest error of the restitution over the impacts of a scene against the stiffness; 0.6 was "
                    "requested. The pose changes during the contact, which takes a time of the order of $1/\\sqrt{k}$; "
                    "where it does not, the error is that of the method, or of a tilt of 1e-6 degrees.",
                .x = {.label = "stiffness", .unit = "N/m", .log = true},
                .y = {.label = "error of e", .log = true}};
  Table table{"values",
              "Restitution at $k = 1.024 \\cdot 10^8$ N/m for each impact; 0.6 was requested.",
              {"scene", "first impact", "second impact", "third impact", "largest error"},
              {}};
  for (const Impact& impact : impacts()) {
    const std::string_view name = impact.name;
    const bool exact = impact.bound > 0.0;
    Convergence errors;
    Series series{impact.name, {}, {}, Style::linespoints};
    std::vector<double> last, before;
    for (const double stiffness : {1e5, 4e5, 1.6e6, 6.4e6, 2.56e7, 1.024e8}) {
      if (setup.coarse && stiffness < 2e7) continue;
      before = last;
      last = restitutions(impact, stiffness, setup, findings);
      last.resize(impact.impacts, 0.0);
      double worst = 0.0;
      for (const double e : last)
        keep_largest(worst, e - wanted);
      series.add(stiffness, std::max(worst, 1e-16));
      if (stiffness > 1e6) errors.add(1.0 / std::sqrt(stiffness), worst);
    }
    figure.series.push_back(series);
    for (std::size_t i = 0; i < impact.impacts; ++i) {
      const std::string which = impact.impacts == 1 ? "" : fmt::format(", number {}", i + 1);
      findings.expect(fmt::format("restitution, {}{}", name, which), last[i], wanted,
                      exact ? Tolerance::truncation(impact.bound, 1.0, impact.why)
                            : Tolerance::truncation(
                                  0.5 * std::abs(before[i] - wanted) + 1e-9, 1.2,
                                  "the changes during contact are proportional to the contact time, which is half of "
                                  "that at a quarter of the stiffness; a fifth for the terms of higher order"));
    }
    if (!exact && !setup.coarse) {
      findings.expect_order(fmt::format("order of the error in 1/sqrt(k), {}", name), errors, 0.9, 1.1,
                            "pose and speed change during contact in proportion to the contact time");
    }
    std::vector<std::string> row{impact.name};
    for (const double e : last)
      row.push_back(fmt::format("{:.6f}", e));
    row.resize(4);
    row.push_back(fmt::format("{:.1e}", series.y.back()));
    table.rows.push_back(row);
  }
  findings.figure(figure);
  findings.table(table);
}

}  // namespace

Case definition() {
  return {
      .id = "restitution_at_impact",
      .title = "Restitution at every impact",
      .family = "B: normal contact",
      .requirements = {{"law.linear_spring_dashpot", {"restitution, central", "restitution, corner"}},
                       {"Eq. 17", {"restitution, pinned bob, another pose"}},
                       {"pair.rectangle.half_plane", {"restitution, flat side", "restitution, corner"}},
                       {"integrator.stormer_cowell", {"restitution, central"}}},
      .main_checks = {"restitution, pinned bob, another pose", "restitution, corner",
                      "restitution, tumbling ellipse, three impacts, number 3"},
      .source = "Goldsmith, W. (1960): Impact. Edward Arnold, London, chapter 2",
      .faults = {{"mass_of_the_start", "a dashpot from the effective mass of the initial pose",
                  "restitution, tumbling ellipse, three impacts, number 2"},
                 {"mass_of_particles", "a dashpot from the masses of the bodies as particles", "restitution, corner"},
                 {"ends_apart", "a damping ratio too large by sqrt(2)", "restitution, flat side"}},
      .run = run};
}

}  // namespace talus::verification::problems::restitution_at_impact
