#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "verification/check/case.hpp"
#include "verification/record/csv.hpp"
#include "verification/record/json_node.hpp"
#include "verification/reference/impacts/restitution.hpp"
#include "verification/reference/integration/amplification.hpp"
#include "verification/reference/many_bodies/pressed_discs.hpp"
#include "verification/study/findings/expectations.hpp"
#include "verification/study/program/program_run.hpp"

namespace talus::verification::problems::step_limits {
namespace {

using reference::Scheme;

/// Speed of the disturbance [m/s]: the relative change of overlaps is 1e-6.
constexpr double speed = 1e-6;
constexpr int steps = 400;
constexpr int diverged = 3;  ///< exit status of a run that failed numerically

struct Mode {
  double frequency{};      ///< [rad/s]
  double damping_ratio{};  ///< [-]
};

/// A scene at rest, except for the disturbance, and its modes of vibration.
struct Vibrating {
  std::string name;
  std::string bodies;  ///< the scene without its [run]
  std::vector<Mode> modes;
  bool by_one_method{};  ///< it differs from another one in its modes alone, which one method shows
};

std::string disc(const std::string& name, double mass, double x, double y, double vx, double vy,
                 const std::string& more = "") {
  return fmt::format(R"([[body]]
name = "{}"
mobility = "particle"
mass = "{} kg"
shape = {{ kind = "circle", radius = "0.5 m" }}
position = ["{} m", "{} m"]
velocity = ["{} m/s", "{} m/s"]
{}
)",
                     name, mass, x, y, vx, vy, more);
}

const std::string ground = R"([[body]]
name = "ground"
mobility = "fixed"
shape = { kind = "half_plane" }
position = ["0 m", "0 m"]
)";

std::string contact(const std::string& one, const std::string& other, const std::string& law) {
  return fmt::format("[[contact]]\nname = \"{0}-{1}\"\nbetween = [\"{0}\", \"{1}\"]\n{2}\n", one, other, law);
}

/// Three discs on top of each other: w_j = 2 sqrt(k/m) sin((2j - 1) pi/14), xi_j = c w_j/(2k).
Vibrating column(const Setup& setup) {
  constexpr double mass = 2.0, gravity = 10.0, stiffness = 3000.0, damping = 8.0;
  const std::vector<double> overlaps = reference::column_overlaps(3, mass, gravity, stiffness);
  const std::string law = fmt::format("law = \"linear_spring_dashpot\"\nstiffness = \"{} N/m\"\ndamping = \"{} N s/m\"",
                                      stiffness, damping);
  Vibrating scene{
      "column of three discs", fmt::format("gravity = [\"0 m/s^2\", \"{} m/s^2\"]\n", -gravity) + ground, {}};
  std::string below = "ground";
  double y = -0.5;
  for (int i = 0; i < 3; ++i) {
    const std::string name = fmt::format("disc{}", i + 1);
    y += 1.0 - overlaps[static_cast<std::size_t>(i)];
    scene.bodies += disc(name, mass, 0.0, y, 0.0, i == 1 ? -speed : speed);
    scene.bodies += contact(below, name, law);
    below = name;
    const double frequency = 2.0 * std::sqrt(stiffness / mass) * std::sin((2 * i + 1) * std::numbers::pi / 14.0);
    if (setup.has("slowest_mode_alone") && i > 0) continue;
    scene.modes.push_back({frequency, damping * frequency / (2.0 * stiffness)});
  }
  return scene;
}

/// Acceleration under which a disc rests on a Hertzian contact with this overlap.
double hertz_gravity(double mass, double modulus, double radius, double overlap) {
  return 4.0 / 3.0 * modulus * std::sqrt(radius) * std::pow(overlap, 1.5) / mass;
}

