#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "verification/check/case.hpp"
#include "verification/problems/program/scenes/moving_scene.hpp"
#include "verification/problems/program/scenes/refused_scenes.hpp"
#include "verification/record/csv.hpp"
#include "verification/record/json_node.hpp"
#include "verification/reference/impacts/restitution.hpp"
#include "verification/study/findings/expectations.hpp"
#include "verification/study/program/program_run.hpp"

namespace talus::verification::problems::scene_fields {
namespace {

using records::Json;
using records::Node;
using reference::EndRule;

/// Bodies placed with overlaps, and two cables across the plane: the first row of the history follows from geometry.
const std::string placed = R"(title = "Bodies placed with overlaps"
units = "SI"
gravity = ["1.5 m/s^2", "-9.81 m/s^2"]
[[body]]
name = "ground"
mobility = "fixed"
position = ["0 m", "0.02 m"]
shape = { kind = "half_plane" }
[[body]]
name = "slope"
mobility = "fixed"
position = ["10 m", "5 m"]
angle = "0.3 rad"
shape = { kind = "half_plane" }
[[body]]
name = "hills"
mobility = "fixed"
position = ["20 m", "3 m"]
angle = "0.05 rad"
shape = { kind = "terrain", points = [["-4 m", "-1 m"], ["5 m", "2.5 m"]] }
[[body]]
name = "box"
mobility = "free"
mass = "2 kg"
inertia = "0.7 kg m^2"
position = ["-2 m", "0.95 m"]
angle = "0.4 rad"
velocity = ["0.2 m/s", "-0.9 m/s"]
spin = "0.5 rad/s"
shape = { kind = "rectangle", half_width = "1.2 m", half_height = "0.7 m" }
[[body]]
name = "plank"
mobility = "free"
mass = "2.2 kg"
inertia = "0.8 kg m^2"
position = ["-14 m", "0.75 m"]
angle = "0.3 rad"
velocity = ["0.1 m/s", "-0.7 m/s"]
spin = "0.6 rad/s"
shape = { kind = "rectangle", half_width = "1.5 m", half_height = "0.5 m" }
[[body]]
name = "egg"
mobility = "free"
mass = "3 kg"
inertia = "0.9 kg m^2"
position = ["-6 m", "0.85 m"]
angle = "0.4 rad"
shape = { kind = "superquadric", half_width = "1.2 m", half_height = "0.7 m", exponent = 3.5 }
[[body]]
name = "wheel"
mobility = "free"
mass = "1.5 kg"
inertia = "0.6 kg m^2"
position = ["-9 m", "0.3 m"]
velocity = ["0 m/s", "-0.4 m/s"]
shape = { kind = "circle", radius = "0.5 m" }
[[body]]
name = "climber"
mobility = "particle"
mass = "1.1 kg"
position = ["20.5 m", "4.2 m"]
velocity = ["0.5 m/s", "-0.7 m/s"]
shape = { kind = "circle", radius = "0.8 m" }
[[body]]
name = "slider"
mobility = "particle"
mass = "1.2 kg"
position = ["11 m", "5.7 m"]
velocity = ["-0.3 m/s", "-0.6 m/s"]
shape = { kind = "circle", radius = "0.8 m" }
[[body]]
name = "door"
mobility = "pinned"
mass = "1.3 kg"
inertia = "0.4 kg m^2"
position = ["5 m", "10 m"]
pin = ["0.3 m", "-0.6 m"]
angle = "0.2 rad"
spin = "1.7 rad/s"
[[body]]
name = "tray"
mobility = "guided_x"
mass = "1.4 kg"
inertia = "0.45 kg m^2"
position = ["15 m", "12 m"]
pin = ["0.2 m", "-0.5 m"]
angle = "-0.3 rad"
velocity = ["0.3 m/s", "0 m/s"]
spin = "-1.2 rad/s"
[[body]]
name = "ellipse"
mobility = "fixed"
position = ["0 m", "5 m"]
shape = { kind = "superquadric", half_width = "1.2 m", half_height = "0.7 m" }
[[body]]
name = "knob"
mobility = "particle"
mass = "1 kg"
position = ["0.5 m", "5.7 m"]
shape = { kind = "circle", radius = "0.6 m" }
[[contact]]
name = "box_ground"
between = ["box", "ground"]
law = "linear_spring_dashpot"
stiffness = "1000 N/m"
restitution = 0.65
restitution_rule = "eq_21"
end_rule = "attractive"
[[contact]]
name = "plank_ground"
between = ["plank", "ground"]
law = "linear_spring_dashpot"
stiffness = "1050 N/m"
restitution = 0.75
[[contact]]
name = "egg_ground"
between = ["egg", "ground"]
law = "latching_spring"
stiffness = "1100 N/m"
unloading_stiffness = "2000 N/m"
[[contact]]
name = "wheel_ground"
between = ["wheel", "ground"]
law = "hertz"
modulus = "1200 N/m^2"
radius = "0.45 m"
damping = "3 N s/m"
method = "nodes"
nodes = 12
[[contact]]
name = "climber_hills"
between = ["climber", "hills"]
law = "linear_spring_dashpot"
stiffness = "1300 N/m"
damping = "3 N s/m"
[[contact]]
name = "slider_slope"
between = ["slider", "slope"]
law = "linear_spring_dashpot"
stiffness = "1250 N/m"
restitution = 0.55
[[contact]]
name = "knob_ellipse"
between = ["knob", "ellipse"]
law = "linear_spring_dashpot"
stiffness = "1400 N/m"
damping = "3 N s/m"
method = "nodes"
nodes = [4, 9]
node_depth = "centroid_ray"
[[cable]]
name = "rope"
law = "tension_only"
from = { body = "door", point = ["0.1 m", "0.2 m", "0.4 m"] }
to = { body = "tray", point = ["0.15 m", "0.25 m", "1.9 m"] }
stiffness = "150 N/m"
damping = "2 N s/m"
rest_length = "8 m"
slack = "0.3 m"
[[cable]]
name = "tether"
law = "tension_only"
from = { body = "box", point = ["0.6 m", "-0.3 m", "0.2 m"] }
to = { body = "plank", point = ["-0.7 m", "0.2 m", "1.1 m"] }
stiffness = "140 N/m"
damping = "1 N s/m"
slack = "0.25 m"
[run]
integrator = "velocity_verlet"
step = "1e-6 s"
end = "240e-6 s"
interval = "60e-6 s"
ledger = "on"
watch = "off"
)";

struct Vector {
  double x{}, y{};
};
Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y}; }
Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y}; }
double dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y; }
Vector turned(Vector a, double angle) {
  return {std::cos(angle) * a.x - std::sin(angle) * a.y, std::sin(angle) * a.x + std::cos(angle) * a.y};
}
/// Velocity that a spin gives to a point at this distance.
Vector spun(double spin, Vector arm) { return {-spin * arm.y, spin * arm.x}; }

