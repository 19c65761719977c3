#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "verification/check/case.hpp"
#include "verification/problems/program/compared_files.hpp"
#include "verification/record/csv.hpp"
#include "verification/record/json_node.hpp"
#include "verification/study/expectations.hpp"
#include "verification/study/program_run.hpp"

namespace talus::verification::problems::agreeing_files {
namespace {

using records::Json;
using Vector = std::array<double, 3>;
constexpr double infinite = std::numeric_limits<double>::infinity();

// --- The scenes ------------------------------------------------------------------------------------------------------

/// Units of a scene's results: symbols, and the units of length, force and mass in SI.
struct Units {
  std::string system, length, mass, force, energy, momentum, angular_momentum;
  double metre{}, newton{};
  double kilogram() const { return newton / metre; }
  double joule() const { return newton * metre; }
};
const Units si{"SI", "m", "kg", "N", "N m", "N s", "N m s", 1.0, 1.0};
/// International foot and avoirdupois pound, exact by definition (1959), and standard gravity.
const Units us{"US", "ft", "slug", "lbf", "lbf ft", "lbf s", "lbf ft s", 0.3048, 0.45359237 * 9.80665};

enum class Shape { none, circle, box, plane };

struct Part {
  std::string name, kind{"body"};
  bool moves{true}, turns{true};
  double mass{}, inertia{};
  Shape shape{};
  double a{}, b{};           ///< half-axes of the shape
  double x{}, y{}, angle{};  ///< where a column of the history does not give them
  double along{};            ///< position along the fence
  int layer{}, number{};
  double multiplicity{1.0};  ///< 2 for a body with a mirror image
  double force_x{}, moment{};
};

/// An end of a cable: a point in the axes of a body, or of the world (body < 0).
struct End {
  int body{-1};
  double x{}, y{}, along{};
};

struct Cable {
  std::string name;
  End from, to;
  double stiffness{}, damping{}, yield{infinite}, strength{infinite}, hardening{};  ///< of the tangent, over k
  double rest{};
  int layer{};
  bool top{};
};

/// What the text of a scene says, in its units.
struct Facts {
  std::string file, title, text, integrator, integrator_step{};
  const Units* units{};
  double gravity{}, step{};  ///< a step of zero: from a rule of fences
  int steps{}, steps_a_state{};
  int degrees_of_freedom{};
  std::vector<Part> bodies{};
  std::vector<Cable> cables{};
  std::vector<std::string> contacts{};
  std::vector<std::string> hangers{};
  bool mirrored{};
};

void replace(std::string& text, const std::string& old, const std::string& with) {
  const std::size_t at = text.find(old);
  if (at == std::string::npos) throw std::runtime_error(fmt::format("'{}' is expected in a scene", old));
  text.replace(at, old.size(), with);
}

constexpr double low_radius = 0.5, high_radius = 0.4, side_radius = 0.3;
constexpr double low_stiffness = 2000.0, low_damping = 8.0, loading = 3000.0, unloading = 5000.0, modulus = 60000.0,
                 hertz_radius = 0.2;

Facts yard() {
  return {.file = "yard",
          .title = "Contacts and cables of several kinds",
          .text = R"(title = "Contacts and cables of several kinds"
units = "SI"
gravity = ["0 m/s^2", "-10 m/s^2"]

[[body]]
name = "ground"
mobility = "fixed"
shape = { kind = "half_plane" }
position = ["0 m", "0 m"]

[[body]]
name = "low"
mobility = "free"
mass = "2 kg"
inertia = "0.25 kg m^2"
shape = { kind = "circle", radius = "0.5 m" }
position = ["0 m", "0.52 m"]
velocity = ["1 m/s", "-2 m/s"]
spin = "3 rad/s"

[[body]]
name = "high"
mobility = "particle"
mass = "1.5 kg"
shape = { kind = "circle", radius = "0.4 m" }
position = ["0.1 m", "1.45 m"]
velocity = ["0 m/s", "-3 m/s"]
force = ["0.5 N", "0 N"]

[[body]]
name = "side"
mobility = "free"
mass = "1 kg"
inertia = "0.1 kg m^2"
shape = { kind = "circle", radius = "0.3 m" }
position = ["0.95 m", "0.6 m"]
velocity = ["-2 m/s", "0 m/s"]
moment = "0.2 N m"

[[body]]
name = "beam"
mobility = "sliding_y"
mass = "3 kg"
position = ["-3 m", "2 m"]
velocity = ["0 m/s", "-1 m/s"]

[[contact]]
name = "low-ground"
between = ["low", "ground"]
law = "linear_spring_dashpot"
stiffness = "2000 N/m"
damping = "8 N s/m"
friction = 0.4

[[contact]]
name = "high-low"
between = ["high", "low"]
law = "latching_spring"
stiffness = "3000 N/m"
unloading_stiffness = "5000 N/m"

[[contact]]
name = "side-low"
between = ["side", "low"]
law = "hertz"
modulus = "60000 N/m^2"
radius = "0.2 m"

[[cable]]
name = "tie"
law = "elastic_plastic"
from = { body = "beam", point = ["0 m", "0 m"] }
to = { point = ["-3 m", "4 m"] }
stiffness = "900 N/m"
yield = "60 N"

[[cable]]
name = "rope"
law = "tension_only"
from = { body = "high", point = ["0 m", "0 m"] }
to = { point = ["0.6 m", "3 m"] }
stiffness = "200 N/m"
damping = "3 N s/m"
rest_length = "1.6 m"

[run]
integrator = "velocity_verlet"
step = "0.5 ms"
end = "0.3 s"
interval = "0.5 ms"
)",
          .integrator = "velocity_verlet",
          .units = &si,
          .gravity = 10.0,
          .step = 5e-4,
          .steps = 600,
          .steps_a_state = 60,
          .degrees_of_freedom = 9,
          .bodies =
              {{.name = "ground", .kind = "ground", .moves = false, .shape = Shape::plane},
               {.name = "low", .mass = 2.0, .inertia = 0.25, .shape = Shape::circle, .a = low_radius},
               {.name = "high", .turns = false, .mass = 1.5, .shape = Shape::circle, .a = high_radius, .force_x = 0.5},
               {.name = "side", .mass = 1.0, .inertia = 0.1, .shape = Shape::circle, .a = side_radius, .moment = 0.2},
               {.name = "beam", .turns = false, .mass = 3.0}},
          .cables = {{.name = "tie",
                      .from = {.body = 4},
                      .to = {.x = -3.0, .y = 4.0},
                      .stiffness = 900.0,
                      .yield = 60.0,
                      .rest = 2.0},
                     {.name = "rope",
                      .from = {.body = 2},
                      .to = {.x = 0.6, .y = 3.0},
                      .stiffness = 200.0,
                      .damping = 3.0,
                      .rest = 1.6}},
          .contacts = {"low-ground", "high-low", "side-low"}};
}

/// Numbers of the fence, in feet and pounds; areas in square inches, Young's modulus in pounds per square inch.
constexpr double fence_span = 30.0, sag = 3.0, spacing = 2.5, layer_spacing = 2.6, y_top = 6.67, y_bottom = -4.0,
                 slack = 0.02, young = 20e6, area_top = 1.076, area_bottom = 0.25, limit_top = 20000.0,
                 limit_bottom = 3000.0, strength_top = 21000.0, hanger_strength = 15000.0, hardening = 0.02,
                 ground_top = -4.5;
constexpr int columns_of_half = 3;

struct Rock {
  double radius, x, y, speed, spin;
};
constexpr std::array<Rock, 2> rocks{{{1.201, 2.451, -1.3, -65.0, 34.0}, {1.1, 2.55, 1.3, -50.0, -20.0}}};
constexpr double rock_density = 5.13, column_a = 1.25, column_b = 4.0, column_density = 0.76;

const std::string fence_text = R"(title = "Two rocks on a yielding fence"
units = "US"

[fence]
steps = 400
print_every = 50
history_every = 1
step_factor = 1
gravity = "32.18 ft/s^2"
connections = 2
columns = 5
layers = 2
layer_spacing = "2.6 ft"
layer_overlap = "0.5 ft"
rock_overlap = "0.6 ft"
span = "30 ft"
sag = "3 ft"
spacing = "2.5 ft"
young = "20000000 psi"
y_top = "6.67 ft"
y_bottom = "-4 ft"
area_top = "1.076 in^2"
area_bottom = "0.25 in^2"
limit_top = "20000 lbf"
limit_bottom = "3000 lbf"
slack = "0.02 ft"
restitution = 0.4
penetration = 0.05
friction = 0.3
history_elements = [2, 3, 4, 5, 6, 7, 8, 9, 10]
history_codes = [15, 16, 35, 36, 37, 38, 48, 51]

[fence.ground]
a = "10 ft"
b = "0.5 ft"
position = ["0 ft", "-5 ft"]

[[fence.rock]]
a = "1.201 ft"
b = "1.201 ft"
density = "5.13 slug/ft^3"
spin = "34 rad/s"
position = ["2.451 ft", "-1.3 ft"]
velocity = ["-65 ft/s", "0 ft/s"]

[[fence.rock]]
a = "1.1 ft"
b = "1.1 ft"
density = "5.13 slug/ft^3"
spin = "-20 rad/s"
position = ["2.55 ft", "1.3 ft"]
velocity = ["-50 ft/s", "0 ft/s"]

[fence.column]
a = "1.25 ft"
b = "4 ft"
density = "0.76 slug/ft^3"

[fence.options]
integrator = "auto"
hardening = 0.02
hanger_strength = "15000 lbf"
strength_top = "21000 lbf"
)";