/// A disc at rest on F = 4/3 E sqrt(R) d^(3/2): the tangent stiffness is 2 E sqrt(R d), 3/2 of the secant stiffness.
/// Its overlap at rest is a tenth of R, up to which the theory holds and at which the program evaluates the stiffness.
Vibrating hertz(const Setup& setup) {
  constexpr double mass = 2.0, modulus = 2e4, radius = 0.5, overlap = 0.1 * radius;
  const double gravity = hertz_gravity(mass, modulus, radius, overlap);
  const double tangent = 2.0 * modulus * std::sqrt(radius * overlap);
  const double stiffness = setup.has("secant_stiffness") ? tangent / 1.5 : tangent;
  return {"Hertzian contact",
          fmt::format("gravity = [\"0 m/s^2\", \"{} m/s^2\"]\n", -gravity) + ground +
              disc("disc", mass, 0.0, radius - overlap, 0.0, speed) +
              contact("disc", "ground",
                      fmt::format("law = \"hertz\"\nmodulus = \"{} N/m^2\"\nradius = \"{} m\"", modulus, radius)),
          {{std::sqrt(stiffness / mass), 0.0}}};
}

/// Two discs of different mass pressed together by forces: the effective mass is m M/(m + M).
Vibrating pair(const Setup& setup) {
  constexpr double light = 1.0, heavy = 3.0, force = 6.0, stiffness = 600.0, damping = 5.0;
  const double effective = setup.has("light_mass_alone") ? light : light * heavy / (light + heavy);
  const double distance = 1.0 - force / stiffness;
  const double frequency = std::sqrt(stiffness / effective);
  return {"pair pressed by forces",
          disc("light", light, 0.0, 0.0, speed, 0.0, fmt::format("force = [\"{} N\", \"0 N\"]", force)) +
              disc("heavy", heavy, distance, 0.0, 0.0, 0.0, fmt::format("force = [\"{} N\", \"0 N\"]", -force)) +
              contact("light", "heavy",
                      fmt::format("law = \"linear_spring_dashpot\"\nstiffness = \"{} N/m\"\ndamping = \"{} N s/m\"",
                                  stiffness, damping)),
          {{frequency, damping / (2.0 * effective * frequency)}}};
}

/// A sticking disc: the tangential spring is four times as stiff as the normal spring, and its dashpot, which the scene
/// does not give, c k_s/k.
Vibrating sticking(const Setup& setup) {
  constexpr double mass = 2.0, gravity = 10.0, stiffness = 1000.0, damping = 4.0;
  const double along = setup.has("no_friction_spring") ? stiffness : 4.0 * stiffness;
  const double frequency = std::sqrt(along / mass);
  const double ratio = setup.has("no_friction_dashpot") ? 0.0 : 0.5 * damping / stiffness * frequency;
  return {"sticking friction",
          fmt::format("gravity = [\"0 m/s^2\", \"{} m/s^2\"]\n", -gravity) + ground +
              disc("disc", mass, 0.0, 0.5 - mass * gravity / stiffness, speed, 0.0) +
              contact("disc", "ground",
                      fmt::format("law = \"linear_spring_dashpot\"\nstiffness = \"{} N/m\"\ndamping = \"{} N s/m\"\n"
                                  "friction = 0.5\nshear_stiffness = \"{} N/m\"",
                                  stiffness, damping, 4.0 * stiffness)),
          {{frequency, ratio}}};
}

/// The sticking disc with the restitution in place of the dashpots: c = 2 xi sqrt(k m), c k_s/k along the plane.
Vibrating sticking_by_restitution(const Setup& setup) {
  constexpr double mass = 2.0, gravity = 10.0, stiffness = 1000.0, ratio = 0.1;
  const double frequency = std::sqrt(4.0 * stiffness / mass);
  return {
      "sticking friction, restitution given",
      fmt::format("gravity = [\"0 m/s^2\", \"{} m/s^2\"]\n", -gravity) + ground +
          disc("disc", mass, 0.0, 0.5 - mass * gravity / stiffness, speed, 0.0) +
          contact("disc", "ground",
                  fmt::format("law = \"linear_spring_dashpot\"\nstiffness = \"{} N/m\"\nrestitution = {}\n"
                              "end_rule = \"clamped\"\nfriction = 0.5\nshear_stiffness = \"{} N/m\"",
                              stiffness, reference::restitution(ratio, reference::EndRule::clamped), 4.0 * stiffness)),
      {{frequency, setup.has("half_the_dashpot") ? ratio : 2.0 * ratio}},
      true};
}