Vector vector_of(const Written& of, const std::string& key) { return {of(key + "[0]"), of(key + "[1]")}; }

/// Velocity of a body's centre: a pin may leave less than all of it free.
Vector velocity_of(const Written& of, const std::string& body) {
  const Vector given = vector_of(of, body + ".velocity");
  const Vector about_pin =
      spun(of(body + ".spin"), turned({-of(body + ".pin[0]"), -of(body + ".pin[1]")}, of(body + ".angle")));
  if (body == "door") return about_pin;
  if (body == "tray") return {given.x, about_pin.y};
  return given;
}

/// First row of the history, by name of column.
std::map<std::string, double> first_row(const Written& of, const Setup& setup) {
  std::map<std::string, double> row;
  double kinetic = 0.0, potential = 0.0;
  for (const std::string& body : of.bodies()) {
    const double mass = of(body + ".mass"), angle = of(body + ".angle"), spin = of(body + ".spin");
    if (mass == 0.0) continue;  // held
    const Vector at = vector_of(of, body + ".position"), v = velocity_of(of, body);
    row[body + ".x"] = at.x, row[body + ".y"] = at.y, row[body + ".vx"] = v.x, row[body + ".vy"] = v.y;
    if (of(body + ".inertia") != 0.0) row[body + ".angle"] = angle, row[body + ".spin"] = spin;
    kinetic += 0.5 * mass * dot(v, v) + 0.5 * of(body + ".inertia") * spin * spin;
    potential -= mass * dot(vector_of(of, "gravity"), at);
  }
  row["energy.kinetic"] = kinetic, row["energy.gravity"] = potential;

  const double floor = of("ground.position[1]");
  // The lowest corner of a box; Eq. 21 has the mass of the body, not the effective mass at its corner.
  for (const std::string body : {"box", "plank"}) {
    const std::string contact = body + "_ground";
    const Vector corner =
        turned({-of(body + ".shape.half_width"), -of(body + ".shape.half_height")}, of(body + ".angle"));
    const double overlap = floor - of(body + ".position[1]") - corner.y, k = of(contact + ".stiffness");
    const double closing = -(of(body + ".velocity[1]") + of(body + ".spin") * corner.x);
    const double effective =
        reference::effective_mass(reference::free_mobility(of(body + ".mass"), of(body + ".inertia"), corner.x), 0.0);
    const double e = of(contact + ".restitution");
    const double damping = body == "box"
                               ? reference::eq_21_damping(e, k, of("box.mass"))
                               : 2.0 * reference::damping_ratio(e, EndRule::clamped) * std::sqrt(k * effective);
    row[contact + ".overlap"] = overlap, row[contact + ".force"] = k * overlap + damping * closing;
  }
  {  // Support of a superellipse: the dual norm.
    const double n = setup.has("ellipse_for_superellipse") ? 2.0 : of("egg.shape.exponent"), dual = n / (n - 1.0);
    const double down = std::pow(std::pow(of("egg.shape.half_width") * std::sin(of("egg.angle")), dual) +
                                     std::pow(of("egg.shape.half_height") * std::cos(of("egg.angle")), dual),
                                 1.0 / dual);
    row["egg_ground.overlap"] = down - (of("egg.position[1]") - floor);
    row["egg_ground.force"] = of("egg_ground.stiffness") * row["egg_ground.overlap"];
  }
  {  // Nodes of the wheel, one of which is lowest, each with Hertz's law.
    const double height = of("wheel.position[1]") - floor, r = of("wheel.shape.radius"),
                 effective = of("wheel_ground.radius");
    double force = 0.0;
    const int nodes = static_cast<int>(of("wheel_ground.nodes"));
    for (int i = 0; i < nodes; ++i) {
      const double inside = r * std::cos(2.0 * std::numbers::pi * i / nodes) - height;
      if (inside <= 0.0) continue;
      force += 4.0 / 3.0 * of("wheel_ground.modulus") * std::sqrt(effective) * std::pow(inside, 1.5) -
               of("wheel_ground.damping") * std::pow(inside / effective, 0.25) * of("wheel.velocity[1]");
    }
    row["wheel_ground.overlap"] = r - height, row["wheel_ground.force"] = force;
  }
  {  // A disc above the line through the two points.
    const auto point = [&](int i) {
      return vector_of(of, "hills.position") +
             turned(vector_of(of, fmt::format("hills.shape.points[{}]", i)), of("hills.angle"));
    };
    const Vector line = point(1) - point(0);
    const double length = std::hypot(line.x, line.y);
    const Vector normal{-line.y / length, line.x / length};
    const double overlap = of("climber.shape.radius") - dot(vector_of(of, "climber.position") - point(0), normal);
    row["climber_hills.overlap"] = overlap;
    row["climber_hills.force"] = of("climber_hills.stiffness") * overlap -
                                 of("climber_hills.damping") * dot(vector_of(of, "climber.velocity"), normal);
  }
  {  // A disc on an inclined half-plane, damped for a restitution.
    const Vector normal = turned({0.0, 1.0}, of("slope.angle"));
    const double k = of("slider_slope.stiffness"),
                 overlap = of("slider.shape.radius") -
                           dot(vector_of(of, "slider.position") - vector_of(of, "slope.position"), normal);
    row["slider_slope.overlap"] = overlap;
    row["slider_slope.force"] =
        k * overlap - 2.0 * reference::damping_ratio(of("slider_slope.restitution"), EndRule::clamped) *
                          std::sqrt(k * of("slider.mass")) * dot(vector_of(of, "slider.velocity"), normal);
  }
  {  // The knob's lowest node lies in the ellipse, at this fraction of the ray from its centre; the ellipse's nodes,
     // the first and the last as far from its vertex in the parameter of its angle, act if they lie in the knob.
    const Vector centre = vector_of(of, "knob.position") - vector_of(of, "ellipse.position");
    const double radius = of("knob.shape.radius"), height = of("ellipse.shape.half_height"),
                 width = of("ellipse.shape.half_width");
    const Vector node = centre - Vector{0.0, radius};
    const double fraction = std::hypot(node.x / width, node.y / height);
    const double of_node = std::hypot(node.x, node.y) * (1.0 / fraction - 1.0);
    double overlap = of_node, sum = of_node;
    const int nodes = static_cast<int>(of("knob_ellipse.nodes[1]"));
    for (int i = 0; i < nodes; ++i) {
      const double at = 2.0 * std::numbers::pi * (i + 0.5) / nodes;
      const double inside = radius - std::hypot(centre.x - width * std::cos(at), centre.y - height * std::sin(at));
      sum += std::max(inside, 0.0), overlap = std::max(overlap, inside);
    }
    row["knob_ellipse.overlap"] = overlap;
    row["knob_ellipse.force"] = of("knob_ellipse.stiffness") * sum;
  }
  {  // A cable that is longer by its distance across the plane.
    const auto arm = [&](const std::string& body, const std::string& end) {
      return turned(vector_of(of, "rope." + end + ".point"), of(body + ".angle"));
    };
    const Vector from = arm("door", "from"), to = arm("tray", "to");
    const Vector between = vector_of(of, "tray.position") + to - vector_of(of, "door.position") - from;
    const double across = setup.has("cable_in_the_plane") ? 0.0 : of("rope.to.point[2]") - of("rope.from.point[2]");
    const double length = std::hypot(between.x, between.y, across);
    const Vector relative =
        velocity_of(of, "tray") + spun(of("tray.spin"), to) - velocity_of(of, "door") - spun(of("door.spin"), from);
    row["rope.elongation"] = length - of("rope.rest_length") - of("rope.slack");
    row["rope.tension"] =
        of("rope.stiffness") * row["rope.elongation"] + of("rope.damping") * dot(between, relative) / length;
    // Without a rest length, the cable is as long as the distance of its ends at the start, and its slack.
    row["tether.elongation"] = -of("tether.slack");
    row["tether.tension"] = 0.0;
    row["energy.cables"] = 0.5 * of("rope.stiffness") * row["rope.elongation"] * row["rope.elongation"];
  }
  return row;
}

