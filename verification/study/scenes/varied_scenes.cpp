#include "verification/study/scenes/varied_scenes.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <string_view>

#include "solver/io/scene/scene_template.hpp"

namespace talus::verification::problems {
namespace {

/// A fixed half-plane through the origin, turned by an angle [deg].
std::string plane(double angle, const char* name = "ground") {
  return fmt::format(
      "[[body]]\nname = \"{}\"\nmobility = \"fixed\"\nposition = [\"0 m\", \"0 m\"]\nangle = \"{} deg\"\n"
      "shape = {{ kind = \"half_plane\" }}\n",
      name, angle);
}

/// A body at (x, y), with further lines.
std::string body(const char* name, const char* mobility, double mass, double x, double y, const std::string& more) {
  return fmt::format(
      "[[body]]\nname = \"{}\"\nmobility = \"{}\"\nmass = \"{} kg\"\nposition = [\"{} m\", \"{} m\"]\n{}", name,
      mobility, mass, x, y, more);
}

std::string velocity(double vx, double vy) { return fmt::format("velocity = [\"{} m/s\", \"{} m/s\"]\n", vx, vy); }

std::string circle(double radius) {
  return fmt::format("shape = {{ kind = \"circle\", radius = \"{} m\" }}\n", radius);
}

/// A disc of 2 kg and 0.1 m that can turn.
std::string disc(const char* name, double x, double y, const std::string& more) {
  return body(name, "free", 2.0, x, y, "inertia = \"0.01 kg m^2\"\n" + circle(0.1) + more);
}

std::string box(const char* name, double mass, double half_width, double half_height, double x, double y,
                const std::string& more) {
  const double inertia = mass * (half_width * half_width + half_height * half_height) / 3.0;
  return body(name, "free", mass, x, y,
              fmt::format("inertia = \"{} kg m^2\"\nshape = {{ kind = \"rectangle\", half_width = \"{} m\", "
                          "half_height = \"{} m\" }}\n{}",
                          inertia, half_width, half_height, more));
}

std::string ellipse(double half_width, double half_height, double x, double y, const std::string& more) {
  return body("stone", "free", 2.0, x, y,
              fmt::format("inertia = \"{} kg m^2\"\nshape = {{ kind = \"superquadric\", half_width = \"{} m\", "
                          "half_height = \"{} m\", exponent = 2 }}\n{}",
                          0.5 * (half_width * half_width + half_height * half_height), half_width, half_height, more));
}

/// A linear spring and dashpot.
std::string contact(const char* a, const char* b, double stiffness, double restitution, const std::string& more = "") {
  return fmt::format(
      "[[contact]]\nname = \"{0}-{1}\"\nbetween = [\"{0}\", \"{1}\"]\nlaw = \"linear_spring_dashpot\"\n"
      "stiffness = \"{2} N/m\"\nrestitution = {3}\n{4}",
      a, b, stiffness, restitution, more);
}

std::string law(const char* a, const char* b, const char* of) {
  return fmt::format("[[contact]]\nname = \"{0}-{1}\"\nbetween = [\"{0}\", \"{1}\"]\n{2}", a, b, of);
}

std::string friction(double coefficient) { return fmt::format("friction = {}\n", coefficient); }

/// A cable from a body's centre to a point of the world.
std::string cable(const char* name, const char* end, double x, double y, const char* of) {
  return fmt::format(
      "[[cable]]\nname = \"{}\"\nfrom = {{ body = \"{}\", point = [\"0 m\", \"0 m\"] }}\n"
      "to = {{ point = [\"{} m\", \"{} m\"] }}\n{}",
      name, end, x, y, of);
}

VariedScene varied(const char* name, const char* quantity, double end, const std::string& parts,
                   double gravity = 9.81) {
  return {
      name, quantity,
      fmt::format("title = \"{}\"\nunits = \"SI\"\ngravity = [\"0 m/s^2\", \"{} m/s^2\"]\n{}[run]\nend = \"{} s\"\n",
                  name, -gravity, parts, end)};
}

constexpr const char* pinned_bob =
    "inertia = \"0.0004 kg m^2\"\npin = [\"0 m\", \"1 m\"]\nangle = \"-30 deg\"\n"
    "shape = { kind = \"circle\", radius = \"0.05 m\" }\n";
constexpr const char* wall =
    "[[body]]\nname = \"wall\"\nmobility = \"fixed\"\nposition = [\"0.05 m\", \"0 m\"]\nangle = \"90 deg\"\n"
    "shape = { kind = \"half_plane\" }\n";

/// Sets a field of a table, uncommenting or adding it if necessary.
std::string with(std::string text, std::string_view table, std::string_view key, std::string_view value) {
  const std::size_t head = text.find(fmt::format("[{}]", table));
  if (head == std::string::npos) throw std::invalid_argument{fmt::format("no table {}", table)};
  const std::size_t next = std::min(text.find("\n[", head), text.size());
  const std::string line = fmt::format("\n{} = {}", key, value);
  for (const std::string& written : {fmt::format("\n{} = ", key), fmt::format("\n# {} = ", key)}) {
    const std::size_t found = text.find(written, head);
    if (found < next) return text.replace(found, text.find('\n', found + 1) - found, line);
  }
  return text.insert(text.find('\n', head), line);
}

struct Change {
  const char* table;
  const char* key;
  const char* value;
};

VariedScene fence(const char* name, const std::vector<Change>& changes) {
  std::string text = scene_template("fence", si);
  for (const Change& change : changes)
    text = with(std::move(text), change.table, change.key, change.value);
  return {name, "", std::move(text)};
}

}  // namespace

std::vector<VariedScene> varied_scenes() {
  const std::string hertz = "law = \"hertz\"\nmodulus = \"5e8 N/m^2\"\nradius = \"0.1 m\"\n";
  const std::string latching =
      "law = \"latching_spring\"\nstiffness = \"2e5 N/m\"\nunloading_stiffness = \"5e5 N/m\"\n";
  const std::string bob = body("bob", "pinned", 1.0, -0.5, -0.8660254037844386, pinned_bob);
  const std::string square_drop = plane(0.0) + contact("box", "ground", 1e6, 0.4, friction(0.3));
  return {
      varied("disc that bounces", "disc.y.end", 1.2,
             disc("disc", 0, 1, "") + plane(0) + contact("disc", "ground", 1e6, 0.8)),
      varied("disc on a soft ground", "disc-ground.force.max", 0.8,
             disc("disc", 0, 1, "") + plane(0) + contact("disc", "ground", 5e4, 0.3)),
      varied("pendulum against a wall", "bob.spin.end", 1.2, bob + wall + contact("bob", "wall", 1e5, 0.7)),
      varied("pendulum against a soft wall", "bob.angle.end", 1.0, bob + wall + contact("bob", "wall", 1e4, 0.4)),
      varied("block that slides to rest", "box.x.end", 2.0,
             box("box", 10, 0.25, 0.25, 0, 0.25, velocity(3, 0)) + plane(0) +
                 contact("box", "ground", 1e6, 0.3, friction(0.3))),
      varied("block that slides down an incline", "box.x.end", 1.0,
             box("box", 5, 0.3, 0.1, 0.05, 0.0866025403784439, "angle = \"-30 deg\"\n") + plane(-30) +
                 contact("box", "ground", 1e6, 0.3, friction(0.2))),
      varied("disc that rolls down", "disc.x.end", 1.0,
             disc("disc", 0.0342020, 0.0939690, "") + plane(-20) + contact("disc", "ground", 1e6, 0.5, friction(0.4))),
      varied("disc that slides down", "disc.spin.end", 1.0,
             disc("disc", 0.0642787, 0.0766040, "") + plane(-40) + contact("disc", "ground", 1e6, 0.5, friction(0.1))),
      varied("disc with backspin", "disc.x.end", 1.0,
             disc("disc", 0, 0.1, velocity(2, 0) + "spin = \"60 rad/s\"\n") + plane(0) +
                 contact("disc", "ground", 1e6, 0.5, friction(0.2))),
      varied("oblique impact that slides", "disc.spin.end", 0.2,
             disc("disc", 0, 0.2, velocity(4, -2)) + plane(0) + contact("disc", "ground", 1e6, 0.8, friction(0.1)), 0),
      varied("oblique impact that sticks", "disc.vx.end", 0.2,
             disc("disc", 0, 0.2, velocity(1, -2)) + plane(0) + contact("disc", "ground", 1e6, 0.6, friction(0.6)), 0),
      varied("three discs in a row", "c.vx.end", 0.4,
             disc("a", 0, 0, velocity(2, 0)) + disc("b", 0.3, 0, "") + disc("c", 0.5, 0, "") +
                 contact("a", "b", 1e6, 0.9) + contact("b", "c", 1e6, 0.9),
             0),
      varied("row of different masses", "c.vx.end", 0.4,
             disc("a", 0, 0, velocity(2, 0)) + body("b", "particle", 0.5, 0.3, 0, circle(0.1)) +
                 body("c", "particle", 4, 0.52, 0, circle(0.1)) + contact("a", "b", 3e5, 0.5) +
                 contact("b", "c", 3e5, 0.5),
             0),
      varied("fall into a cable", "bob.y.min", 2.0,
             body("bob", "particle", 3, 0, -1, "") +
                 cable("rope", "bob", 0, 0,
                       "law = \"tension_only\"\nstiffness = \"2 kN/m\"\ndamping = \"20 N s/m\"\n"
                       "rest_length = \"2 m\"\n")),
      varied("fall into a stiff cable", "rope.tension.max", 1.0,
             body("bob", "particle", 3, 0, -1, "") +
                 cable("rope", "bob", 0, 0, "law = \"tension_only\"\nstiffness = \"200 kN/m\"\nslack = \"1 m\"\n")),
      varied("cable that yields", "bob.y.min", 1.0,
             body("bob", "particle", 20, 0, -1, "") +
                 cable("rope", "bob", 0, 0,
                       "law = \"elastic_plastic\"\nstiffness = \"100 kN/m\"\nyield = \"2 kN\"\n"
                       "hardening = \"5 kN/m\"\nrest_length = \"2 m\"\n")),
      varied("mass between two cables", "bob.y.max", 0.6,
             body("bob", "particle", 5, 0, 0, velocity(0, 8)) +
                 cable("left", "bob", -2, 0, "law = \"tension_only\"\nstiffness = \"50 kN/m\"\n") +
                 cable("right", "bob", 2, 0, "law = \"tension_only\"\nstiffness = \"50 kN/m\"\nslack = \"10 mm\"\n"),
             0),
      varied("Hertzian bounce", "disc-ground.force.max", 0.5,
             disc("disc", 0, 0.6, "") + plane(0) + law("disc", "ground", hertz.c_str())),
      varied("Hertzian impact of two discs", "b.vx.end", 0.3,
             disc("a", 0, 0, velocity(3, 0)) + disc("b", 0.4, 0.05, "") + law("a", "b", hertz.c_str()), 0),
      varied("latching impact", "b.vx.end", 0.3,
             disc("a", 0, 0, velocity(3, 0)) + disc("b", 0.4, 0, "") + law("a", "b", latching.c_str()), 0),
      varied(
          "latching bounce", "disc.y.end", 0.7,
          disc("disc", 0, 0.6, "") + plane(0) + law("disc", "ground", (latching + "growth = \"20 m^-1\"\n").c_str())),
      varied("box on its corner", "box.spin.end", 0.3,
             box("box", 3, 0.3, 0.1, 0, 0.5, "angle = \"35 deg\"\n" + velocity(0.5, -2)) + square_drop),
      varied("box that lands flat and slides", "box.x.end", 1.2,
             box("box", 3, 0.3, 0.1, 0, 0.3, velocity(2, 0)) + square_drop),
      varied("stone that tumbles", "stone.y.end", 0.8,
             ellipse(0.3, 0.15, 0, 0.8, "angle = \"50 deg\"\nspin = \"1 rad/s\"\n") + plane(0) +
                 contact("stone", "ground", 1e6, 0.6, friction(0.4))),
      varied("stone that rocks", "stone.angle.end", 0.9,
             ellipse(0.3, 0.2, 0, 0.2, "angle = \"5 deg\"\n") + plane(0) +
                 contact("stone", "ground", 1e6, 0.3, friction(0.8))),
      varied("disc in a valley", "disc.x.end", 1.0,
             disc("disc", -0.8, 0.7, "") +
                 "[[body]]\nname = \"valley\"\nmobility = \"fixed\"\nposition = [\"0 m\", \"0 m\"]\n"
                 "shape = { kind = \"terrain\", points = [[\"-2 m\", \"1 m\"], [\"0 m\", \"0 m\"], [\"2 m\", \"1 m\"]] "
                 "}\n" +
                 contact("disc", "valley", 1e6, 0.4, friction(0.5))),
      varied("carriage against a stop", "load.x.end", 0.8,
             body("load", "sliding_x", 8, -0.5, 0, circle(0.1) + velocity(1.5, 0)) + wall +
                 contact("load", "wall", 2e5, 0.5)),
      varied("guided bar against a wall", "bar.angle.end", 0.6,
             body("bar", "guided_x", 4, -0.6, -0.3,
                  "inertia = \"0.2 kg m^2\"\npin = [\"0.2 m\", \"0.3 m\"]\n" + circle(0.15) + velocity(2, 0)) +
                 wall + contact("bar", "wall", 2e5, 0.5)),
      varied("piston", "piston.y.min", 0.9,
             body("piston", "sliding_y", 6, 0, 0.5, circle(0.1)) + plane(0) + contact("piston", "ground", 2e4, 0.2)),
      varied("ball against a pinned plank", "plank.spin.end", 0.3,
             disc("ball", -0.5, -0.6, velocity(4, 0)) +
                 body("plank", "pinned", 3, 0, -0.5,
                      "inertia = \"0.26 kg m^2\"\npin = [\"0 m\", \"0.5 m\"]\nshape = { kind = \"rectangle\", "
                      "half_width = \"0.05 m\", half_height = \"0.5 m\" }\n") +
                 contact("ball", "plank", 5e5, 0.5)),
  };
}

std::vector<VariedScene> even_fences() {
  const Change columns{"fence", "columns", "14"};
  return {fence("half", {columns}), fence("whole", {columns, {"fence.options", "symmetry", "\"full\""}})};
}

std::vector<VariedScene> varied_fences() {
  constexpr const char *of = "fence", *rock = "fence.rock", *column = "fence.column", *options = "fence.options";
  const auto moving = [](const char* v) { return Change{"fence.rock", "velocity", v}; };
  return {
      fence("nine columns", {moving("[\"-6 m/s\", \"0 m/s\"]"), {of, "columns", "9"}}),
      fence("long span", {moving("[\"-15 m/s\", \"0 m/s\"]"),
                          {of, "columns", "21"},
                          {of, "span", "\"24 m\""},
                          {of, "sag", "\"2 m\""}}),
      fence("light and fast",
            {moving("[\"-25 m/s\", \"0 m/s\"]"), {rock, "mass", "\"400 kg\""}, {of, "columns", "12"}}),
      fence("two layers",
            {moving("[\"-12 m/s\", \"0 m/s\"]"), {of, "layers", "2"}, {of, "layer_spacing", "\"0.9 m\""}}),
      fence("two layers without friction", {moving("[\"-18 m/s\", \"-1 m/s\"]"),
                                            {of, "layers", "2"},
                                            {of, "layer_spacing", "\"1 m\""},
                                            {of, "friction", "0.0"}}),
      fence("weak hangers", {moving("[\"-20 m/s\", \"0 m/s\"]"), {options, "hanger_strength", "\"20 kN\""}}),
      fence("weak top cable",
            {moving("[\"-22 m/s\", \"0 m/s\"]"), {options, "strength_top", "\"420 kN\""}, {of, "friction", "0.1"}}),
      fence("rock beside the centre",
            {moving("[\"-9 m/s\", \"0 m/s\"]"), {options, "symmetry", "\"full\""}, {rock, "along", "\"0.3 m\""}}),
      fence("top cable alone", {moving("[\"-10 m/s\", \"0 m/s\"]"), {of, "connections", "1"}, {of, "friction", "0.0"}}),
      fence("lively contacts",
            {moving("[\"-8 m/s\", \"0 m/s\"]"), {of, "restitution", "0.9"}, {of, "friction", "0.0"}}),
      fence("block", {moving("[\"-11 m/s\", \"0 m/s\"]"),
                      {rock, "shape", "\"rectangle\""},
                      {rock, "solid", "\"block\""},
                      {rock, "b", "\"0.35 m\""}}),
      fence("rounded block", {moving("[\"-11 m/s\", \"1 m/s\"]"), {rock, "exponent", "4.0"}, {of, "friction", "0.2"}}),
      fence("soft cables",
            {moving("[\"-14 m/s\", \"0 m/s\"]"), {of, "penetration", "0.1"}, {of, "young", "\"50 GPa\""}}),
      fence("columns touch the ground",
            {moving("[\"-14 m/s\", \"0 m/s\"]"), {options, "column_ground", "\"contact\""}, {of, "friction", "0.2"}}),
      fence("cables that harden",
            {moving("[\"-10 m/s\", \"0 m/s\"]"), {options, "hardening", "0.02"}, {of, "limit_top", "\"100 kN\""}}),
      fence("slack bottom cable",
            {moving("[\"-12 m/s\", \"0 m/s\"]"), {of, "slack", "\"0.15 m\""}, {of, "columns", "10"}}),
      fence("heavy columns",
            {moving("[\"-16 m/s\", \"0 m/s\"]"), {column, "density", "\"400 kg/m^3\""}, {of, "friction", "0.0"}}),
      fence("heavy rock that spins",
            {moving("[\"-9 m/s\", \"-3 m/s\"]"), {rock, "spin", "\"6 rad/s\""}, {rock, "mass", "\"1200 kg\""}}),
      fence("five columns", {moving("[\"-7 m/s\", \"0 m/s\"]"),
                             {of, "columns", "5"},
                             {of, "span", "\"8 m\""},
                             {of, "restitution", "0.2"}}),
      fence("lightest and fastest",
            {moving("[\"-30 m/s\", \"0 m/s\"]"), {rock, "mass", "\"250 kg\""}, {of, "duration", "\"0.5 s\""}}),
  };
}

}  // namespace talus::verification::problems