/// The fence; its columns hang on a parabola, the first one at its lowest point.
Facts fence() {
  Facts facts{.file = "fence",
              .title = "Two rocks on a yielding fence",
              .text = fence_text,
              .integrator = "stormer_cowell",
              .integrator_step = "steps chosen by stormer_cowell, events located, tolerance 1e-10",
              .units = &us,
              .gravity = 32.18,
              .steps = 400,
              .steps_a_state = 50,
              .degrees_of_freedom = 24,
              .mirrored = true};
  facts.bodies.push_back(
      {.name = "ground", .kind = "ground", .moves = false, .shape = Shape::plane, .y = ground_top, .number = 1});
  for (std::size_t r = 0; r < rocks.size(); ++r) {
    const double a = rocks[r].radius, mass = 4.0 / 3.0 * std::numbers::pi * a * a * a * rock_density;
    facts.bodies.push_back({.name = fmt::format("rock{}", r + 1),
                            .kind = "rock",
                            .mass = mass,
                            .inertia = 0.4 * mass * a * a,
                            .shape = Shape::circle,
                            .a = a,
                            .number = static_cast<int>(r) + 2});
  }
  const double mass = 2.0 * std::numbers::pi * column_a * column_a * column_b * column_density;
  for (const int layer : {1, 2}) {
    const std::string prefix = layer == 1 ? "" : "back_";
    const double x = layer == 1 ? 0.0 : -layer_spacing;
    const auto first = static_cast<int>(facts.bodies.size());
    for (int i = 0; i < columns_of_half; ++i) {
      facts.bodies.push_back({.name = fmt::format("{}column{}", prefix, i + 1),
                              .kind = "column",
                              .mass = mass,
                              .inertia = mass * (column_a * column_a / 4.0 + column_b * column_b / 3.0),
                              .shape = Shape::box,
                              .a = column_a,
                              .b = column_b,
                              .along = spacing * i,
                              .layer = layer,
                              .number = first + i + layer,
                              .multiplicity = i == 0 ? 1.0 : 2.0});
      facts.hangers.push_back(fmt::format("{}hanger{}", prefix, i + 1));
    }
    for (const bool top : {true, false}) {
      for (int i = 0; i < (top ? columns_of_half : columns_of_half - 1); ++i) {
        const bool last = i + 1 == columns_of_half;
        const End anchor{-1, x, y_top + sag, 0.5 * fence_span};
        const double y = top ? y_top : y_bottom;
        facts.cables.push_back({.name = fmt::format("{}{}{}", prefix, top ? "top" : "bottom", i + 1),
                                .from = {first + i, 0.0, y, spacing * i},
                                .to = last ? anchor : End{first + i + 1, 0.0, y, spacing * (i + 1)},
                                .yield = top ? limit_top : limit_bottom,
                                .strength = top ? strength_top : infinite,
                                .hardening = hardening,
                                .layer = layer,
                                .top = top});
      }
    }
  }
  facts.contacts = {"rock1-column1",      "rock1-back_column1", "rock1-ground", "rock2-column1",
                    "rock2-back_column1", "rock2-ground",       "rock1-rock2",  "column1-back_column1"};
  return facts;
}

// --- The files of a run ----------------------------------------------------------------------------------------------

struct Run {
  Facts facts;
  std::string printed, messages;
  Json summary, state, plot;
  Columns history;
  std::vector<GeometryState> states;

  [[nodiscard]] std::size_t rows() const { return history.rows(); }
  [[nodiscard]] double time(std::size_t row) const { return history.values[0][row]; }
  /// A column of a body, or what the scene says if it has none.
  [[nodiscard]] double of(const Part& body, const char* quantity, std::size_t row, double otherwise) const {
    const std::string name = body.name + quantity;
    return history.has(name) ? history.at(name)[row] : otherwise;
  }
  /// Position in the world of a point in a body's axes.
  [[nodiscard]] Vector place(const Part& body, double u, double v, std::size_t row) const {
    const double turned = of(body, ".angle", row, body.angle), c = std::cos(turned), s = std::sin(turned);
    return {of(body, ".x", row, body.x) + c * u - s * v, of(body, ".y", row, body.y) + s * u + c * v, body.along};
  }
  [[nodiscard]] Vector place(const End& end, std::size_t row) const {
    if (end.body < 0) return {end.x, end.y, end.along};
    return place(facts.bodies[static_cast<std::size_t>(end.body)], end.x, end.y, row);
  }
  [[nodiscard]] const Part& body(const std::string& name) const {
    return *std::ranges::find_if(facts.bodies, [&](const Part& part) { return part.name == name; });
  }
};

Vector between(const Vector& a, const Vector& b) { return {b[0] - a[0], b[1] - a[1], b[2] - a[2]}; }
double size(const Vector& v) { return std::hypot(v[0], v[1], v[2]); }

/// Runs the scene with its files in a folder of its name. The cables' stiffness and rest length, where the scene gives
/// them by Young's modulus, follow from the distance of their ends at the start, and the step of 1993 from the
/// stiffness of the first cable: a hundredth of the period of a column between two of them.
Run run_of(const TemporaryFolder& folder, Facts facts, std::vector<std::string> more) {
  folder.write(facts.file + ".toml", facts.text);
  std::vector<std::string> arguments{"run", facts.file + ".toml", "--out", facts.file};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const ProgramEnd end = run_talus(folder, arguments);
  if (end.exit_code != 0) throw std::runtime_error("the program ended with: " + end.messages);
  const auto json = [&](const char* name) { return records::read_json(folder.path() / facts.file / name); };
  Run run{.facts = facts,
          .printed = end.output,
          .messages = end.messages,
          .summary = json("summary.json"),
          .state = json("final_state.json"),
          .plot = json("plot.json"),
          .history = Columns{records::read_csv(folder.path() / facts.file / "history.csv")},
          .states = geometry_states(folder, facts.file, facts.file)};
  for (Cable& cable : run.facts.cables) {
    if (cable.stiffness > 0.0) continue;
    const double length = size(between(run.place(cable.from, 0), run.place(cable.to, 0)));
    cable.stiffness = young * (cable.top ? area_top : 2.0 * area_bottom) / length;
    cable.rest = cable.top ? length - run.history.at(cable.name + ".tension")[0] / cable.stiffness : length + slack;
  }
  if (run.facts.step == 0.0) {
    const Part& column = run.body("column1");
    run.facts.step =
        2.0 * std::numbers::pi * std::sqrt(column.mass / (2.0 * run.facts.cables.front().stiffness)) / 100.0;
  }
  return run;
}

/// The text if the program printed it on a line after `before`; else a text that differs.
Json as_printed(const std::string& text, const std::string& before, const std::string& lines) {
  return lines.find(before + text + "\n") != std::string::npos ? text : fmt::format("not printed after '{}'", before);
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++found;
  return found;
}

/// Texts of the summary, each of which must be printed; their number is that of the printed lines.
Json all_printed(const Json& texts, const std::string& before, const std::string& lines, std::size_t expected) {
  Json list = Json::array();
  for (const Json& text : texts)
    list.push_back(as_printed(text.get<std::string>(), before, lines));
  while (list.size() < expected)
    list.push_back("a line that was printed");
  return list;
}

/// The integer that the program printed after a text.
long printed_number(const std::string& lines, const std::string& before) {
  const std::size_t at = lines.find(before);
  return at == std::string::npos ? -1 : std::stol(lines.substr(at + before.size()));
}

// --- Expected documents ----------------------------------------------------------------------------------------------

Json units_of(const Units& units) {
  return {{"system", units.system},
          {"length", units.length},
          {"time", "s"},
          {"mass", units.mass},
          {"force", units.force},
          {"energy", units.energy},
          {"momentum", units.momentum},
          {"angular_momentum", units.angular_momentum}};
}

/// The unit of a column, by what its name ends or begins with.
std::string unit_of(const std::string& name, const Units& units) {
  const std::map<std::string, std::string> endings{{"time", "s"},
                                                   {".x", units.length},
                                                   {".y", units.length},
                                                   {".vx", units.length + "/s"},
                                                   {".vy", units.length + "/s"},
                                                   {".angle", "rad"},
                                                   {".spin", "rad/s"},
                                                   {".overlap", units.length},
                                                   {".force", units.force},
                                                   {".elongation", units.length},
                                                   {".tension", units.force},
                                                   {"balance_error.momentum_x", units.momentum},
                                                   {"balance_error.momentum_y", units.momentum},
                                                   {"balance_error.angular_momentum", units.angular_momentum}};
  if (const auto whole = endings.find(name); whole != endings.end()) return whole->second;
  if (name.starts_with("energy.") || name.starts_with("dissipated.") || name == "balance_error.energy")
    return units.energy;
  const auto ending = endings.find(name.substr(std::min(name.rfind('.'), name.size())));
  return ending == endings.end() ? "" : ending->second;
}

const std::vector<std::string> energies{"kinetic", "gravity", "applied", "contacts", "cables"},
    mechanisms{"contact_damping", "contact_release", "cable_damping", "cable_release",
               "cable_yield",     "cable_break",     "hanger_break",  "friction"},
    balances{"energy", "momentum_x", "momentum_y", "angular_momentum"};

std::vector<std::string> expected_columns(const Facts& facts) {
  std::vector<std::string> names{"time"};
  const auto add = [&](const std::string& of, const std::vector<std::string>& quantities) {
    for (const std::string& quantity : quantities)
      names.push_back(of + "." + quantity);
  };
  for (const Part& body : facts.bodies) {
    if (!body.moves) continue;
    add(body.name, {"x", "y", "vx", "vy"});
    if (body.turns) add(body.name, {"angle", "spin"});
  }
  for (const std::string& contact : facts.contacts)
    add(contact, {"overlap", "force"});
  for (const Cable& cable : facts.cables)
    add(cable.name, {"elongation", "tension"});
  add("energy", energies), add("dissipated", mechanisms), add("balance_error", balances);
  return names;
}

/// Minimum, maximum and their first times, over the rows, which are of all steps.
Json extremes_of(const Run& run) {
  Json list = Json::array();
  for (std::size_t i = 1; i < run.history.names.size(); ++i) {
    const std::vector<double>& values = run.history.values[i];
    const auto low = std::ranges::min_element(values) - values.begin(),
               high = std::ranges::max_element(values) - values.begin();
    list.push_back({{"name", run.history.names[i]},
                    {"unit", unit_of(run.history.names[i], *run.facts.units)},
                    {"minimum", values[static_cast<std::size_t>(low)]},
                    {"minimum_time", run.time(static_cast<std::size_t>(low))},
                    {"maximum", values[static_cast<std::size_t>(high)]},
                    {"maximum_time", run.time(static_cast<std::size_t>(high))}});
  }
  return list;
}