/// The disc on a Hertzian contact whose dashpot gives every impact the same restitution: at the overlap d its
/// coefficient is xi sqrt(20/3 E R m) (d/R)^(1/4) (Tsuji et al. 1992; Antypov & Elliott 2011).
Vibrating hertz_by_restitution(const Setup&) {
  constexpr double mass = 2.0, modulus = 2e4, radius = 0.5, overlap = 0.1 * radius, ratio = 0.15;
  const double gravity = hertz_gravity(mass, modulus, radius, overlap);
  const double tangent = 2.0 * modulus * std::sqrt(radius * overlap);
  const double damping = ratio * std::sqrt(20.0 / 3.0 * modulus * radius * mass) * std::pow(overlap / radius, 0.25);
  return {"Hertzian contact, restitution given",
          fmt::format("gravity = [\"0 m/s^2\", \"{} m/s^2\"]\n", -gravity) + ground +
              disc("disc", mass, 0.0, radius - overlap, 0.0, speed) +
              contact("disc", "ground",
                      fmt::format("law = \"hertz\"\nmodulus = \"{} N/m^2\"\nradius = \"{} m\"\nrestitution = {}\n"
                                  "end_rule = \"clamped\"",
                                  modulus, radius, reference::restitution(ratio, reference::EndRule::clamped))),
          {{std::sqrt(tangent / mass), damping / (2.0 * std::sqrt(tangent * mass))}},
          true};
}

/// A disc that sticks by Mindlin's spring, k_s = 8 G sqrt(R d), to its Hertzian contact, k = 2 E sqrt(R d).
Vibrating sticking_by_mindlin(const Setup&) {
  constexpr double mass = 2.0, modulus = 2e4, shear_modulus = 1.5e4, radius = 0.5, overlap = 0.1 * radius;
  const double gravity = hertz_gravity(mass, modulus, radius, overlap);
  const double along = 8.0 * shear_modulus * std::sqrt(radius * overlap);
  return {"sticking friction by Mindlin",
          fmt::format("gravity = [\"0 m/s^2\", \"{} m/s^2\"]\n", -gravity) + ground +
              disc("disc", mass, 0.0, radius - overlap, speed, 0.0) +
              contact("disc", "ground",
                      fmt::format("law = \"hertz\"\nmodulus = \"{} N/m^2\"\nradius = \"{} m\"\nfriction = 0.5\n"
                                  "shear_law = \"mindlin\"\nshear_modulus = \"{} N/m^2\"",
                                  modulus, radius, shear_modulus)),
          {{std::sqrt(along / mass), 0.0}},
          true};
}

/// A body that hangs from a cable and slides up and down.
Vibrating hung(const Setup&) {
  constexpr double mass = 1.5, gravity = 10.0, stiffness = 96.0, damping = 1.2;
  const double frequency = std::sqrt(stiffness / mass);
  return {"body in a cable",
          fmt::format(R"(gravity = ["0 m/s^2", "{} m/s^2"]
[[body]]
name = "hung"
mobility = "sliding_y"
mass = "{} kg"
position = ["0 m", "{} m"]
velocity = ["0 m/s", "{} m/s"]

[[cable]]
name = "rope"
law = "tension_only"
from = {{ body = "hung", point = ["0 m", "0 m"] }}
to = {{ point = ["0 m", "2 m"] }}
stiffness = "{} N/m"
damping = "{} N s/m"
rest_length = "2 m"
)",
                      -gravity, mass, -mass * gravity / stiffness, speed, stiffness, damping),
          {{frequency, damping / (2.0 * mass * frequency)}}};
}

struct Method {
  std::string name;
  Scheme scheme;
  bool grows_fast{};  ///< by a factor of more than 100 in 400 steps, 1 % beyond the limit
};

/// Longest stable step of a method: minimum over the modes of eta/w, where eta is the first at which the motion grows.
double limit(const Method& method, const std::vector<Mode>& modes) {
  double minimum = std::numeric_limits<double>::infinity();
  // The search is fine: Euler's limits are near zero, and the first unstable band of blanes_moan4 is narrow.
  for (const Mode& mode : modes) {
    const std::vector<double> found = reference::limits(method.scheme, mode.damping_ratio, 8.0, 2000);
    if (found.empty())
      throw std::logic_error(fmt::format("{} has no limit at xi = {}", method.name, mode.damping_ratio));
    minimum = std::min(minimum, found.front() / mode.frequency);
  }
  return minimum;
}