void check_placed(const TemporaryFolder& folder, Findings& findings, const Setup& setup) {
  folder.write("placed.toml", placed);
  (void)talus_output(folder, {"run", "placed.toml", "--out", "placed"});
  const Written written{placed};
  const records::Csv history = records::read_csv(folder.path() / "placed/history.csv");
  std::map<std::string, double> exact = first_row(written, setup);
  double worst = 0.0, compared = 0.0;
  std::string where;
  for (std::size_t i = 0; i < history.header().size(); ++i) {
    const auto found = exact.find(history.header()[i].substr(0, history.header()[i].find(" [")));
    if (found == exact.end()) continue;
    const double before = worst;
    keep_worst(worst, (history.number(0, i) - found->second) / std::max(1.0, std::abs(found->second)));
    if (worst != before) where = found->first;
    ++compared;
  }
  findings.expect("first row of the history: quantities compared", compared, static_cast<double>(exact.size()),
                  Tolerance::exact("each quantity with a closed form is a column"));
  findings.expect(
      "first row of the history: motion, overlaps, forces and energies, largest error", worst, 0.0,
      Tolerance::round_off(1e-13,
                           "overlaps are differences of positions up to 20, with 1.1e-16 of them in each of "
                           "about ten operations, times stiffnesses up to 1400 in forces above 100"));
  double times = 0.0;
  for (std::size_t i = 0; i < history.rows(); ++i)
    keep_worst(times, history.number(i, 0) - static_cast<double>(i) * written("run.interval"));
  findings.expect("times of the rows of the history, largest error", times, 0.0,
                  Tolerance::round_off(7e-18, "a sum of 240 steps of 1e-6 s, each rounded by at most 2.7e-20 s"), "s");
  findings.expect("rows of the history", static_cast<double>(history.rows()),
                  std::round(written("run.end") / written("run.interval")) + 1.0,
                  Tolerance::exact("one at the start and at the end of each interval"));
  const Json summary = records::read_json(folder.path() / "placed/summary.json");
  const bool ledger = summary.at("ledger").is_object();
  findings.expect_true("title and balance of the summary",
                       ledger && summary.at("title") == "Bodies placed with overlaps",
                       "the title of the scene; a balance is requested");
  // A slash divides by the next unit alone, whatever follows: the same numbers in units with other texts.
  std::string divided = placed;
  for (const auto& [unit, other] :
       {std::pair{"\"3 N s/m\"", "\"3 N/m s\""}, std::pair{"\"2 N s/m\"", "\"2 N/m*s\""},
        std::pair{"\"0.9 kg m^2\"", "\"0.9 kg/m m^3\""}, std::pair{"\"-0.7 m/s\"", "\"-0.7 m/s^2 s\""}})
    divided.replace(divided.find(unit), std::string_view{unit}.size(), other);
  folder.write("divided.toml", divided);
  const ProgramEnd in_divided = run_talus(folder, {"run", "divided.toml", "--out", "divided"});
  findings.expect_true(
      "the same history in units of which one follows a divided one",
      in_divided.exit_code == 0 && folder.read("divided/history.csv") == folder.read("placed/history.csv"),
      "N/m s is N s/m, kg/m m^3 is kg m^2, m/s^2 s is m/s: all sizes are 1 in SI, so that the same bytes are written");
  findings.table({.name = "first_row",
                  .caption = "Quantity of the first row with the largest error.",
                  .columns = {"quantity", "error"},
                  .rows = {{where, fmt::format("{:.3g}", worst)}}});
}