Json bodies_of(const Run& run) {
  Json list = Json::array();
  const std::size_t last = run.rows() - 1;
  for (const Part& body : run.facts.bodies) {
    list.push_back({{"name", body.name},
                    {"position", {run.of(body, ".x", last, body.x), run.of(body, ".y", last, body.y)}},
                    {"angle", run.of(body, ".angle", last, body.angle)},
                    {"velocity", {run.of(body, ".vx", last, 0.0), run.of(body, ".vy", last, 0.0)}},
                    {"spin", run.of(body, ".spin", last, 0.0)}});
  }
  return list;
}

double total(const Run& run, const std::string& of, const std::vector<std::string>& parts, std::size_t row) {
  double sum = 0.0;
  for (const std::string& part : parts)
    sum += run.history.at(of + "." + part)[row];
  return sum;
}

/// Largest kinetic energy, or change of another energy, over the rows.
double energy_scale(const Run& run) {
  double scale = 0.0;
  for (const std::string& name : energies) {
    const std::vector<double>& values = run.history.at("energy." + name);
    for (const double value : values)
      scale = std::max(scale, std::abs(name == "kinetic" ? value : value - values.front()));
  }
  return scale;
}

/// Momentum, angular momentum about the origin, kinetic energy and weight, from the bodies' motion.
struct Sums {
  double x{}, y{}, angular{}, kinetic{}, gravity{};
  double momentum_scale{}, angular_scale{}, gravity_scale{};
};
Sums sums_of(const Run& run, std::size_t row) {
  Sums sums;
  for (const Part& body : run.facts.bodies) {
    if (!body.moves) continue;
    const double m = body.multiplicity * body.mass, inertia = body.multiplicity * body.inertia,
                 x = run.of(body, ".x", row, 0.0), y = run.of(body, ".y", row, 0.0), vx = run.of(body, ".vx", row, 0.0),
                 vy = run.of(body, ".vy", row, 0.0), spin = run.of(body, ".spin", row, 0.0);
    sums.x += m * vx, sums.y += m * vy, sums.angular += m * (x * vy - y * vx) + inertia * spin;
    sums.kinetic += 0.5 * (m * (vx * vx + vy * vy) + inertia * spin * spin);
    sums.gravity += m * run.facts.gravity * y;
    sums.momentum_scale += m * std::hypot(vx, vy);
    sums.angular_scale += m * std::hypot(x, y) * std::hypot(vx, vy) + inertia * std::abs(spin);
    sums.gravity_scale += m * run.facts.gravity * std::abs(y);
  }
  return sums;
}

double largest_balance_error(const Run& run) {
  double largest = 0.0;
  for (const double error : run.history.at("balance_error.energy"))
    largest = std::max(largest, std::abs(error));
  return largest;
}

Json ledger_of(const Run& run) {
  const std::size_t last = run.rows() - 1;
  Json energy, dissipated;
  for (const std::string& part : energies)
    energy[part] = run.history.at("energy." + part)[last];
  energy["total"] = total(run, "energy", energies, last);
  for (const std::string& part : mechanisms)
    dissipated[part] = run.history.at("dissipated." + part)[last];
  const Sums sums = sums_of(run, last);
  const auto balance = [&](const char* of) { return run.history.at(std::string("balance_error.") + of)[last]; };
  return {{"energy", energy},
          {"dissipated", dissipated},
          {"energy_balance_error", balance("energy")},
          {"largest_energy_balance_error", largest_balance_error(run)},
          {"energy_scale", energy_scale(run)},
          {"momentum", {scaled(sums.x, sums.momentum_scale), scaled(sums.y, sums.momentum_scale)}},
          {"momentum_balance_error", {balance("momentum_x"), balance("momentum_y")}},
          {"angular_momentum", scaled(sums.angular, sums.angular_scale)},
          {"angular_momentum_balance_error", balance("angular_momentum")}};
}

/// Plastic stretch after a largest tension.
double plastic_stretch(const Cable& cable, double tension) {
  return std::max(0.0, tension - cable.yield) * (1.0 / cable.hardening - 1.0) / cable.stiffness;
}

double elongation_at_break(const Cable& cable) {
  return cable.strength / cable.stiffness + plastic_stretch(cable, cable.strength);
}

struct Event {
  double time;
  std::string part, event;
};

/// Cables yield in the first row with at least the elongation of their yield force, and break likewise.
std::vector<Event> events_of(const Run& run) {
  std::vector<Event> events;
  for (const Cable& cable : run.facts.cables) {
    const std::vector<double>& elongation = run.history.at(cable.name + ".elongation");
    const auto add = [&](double limit, const char* what) {
      const auto reached = std::ranges::find_if(elongation, [limit](double now) { return now >= limit; });
      if (reached == elongation.end()) return;
      events.push_back({run.time(static_cast<std::size_t>(reached - elongation.begin())),
                        fmt::format("cable '{}'", cable.name), what});
    };
    if (cable.yield < infinite) add(cable.yield / cable.stiffness, "yields");
    if (cable.strength < infinite) add(elongation_at_break(cable), "breaks");
  }
  std::ranges::sort(events, {}, &Event::time);
  return events;
}

/// Modes and plastic stretch at the end.
Json cables_of(const Run& run) {
  Json list = Json::array();
  for (const Cable& cable : run.facts.cables) {
    const std::vector<double>&tensions = run.history.at(cable.name + ".tension"),
          &elongations = run.history.at(cable.name + ".elongation");
    const double peak = *std::ranges::max_element(tensions);
    bool broken = false;
    for (const Event& event : events_of(run))
      broken = broken || (event.event == "breaks" && event.part == fmt::format("cable '{}'", cable.name));
    double stretch = broken                  ? plastic_stretch(cable, cable.strength)
                     : cable.hardening > 0.0 ? plastic_stretch(cable, peak)
                     : cable.yield < infinite
                         ? std::max(0.0, *std::ranges::max_element(elongations) - cable.yield / cable.stiffness)
                         : 0.0;
    const bool yields = stretch > 0.0 && tensions.back() == peak;
    list.push_back({{"name", cable.name},
                    {"mode", broken                  ? "broken"
                             : yields                ? "yielding"
                             : tensions.back() > 0.0 ? "taut"
                                                     : "slack"},
                    {"plastic_stretch", scaled(stretch, stretch > 0.0 ? stretch : 1.0)}});
  }
  return list;
}

/// The contact that acts last: any of those that act in the last row with a contact, at its time; or at the end of that
/// contact, in the row after it.
Json last_contact_of(const Run& run) {
  const std::string name = run.summary["quality"]["last_contact"]["name"];
  for (std::size_t row = run.rows(); row-- > 0;) {
    bool any = false, named = false;
    for (const std::string& contact : run.facts.contacts) {
      const bool acts =
          run.history.at(contact + ".overlap")[row] > 0.0 || run.history.at(contact + ".force")[row] > 0.0;
      any = any || acts, named = named || (acts && contact == name);
    }
    if (!any) continue;
    const bool touching = row + 1 == run.rows();
    return {
        {"name", named ? name : "one that acts"}, {"time", run.time(touching ? row : row + 1)}, {"touching", touching}};
  }
  return nullptr;
}

Json quality_of(const Run& run) {
  const Json& found = run.summary["quality"];
  const double balance = largest_balance_error(run) / energy_scale(run);
  Json json{{"usable", balance < 0.01}, {"flaw", ""}, {"enforced", true}};
  const std::string step = found["step"];
  json["step"] = !run.facts.integrator_step.empty()                         ? run.facts.integrator_step
                 : run.printed.find(" " + step + "; ") != std::string::npos ? step
                                                                            : "as printed";
  json["energy_balance"] = balance;
  if (found.contains("steps_in_shortest_contact")) {
    // The monitor prints four digits.
    const std::string line = "  steps in the shortest contact";
    const std::size_t at = run.printed.find(line);
    const double printed = at == std::string::npos ? 0.0 : std::stod(run.printed.substr(at + line.size()));
    const double steps = found["steps_in_shortest_contact"];
    json["steps_in_shortest_contact"] = std::abs(steps - printed) < 6e-4 * printed ? steps : printed;
  }
  json["last_contact"] = last_contact_of(run);
  return json;
}

Json outcome_of(const Run& run) { return {{"kind", "finished"}, {"time", run.facts.steps * run.facts.step}}; }

/// summary.json without what only fences have.
Json expected_summary(const Run& run) {
  const Facts& facts = run.facts;
  const auto rows = run.rows();
  Json failures = Json::array();
  for (const Event& event : events_of(run))
    failures.push_back({{"time", event.time}, {"part", event.part}, {"event", event.event}});
  const bool located = !facts.integrator_step.empty();
  const std::string steps = fmt::format("steps        {}, force evaluations ", facts.steps);
  const std::string model =
      fmt::format("  {} bodies, {} degrees of freedom, {} contacts, {} cables, ", facts.bodies.size(),
                  facts.degrees_of_freedom, facts.contacts.size(), facts.cables.size());
  Json json{{"schema", 2},
            {"title", facts.title},
            {"units", units_of(*facts.units)},
            {"outcome", outcome_of(run)},
            {"quality", quality_of(run)},
            {"integrator", facts.integrator},
            {"step", facts.step},
            {"end", facts.steps * facts.step},
            {"steps", facts.steps},
            {"evaluations", located ? printed_number(run.printed, steps) : facts.steps + 1},
            {"model",
             {{"bodies", facts.bodies.size()},
              {"degrees_of_freedom", facts.degrees_of_freedom},
              {"contacts", facts.contacts.size()},
              {"cables", facts.cables.size()},
              {"law_instances", printed_number(run.printed, model)}}},
            {"history_rows", rows},
            {"history_rows_cut", 0},
            {"ledger", ledger_of(run)},
            {"extremes", extremes_of(run)},
            {"failures", failures},
            {"bodies", bodies_of(run)}};
  // The monitor's lines are those between two heads.
  const std::size_t head = run.printed.find("run monitor\n");
  const std::string monitor = head == std::string::npos ? "" : run.printed.substr(head);
  json["monitor"] = all_printed(run.summary["monitor"], "\n  ", monitor, count(monitor, "\n  "));
  const std::string warning = "talus: warning: ", note = "note: ";
  json["warnings"] = all_printed(run.summary["warnings"], warning, run.messages + "\n", count(run.messages, warning));
  json["notes"] = all_printed(run.summary["notes"], note, run.printed, count(run.printed, note));
  return json;
}

