#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "verification/check/case.hpp"
#include "verification/problems/program/files/energy_scales.hpp"
#include "verification/problems/program/files/interrupted_runs.hpp"
#include "verification/record/csv.hpp"
#include "verification/record/json_node.hpp"
#include "verification/reference/motion/constant_force.hpp"
#include "verification/reference/motion/damped_oscillator.hpp"
#include "verification/study/findings/curves.hpp"
#include "verification/study/findings/expectations.hpp"
#include "verification/study/program/program_run.hpp"

namespace talus::verification::problems::run_files {
namespace {

using records::Csv;
using records::Json;
using records::Node;

const std::string frames = "34";  // intervals between states of the geometry
constexpr double step = 0.0125;
constexpr int steps = 102, steps_a_row = 4, steps_a_file = 3;  // the last interval between rows is half as long

/// Parameters used both in the scene's text and in its closed forms.
constexpr double gravity = 10.0;
/// The force along y exceeds the weight: of all energies, that of the applied force changes most.
constexpr double thrown_mass = 2.0, thrown_inertia = 0.3, thrown_force_x = 0.5, thrown_force_y = 24.0, moment = 0.12;
constexpr reference::ConstantForce thrown_x{0.5, -3.0, thrown_force_x / thrown_mass};
constexpr reference::ConstantForce thrown_y{1.0, 4.0, thrown_force_y / thrown_mass - gravity};
constexpr reference::ConstantForce thrown_angle{0.25, 5.0, moment / thrown_inertia};
constexpr double pressed_mass = 3.0, pressed_x = -4.0, pressed_y = 0.486, radius = 0.5, bed_stiffness = 3000.0,
                 bed_damping = 9.6;
constexpr double hung_mass = 1.5, hung_x = 6.0, hung_y = -1.0, hung_speed = -0.25, rope_x = 6.25, rope_top = 3.0,
                 rope_length = 3.7, rope_stiffness = 96.0, rope_damping = 1.2;

std::string scene_text(const Setup& setup) {
  const double fallen = setup.has("more_gravity") ? (1.0 + 1e-10) * gravity : gravity;
  const double stiffness = setup.has("softer_bed") ? (1.0 - 1e-10) * bed_stiffness : bed_stiffness;
  const double length = setup.has("longer_rope") ? rope_length + 1e-10 : rope_length;
  const double end = (setup.has("one_step_less") ? steps - 1 : steps) * step;
  const double interval = (setup.has("other_interval") ? steps_a_row + 1 : steps_a_row) * step;
  std::string text = R"(title = "Three bodies with closed forms"
units = "SI"
)";
  text += fmt::format("gravity = [\"0 m/s^2\", \"{} m/s^2\"]\n", -fallen);
  text += fmt::format(R"(
[[body]]
name = "thrown"
mobility = "free"
mass = "{} kg"
inertia = "{} kg m^2"
position = ["{} m", "{} m"]
velocity = ["{} m/s", "{} m/s"]
angle = "{} rad"
spin = "{} rad/s"
force = ["{} N", "{} N"]
moment = "{} N m"
)",
                      thrown_mass, thrown_inertia, thrown_x.position, thrown_y.position, thrown_x.speed, thrown_y.speed,
                      thrown_angle.position, thrown_angle.speed, thrown_force_x, thrown_force_y, moment);
  // The guides carry the force along x, with its moment about the origin, and the rope's moment about the hung body.
  text += fmt::format(R"(
[[body]]
name = "pressed"
mobility = "sliding_y"
mass = "{} kg"
shape = {{ kind = "circle", radius = "{} m" }}
position = ["{} m", "{} m"]
force = ["1.5 N", "0 N"]

[[body]]
name = "hung"
mobility = "sliding_y"
mass = "{} kg"
position = ["{} m", "{} m"]
velocity = ["0 m/s", "{} m/s"]

[[body]]
name = "ground"
mobility = "fixed"
shape = {{ kind = "half_plane" }}
position = ["0 m", "0 m"]

[[contact]]
name = "bed"
between = ["pressed", "ground"]
law = "linear_spring_dashpot"
stiffness = "{} N/m"
damping = "{} N s/m"
)",
                      pressed_mass, radius, pressed_x, pressed_y, hung_mass, hung_x, hung_y, hung_speed, stiffness,
                      bed_damping);
  text += fmt::format(R"(
[[cable]]
name = "rope"
law = "tension_only"
from = {{ body = "hung", point = ["{} m", "0 m"] }}
to = {{ point = ["{} m", "{} m"] }}
stiffness = "{} N/m"
damping = "{} N s/m"
rest_length = "{} m"

[run]
integrator = "stormer_cowell"
tolerance = 1e-13
step = "{} s"
end = "{} s"
interval = "{} s"
)",
                      rope_x - hung_x, rope_x, rope_top, rope_stiffness, rope_damping, length, step, end, interval);
  return text;
}