std::string scene_text(const Vibrating& scene, const Method& method, double step, bool watched) {
  const double end = steps * step;
  return fmt::format(
      "title = \"{}\"\nunits = \"SI\"\n{}\n[run]\nintegrator = \"{}\"\nstep = \"{} s\"\nend = \"{} s\"\n"
      "interval = \"{} s\"\n{}\n",
      scene.name, scene.bodies, method.name, step, end, step, watched ? "" : "watch = \"off\"");
}

/// Largest speed of any body over that of the disturbance, at most 1e9; 1e9 after divergence. (In the end an unstable
/// motion may be a cycle of two positions with velocities of zero at both.)
double growth(const TemporaryFolder& folder, const std::string& text) {
  constexpr double maximum = 1e9;
  folder.write("free.toml", text);
  const ProgramEnd end = run_talus(folder, {"run", "free.toml", "--out", "free", "--frames", "1"});
  if (end.exit_code == diverged) return maximum;
  if (end.exit_code != 0)
    throw std::runtime_error(fmt::format("talus run ended with {}: {}", end.exit_code, end.messages));
  const records::Csv history = records::read_csv(folder.path() / "free/history.csv");
  double largest = 0.0;
  for (std::size_t i = 0; i < history.header().size(); ++i) {
    const std::string& column = history.header()[i];
    if (column.find(".vx ") == std::string::npos && column.find(".vy ") == std::string::npos) continue;
    for (std::size_t row = 0; row < history.rows(); ++row)
      largest = std::max(largest, std::abs(history.number(row, i)));
  }
  return std::min(maximum, largest / speed);
}

/// Output of `check`: the longest step, its verdict on the scene's step, and whether it warns of this step.
struct Verdict {
  double limit{};
  double ratio{};  ///< of the scene's step to it
  bool too_long{};
  bool warns{};
};
Verdict verdict(const TemporaryFolder& folder, const std::string& text) {
  folder.write("scene.toml", text);
  const ProgramEnd ended = run_talus(folder, {"check", "scene.toml"});
  const std::string& printed = ended.output;
  const std::string expected = "a step of ";
  const std::size_t at = printed.find(expected);
  if (at == std::string::npos) return {std::numeric_limits<double>::quiet_NaN(), 0.0, false, false};
  const std::string of_it = "the step is ";
  const std::size_t ratio = printed.find(of_it, at);
  return {std::stod(printed.substr(at + expected.size())),
          ratio == std::string::npos ? 0.0 : std::stod(printed.substr(ratio + of_it.size())),
          printed.find("TOO LONG") != std::string::npos,
          ended.messages.find("may grow without bound") != std::string::npos};
}

/// Names of the methods with steps of fixed length, as `talus list integrators` prints them.
std::vector<std::string> fixed_step_methods(const TemporaryFolder& folder) {
  std::vector<std::string> names;
  std::istringstream lines(talus_output(folder, {"list", "integrators"}));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream tokens(line);
    std::string name;
    if (tokens >> name && line.find("fixed step") != std::string::npos) names.push_back(name);
  }
  return names;
}

/// Number of methods for which `check` prints a limit that is not compared here: a new method must be added.
double uncompared(const TemporaryFolder& folder, const Vibrating& scene, const std::vector<Method>& methods,
                  bool forgotten) {
  double count = 0.0;
  for (const std::string& name : fixed_step_methods(folder)) {
    const bool compared =
        std::any_of(methods.begin(), methods.end(), [&](const Method& method) { return method.name == name; });
    if (compared && !(forgotten && name == "taylor")) continue;
    const Verdict printed = verdict(folder, scene_text(scene, {.name = name, .scheme = {}}, 1e-4, true));
    count += std::isnan(printed.limit) ? 0.0 : 1.0;
  }
  return count;
}