Json expected_final_state(const Run& run) {
  Json hangers = Json::array();
  for (const std::string& name : run.facts.hangers)
    hangers.push_back({{"name", name}, {"mode", "holds"}, {"plastic_stretch", 0.0}});
  return {{"schema", 2},
          {"title", run.facts.title},
          {"units", units_of(*run.facts.units)},
          {"outcome", outcome_of(run)},
          {"time", run.time(run.rows() - 1)},
          {"bodies", bodies_of(run)},
          {"cables", cables_of(run)},
          {"hangers", hangers}};
}

/// plot.json: one figure for each kind of column, without curves that are zero throughout.
Json expected_plot(const Run& run) {
  struct Kind {
    std::string name, title, axis, unit;
    std::vector<std::string> parts;  ///< of names of columns: endings, or the whole beginning if it ends with a point
  };
  const Units& units = *run.facts.units;
  const std::vector<Kind> kinds{
      {"positions", "Positions of the centres of mass", "position", units.length, {".x", ".y"}},
      {"angles", "Angles", "angle", "rad", {".angle"}},
      {"velocities", "Velocities", "velocity", units.length + "/s", {".vx", ".vy"}},
      {"spins", "Angular velocities", "angular velocity", "rad/s", {".spin"}},
      {"overlaps", "Overlaps of the contacts", "overlap", units.length, {".overlap"}},
      {"contact_forces", "Contact forces", "force", units.force, {".force"}},
      {"tensions", "Cable tensions", "tension", units.force, {".tension"}},
      {"energies", "Energies", "energy", units.energy, {"energy."}},
      {"dissipation", "Dissipated energy, by mechanism", "energy", units.energy, {"dissipated."}},
      {"energy_balance_error", "Energy balance error", "energy", units.energy, {"balance_error.energy"}}};
  Json figures = Json::array();
  for (const Kind& kind : kinds) {
    Json series = Json::array();
    for (std::size_t i = 1; i < run.history.names.size(); ++i) {
      const std::string& name = run.history.names[i];
      const bool drawn = std::ranges::any_of(
          kind.parts, [&](const std::string& part) { return name.starts_with(part) || name.ends_with(part); });
      if (!drawn || std::ranges::all_of(run.history.values[i], [](double value) { return value == 0.0; })) continue;
      series.push_back({{"label", name}, {"x", "time [s]"}, {"y", run.history.heads[i]}, {"style", "lines"}});
    }
    if (series.empty()) continue;
    figures.push_back({{"name", kind.name},
                       {"title", kind.title},
                       {"caption", fmt::format("{}: {}.", run.facts.title, kind.title)},
                       {"x", {{"label", "time"}, {"unit", "s"}, {"log", false}}},
                       {"y", {{"label", kind.axis}, {"unit", kind.unit}, {"log", false}}},
                       {"csv", "history.csv"},
                       {"series", series},
                       {"slopes", Json::array()},
                       {"lines", Json::array()}});
  }
  Json bodies = Json::array(), cables = Json::array(), histories = Json::array();
  for (std::size_t i = 0; i < run.facts.bodies.size(); ++i) {
    const Part& body = run.facts.bodies[i];
    bodies.push_back({{"name", body.name},
                      {"number", body.number > 0 ? body.number : static_cast<int>(i) + 1},
                      {"kind", body.kind}});
  }
  for (const Cable& cable : run.facts.cables)
    cables.push_back(cable.name);
  if (run.facts.mirrored) histories.push_back(run.facts.file + ".history.csv");
  histories.push_back("history.csv");
  return {
      {"schema", 1},
      {"title", run.facts.title},
      {"units", units.system},
      {"histories", histories},
      {"geometry",
       {{"index", run.facts.file + ".pvd"}, {"bodies", bodies}, {"cables", cables}, {"mirrored", run.facts.mirrored}}},
      {"figures", figures}};
}

// --- Checks of the history -------------------------------------------------------------------------------------------

/// Differences over both scenes, reduced to few checks.
struct Checks {
  Disagreements heads, states;
  WorstDifference times, kinetic, energy, elongations, tensions, overlaps, forces, geometry;
  double rate{}, rate_bound{}, tension_bound{};
  std::string rate_of;
};

void check_columns(const Run& run, Checks& checks) {
  const std::vector<std::string> names = expected_columns(run.facts);
  checks.heads.check("the number of columns", names.size() == run.history.names.size());
  for (std::size_t i = 0; i < std::min(names.size(), run.history.names.size()); ++i) {
    checks.heads.check(names[i], run.history.names[i] == names[i]);
    checks.heads.check("the unit of " + names[i], run.history.units[i] == unit_of(names[i], *run.facts.units));
  }
  for (std::size_t row = 0; row < run.rows(); ++row)
    checks.times.compare("time", run.time(row), run.facts.step * static_cast<double>(row), run.time(run.rows() - 1));
}

/// Displacements from the velocities, by the trapezoidal rule with all rows and with every other row.
void check_rates(const Run& run, Checks& checks) {
  const std::size_t last = run.rows() - 1;
  const std::vector<std::pair<std::string, std::string>> pairs{{".x", ".vx"}, {".y", ".vy"}, {".angle", ".spin"}};
  for (const Part& body : run.facts.bodies) {
    for (const auto& [position, velocity] : pairs) {
      if (!run.history.has(body.name + position)) continue;
      const std::vector<double>&x = run.history.at(body.name + position), &v = run.history.at(body.name + velocity);
      const auto integral = [&](std::size_t every) {
        double sum = 0.0;
        for (std::size_t row = every; row <= last; row += every)
          sum += 0.5 * (run.time(row) - run.time(row - every)) * (v[row] + v[row - every]);
        return sum;
      };
      double path = 0.0;
      for (std::size_t row = 1; row <= last; ++row)
        path += std::abs(x[row] - x[row - 1]);
      if (path == 0.0) continue;
      const double error = std::abs(x[last] - x[0] - integral(1)) / path;
      if (error > checks.rate) checks.rate = error, checks.rate_of = body.name + position;
      checks.rate_bound = std::max(checks.rate_bound, std::abs(integral(2) - integral(1)) / path);
    }
  }
}

void check_energies(const Run& run, Checks& checks) {
  const double scale = energy_scale(run), first = total(run, "energy", energies, 0);
  const double offset = sums_of(run, 0).gravity_scale + std::abs(first);
  for (std::size_t row = 0; row < run.rows(); ++row) {
    const Sums sums = sums_of(run, row);
    const auto energy = [&](const char* name) { return run.history.at(std::string("energy.") + name)[row]; };
    checks.kinetic.compare("energy.kinetic", energy("kinetic"), sums.kinetic, scale);
    checks.kinetic.compare("energy.gravity", energy("gravity"), sums.gravity, sums.gravity_scale);
    double applied = 0.0;
    for (const Part& body : run.facts.bodies) {
      if (body.force_x != 0.0) applied -= body.force_x * (run.of(body, ".x", row, 0.0) - run.of(body, ".x", 0, 0.0));
      if (body.moment != 0.0) applied -= body.moment * run.of(body, ".angle", row, 0.0);
    }
    checks.kinetic.compare("energy.applied", energy("applied") - run.history.at("energy.applied")[0], applied, scale);
    checks.energy.compare(fmt::format("row {}", row),
                          total(run, "energy", energies, row) - first + total(run, "dissipated", mechanisms, row) -
                              run.history.at("balance_error.energy")[row],
                          0.0, scale + offset);
  }
}

/// Elongations from positions; tensions from elongations by the law, with the largest elongation so far. Between two
/// rows the elongation exceeds both by at most an eighth of its second difference, and after it the tension is lower by
/// as much times the stiffness.
void check_cables(const Run& run, Checks& checks) {
  for (const Cable& cable : run.facts.cables) {
    const std::vector<double>& elongation = run.history.at(cable.name + ".elongation");
    const std::vector<double>& tension = run.history.at(cable.name + ".tension");
    const double scale = std::max(*std::ranges::max_element(tension), 1e-3 * std::min(cable.yield, 1e3));
    double longest = 0.0;
    bool broken = false;
    for (std::size_t row = 0; row < run.rows(); ++row) {
      const Vector a = run.place(cable.from, row), b = run.place(cable.to, row);
      const double length = size(between(a, b)), now = elongation[row];
      checks.elongations.compare(cable.name + ".elongation", now, length - cable.rest, length);
      if (row > 0 && row + 1 < run.rows() && now * cable.stiffness > cable.yield && now >= longest) {
        const double bend = std::abs(elongation[row + 1] - 2.0 * now + elongation[row - 1]);
        checks.tension_bound = std::max(checks.tension_bound, cable.stiffness * bend / 8.0 / scale);
      }
      longest = std::max(longest, now);
      broken = broken || (cable.strength < infinite && now >= elongation_at_break(cable));
      double exact = 0.0;
      if (cable.damping > 0.0 && now > 0.0) {
        const Part& body = run.facts.bodies[static_cast<std::size_t>(cable.from.body)];
        const Vector along = between(a, b);
        const double closing =
            (run.of(body, ".vx", row, 0.0) * along[0] + run.of(body, ".vy", row, 0.0) * along[1]) / length;
        exact = std::max(0.0, cable.stiffness * now - cable.damping * closing);
      } else if (!broken && now > 0.0) {
        const double yielded = std::max(0.0, longest - cable.yield / cable.stiffness);
        exact = std::max(0.0, cable.stiffness * (now - (1.0 - cable.hardening) * yielded));
      }
      checks.tensions.compare(cable.name + ".tension", tension[row], exact, scale);
    }
  }
}