struct Quantity {
  std::string name;
  std::string unit;
  double scale{};  ///< largest magnitude over the run, of the quantity or of its summands
};

/// All columns of the history, in order.
const std::vector<Quantity>& quantities() {
  static const std::vector<Quantity> list{{"time", "s", 1.3},
                                          {"thrown.x", "m", 4.0},
                                          {"thrown.y", "m", 7.7},
                                          {"thrown.vx", "m/s", 3.0},
                                          {"thrown.vy", "m/s", 6.5},
                                          {"thrown.angle", "rad", 7.0},
                                          {"thrown.spin", "rad/s", 5.5},
                                          {"pressed.x", "m", 4.0},
                                          {"pressed.y", "m", 0.5},
                                          {"pressed.vx", "m/s", 1.0},
                                          {"pressed.vy", "m/s", 0.13},
                                          {"hung.x", "m", 6.0},
                                          {"hung.y", "m", 1.2},
                                          {"hung.vx", "m/s", 1.0},
                                          {"hung.vy", "m/s", 1.2},
                                          {"bed.overlap", "m", 0.5},
                                          {"bed.force", "N", 1500.0},  // k times the radius: overlap = radius - y
                                          {"rope.elongation", "m", 4.0},
                                          {"rope.tension", "N", 400.0},
                                          {"energy.kinetic", "N m", 55.0},
                                          {"energy.gravity", "N m", 155.0},
                                          {"energy.applied", "N m", 160.0},
                                          {"energy.contacts", "N m", 21.0},
                                          {"energy.cables", "N m", 115.0},
                                          {"dissipated.contact_damping", "N m", 1.0},
                                          {"dissipated.contact_release", "N m", 1.0},
                                          {"dissipated.cable_damping", "N m", 4.3},
                                          {"dissipated.cable_release", "N m", 1.0},
                                          {"dissipated.cable_yield", "N m", 1.0},
                                          {"dissipated.cable_break", "N m", 1.0},
                                          {"dissipated.hanger_break", "N m", 1.0},
                                          {"dissipated.friction", "N m", 1.0},
                                          {"balance_error.energy", "N m", 200.0},
                                          {"balance_error.momentum_x", "N s", 10.0},
                                          {"balance_error.momentum_y", "N s", 60.0},
                                          {"balance_error.angular_momentum", "N m s", 300.0}};
  return list;
}