/// Balls over pinned beams, of which the last pair has the stiffest contact; more contacts than `check` prints rows.
constexpr int beams = 102;
constexpr double ball_mass = 2.0, beam_inertia = 0.5, beam_half_width = 0.4, beam_stiffness = 4e4;
std::string beams_text() {
  std::string text = "units = \"SI\"\n";
  for (int i = 1; i <= beams; ++i) {
    const std::string ball = fmt::format("ball{}", i), beam = fmt::format("beam{}", i);
    text += disc(ball, ball_mass, 2.0 * i, 1.0, 0.0, 0.0);
    text += fmt::format(
        "[[body]]\nname = \"{}\"\nmobility = \"pinned\"\nmass = \"3 kg\"\ninertia = \"{} kg m^2\"\n"
        "pin = [\"0 m\", \"0 m\"]\nposition = [\"{} m\", \"0 m\"]\n"
        "shape = {{ kind = \"rectangle\", half_width = \"{} m\", half_height = \"0.2 m\" }}\n",
        beam, beam_inertia, 2 * i, beam_half_width);
    text += contact(ball, beam,
                    fmt::format("law = \"linear_spring_dashpot\"\nstiffness = \"{} N/m\"\ndamping = \"0 N s/m\"",
                                i == beams ? beam_stiffness : 0.25 * beam_stiffness));
  }
  return text + "[run]\nintegrator = \"velocity_verlet\"\nstep = \"1 ms\"\nend = \"2 ms\"\n";
}

/// The first row of the table of bounds that `check` prints, below two lines of headings; the lines after it are next.
std::string first_bound(std::istream& lines) {
  std::string line;
  while (std::getline(lines, line) && line.find("Bounds over all positions") == std::string::npos) {
  }
  for (int i = 0; i < 3; ++i)
    std::getline(lines, line);
  return line;
}

/// What `check` prints of the beams: highest frequency in the first row of the table of bounds [rad/s], NaN if this row
/// is not that of the last beam; and the shortest contact over all positions [s].
struct Bounds {
  double frequency{std::numeric_limits<double>::quiet_NaN()};
  double shortest_contact{std::numeric_limits<double>::quiet_NaN()};
};
Bounds bounds_of_beams(const TemporaryFolder& folder) {
  folder.write("beams.toml", beams_text());
  std::istringstream lines{talus_output(folder, {"check", "beams.toml"})};
  // Name, smallest and largest effective mass, frequency.
  std::istringstream row{first_bound(lines)};
  std::string name, minimum, maximum;
  Bounds found;
  double frequency = 0.0;
  row >> name >> minimum >> maximum >> frequency;
  if (name == fmt::format("ball{0}-beam{0}", beams)) found.frequency = frequency;
  const std::string shortest = "shortest contact: ";
  for (std::string line; std::getline(lines, line);) {
    if (const std::size_t at = line.find(shortest); at != std::string::npos)
      found.shortest_contact = std::stod(line.substr(at + shortest.size()));
  }
  return found;
}

/// Highest frequency in the table of bounds for a ball on a superquadric that is pinned off its centre, and the largest
/// lever of its outline's normals about the pin, by search. Frequencies: [rad/s].
struct PinnedBound {
  double found{}, exact{};
};
PinnedBound bound_of_pinned(const TemporaryFolder& folder, bool lever_of_the_centre) {
  constexpr double a = 0.6, b = 0.25, exponent = 3.0, mass = 3.0, inertia = 0.5, pin_x = 0.3, pin_y = -0.1;
  folder.write(
      "pinned.toml",
      "units = \"SI\"\n" + disc("ball", ball_mass, 0.0, 1.5, 0.0, 0.0) +
          fmt::format("[[body]]\nname = \"cam\"\nmobility = \"pinned\"\nmass = \"{} kg\"\ninertia = \"{} kg m^2\"\n"
                      "pin = [\"{} m\", \"{} m\"]\nposition = [\"0 m\", \"0 m\"]\nshape = {{ kind = \"superquadric\", "
                      "half_width = \"{} m\", half_height = \"{} m\", exponent = {} }}\n",
                      mass, inertia, pin_x, pin_y, a, b, exponent) +
          contact("ball", "cam",
                  fmt::format("law = \"linear_spring_dashpot\"\nstiffness = \"{} N/m\"\ndamping = \"0 N s/m\"",
                              beam_stiffness)) +
          "[run]\nintegrator = \"velocity_verlet\"\nstep = \"1 ms\"\nend = \"2 ms\"\n");
  double lever = 0.0;
  constexpr int points = 20000;
  for (int i = 0; i < points; ++i) {
    const double t = 2.0 * std::numbers::pi * i / points, c = std::cos(t), s = std::sin(t);
    // On the outline |x/a|^n + |y/b|^n = 1; the normal is along the gradient.
    const double scale = std::pow(std::pow(std::abs(c), exponent) + std::pow(std::abs(s), exponent), -1.0 / exponent);
    const double u = scale * c, v = scale * s;
    const double nx = std::copysign(std::pow(std::abs(u), exponent - 1.0), u) / a,
                 ny = std::copysign(std::pow(std::abs(v), exponent - 1.0), v) / b;
    const double x = a * u - (lever_of_the_centre ? 0.0 : pin_x), y = b * v - (lever_of_the_centre ? 0.0 : pin_y);
    lever = std::max(lever, std::abs(x * ny - y * nx) / std::hypot(nx, ny));
  }
  const double about_pin = inertia + mass * (pin_x * pin_x + pin_y * pin_y);
  std::istringstream lines{talus_output(folder, {"check", "pinned.toml"})};
  std::string name, minimum, maximum;
  PinnedBound bound{.found = std::numeric_limits<double>::quiet_NaN(),
                    .exact = std::sqrt(beam_stiffness * (1.0 / ball_mass + lever * lever / about_pin))};
  std::istringstream{first_bound(lines)} >> name >> minimum >> maximum >> bound.found;
  return bound;
}