/// Overlap of two bodies by geometry; a NaN where both are boxes, or the centre of a disc is in a box.
double overlap(const Run& run, const Part& a, const Part& b, std::size_t row) {
  const Vector at = run.place(a, 0.0, 0.0, row), other = run.place(b, 0.0, 0.0, row);
  if (a.shape != Shape::circle) return std::numeric_limits<double>::quiet_NaN();
  if (b.shape == Shape::circle) return a.a + b.a - std::hypot(at[0] - other[0], at[1] - other[1]);
  if (b.shape == Shape::plane) return a.a - (at[1] - other[1]);
  const double turned = run.of(b, ".angle", row, 0.0), c = std::cos(turned), s = std::sin(turned), x = at[0] - other[0],
               y = at[1] - other[1];
  const double off_x = std::max(0.0, std::abs(c * x + s * y) - b.a),
               off_y = std::max(0.0, std::abs(c * y - s * x) - b.b);
  const double distance = std::hypot(off_x, off_y);
  return distance > 0.0 ? a.a - distance : std::numeric_limits<double>::quiet_NaN();
}

void check_overlaps(const Run& run, Checks& checks) {
  for (const std::string& contact : run.facts.contacts) {
    const std::size_t dash = contact.find('-');
    const Part &a = run.body(contact.substr(0, dash)), &b = run.body(contact.substr(dash + 1));
    const std::vector<double>& overlaps = run.history.at(contact + ".overlap");
    for (std::size_t row = 0; row < run.rows(); ++row) {
      const double exact = overlap(run, a, b, row);
      if (!std::isnan(exact)) checks.overlaps.compare(contact + ".overlap", overlaps[row], exact, 1.0);
    }
  }
}

/// Forces of the laws in the yard, from overlaps and velocities in the same row.
void check_forces(const Run& run, Checks& checks) {
  const auto column = [&](const char* name) -> const std::vector<double>& { return run.history.at(name); };
  double largest = 0.0;
  for (std::size_t row = 0; row < run.rows(); ++row) {
    const double pressed = column("low-ground.overlap")[row], latched = column("high-low.overlap")[row],
                 hertz = column("side-low.overlap")[row];
    const double linear = low_stiffness * pressed - low_damping * column("low.vy")[row];
    largest = latched > 0.0 ? std::max(largest, latched) : 0.0;
    checks.forces.compare("low-ground.force", column("low-ground.force")[row],
                          pressed > 0.0 ? std::max(0.0, linear) : 0.0, 100.0);
    checks.forces.compare("high-low.force", column("high-low.force")[row],
                          std::max(0.0, loading * largest - unloading * (largest - latched)), 100.0);
    checks.forces.compare("side-low.force", column("side-low.force")[row],
                          hertz > 0.0 ? 4.0 / 3.0 * modulus * std::sqrt(hertz_radius) * std::pow(hertz, 1.5) : 0.0,
                          100.0);
  }
}

// --- States of the geometry ------------------------------------------------------------------------------------------

/// Numbers of the data array NAME after the first occurrence of `section`.
std::vector<double> array_in(const std::string& text, const std::string& section, const std::string& name) {
  return data_array(text.substr(std::min(text.find("<" + section + ">"), text.size())), name);
}

/// The outline of a body in its axes: 96 points of a circle and the first again, corners of a box and the first again,
/// the ends of a plane.
std::vector<std::array<double, 2>> outline_of(const Part& body, double reach) {
  std::vector<std::array<double, 2>> points;
  if (body.shape == Shape::plane) return {{-reach, 0.0}, {reach, 0.0}};
  if (body.shape == Shape::box) {
    points = {{body.a, body.b}, {-body.a, body.b}, {-body.a, -body.b}, {body.a, -body.b}};
  } else if (body.shape == Shape::circle) {
    for (int i = 0; i < 96; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / 96.0;
      points.push_back({body.a * std::cos(angle), body.a * std::sin(angle)});
    }
  }
  if (!points.empty()) points.push_back(points.front());
  return points;
}

void check_states(const Run& run, Checks& checks, const Setup& setup) {
  const Facts& facts = run.facts;
  double reach = 0.0;
  for (const Part& body : facts.bodies)
    reach = std::max({reach, std::abs(run.of(body, ".x", 0, body.x)), std::abs(run.of(body, ".y", 0, body.y))});
  checks.states.check("the number of states",
                      run.states.size() == static_cast<std::size_t>(facts.steps / facts.steps_a_state) + 1);
  for (std::size_t n = 0; n < run.states.size(); ++n) {
    const std::string& text = run.states[n].text;
    std::size_t row = n * static_cast<std::size_t>(facts.steps_a_state);
    checks.states.check("time", run.states[n].time == run.time(std::min(row, run.rows() - 1)));
    if (setup.has("state_one_late")) row = std::min(row + 1, run.rows() - 1);
    const auto expect_numbers = [&](const char* section, const char* name, const std::vector<double>& exact) {
      const std::vector<double> found = array_in(text, section, name);
      checks.states.check(fmt::format("{} of {}", name, section), found == exact);
    };
    std::vector<double> points, point_body, offsets, body_of, cable_of, tension, slacks, connectivity;
    const auto add = [&](const Vector& point, double body) {
      points.insert(points.end(), point.begin(), point.end()), point_body.push_back(body);
    };
    const auto end_line = [&](double body, double cable, double pull, double is_slack) {
      offsets.push_back(static_cast<double>(point_body.size())), body_of.push_back(body), cable_of.push_back(cable);
      tension.push_back(pull), slacks.push_back(is_slack);
    };
    for (std::size_t i = 0; i < facts.bodies.size(); ++i) {
      const auto outline = outline_of(facts.bodies[i], 2.0 * reach);
      for (const auto& [u, v] : outline)
        add(run.place(facts.bodies[i], u, v, row), static_cast<double>(i));
      if (!outline.empty()) end_line(static_cast<double>(i), -1.0, 0.0, 0.0);
    }
    for (std::size_t c = 0; c < facts.cables.size(); ++c) {
      const Cable& cable = facts.cables[c];
      for (const End& end : {cable.from, cable.to})
        add(run.place(end, row), end.body);
      const double pull = run.history.at(cable.name + ".tension")[row];
      end_line(-1.0, static_cast<double>(c), pull, pull == 0.0 ? 1.0 : 0.0);
    }
    for (std::size_t i = 0; i < point_body.size(); ++i)
      connectivity.push_back(static_cast<double>(i));
    expect_numbers("PointData", "body", point_body), expect_numbers("CellData", "body", body_of);
    expect_numbers("CellData", "cable", cable_of), expect_numbers("CellData", "tension", tension);
    expect_numbers("CellData", "slack", slacks), expect_numbers("Lines", "connectivity", connectivity);
    expect_numbers("Lines", "offsets", offsets);
    const std::vector<double> found = data_array(text, "Points");
    checks.states.check("Points", found.size() == points.size());
    for (std::size_t i = 0; i < std::min(found.size(), points.size()); ++i)
      checks.geometry.compare(fmt::format("point {} of state {}", i / 3, n), found[i], points[i], fence_span);
  }
}

// --- Files of a fence ------------------------------------------------------------------------------------------------

/// A force over all rows: its largest size, and its impulse by the trapezoidal rule.
struct Force {
  std::vector<Vector> values;

  [[nodiscard]] std::size_t peak_row() const {
    const auto found = std::ranges::max_element(values, {}, [](const Vector& v) { return size(v); });
    return static_cast<std::size_t>(found - values.begin());
  }
  [[nodiscard]] Json json(const Run& run, const Json& found) const {
    const double newton = run.facts.units->newton, peak = newton * size(values[peak_row()]);
    Json at_peak = Json::array(), impulse = Json::array();
    for (std::size_t i = 0; i < 3; ++i) {
      double sum = 0.0;
      for (std::size_t row = 1; row < values.size(); ++row)
        sum += 0.5 * (values[row][i] + values[row - 1][i]) * (run.time(row) - run.time(row - 1));
      at_peak.push_back(scaled(newton * values[peak_row()][i], peak));
      impulse.push_back(scaled(newton * sum, peak * run.time(run.rows() - 1)));
    }
    // Rounding errors decide which row has the largest of forces that are equal to within a few of them.
    const double at = found.value("peak_time", -1.0);
    double time = run.time(peak_row());
    for (std::size_t row = 0; row < values.size(); ++row)
      if (run.time(row) == at && newton * size(values[row]) > (1.0 - 1e-12) * peak) time = at;
    return {{"peak", peak}, {"peak_time", time}, {"at_peak", at_peak}, {"impulse", impulse}};
  }
};

/// Sum of the tensions of the top cables at a point of a column or at an anchor, each towards its other end [force].
Force pull_at(const Run& run, const Vector& start, int body) {
  Force force{.values = std::vector<Vector>(run.rows(), Vector{})};
  for (const Cable& cable : run.facts.cables) {
    for (const auto& [here, there] : {std::pair{cable.from, cable.to}, std::pair{cable.to, cable.from}}) {
      const bool is_anchor = body < 0 && here.body < 0 && here.x == start[0];
      if (!cable.top || (!is_anchor && (body < 0 || here.body != body))) continue;
      for (std::size_t row = 0; row < run.rows(); ++row) {
        const Vector along = between(run.place(here, row), run.place(there, row));
        const double pull = run.history.at(cable.name + ".tension")[row] / size(along);
        for (std::size_t i = 0; i < 3; ++i)
          force.values[row][i] += pull * along[i];
      }
    }
  }
  return force;
}

/// The pull on a column's top joint in its plane; the central column is also pulled by the mirror images of its cables.
Force hanger_force(const Run& run, int body) {
  const Part& column = run.facts.bodies[static_cast<std::size_t>(body)];
  Force force = pull_at(run, {}, body);
  for (Vector& value : force.values) {
    for (double& component : value)
      component *= column.along == 0.0 ? 2.0 : 1.0;
    value[2] = 0.0;
  }
  return force;
}

struct Passage {
  std::string name, verdict{};
  double mass{};
  std::size_t touch{}, exit{}, stop{};  ///< rows
  double vx{}, vy{}, spin{};            ///< of the approach
  double approach{}, exit_energy{}, end_energy{}, travel{};
  bool separated{}, turned{};
};