/// The closed forms of all columns at time t.
std::vector<double> exact_row(double t) {
  using reference::position_at, reference::speed_at;
  const double x = position_at(thrown_x, t), y = position_at(thrown_y, t), vx = speed_at(thrown_x, t),
               vy = speed_at(thrown_y, t), angle = position_at(thrown_angle, t), spin = speed_at(thrown_angle, t);
  const auto oscillator = [](double stiffness, double damping, double mass, double from_rest, double speed) {
    const double frequency = std::sqrt(stiffness / mass);
    return reference::DampedOscillator{frequency, damping / (2.0 * mass * frequency), from_rest, speed};
  };
  const double bed_rest = radius - pressed_mass * gravity / bed_stiffness;
  const double rope_rest = rope_top - rope_length - hung_mass * gravity / rope_stiffness;
  const reference::OscillatorState
      pressed = state_at(oscillator(bed_stiffness, bed_damping, pressed_mass, pressed_y - bed_rest, 0.0), t),
      hung = state_at(oscillator(rope_stiffness, rope_damping, hung_mass, hung_y - rope_rest, hung_speed), t);
  const double overlap = radius - (bed_rest + pressed.displacement);
  const double elongation = rope_top - (rope_rest + hung.displacement) - rope_length;
  const double kinetic =
      0.5 * (thrown_mass * (vx * vx + vy * vy) + thrown_inertia * spin * spin +
             pressed_mass * pressed.velocity * pressed.velocity + hung_mass * hung.velocity * hung.velocity);
  const double weight = gravity * (thrown_mass * y + pressed_mass * (bed_rest + pressed.displacement) +
                                   hung_mass * (rope_rest + hung.displacement));
  const double applied = -(thrown_force_x * (x - thrown_x.position) + thrown_force_y * (y - thrown_y.position) +
                           moment * (angle - thrown_angle.position));
  return {t,
          x,
          y,
          vx,
          vy,
          angle,
          spin,
          pressed_x,
          bed_rest + pressed.displacement,
          0.0,
          pressed.velocity,
          hung_x,
          rope_rest + hung.displacement,
          0.0,
          hung.velocity,
          overlap,
          bed_stiffness * overlap - bed_damping * pressed.velocity,
          elongation,
          rope_stiffness * elongation - rope_damping * hung.velocity,
          kinetic,
          weight,
          applied,
          0.5 * bed_stiffness * overlap * overlap,
          0.5 * rope_stiffness * elongation * elongation,
          bed_damping * pressed.squared_velocity,
          0.0,
          rope_damping * hung.squared_velocity,
          0.0,
          0.0,
          0.0,
          0.0,
          0.0,
          0.0,
          0.0,
          0.0,
          0.0};
}

/// Step numbers of the rows of the history: every fourth, and the last.
std::vector<int> rows() {
  std::vector<int> found;
  for (int n = 0; n < steps; n += steps_a_row)
    found.push_back(n);
  found.push_back(steps);
  return found;
}

const std::string tolerance_reason =
    "the method's tolerance, 1e-13, is relative to the largest speed of the run, 7 m/s; for the slowest column, "
    "pressed.vy of 0.13 m/s, that is 5e-12, not all of which accumulates. With ten printed digits the error was 57 "
    "times the bound";

Tolerance of_files() { return Tolerance::round_off(5e-12, tolerance_reason); }

void check_history(const Csv& history, Findings& findings) {
  std::vector<std::string> header;
  for (const Quantity& quantity : quantities())
    header.push_back(fmt::format("{} [{}]", quantity.name, quantity.unit));
  findings.expect_true("history.csv: names, units and order of its columns", history.header() == header,
                       "the columns follow the scene: bodies, contacts, cables, energy balance");
  const std::vector<int> expected = rows();
  findings.expect("history.csv: rows", static_cast<double>(history.rows()), static_cast<double>(expected.size()),
                  Tolerance::exact("every fourth of 102 steps from the first on, and the last"));
  double worst = 0.0, worst_ledger = 0.0;
  for (std::size_t row = 0; row < std::min(history.rows(), expected.size()); ++row) {
    const std::vector<double> exact = exact_row(step * expected[row]);
    for (std::size_t i = 0; i < std::min(exact.size(), history.header().size()); ++i) {
      const bool ledger = quantities()[i].unit.starts_with("N m") || quantities()[i].name.starts_with("balance_error");
      keep_worst(ledger ? worst_ledger : worst, (history.number(row, i) - exact[i]) / quantities()[i].scale);
    }
  }
  findings.expect("history.csv: motion and forces, largest error", worst, 0.0, of_files());
  findings.expect("history.csv: energies and balances, largest error", worst_ledger, 0.0, of_files());
}