/// Exit statuses of `talus run` and `talus check`.
struct Codes {
  int run{}, check{};
};
/// A run that a rule of the monitor concerns, and its exit statuses with the default and with another choice.
struct Watched {
  std::string bodies, step, end, choice;
  Codes usual, chosen;
  std::string fields{};  ///< of the run, with both
};

std::vector<Watched> watched_runs() {
  const auto disc = [](const char* name, const char* position, const char* velocity) {
    return fmt::format(
        "[[body]]\nname = \"{}\"\nmobility = \"particle\"\nmass = \"1 kg\"\nposition = [{}]\nvelocity = [{}]\n"
        "shape = {{ kind = \"circle\", radius = \"0.5 m\" }}\n",
        name, position, velocity);
  };
  const std::string ground =
      "[[body]]\nname = \"ground\"\nmobility = \"fixed\"\nposition = [\"0 m\", \"0 m\"]\nshape = { kind = "
      "\"half_plane\" }\n";
  const auto contact = [](const char* with) {
    return fmt::format(
        "[[contact]]\nname = \"touch\"\nbetween = [\"disc\", \"{}\"]\nlaw = \"linear_spring_dashpot\"\n"
        "stiffness = \"1000 N/m\"\ndamping = \"0 N s/m\"\n",
        with);
  };
  const auto pair = [](const char* name, double radius, double x, double apart, double speed, double stiffness) {
    std::string text;
    for (const auto& [number, at, v] : {std::tuple{1, x, speed}, {2, x + apart, 0.0}})
      text += fmt::format(
          "[[body]]\nname = \"{0}{1}\"\nmobility = \"particle\"\nmass = \"1 kg\"\nposition = [\"{2} m\", \"0 m\"]\n"
          "velocity = [\"{3} m/s\", \"0 m/s\"]\nshape = {{ kind = \"circle\", radius = \"{4} m\" }}\n",
          name, number, at, v, radius);
    return text + fmt::format(
                      "[[contact]]\nname = \"{0}\"\nbetween = [\"{0}1\", \"{0}2\"]\n"
                      "law = \"linear_spring_dashpot\"\nstiffness = \"{1} N/m\"\ndamping = \"0 N s/m\"\n",
                      name, stiffness);
  };
  const std::string impact = ground + disc("disc", R"("0 m", "0.51 m")", R"("0 m/s", "-0.4 m/s")") + contact("ground");
  return {{ground + disc("disc", R"("0 m", "0.49 m")", R"("0 m/s", "0.001 m/s")") + contact("ground"),
           "0.064 s",
           "0.32 s",
           "instability = \"warning\", quality = \"warning\"",
           {3, 7},
           {0, 0}},
          {ground + disc("disc", R"("0 m", "0.49 m")", R"("0 m/s", "0.001 m/s")") + contact("ground"),
           "0.064 s",
           "0.32 s",
           "instability = \"warning\"",
           {3, 7},
           {7, 7},
           "ledger = \"off\"\n"},
          {disc("disc", R"("-2 m", "5 m")", R"("300 m/s", "0 m/s")") +
               disc("other", R"("2 m", "5 m")", R"("0 m/s", "0 m/s")") + contact("other"),
           "0.02 s",
           "0.04 s",
           "tunnelling = \"warning\"",
           {3, 0},
           {0, 0}},
          // The overlap of the small discs exceeds half of their radius; that of the large ones is larger, and small
          // beside theirs.
          {pair("large", 2.0, 0.0, 3.7, 0.0, 0.01) + pair("small", 0.1, 10.0, 0.21, 1.0, 20.0),
           "0.005 s",
           "0.4 s",
           "tunnelling = \"warning\"",
           {3, 0},
           {0, 0}},
          {impact, "0.02 s", "0.2 s", "accuracy = \"error\"", {7, 0}, {3, 0}},
          {ground + disc("disc", R"("0 m", "0.4 m")", R"("0 m/s", "0 m/s")"),
           "0.02 s",
           "0.2 s",
           "missing_contacts = \"error\"",
           {0, 0},
           {3, 7}},
          {impact, "0.03 s", "0.3 s", "quality = \"warning\"", {7, 0}, {0, 0}}};
}