/// Step that `run --step auto` chooses, over the closed form: a 200th of the contact time of an undamped ball, and a
/// twentieth of the linear limit without contacts. Largest deviation from 1.
double automatic_step_error(const TemporaryFolder& folder, const Vibrating& without_contacts, const Method& method) {
  constexpr double mass = 2.0, stiffness = 3000.0;
  const double of_contact = std::numbers::pi * std::sqrt(mass / stiffness) / 200.0;
  const Vibrating ball{"ball above a plane",
                       disc("ball", mass, 0.0, 0.6, 0.0, -1.0) + ground +
                           contact("ball", "ground",
                                   fmt::format("law = \"linear_spring_dashpot\"\nstiffness = \"{} N/m\"\n"
                                               "damping = \"0 N s/m\"",
                                               stiffness)),
                       {{std::sqrt(stiffness / mass), 0.0}}};
  double worst = 0.0;
  for (const auto& [scene, exact] : {std::pair{&ball, std::min(of_contact, limit(method, ball.modes) / 20.0)},
                                     std::pair{&without_contacts, limit(method, without_contacts.modes) / 20.0}}) {
    folder.write("automatic.toml", scene_text(*scene, method, exact, true));
    const std::string summary = talus_output(folder, {"run", "automatic.toml", "--step", "auto", "--json"});
    keep_worst(worst, records::Json::parse(summary).at("step").get<double>() / exact - 1.0);
  }
  return worst;
}

void draw_growth(const TemporaryFolder& folder, const std::vector<Vibrating>& scenes, const Method& method,
                 Findings& findings) {
  std::vector<Series> curves;
  for (const Vibrating& scene : scenes) {
    Series curve{.label = scene.name, .style = Style::linespoints};
    const double longest = limit(method, scene.modes);
    for (const double ratio : {0.97, 0.99, 0.998, 1.002, 1.01, 1.03})
      curve.add(ratio, growth(folder, scene_text(scene, method, ratio * longest, false)));
    curves.push_back(std::move(curve));
  }
  findings.figure({.name = "growth",
                   .title = "Growth on both sides of the step limit",
                   .caption =
                       "Largest speed in 400 steps of velocity Verlet over that of the disturbance. The line is the "
                       "limit printed by `talus check`.",
                   .x = {.label = "step over its limit"},
                   .y = {.label = "growth", .log = true},
                   .series = curves,
                   .lines = {{'x', 1.0, "limit"}}});
}