/// The balances of the thrown body alone by the integrator `exact`, which adds forces and moments over its segments.
void check_exact(const TemporaryFolder& folder, Findings& findings) {
  const std::string all = folder.read("scene.toml");
  folder.write("thrown.toml",
               all.substr(0, all.find("[[body]]\nname = \"pressed\"")) +
                   "[run]\nintegrator = \"exact\"\nstep = \"10 ms\"\nend = \"1 s\"\ninterval = \"50 ms\"\n");
  (void)talus_output(folder, {"run", "thrown.toml", "--out", "exact"});
  const Csv history = records::read_csv(folder.path() / "exact/history.csv");
  double worst = 0.0;
  for (const Quantity& quantity : quantities()) {
    if (!quantity.name.starts_with("balance_error.")) continue;
    const std::size_t column = history.column(fmt::format("{} [{}]", quantity.name, quantity.unit));
    for (std::size_t row = 0; row < history.rows(); ++row)
      keep_worst(worst, history.number(row, column) / quantity.scale);
  }
  findings.expect(
      "history.csv: balances of a thrown body by the integrator `exact`, largest error", worst, 0.0,
      Tolerance::round_off(1e-14,
                           "a hundred segments, each rounded by 1.1e-16 of the scale; moments are parabolas "
                           "in time, for which the rule of eight points is exact"));
}

/// The balance of momentum in rows within the implicit steps of a body that swings on a stiffly damped rope.
void check_implicit(const TemporaryFolder& folder, Findings& findings) {
  constexpr double mass = 1.5, end = 2.0;
  folder.write("swinging.toml", fmt::format(R"(units = "SI"
gravity = ["0 m/s^2", "{} m/s^2"]
[[body]]
name = "swinging"
mobility = "free"
mass = "{} kg"
inertia = "0.3 kg m^2"
position = ["4 m", "0 m"]
[[cable]]
name = "rope"
law = "tension_only"
from = {{ body = "swinging", point = ["0.25 m", "0.1 m"] }}
to = {{ point = ["7 m", "3 m"] }}
stiffness = "96 N/m"
damping = "4000 N s/m"
rest_length = "3.5 m"
[run]
integrator = "stormer_cowell"
tolerance = 1e-10
step = "2 ms"
end = "{} s"
)",
                                            -gravity, mass, end));
  (void)talus_output(folder, {"run", "swinging.toml", "--out", "swinging"});
  const Csv history = records::read_csv(folder.path() / "swinging/history.csv");
  double worst = history.rows() > 100 ? 0.0 : NAN;
  for (const char* const name : {"balance_error.momentum_x", "balance_error.momentum_y"})
    for (const double error : column(history, name))
      keep_worst(worst, error / (mass * gravity * end));
  findings.expect("history.csv: momentum balance in implicit steps over the impulse of the weight, largest error",
                  worst, 0.0,
                  Tolerance::truncation(1.1e-8, 3.0,
                                        "measured: within a step the impulse is a cubic, which errs by h^4/384 of the "
                                        "third derivative of the force. A wrong rate at an end would be an error of "
                                        "the order of h^2, 3e-6 here"));
}

/// Rows of a run whose interval is a whole number of steps but for the rounding of decimals, or is no whole number.
void check_intervals(const TemporaryFolder& folder, Findings& findings) {
  constexpr double long_step = 0.1;
  double worst = 0.0;
  for (const char* const interval : {"0.3", "0.27", "0.33"}) {
    folder.write("rows.toml",
                 fmt::format("units = \"SI\"\n[[body]]\nname = \"free\"\nmobility = \"particle\"\nmass = \"1 kg\"\n"
                             "position = [\"0 m\", \"0 m\"]\n[run]\nintegrator = \"velocity_verlet\"\n"
                             "step = \"{} s\"\nend = \"1 s\"\ninterval = \"{} s\"\n",
                             long_step, interval));
    (void)talus_output(folder, {"run", "rows.toml", "--out", "rows"});
    keep_worst(worst, worst_error(column(records::read_csv(folder.path() / "rows/history.csv"), "time"),
                                  {0.0, 3.0 * long_step, 6.0 * long_step, 9.0 * long_step, 1.0}));
  }
  findings.expect("history.csv: times of rows every 3, 2.7 and 3.3 steps, largest error", worst, 0.0,
                  Tolerance::round_off(1e-15, "a sum of ten steps; the interval is the nearest number of steps"), "s");
}