void check_watch(const TemporaryFolder& folder, Findings& findings, const Setup& setup) {
  double wrong = 0.0;
  std::vector<std::vector<std::string>> rows;
  for (const Watched& run : watched_runs()) {
    for (const bool chosen : {false, true}) {
      const std::string watch =
          chosen && !setup.has("rules_left_out") ? fmt::format("watch = {{ {} }}\n", run.choice) : "";
      folder.write(
          "watched.toml",
          fmt::format("units = \"SI\"\n{}[run]\nintegrator = \"velocity_verlet\"\nstep = \"{}\"\nend = \"{}\"\n{}{}",
                      run.bodies, run.step, run.end, run.fields, watch));
      const auto [of_run, of_check] = chosen ? run.chosen : run.usual;
      for (const auto& [command, expected] : {std::pair{"run", of_run}, std::pair{"check", of_check}}) {
        const int code = run_talus(folder, {command, "watched.toml"}).exit_code;
        wrong += code == expected ? 0.0 : 1.0;
        rows.push_back(
            {chosen ? run.choice : "default", command, fmt::format("{}", expected), fmt::format("{}", code)});
      }
    }
  }
  findings.expect(
      "runs whose rules of the monitor have another effect", wrong, 0.0,
      Tolerance::exact("exit statuses of `talus run` and `talus check` with the default and with another choice "
                       "of each rule"));
  findings.table({.name = "rules",
                  .caption = "Exit statuses of runs, and of their checks, with rules of the monitor.",
                  .columns = {"rules", "command", "expected", "found"},
                  .rows = rows});
}