void run(Findings& findings, const Setup& setup) {
  const auto group = findings.in("limits");
  const std::vector<Method> methods{{"velocity_verlet", Scheme::half_step, true},
                                    {"central_difference", Scheme::half_step, true},
                                    {"euler_cromer", Scheme::half_step, true},
                                    {"lagged_central_difference", Scheme::late, false},
                                    {"rk4", Scheme::rk4, true},
                                    {"blanes_moan4", Scheme::blanes_moan4, false},
                                    {"euler", Scheme::euler, false},
                                    {"taylor", Scheme::taylor, false}};
  const TemporaryFolder folder;
  double printed = 0.0, wrong_checks = 0.0, wrong_runs = 0.0, stable = 0.0, limits = 0.0;
  double unstable = std::numeric_limits<double>::infinity();
  Table table{.name = "limits",
              .caption =
                  "Limits of the step, computed and as printed by `talus check`. Growth: largest speed in 400 steps "
                  "over that of the disturbance.",
              .columns = {"scene", "method", "limit [s]", "printed [s]", "growth at 0.99", "growth at 1.01"},
              .rows = {}};
  const Vibrating rope = hung(setup);
  const std::vector scenes{column(setup),
                           hertz(setup),
                           pair(setup),
                           sticking(setup),
                           rope,
                           sticking_by_restitution(setup),
                           hertz_by_restitution(setup),
                           sticking_by_mindlin(setup)};
  for (const Vibrating& scene : scenes) {
    for (const Method& method : methods) {
      // Explicit Euler and Taylor grow at any step if there is no damping.
      const bool always_grows = method.scheme == Scheme::euler || method.scheme == Scheme::taylor;
      if (always_grows && scene.modes.front().damping_ratio == 0.0) continue;
      if (&scene != &scenes.front() && &method != &methods.front() && setup.coarse) continue;
      if (scene.by_one_method && &method != &methods.front()) continue;
      const double longest = limit(method, scene.modes);
      ++limits;
      const Verdict below = verdict(folder, scene_text(scene, method, 0.999 * longest, true)),
                    beyond = verdict(folder, scene_text(scene, method, 1.001 * longest, true));
      keep_worst(printed, below.limit / longest - 1.0);
      wrong_checks += (below.too_long ? 1.0 : 0.0) + (beyond.too_long ? 0.0 : 1.0);
      wrong_checks += (below.warns ? 1.0 : 0.0) + (beyond.warns ? 0.0 : 1.0);
      // Four digits are printed.
      wrong_checks +=
          (std::abs(below.ratio - 0.999) < 1e-4 ? 0.0 : 1.0) + (std::abs(beyond.ratio - 1.001) < 6e-4 ? 0.0 : 1.0);
      if (!method.grows_fast) continue;
      folder.write("watched.toml", scene_text(scene, method, 0.999 * longest, true));
      wrong_runs += run_talus(folder, {"run", "watched.toml"}).exit_code != diverged ? 0.0 : 1.0;
      folder.write("watched.toml", scene_text(scene, method, 1.001 * longest, true));
      const ProgramEnd ended = run_talus(folder, {"run", "watched.toml"});
      wrong_runs += ended.exit_code == diverged ? 0.0 : 1.0;
      wrong_runs += ended.messages.find(" s; its summary gives the reason") != std::string::npos ? 0.0 : 1.0;
      const double inside = growth(folder, scene_text(scene, method, 0.99 * longest, false)),
                   outside = growth(folder, scene_text(scene, method, 1.01 * longest, false));
      stable = std::max(stable, inside), unstable = std::min(unstable, outside);
      table.rows.push_back({scene.name, method.name, fmt::format("{:.6g}", longest), fmt::format("{:.6g}", below.limit),
                            fmt::format("{:.3g}", inside), fmt::format("{:.3g}", outside)});
    }
  }
  findings.expect("methods for which `talus check` prints a limit that is not compared",
                  uncompared(folder, rope, methods, setup.has("method_forgotten")), 0.0,
                  Tolerance::exact("count over the list of the program"));
  if (!setup.coarse)
    findings.expect("limits compared", limits, 41.0,
                    Tolerance::exact("eight methods, five scenes; two methods have no limit in the undamped scene; one "
                                     "method, three scenes"));
  findings.expect("limit of the step printed by `talus check`, over the exact one: largest deviation from 1", printed,
                  0.0,
                  Tolerance::round_off(1e-5,
                                       "six digits are printed; damping is proportional to stiffness, so that the "
                                       "modes are exact; initial overlaps change by 1e-6"));
  findings.expect("wrong verdicts of `talus check` at 0.999 and 1.001 of the limit", wrong_checks, 0.0,
                  Tolerance::exact("both sides of each limit"));
  findings.expect(
      "runs terminated at 0.999 of the limit, or not terminated at 1.001", wrong_runs, 0.0,
      Tolerance::exact("exit status 3 of `talus run` and a message with the time and its unit, or another status"));
  findings.expect_between(
      "growth in 400 steps: at 0.99 of the limit, maximum", stable, 0.0, 12.3,
      "a leapfrog mode grows to at most 1/sqrt(1 - 0.99^2) = 7.1 times its disturbance; three orthogonal modes of "
      "three equal discs, disturbed alike, add up to sqrt(3) times that for one disc");
  findings.expect_between(
      "growth in 400 steps: at 1.01 of the limit, minimum, in powers of ten", std::log10(unstable), 2.0, 9.0,
      "linear motion would grow without bound; bodies that lose contact or slip end the growth, measured at no less "
      "than 1.6e4 times the disturbance. Below the limit the growth stays under 12.3");
  findings.expect("step of `talus run --step auto` over its closed form: largest deviation from 1",
                  automatic_step_error(folder, rope, methods.front()), 0.0,
                  Tolerance::round_off(1e-8,
                                       "pi sqrt(m/k)/200 of an undamped ball, and a twentieth of a limit that is "
                                       "found by bisection"));
  const double lever = setup.has("lever_of_the_start") ? 0.0 : beam_half_width;
  const Bounds bounds = bounds_of_beams(folder);
  const double worst = std::sqrt(beam_stiffness * (1.0 / ball_mass + lever * lever / beam_inertia));
  findings.expect("bounds of 102 contacts: highest frequency in the first row over that of the worst, deviation from 1",
                  bounds.frequency / worst - 1.0, 0.0,
                  Tolerance::model(5.1e-5, "five digits are printed: half a unit of the last one, and round-off"));
  findings.expect("bounds of 102 contacts: shortest contact over half the period of the worst, deviation from 1",
                  bounds.shortest_contact / (std::numbers::pi / worst) - 1.0, 0.0,
                  Tolerance::model(5.1e-6, "six digits are printed: half a unit of the last one, and round-off"));
  const PinnedBound pinned = bound_of_pinned(folder, setup.has("lever_of_the_centre"));
  findings.expect(
      "bounds of a ball on a pinned superquadric: highest frequency over that of the largest lever, "
      "deviation from 1",
      pinned.found / pinned.exact - 1.0, 0.0,
      Tolerance::model(1.6e-4,
                       "the program samples the outline at 2048 points, which miss the largest lever "
                       "by at most 1e-4; five digits are printed"));
  findings.table(std::move(table));
  if (!setup.coarse) draw_growth(folder, scenes, methods.front(), findings);
}

}  // namespace