void check_extremes(const Node& summary, Findings& findings) {
  std::vector<std::vector<double>> exact;
  for (int n = 0; n <= steps; ++n)
    exact.push_back(exact_row(step * n));
  double value = 0.0, time = 0.0;
  std::size_t named = 0;
  const std::vector<Node> extremes = summary.at("extremes").list();
  for (std::size_t i = 1; i < quantities().size(); ++i) {
    const auto& quantity = quantities()[i];
    const auto found =
        std::ranges::find_if(extremes, [&](const Node& node) { return node.at("name").text() == quantity.name; });
    if (found == extremes.end() || found->at("unit").text() != quantity.unit) continue;
    ++named;
    const auto column = [i](const std::vector<double>& row) { return row[i]; };
    const auto [smallest, largest] = std::ranges::minmax_element(exact, {}, column);
    keep_worst(value, (found->at("minimum").number() - (*smallest)[i]) / quantity.scale);
    keep_worst(value, (found->at("maximum").number() - (*largest)[i]) / quantity.scale);
    // The extremes of a constant quantity, or of rounding errors, may occur at any time.
    if ((*largest)[i] - (*smallest)[i] < 1e-6 * quantity.scale) continue;
    keep_worst(time, found->at("minimum_time").number() - (*smallest)[0]);
    keep_worst(time, found->at("maximum_time").number() - (*largest)[0]);
  }
  findings.expect("summary.json: quantities with extremes", static_cast<double>(named),
                  static_cast<double>(quantities().size() - 1),
                  Tolerance::exact("all except the time, with their units"));
  findings.expect("summary.json: extremes, largest error", value, 0.0, of_files());
  findings.expect("summary.json: times of the extremes, largest error", time, 0.0,
                  Tolerance::round_off(1e-14, "a time is n h, and no two samples near an extreme agree to 1e-6"), "s");
}

void check_summary(const Node& summary, Findings& findings) {
  findings.expect("summary.json: steps", static_cast<double>(summary.at("steps").count()), steps,
                  Tolerance::exact("an integer"));
  const std::vector<double> exact = exact_row(step * steps);
  const Node ledger = summary.at("ledger");
  double worst = 0.0;
  for (std::size_t i = 0; i < quantities().size(); ++i) {
    const auto& [name, unit, scale] = quantities()[i];
    const auto part = name.substr(name.find('.') + 1);
    const bool energy = name.starts_with("energy."), dissipated = name.starts_with("dissipated.");
    if (!energy && !dissipated) continue;
    const Node node = ledger.at(energy ? "energy" : "dissipated").at(part.c_str());
    keep_worst(worst, (node.number() - exact[i]) / scale);
  }
  // Kinetic energy, and the change of the others since the start, in every step.
  double largest = 0.0, of_applied = 0.0;
  const std::vector<double> first = exact_row(0.0);
  for (int n = 0; n <= steps; ++n) {
    const std::vector<double> row = exact_row(step * n);
    for (std::size_t i = 0; i < quantities().size(); ++i) {
      const std::string& name = quantities()[i].name;
      if (!name.starts_with("energy.")) continue;
      const double change = std::abs(name == "energy.kinetic" ? row[i] : row[i] - first[i]);
      largest = std::max(largest, change);
      if (name == "energy.applied") of_applied = std::max(of_applied, change);
    }
  }
  keep_worst(worst, of_applied == largest ? ledger.at("energy_scale").number() / largest - 1.0 : std::nan(""));
  findings.expect("summary.json: energies at the end and energy scale, largest error", worst, 0.0, of_files());
}

void check_final_state(const Node& file, Findings& findings) {
  const std::vector<double> exact = exact_row(step * steps);
  const std::vector<Node> bodies = file.at("bodies").list();
  double worst = file.at("time").number() - step * steps;
  const auto compare = [&](const Node& body, std::size_t first, bool turns) {
    const std::vector<Node> position = body.at("position").list(), velocity = body.at("velocity").list();
    for (const std::size_t i : {0u, 1u}) {
      keep_worst(worst, position.at(i).number() - exact[first + i]);
      keep_worst(worst, velocity.at(i).number() - exact[first + 2 + i]);
    }
    keep_worst(worst, body.at("angle").number() - (turns ? exact[first + 4] : 0.0));
    keep_worst(worst, body.at("spin").number() - (turns ? exact[first + 5] : 0.0));
  };
  compare(bodies.at(0), 1, true), compare(bodies.at(1), 7, false), compare(bodies.at(2), 11, false);
  findings.expect("final_state.json: positions and velocities, largest error", worst, 0.0, of_files());
}