/// A rock touches the fence in the rows in which it overlaps a column or presses it.
Passage passage_of(const Run& run, std::size_t r) {
  const Part& rock = run.facts.bodies[r + 1];
  const auto column = [&](const char* quantity) -> const std::vector<double>& {
    return run.history.at(rock.name + quantity);
  };
  const std::size_t last = run.rows() - 1;
  const auto energy = [&](double vx, double vy, double spin) {
    return 0.5 * (rock.mass * (vx * vx + vy * vy) + rock.inertia * spin * spin);
  };
  const auto energy_at = [&](std::size_t row) {
    return energy(column(".vx")[row], column(".vy")[row], column(".spin")[row]);
  };
  Passage found{.name = rock.name, .mass = rock.mass};
  found.touch = last + 1;
  for (std::size_t row = 0; row <= last; ++row) {
    double most = 0.0;
    for (const char* with : {"-column1", "-back_column1"})
      for (const char* quantity : {".overlap", ".force"})
        most = std::max(most, run.history.at(rock.name + with + quantity)[row]);
    if (most > 0.0) found.touch = std::min(found.touch, row), found.exit = std::min(row + 1, last);
    found.separated = !(most > 0.0);
  }
  if (found.touch > last) throw std::runtime_error(rock.name + " does not touch the fence");
  found.vx = rocks[r].speed, found.spin = rocks[r].spin;
  if (found.touch > 0) {
    const std::size_t before = found.touch - 1;
    found.vx = column(".vx")[before], found.vy = column(".vy")[before], found.spin = column(".spin")[before];
  }
  found.approach = energy(found.vx, found.vy, found.spin);
  found.exit_energy = energy_at(found.exit), found.end_energy = energy_at(last);
  found.stop = found.exit;
  for (std::size_t row = found.touch; row <= found.exit; ++row) {
    found.travel = std::max(found.travel, column(".x")[found.touch] - column(".x")[row]);
    if (!found.turned && column(".vx")[row] >= 0.0) found.turned = true, found.stop = row;
  }
  found.verdict = column(".vx")[last] >= 0.0 ? "stopped" : "undecided";
  return found;
}

Json vector_of(double x, double y, double scale) { return {scaled(x, scale), scaled(y, scale)}; }

/// The largest tension of a cable with its row and its ratio to the yield force.
struct Peak {
  std::string name;
  double force{}, time{}, limit{};
};
Json json_of(const Peak& peak) {
  Json json{{"name", peak.name}, {"peak", peak.force}, {"time", peak.time}, {"margin", nullptr}};
  if (peak.limit > 0.0) json["margin"] = peak.force / peak.limit;
  return json;
}
Peak largest(const std::vector<Peak>& peaks, bool over_limit) {
  return *std::ranges::max_element(peaks, {}, [&](const Peak& p) { return over_limit ? p.force / p.limit : p.force; });
}

Peak peak_of(const Run& run, const Cable& cable) {
  const std::vector<double>& tension = run.history.at(cable.name + ".tension");
  const auto at = std::ranges::max_element(tension);
  return {cable.name, *at, run.time(static_cast<std::size_t>(at - tension.begin())), cable.yield};
}

/// The verdict in summary.json, in the scene's units.
Json expected_verdict(const Run& run) {
  Json list = Json::array();
  std::string worst = "stopped";
  for (std::size_t r = 0; r < rocks.size(); ++r) {
    const Passage rock = passage_of(run, r);
    if (rock.verdict == "undecided") worst = rock.verdict;
    const auto velocity = [&](std::size_t row) {
      return vector_of(run.history.at(rock.name + ".vx")[row], run.history.at(rock.name + ".vy")[row], 10.0);
    };
    list.push_back({{"name", rock.name},
                    {"verdict", rock.verdict},
                    {"passed_time", 0.0},
                    {"touched", true},
                    {"last_contact_time", run.time(rock.exit)},
                    {"still_touching", !rock.separated},
                    {"approach_energy", rock.approach},
                    {"velocity_after", rock.separated ? velocity(rock.exit) : Json(nullptr)},
                    {"energy_after", rock.separated ? Json(rock.exit_energy) : Json(nullptr)},
                    {"velocity_at_end", velocity(run.rows() - 1)},
                    {"energy_at_end", rock.end_energy}});
  }
  std::vector<Peak> cables, hangers, anchors;
  for (const Cable& cable : run.facts.cables) {
    cables.push_back(peak_of(run, cable));
    if (cable.to.body >= 0) continue;
    const Force force = pull_at(run, {cable.to.x, 0.0, 0.0}, -1);
    anchors.push_back({"anchor", size(force.values[force.peak_row()]), run.time(force.peak_row()), 0.0});
  }
  for (std::size_t i = 0; i < run.facts.bodies.size(); ++i) {
    if (run.facts.bodies[i].layer == 0) continue;
    const Force force = hanger_force(run, static_cast<int>(i));
    hangers.push_back(
        {run.facts.bodies[i].name, size(force.values[force.peak_row()]), run.time(force.peak_row()), hanger_strength});
  }
  return {{"fence", worst},
          {"rocks", list},
          {"largest_anchor_force", json_of(largest(anchors, false))},
          {"largest_cable_force", json_of(largest(cables, false))},
          {"cable_closest_to_limit", json_of(largest(cables, true))},
          {"largest_hanger_force", json_of(largest(hangers, false))},
          {"hanger_closest_to_limit", json_of(largest(hangers, true))}};
}

/// One of the three states drawn in the sheet [m].
Json drawn(const Run& run, const char* name, std::size_t row) {
  const double metre = run.facts.units->metre;
  Json bodies = Json::array(), cables = Json::array();
  for (const Part& body : run.facts.bodies) {
    if (body.shape == Shape::plane) continue;
    Json points = Json::array();
    for (const auto& [u, v] : outline_of(body, 0.0)) {
      const Vector at = run.place(body, u, v, row);
      points.push_back({scaled(metre * at[0], 1.0), scaled(metre * at[1], 1.0)});
    }
    bodies.push_back({{"name", body.name}, {"layer", body.layer}, {"outline", points}});
  }
  for (const Cable& cable : run.facts.cables) {
    Json ends = Json::array();
    for (const End& end : {cable.from, cable.to}) {
      const Vector at = run.place(end, row);
      ends.push_back({scaled(metre * at[0], 1.0), scaled(metre * at[1], 1.0), scaled(metre * at[2], 1.0)});
    }
    cables.push_back({{"layer", cable.layer}, {"cable", cable.top ? "top" : "bottom"}, {"ends", ends}});
  }
  return {{"name", name}, {"time", run.time(row)}, {"bodies", bodies}, {"cables", cables}};
}

/// Height of a layer's lowest top joint or highest bottom joint above the ground [m].
Json height_of(const Run& run, int layer, bool top, const Json& found) {
  std::vector<double> heights;
  for (std::size_t row = 0; row < run.rows(); ++row) {
    double extreme = top ? infinite : -infinite;
    for (const Part& body : run.facts.bodies) {
      if (body.layer != layer) continue;
      const double height = run.place(body, 0.0, top ? y_top : y_bottom, row)[1] - ground_top;
      extreme = top ? std::min(extreme, height) : std::max(extreme, height);
    }
    heights.push_back(run.facts.units->metre * extreme);
  }
  const auto at = top ? std::ranges::min_element(heights) : std::ranges::max_element(heights);
  double time = run.time(static_cast<std::size_t>(at - heights.begin()));
  // As for the largest force.
  for (std::size_t row = 0; row < heights.size(); ++row)
    if (run.time(row) == found["extreme_time"].get<double>() && std::abs(heights[row] - *at) < 1e-12)
      time = run.time(row);
  return {{"start", heights.front()}, {"extreme", *at}, {"extreme_time", time}, {"end", heights.back()}};
}