Case definition() {
  return {
      .id = "step_limits",
      .title = "Step limits reported by `talus check`",
      .requirements = {{"G2", {"limits"}}},
      .main_checks = {"wrong verdicts of `talus check` at 0.999 and 1.001 of the limit",
                      "growth in 400 steps: at 1.01 of the limit, minimum, in powers of ten"},
      .source = "Linear stability of the methods, as in case `stability_maps`",
      .faults =
          {{"slowest_mode_alone", "only the slowest of the three modes",
            "wrong verdicts of `talus check` at 0.999 and 1.001 of the limit"},
           {"secant_stiffness", "secant instead of tangent stiffness of the Hertzian contact",
            "wrong verdicts of `talus check` at 0.999 and 1.001 of the limit"},
           {"light_mass_alone", "the lighter mass instead of the effective mass",
            "runs terminated at 0.999 of the limit, or not terminated at 1.001"},
           {"lever_of_the_start", "the stiffest contact with the effective mass at the start",
            "bounds of 102 contacts: highest frequency in the first row over that of the worst, deviation from 1"},
           {"lever_of_the_centre", "levers about the centre of a body that is pinned beside it",
            "bounds of a ball on a pinned superquadric: highest frequency over that of the largest lever, deviation "
            "from 1"},
           {"no_friction_spring", "friction spring omitted", "growth in 400 steps: at 0.99 of the limit, maximum"},
           {"no_friction_dashpot", "friction spring without the dashpot that follows from the normal one",
            "wrong verdicts of `talus check` at 0.999 and 1.001 of the limit"},
           {"half_the_dashpot", "the dashpot of friction with the damping ratio of the normal one",
            "wrong verdicts of `talus check` at 0.999 and 1.001 of the limit"},
           {"method_forgotten", "a method of the program omitted from the comparison",
            "methods for which `talus check` prints a limit that is not compared"}},
      .seconds = 4.0,
      .run = run};
}

}  // namespace talus::verification::problems::step_limits