/// Checks each file of the series: the disc's outline, the rope's ends and its tension.
void check_geometry(const TemporaryFolder& folder, Findings& findings, const Setup& setup) {
  double outline = 0.0, rope = 0.0, tension = 0.0, times = 0.0;
  int files = 0;
  for (const auto& [time, text] : geometry_states(folder, "out", "scene")) {
    const std::vector<double> exact = exact_row(step * (steps_a_file * files + setup.has("frames_one_late")));
    ++files;
    keep_worst(times, time - exact[0]);
    const std::vector<double> points = data_array(text, "Points"), offsets = data_array(text, "offsets");
    const auto on_circle = static_cast<std::size_t>(offsets.at(0));
    for (std::size_t i = 0; i < on_circle; ++i)
      keep_worst(outline, std::hypot(points.at(3 * i) - pressed_x, points.at(3 * i + 1) - exact[8]) - radius);
    const std::array ends{rope_x, exact[12], 0.0, rope_x, rope_top, 0.0};
    for (std::size_t i = 0; i < ends.size(); ++i)
      keep_worst(rope, points.at(points.size() - ends.size() + i) - ends[i]);
    keep_worst(tension, (data_array(text, "tension").at(2) - exact[18]) / quantities()[18].scale);
  }
  findings.expect("geometry: files", files, steps / steps_a_file + 1,
                  Tolerance::exact("the first state, and one for every third step"));
  findings.expect("geometry: times of its files, largest error", times, 0.0,
                  Tolerance::round_off(1e-14, "a time is n h"), "s");
  findings.expect("geometry: distance of the outline from its circle, largest error", outline, 0.0, of_files(), "m");
  findings.expect("geometry: ends of the rope, largest error", rope, 0.0, of_files(), "m");
  findings.expect("geometry: tension of the rope, largest error", tension, 0.0, of_files());
}

void check_resumed(const TemporaryFolder& folder, Findings& findings, const Setup& setup) {
  const std::vector<std::string> files{"history.csv", "final_state.json", "scene.pvd"};
  // The interruption is between two rows and between two states of the geometry.
  const std::string until = setup.has("resumed_from_the_start") ? "" : fmt::format("{} s", 47 * step);
  if (!until.empty()) {
    (void)talus_output(folder, {"run", "scene.toml", "--out", "halves", "--frames", frames, "--until", until});
    (void)talus_output(folder, {"run", "--resume", "halves"});
  } else {
    folder.write("scene.toml", scene_text({.fault = "one_step_less"}));
    (void)talus_output(folder, {"run", "scene.toml", "--out", "halves", "--frames", frames});
  }
  double different = 0.0;
  for (const std::string& file : files)
    different += folder.read("out/" + file) != folder.read("halves/" + file);
  const auto extremes = [&](const char* out) {
    return records::read_json(folder.path() / out / "summary.json").at("extremes");
  };
  different += extremes("out") != extremes("halves");
  different += different_warnings(folder);
  different += different_events(folder);
  different += different_fence_files(folder);
  // An interval that the scene leaves out follows from the end of the run, not from that of the scene.
  std::string plain = folder.read("scene.toml");
  const std::size_t at = plain.find("interval = ");
  plain.erase(at, plain.find('\n', at) + 1 - at);
  folder.write("plain.toml", plain);
  const std::string later = fmt::format("{} s", 40 * steps * step);
  const std::vector<std::string> start{"run", "plain.toml", "--end", later, "--out"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), start.begin(), start.end());
    return more;
  };
  (void)talus_output(folder, with({"longer"}));
  (void)talus_output(folder, with({"paused", "--until", fmt::format("{} s", 7 * steps * step)}));
  (void)talus_output(folder, {"run", "--resume", "paused"});
  for (const char* const file : {"history.csv", "final_state.json"})
    different += folder.read(std::string{"longer/"} + file) != folder.read(std::string{"paused/"} + file);
  findings.expect(
      "files that differ after an interruption", different, 0.0,
      Tolerance::exact("history, final state and index of the geometry are byte-identical, and the summary "
                       "has the same extremes; of a second run, with three warnings, and of one with two located "
                       "events the whole summary is the same; of a fence, whose cables yield before, each file"));
}