/// sheet.json in SI, from the scene, the history and summary.json.
Json expected_sheet(const Run& run, const Json& found, const Setup& setup) {
  const Facts& facts = run.facts;
  const Units& units = *facts.units;
  const double metre = setup.has("survey_foot") ? 1200.0 / 3937.0 : units.metre, newton = units.newton,
               joule = units.joule();
  const std::size_t last = run.rows() - 1;
  Json passages = Json::array();
  for (std::size_t r = 0; r < rocks.size(); ++r) {
    const Passage rock = passage_of(run, r);
    const auto velocity = [&](std::size_t row) {
      return vector_of(metre * run.history.at(rock.name + ".vx")[row], metre * run.history.at(rock.name + ".vy")[row],
                       10.0);
    };
    passages.push_back({{"name", rock.name},
                        {"mass", units.kilogram() * rock.mass},
                        {"approach_velocity", vector_of(metre * rock.vx, metre * rock.vy, 10.0)},
                        {"approach_spin", rock.spin},
                        {"approach_energy", joule * rock.approach},
                        {"touched", true},
                        {"verdict", rock.verdict},
                        {"passed_time", 0.0},
                        {"end_velocity", velocity(last)},
                        {"end_energy", joule * rock.end_energy},
                        {"touch_time", run.time(rock.touch)},
                        {"separated", rock.separated},
                        {"exit_time", run.time(rock.exit)},
                        {"exit_velocity", velocity(rock.exit)},
                        {"exit_spin", run.history.at(rock.name + ".spin")[rock.exit]},
                        {"exit_energy", joule * rock.exit_energy},
                        {"energy_loss_fraction", 1.0 - rock.exit_energy / rock.approach},
                        {"turned", rock.turned},
                        {"braking_time", run.time(rock.stop) - run.time(rock.touch)},
                        {"travel", scaled(metre * rock.travel, 1.0)}});
  }
  Json layers = Json::array(), columns = Json::array(), segments = Json::array(), anchors = Json::array();
  for (const int layer : {1, 2}) {
    const Json& known = found["layers"][static_cast<std::size_t>(layer - 1)];
    layers.push_back({{"top", height_of(run, layer, true, known["top"])},
                      {"bottom", height_of(run, layer, false, known["bottom"])}});
  }
  double travel = 0.0;
  std::size_t travel_row = 0;
  std::vector<Force> hangers;
  for (std::size_t i = 0; i < facts.bodies.size(); ++i) {
    const Part& body = facts.bodies[i];
    if (body.layer == 0) continue;
    std::vector<double> away;
    for (const double x : run.history.at(body.name + ".x"))
      away.push_back(std::abs(x - run.history.at(body.name + ".x").front()));
    const auto row = static_cast<std::size_t>(std::ranges::max_element(away) - away.begin());
    if (away[row] > travel) travel = away[row], travel_row = row;
    hangers.push_back(hanger_force(run, static_cast<int>(i)));
    const Json& known = found["columns"][columns.size()]["hanger"];
    const Json hanger = hangers.back().json(run, known);
    columns.push_back({{"name", body.name},
                       {"layer", body.layer},
                       {"along", metre * body.along},
                       {"travel", scaled(metre * away[row], 1.0)},
                       {"travel_time", run.time(row)},
                       {"limit", newton * hanger_strength},
                       {"margin", hanger["peak"].get<double>() / (newton * hanger_strength)},
                       {"hanger", hanger}});
  }
  for (const Cable& cable : facts.cables) {
    const std::vector<double>& tension = run.history.at(cable.name + ".tension");
    const Peak peak = peak_of(run, cable);
    double impulse = 0.0;
    for (std::size_t row = 1; row <= last; ++row)
      impulse += 0.5 * (tension[row] + tension[row - 1]) * (run.time(row) - run.time(row - 1));
    segments.push_back({{"name", cable.name},
                        {"layer", cable.layer},
                        {"cable", cable.top ? "top" : "bottom"},
                        {"peak", newton * peak.force},
                        {"peak_time", peak.time},
                        {"impulse", newton * impulse},
                        {"limit", newton * cable.yield},
                        {"margin", peak.force / cable.yield}});
    if (cable.to.body >= 0) continue;
    const Json& known = found["anchors"][anchors.size()]["force"];
    anchors.push_back({{"layer", cable.layer},
                       {"position", {metre * cable.to.x, metre * cable.to.y, metre * cable.to.along}},
                       {"force", pull_at(run, {cable.to.x, 0.0, 0.0}, -1).json(run, known)}});
  }
  const auto energies_at = [&](std::size_t row) {
    Json json;
    for (const std::string& part : energies)
      json[part] = joule * run.history.at("energy." + part)[row];
    return json;
  };
  Json dissipated;
  for (const std::string& part : mechanisms)
    dissipated[part] = joule * run.history.at("dissipated." + part)[last];
  Json names{"time"}, rows = Json::array();
  for (const char* rock : {"rock1", "rock2"})
    for (const char* quantity : {".x", ".y", ".vx"})
      names.push_back(std::string(rock) + quantity);
  for (const char* force : {"hanger", "top", "bottom"})
    names.push_back(force);
  for (std::size_t row = 0; row <= last; ++row) {
    Json numbers{run.time(row)};
    for (const char* rock : {"rock1", "rock2"})
      for (const char* quantity : {".x", ".y", ".vx"})
        numbers.push_back(metre * run.history.at(std::string(rock) + quantity)[row]);
    double hanger = 0.0, top = 0.0, bottom = 0.0;
    for (const Force& force : hangers)
      hanger = std::max(hanger, size(force.values[row]));
    for (const Cable& cable : facts.cables) {
      double& most = cable.top ? top : bottom;
      most = std::max(most, run.history.at(cable.name + ".tension")[row]);
    }
    for (const double force : {hanger, top, bottom})
      numbers.push_back(newton * force);
    rows.push_back(numbers);
  }
  const double reach = metre * 100.0 * fence_span;
  return {{"schema", 3},
          {"title", facts.title},
          {"units", "SI"},
          {"verdict", expected_verdict(run)["fence"]},
          {"quality", run.summary["quality"]},
          {"run",
           {{"outcome", "finished"},
            {"time", facts.steps * facts.step},
            {"integrator", facts.integrator},
            {"step", facts.step},
            {"steps", facts.steps}}},
          {"fence",
           {{"layers", 2},
            {"columns", 2 * columns_of_half - 1},
            {"half_model", true},
            {"span", metre * fence_span},
            {"sag", metre * sag},
            {"spacing", metre * spacing},
            {"bottom_cable", true},
            {"scene_units", units.system},
            {"travel", scaled(metre * travel, 1.0)},
            {"travel_time", run.time(travel_row)}}},
          {"rocks", passages},
          {"layers", layers},
          {"columns", columns},
          {"segments", segments},
          {"anchors", anchors},
          {"events", run.summary["failures"]},
          {"energy",
           {{"start", energies_at(0)},
            {"end", energies_at(last)},
            {"dissipated", dissipated},
            {"balance_error", joule * run.history.at("balance_error.energy")[last]},
            {"scale", joule * energy_scale(run)}}},
          {"drawing",
           {{"ground", {{-reach, metre * ground_top}, {reach, metre * ground_top}}},
            {"column_half_width", metre * column_a},
            {"states", {drawn(run, "start", 0), drawn(run, "largest travel", travel_row), drawn(run, "end", last)}}}},
          {"history", {{"columns", names}, {"rows", rows}}}};
}

/// NAME.history.json: numbers from the scene and history.csv, titles of the manual of 1993.
Json expected_codes(const Run& run, const std::string& csv) {
  struct Code {
    int number;
    const char *name, *title;
    std::string unit;
  };
  const Units& units = *run.facts.units;
  const std::vector<Code> codes{
      {15, "mass", "ELEMENT MASS", units.mass},
      {16, "inertia", "ELEMENT MASS MOMENT OF INERTIA", units.mass + " " + units.length + "^2"},
      {35, "kinetic_translation", "ELEMENT KINETIC ENERGY (TRANSLATIONAL)", units.energy},
      {36, "kinetic_rotation", "ELEMENT KINETIC ENERGY (ROTATIONAL)", units.energy},
      {37, "kinetic", "ELEMENT KINETIC ENERGY (TOTAL)", units.energy},
      {38, "gravitational", "ELEMENT GRAVITATIONAL ENERGY", units.energy},
      {48, "top_tension", "TENSION IN TOP CABLE", units.force},
      {51, "top_joint_force", "FORCE IN TOP JOINT OF ATTENUATOR", units.force}};
  Json columns = Json::array();
  columns.push_back({{"name", "time"}, {"unit", "s"}, {"values", run.history.values[0]}});
  for (std::size_t i = 1; i < run.facts.bodies.size(); ++i) {
    const Part& body = run.facts.bodies[i];
    const Force hanger = body.layer > 0 ? hanger_force(run, static_cast<int>(i)) : Force{};
    const auto top = std::ranges::find_if(
        run.facts.cables, [&](const Cable& cable) { return cable.top && cable.from.body == static_cast<int>(i); });
    for (const Code& code : codes) {
      if (code.number >= 48 && body.layer == 0) continue;
      Json values = Json::array();
      for (std::size_t row = 0; row < run.rows(); ++row) {
        const double vx = run.of(body, ".vx", row, 0.0), vy = run.of(body, ".vy", row, 0.0),
                     spin = run.of(body, ".spin", row, 0.0);
        const double along = 0.5 * body.mass * (vx * vx + vy * vy), about = 0.5 * body.inertia * spin * spin,
                     weight = body.mass * run.facts.gravity;
        values.push_back(code.number == 15   ? Json(body.mass)
                         : code.number == 16 ? Json(body.inertia)
                         : code.number == 35 ? Json(along)
                         : code.number == 36 ? Json(about)
                         : code.number == 37 ? Json(along + about)
                         : code.number == 38 ? scaled(weight * run.of(body, ".y", row, 0.0), weight)
                         : code.number == 48 ? Json(run.history.at(top->name + ".tension")[row])
                                             : scaled(size(hanger.values[row]), 1e3));
      }
      columns.push_back({{"name", fmt::format("element{}.{}", body.number, code.name)},
                         {"element", body.number},
                         {"code", code.number},
                         {"title", code.title},
                         {"unit", code.unit},
                         {"values", values}});
    }
  }
  // The comments at the head of the CSV file say what is skipped; the program prints it, too.
  Json skipped = Json::array();
  for (std::size_t at = 0; csv.compare(at, 2, "# ") == 0; at = csv.find('\n', at) + 1)
    skipped.push_back(csv.substr(at + 2, csv.find('\n', at) - at - 2));
  return {
      {"schema", 1}, {"title", run.facts.title}, {"units", units.system}, {"skipped", skipped}, {"columns", columns}};
}

/// NAME.history.csv, as a document like NAME.history.json.
void check_codes(const TemporaryFolder& folder, const Run& run, Findings& findings) {
  const std::string csv = folder.read("fence/fence.history.csv");
  const Json codes = records::read_json(folder.path() / "fence/fence.history.json");
  ComparedDocument("fence.history.json", codes, expected_codes(run, csv))
      .expect(findings, 1e-14,
              "about ten roundings of 1.1e-16; kinetic energies are squares of velocities, and a force is a sum of two "
              "tensions in other directions");
  const Columns table{records::read_csv(folder.path() / "fence/fence.history.csv")};
  Disagreements different;
  different.check("the number of columns", table.names.size() == codes["columns"].size());
  for (std::size_t i = 0; i < std::min(table.names.size(), codes["columns"].size()); ++i) {
    const Json& column = codes["columns"][i];
    different.check(table.names[i], table.names[i] == column["name"].get<std::string>() &&
                                        table.units[i] == column["unit"].get<std::string>() &&
                                        table.values[i] == column["values"].get<std::vector<double>>());
  }
  different.expect(findings, "fence.history.csv: columns that differ from fence.history.json",
                   "names, units and all digits agree");
}