void run(Findings& findings, const Setup& setup) {
  const auto group = findings.in("fields");
  const TemporaryFolder folder;
  if (setup.needs("first row")) check_placed(folder, findings, setup);
  if (setup.needs("final state")) check_moving(folder, findings, setup);
  if (setup.needs("rules")) check_watch(folder, findings, setup);
  if (setup.needs("refused")) check_refused(folder, findings, setup);
  if (setup.needs("diverges")) check_diverging(folder, findings);
  if (setup.needs("without a shape")) check_lines(folder, findings);
}

}  // namespace

Case definition() {
  return {
      .id = "scene_fields",
      .title = "Fields of a scene",
      .requirements = {{"G10", {"fields"}}},
      .main_checks = {"first row of the history: motion, overlaps, forces and energies, largest error",
                      "final state: plastic elongations, positions and velocities, largest error",
                      "runs whose rules of the monitor have another effect"},
      .source = "Textbook mechanics; Mustoe & Huttelmaier 1993, Eq. 21; Schwager & Poeschel 2007 (clamped contact)",
      .faults = {{"ellipse_for_superellipse", "the exponent 2 for the superellipse",
                  "first row of the history: motion, overlaps, forces and energies, largest error"},
                 {"cable_in_the_plane", "a cable without its distance across the plane",
                  "first row of the history: motion, overlaps, forces and energies, largest error"},
                 {"no_hardening", "a yielding cable without hardening",
                  "final state: plastic elongations, positions and velocities, largest error"},
                 {"round_outlines", "an exponent that is accepted in place of one that is refused",
                  "scenes on both sides of what is refused: verdicts that differ"},
                 {"rules_left_out", "runs without their rules", "runs whose rules of the monitor have another effect"}},
      .run = run};
}

}  // namespace talus::verification::problems::scene_fields