void run(Findings& findings, const Setup& setup) {
  const auto group = findings.in("files");
  const TemporaryFolder folder;
  folder.write("scene.toml", scene_text(setup));
  const std::string printed = talus_output(folder, {"run", "scene.toml", "--out", "out", "--frames", frames, "--json"});
  const Json summary_json = records::read_json(folder.path() / "out/summary.json");
  const Json state_json = records::read_json(folder.path() / "out/final_state.json");
  const Node summary{summary_json, "summary.json"};
  findings.count(summary.at("evaluations").count());
  const Csv history = records::read_csv(folder.path() / "out/history.csv");
  check_history(history, findings);
  check_exact(folder, findings);
  if (setup.needs("implicit steps")) check_implicit(folder, findings);
  if (setup.needs("times of rows")) check_intervals(folder, findings);
  check_extremes(summary, findings);
  check_summary(summary, findings);
  check_final_state(Node{state_json, "final_state.json"}, findings);
  check_geometry(folder, findings, setup);
  findings.expect_true("summary on standard output (--json)", Json::parse(printed) == summary_json,
                       "the same document as in summary.json");
  check_resumed(folder, findings, setup);
  findings.expect(
      "files that differ in the folder of an earlier run, of a fence", different_after_a_fence(folder), 0.0,
      Tolerance::exact("histories, listing and states of the fence are removed: the folder has the files of "
                       "the last run, byte-identical to those in a new folder"));
  findings.expect("summary.json: energy scale of damped bodies over the largest change of an energy, deviation from 1",
                  scale_error(folder), 0.0, Tolerance::round_off(1e-15, "one difference of the numbers in 17 digits"));
  if (setup.coarse) return;
  std::vector<double> times, forces;
  for (std::size_t row = 0; row < history.rows(); ++row)
    times.push_back(history.number(row, 0)), forces.push_back(history.number(row, "bed.force [N]"));
  Series exact{.label = "closed form", .style = Style::lines};
  for (double t = 0.0; t <= step * steps; t += 0.1 * step)
    exact.add(t, exact_row(t)[16]);
  findings.figure({.name = "force",
                   .title = "Contact force in history.csv",
                   .caption = "Contact force: rows of the file (points) and the closed form (line).",
                   .x = {.label = "time", .unit = "s"},
                   .y = {.label = "contact force", .unit = "N"},
                   .series = {exact, points("history.csv", times, forces)},
                   .lines = {{'y', pressed_mass * gravity, "weight"}}});
}

}  // namespace

Case definition() {
  return {.id = "run_files",
          .title = "Output files of a run",
          .requirements = {{"G1", {"files"}}},
          .main_checks = {"history.csv: motion and forces, largest error", "summary.json: extremes, largest error"},
          .source = "Textbook mechanics",
          .faults = {{"more_gravity", "gravity too large by a factor of 1 + 1e-10",
                      "history.csv: motion and forces, largest error"},
                     {"softer_bed", "a contact too soft by a factor of 1 - 1e-10",
                      "history.csv: energies and balances, largest error"},
                     {"longer_rope", "a cable too long by 1e-10 m", "geometry: tension of the rope, largest error"},
                     {"one_step_less", "a run that ends one step earlier", "summary.json: extremes, largest error"},
                     {"other_interval", "a row every five steps", "history.csv: rows"},
                     {"frames_one_late", "states of the geometry compared with those one step later",
                      "geometry: distance of the outline from its circle, largest error"},
                     {"resumed_from_the_start", "a run with one step less in place of the resumed one",
                      "files that differ after an interruption"}},
          .run = run};
}

}  // namespace talus::verification::problems::run_files