/// What the summary says of the repeated run: the same fence, run here with the faster rocks. Stiffness is proportional
/// to the square of speed over overlap, so that overlaps are larger by the same factor.
Json repeat_of(const TemporaryFolder& folder, const Run& run, Findings& findings) {
  Facts faster = fence();
  faster.file = "faster";
  for (const Rock& rock : rocks) {
    replace(faster.text, fmt::format("velocity = [\"{} ft/s\"", rock.speed),
            fmt::format("velocity = [\"{} ft/s\"", 1.001 * rock.speed));
    replace(faster.text, fmt::format("spin = \"{} rad/s\"", rock.spin),
            fmt::format("spin = \"{} rad/s\"", 1.001 * rock.spin));
  }
  replace(faster.text, "layer_overlap = \"0.5 ft\"", fmt::format("layer_overlap = \"{} ft\"", 1.001 * 0.5));
  replace(faster.text, "rock_overlap = \"0.6 ft\"", fmt::format("rock_overlap = \"{} ft\"", 1.001 * 0.6));
  replace(faster.text, "penetration = 0.05", fmt::format("penetration = {}", 1.001 * 0.05));
  const Run again = run_of(folder, faster, {});
  const auto peak = [](const Run& of) { return of.summary["verdict"]["largest_cable_force"]["peak"].get<double>(); };
  const double found = run.summary["quality"]["repeat"]["change_of_largest_cable_force"];
  findings.expect(
      "fence/summary.json: change of the largest cable force with faster rocks", found, peak(again) / peak(run) - 1.0,
      Tolerance::round_off(1e-9,
                           "the method's tolerance is 1e-10, relative to the largest displacement and speed, "
                           "and the speeds and overlaps given here are rounded otherwise than in the "
                           "repeated run; ten times that"));
  return {{"change_of_speed", 0.001},
          {"failure", ""},
          {"verdict", again.summary["verdict"]["fence"]},
          {"change_of_largest_cable_force", found}};
}

/// A fence with steps that are too long: the summary says so, and what `--integrator auto` gives, which is run here.
void check_repair(const TemporaryFolder& folder, Findings& findings) {
  std::string text = fence_text;
  replace(text, "steps = 400", "steps = 40"), replace(text, "step_factor = 1\n", "step_factor = 10\n");
  replace(text, "print_every = 50", "print_every = 5");
  replace(text, "integrator = \"auto\"", "integrator = \"velocity_verlet\"");
  folder.write("coarse.toml", text);
  const ProgramEnd end = run_talus(folder, {"run", "coarse.toml", "--out", "coarse"});
  (void)run_talus(folder, {"run", "coarse.toml", "--out", "repaired", "--integrator", "auto"});
  const Json summary = records::read_json(folder.path() / "coarse/summary.json"),
             repaired = records::read_json(folder.path() / "repaired/summary.json");
  const Json& ledger = summary["ledger"];
  const double balance = ledger["largest_energy_balance_error"].get<double>() / ledger["energy_scale"].get<double>();
  const std::string flaw = fmt::format("the energy balance is off by {:.3g} % of the largest energy", 100.0 * balance);
  Json expected = summary["quality"];
  expected["usable"] = false, expected["enforced"] = true, expected["energy_balance"] = balance;
  expected["flaw"] = flaw;
  expected["repair"] = {{"option", "--integrator auto"},
                        {"flaw", repaired["quality"]["flaw"]},
                        {"verdict", repaired["verdict"]["fence"]},
                        {"energy_balance", repaired["quality"]["energy_balance"]}};
  const std::string step = summary["quality"]["step"];
  if (end.output.find(" " + step + "; ") == std::string::npos) expected["step"] = "as printed";
  ComparedDocument("summary.json of a step too long", summary["quality"], expected)
      .expect(findings, 1e-15, "the same numbers divided");
  findings.expect("summary.json of a step too long: exit code", end.exit_code, 7,
                  Tolerance::exact("the results are not usable"));
}

// --- The case --------------------------------------------------------------------------------------------------------

void expect_history(const Checks& checks, Findings& findings) {
  checks.heads.expect(findings, "history.csv: heads that differ",
                      "columns of bodies, contacts, cables and the energy balance, with the units of the scene");
  checks.times.expect(findings, "history.csv: times of the rows over the duration, largest error", 1e-13,
                      "n additions of the step, each rounded by 1.1e-16 of the duration");
  findings.expect("history.csv: displacements from the velocities over the distance travelled, largest error",
                  checks.rate, 0.0,
                  Tolerance::truncation(checks.rate_bound, 1.0,
                                        fmt::format("trapezoidal rule with a row for each step: with every other row "
                                                    "the error is four times as large, so that both results differ by "
                                                    "three times the error. The largest is of {}",
                                                    checks.rate_of)));
  checks.kinetic.expect(findings, "history.csv: energies from positions and velocities, largest error", 1e-14,
                        "sums of at most eight bodies with five roundings each, 1.1e-16 of the sum of their sizes");
  checks.energy.expect(findings, "history.csv: sum of all energies less the balance error, largest error", 1e-14,
                       "fourteen summands, each rounded by 1.1e-16 of the largest");
  checks.elongations.expect(findings, "history.csv: elongations from positions over the length, largest error", 1e-13,
                            "twenty roundings of a position, 1.1e-16 each, at most three times the length");
  findings.expect("history.csv: tensions from elongations, over the largest, largest error", checks.tensions.worst(),
                  0.0,
                  Tolerance::truncation(checks.tension_bound, 1.0,
                                        fmt::format("between two rows the elongation exceeds both by at most an eighth "
                                                    "of its second difference. The largest is of {}",
                                                    checks.tensions.item())));
  checks.overlaps.expect(findings, "history.csv: overlaps from positions, largest error", 1e-14,
                         "twenty roundings of lengths up to 5, 1.1e-16 each");
  checks.forces.expect(findings, "history.csv: contact forces from overlaps and velocities, largest error", 1e-14,
                       "ten roundings of 1.1e-16 in forces that are relative to 100 N");
  checks.states.expect(findings, "geometry: arrays that differ",
                       "bodies, cables, connectivity, offsets and slack are integers; times and tensions have the "
                       "digits of the history");
  checks.geometry.expect(findings, "geometry: points over the span, largest error", 1e-14,
                         "twenty roundings of 1.1e-16");
}

void run(Findings& findings, const Setup& setup) {
  const auto group = findings.in("files");
  const TemporaryFolder folder;
  Checks checks;
  Facts of_fence = fence();
  Facts of_yard = yard();
  if (setup.has("faster_rock")) replace(of_fence.text, "-65 ft/s", "-65.01 ft/s");
  if (setup.has("later_yield")) replace(of_fence.text, "\"20000 lbf\"", "\"20001 lbf\"");
  if (setup.has("harder_bed")) replace(of_yard.text, "2000 N/m", "2000.001 N/m");
  if (setup.has("larger_rock")) replace(of_fence.text, "b = \"1.1 ft\"", "b = \"1.1001 ft\"");
  std::vector<Run> runs;
  runs.push_back(run_of(folder, of_yard, {"--frames", "10"}));
  const bool sheet_is_needed = setup.needs("sheet.json");
  runs.push_back(
      run_of(folder, of_fence, sheet_is_needed ? std::vector<std::string>{"--sheet"} : std::vector<std::string>{}));
  for (const Run& one : runs) {
    findings.count(one.summary["evaluations"].get<long>());
    check_columns(one, checks), check_rates(one, checks), check_energies(one, checks);
    check_cables(one, checks), check_overlaps(one, checks), check_states(one, checks, setup);
  }
  check_forces(runs[0], checks);
  expect_history(checks, findings);
  for (const Run& one : runs) {
    Json summary = expected_summary(one);
    if (one.facts.mirrored) {
      summary["verdict"] = expected_verdict(one);
      summary["integrator_reason"] = as_printed(one.summary["integrator_reason"], "chosen, as ", one.printed);
      summary["quality"]["repeat"] = setup.needs("faster rocks") || setup.needs("summary.json: members")
                                         ? repeat_of(folder, one, findings)
                                         : one.summary["quality"]["repeat"];
      summary["events"] = printed_number(one.printed, "events located ");
    }
    const std::string of = one.facts.file + "/";
    ComparedDocument(of + "summary.json", one.summary, summary)
        .expect(findings, 1e-14,
                "numbers of the history are copied; sums have at most thirty roundings of 1.1e-16 of their summands");
    ComparedDocument(of + "final_state.json", one.state, expected_final_state(one))
        .expect(findings, 1e-12,
                "a plastic stretch is 49 times the difference of two tensions, over the stiffness: twenty roundings of "
                "1.1e-16 of 20,000 lbf, over a difference of at least 250 lbf");
    ComparedDocument(of + "plot.json", one.plot, expected_plot(one)).expect(findings, 0.0, "all numbers are integers");
  }
  if (sheet_is_needed) {
    const Json sheet = records::read_json(folder.path() / "fence/sheet.json");
    ComparedDocument("sheet.json", sheet, expected_sheet(runs[1], sheet, setup))
        .expect(findings, 1e-14,
                "about ten roundings between feet and metres, 1.1e-16 each, and as many of positions and forces; four "
                "times that as a walk for the sums of 400 terms");
  }
  check_codes(folder, runs[1], findings);
  if (setup.needs("step too long")) check_repair(folder, findings);
}

}  // namespace

Case definition() {
  return {
      .id = "agreeing_files",
      .title = "Agreement of all files of a run",
      .requirements = {{"G9", {"files"}}},
      .main_checks = {"sheet.json: numbers, largest error", "fence/summary.json: numbers, largest error"},
      .source = "Textbook mechanics; Mustoe & Huttelmaier 1993 (fence)",
      .faults = {{"faster_rock", "a rock of 65.01 ft/s", "sheet.json: numbers, largest error"},
                 {"later_yield", "a cable that yields at 20,001 lbf", "fence/final_state.json: numbers, largest error"},
                 {"harder_bed", "a contact of 2000.001 N/m",
                  "history.csv: contact forces from overlaps and velocities, largest error"},
                 {"larger_rock", "a rock with a half-axis of 1.1001 ft",
                  "history.csv: overlaps from positions, largest error"},
                 {"state_one_late", "states of the geometry compared with the next row",
                  "geometry: points over the span, largest error"},
                 {"survey_foot", "lengths converted by the survey foot, 1200/3937 m",
                  "sheet.json: numbers, largest error"}},
      .seconds = 3.0,
      .run = run};
}

}  // namespace talus::verification::problems::agreeing_files
