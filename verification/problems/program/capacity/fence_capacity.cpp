#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include "verification/check/case.hpp"
#include "verification/problems/program/capacity/capacity_statistics.hpp"
#include "verification/problems/program/pictures/picture_script.hpp"
#include "verification/record/csv.hpp"
#include "verification/record/json_node.hpp"
#include "verification/record/whole_file.hpp"
#include "verification/study/findings/expectations.hpp"
#include "verification/study/program/program_options.hpp"
#include "verification/study/program/program_run.hpp"

namespace talus::verification::problems::fence_capacity {
namespace {

namespace fs = std::filesystem;
using records::Json;

/// A cable with a column in its middle, and a rock against it. Both move along x alone.
constexpr double half_span = 5.0, area = 1e-4, young = 1e11, strength = 1e5, column_mass = 1.0, own_mass = 200.0,
                 own_radius = 0.3, own_x = 0.51, ground_top = -4.5;

constexpr const char* guided = "held = [\"y\", \"rotation\"]\n";

/// `more`: further fields of [fence.options]. The step is only the interval between samples: cables that turn select a
/// method which chooses its steps. A rock that is stopped turns back within 0.35 s.
std::string fence(const std::string& of_rock, const std::string& more = "") {
  return fmt::format(R"(title = "One column on one cable"
units = "SI"

[fence]
columns = 1
layers = 1
connections = 1
spacing = "1 m"
y_top = "0 m"
y_bottom = "-0.5 m"
span = "{} m"
sag = "0.001 m"
young = "{} Pa"
area_top = "{} m^2"
area_bottom = "1e-4 m^2"
limit_top = "1e9 N"
limit_bottom = "1e9 N"
restitution = 1.0
penetration = 0.002
gravity = "1e-6 m/s^2"
duration = "0.4 s"
step_factor = 4

[fence.ground]
position = ["0 m", "-5 m"]
a = "10 m"
b = "0.5 m"
density = "1000 kg/m^3"

[fence.column]
a = "0.2 m"
b = "1 m"
mass = "{} kg"
held = ["y", "rotation"]

[[fence.rock]]
a = "{} m"
b = "{} m"
mass = "{} kg"
position = ["{} m", "0 m"]
velocity = ["-5 m/s", "0 m/s"]
{}
[fence.options]
strength_top = "1 N"
{})",
                     2.0 * half_span, young, area, column_mass, own_radius, own_radius, own_mass, own_x, of_rock, more);
}

/// Kinetic energy with which the cable breaks: that of both halves at their strength.
double breaking_energy(const Setup& setup) {
  const double stiffness = young * area / half_span, draw = strength / stiffness;
  return (setup.has("one_half") ? 1.0 : 2.0) * 0.5 * stiffness * draw * draw;
}

std::string question(int cells, const std::string& more) {
  return fmt::format(
      "title = \"One column\"\nbase = \"fence.toml\"\nmass = [\"100 kg\", \"800 kg\"]\nspeed = [\"2 m/s\", \"12 "
      "m/s\"]\n"
      "set = {{ \"fence.options.strength_top\" = \"{} N\" }}\nseed = 3\n{}[map]\ncells = {}\nruns = 12\naudit = 20\n"
      "[changes]\nspeed = 0.002\n",
      strength, more, cells);
}

/// The boundary at each mass beside the closed form, and the fields of all runs.
void check_boundary(const Program& program, Findings& findings, Differences& differ) {
  const Setup& setup = program.setup();
  const int cells = setup.coarse ? 16 : 32;
  program.write("fence.toml", fence(guided));
  program.write("map.toml", question(cells, ""));
  const Json found = program.json({"capacity", "map.toml"}, {{"--no-plots", {}}, {"--threads", {"2"}}, {"--json", {}}});
  const Json& map = found.at("maps").at(0);
  double outside = 0.0, widest = 0.0;
  std::vector<std::vector<std::string>> rows;
  for (const Json& line : map.at("boundary")) {
    const double mass = line.at("mass").get<double>(), exact = std::sqrt(2.0 * breaking_energy(setup) / mass);
    const double low = line.at("speed").at(0).get<double>(), high = line.at("speed").at(1).get<double>();
    if (!(low <= exact && exact <= high)) outside += 1.0;
    widest = std::max(widest, (high - low) / (10.0 / cells));
    rows.push_back({fmt::format("{}", mass), fmt::format("{:.4g} to {:.4g}", low, high), fmt::format("{:.4g}", exact)});
    differ.compare("energy of a boundary",
                   std::abs(line.at("kinetic_energy").at(0).get<double>() / (0.5 * mass * low * low) - 1.0) < 1e-12,
                   true);
  }
  // At the boundary: the force is that of the cable which takes up the energy; beyond it the rock keeps the rest.
  double forces = 0.0, energies = 0.0;
  for (const Json& line : map.at("boundary")) {
    const double mass = line.at("mass").get<double>(), low = line.at("speed").at(0).get<double>(),
                 high = line.at("speed").at(1).get<double>();
    const double share = mass * low * low / (2.0 * breaking_energy(setup));
    const Json &stopped = line.at("stopped"), &passed = line.at("not_stopped");
    keep_worst(forces, stopped.at("outputs").at("fence.cable_force").at("median").at("value").get<double>() /
                               (strength * std::sqrt(share)) -
                           1.0);
    keep_worst(energies, (passed.at("outputs").at("fence.exit_energy").at("median").at("value").get<double>() -
                          0.5 * mass * high * high + breaking_energy(setup)) /
                             (0.5 * mass * high * high));
    differ.compare("runs at the boundary",
                   stopped.at("ends").at("stopped").get<int>() > passed.at("ends").at("stopped").get<int>(), true);
  }
  findings.expect("one column: cable force at the boundary over the closed form, largest deviation from 1", forces, 0.0,
                  Tolerance::model(0.012, "the column has at most 1 % of the rock's mass, speeds change by 0.2 %"));
  findings.expect("one column: energy beyond the boundary, largest deviation from the closed form over the energy",
                  energies, 0.0, Tolerance::model(0.024, "twice these of the speed"));
  findings.expect(
      "one column: speeds at which the cable breaks outside of the boundary, number", outside, 0.0,
      Tolerance::exact("energy of the rock = energy of both halves of the cable; the column of 1 kg adds at "
                       "most 1 %, a cell is at least as wide"));
  findings.expect_between("one column: widest boundary, in cells", widest, 0.999, 2.001,
                          "neighbouring nodes, or one open node between them: speeds are changed by 0.2 %");
  findings.table({.name = "one_column",
                  .caption = "Speeds up to which a fence of one column stops a rock, and at which the cable breaks.",
                  .columns = {"mass [kg]", "boundary [m/s]", "closed form [m/s]"},
                  .rows = rows});
  differ.compare("one energy for all masses", map.at("energy_factor").get<double>(), 1.0);
  differ.compare("boundaries", map.at("boundary").size(), std::size_t{5});
  differ.compare("full grid", map.at("full_grid_runs").get<int>(), (cells + 1) * (cells + 1) * 12);
  differ.compare("height of the base's rock", std::abs(map.at("height").get<double>() + ground_top) < 1e-12, true);
  differ.compare("audit", map.at("audit").at("contradictions").get<int>(), 0);
  differ.compare("rock of the base", std::abs(found.at("rock").at("mass").get<double>() - own_mass) < 1e-9, true);

  // Each run, as a sweep lists it.
  static_cast<void>(program.run({"sweep", "collect", "map"}, {}));
  const records::Csv runs = program.csv("map/results.csv"), nodes = program.csv("map/capacity.csv");
  double geometry = 0.0, speeds = 0.0, sizes = 0.0;
  std::size_t stopped = 0;
  for (std::size_t row = 0; row < runs.rows(); ++row) {
    const auto number = [&](const std::string& head) { return runs.number(row, runs.column(head)); };
    const double radius = own_radius * std::cbrt(number("fence.rock[0].mass [kg]") / own_mass);
    keep_worst(geometry, number("fence.rock[0].a [m]") / radius - 1.0);
    keep_worst(geometry, number("fence.rock[0].b [m]") / radius - 1.0);
    keep_worst(geometry, number("fence.rock[0].position[0] [m]") - (own_x + radius - own_radius));
    keep_worst(geometry, number("fence.rock[0].position[1] [m]"));
    // Speeds lie on the grid, but for the changes.
    const double spacing = 10.0 / cells, speed = -number("fence.rock[0].velocity[0] [m/s]");
    const double change = speed / (2.0 + spacing * std::round((speed - 2.0) / spacing)) - 1.0;
    keep_worst(speeds, change / 0.002);
    keep_worst(sizes, number("fence.cable_margin") - number("fence.cable_force [N]") / strength);
    stopped += runs.cell(row, runs.column("verdict")) == "stopped" ? 1 : 0;
  }
  findings.expect("fields of the runs: size and place of the rock, largest deviation", geometry, 0.0,
                  Tolerance::round_off(1e-12, "a cube root, and sums of a few terms of 1 m"));
  findings.expect_between("fields of the runs: largest change of speed over the requested one", std::abs(speeds), 0.98,
                          1.0 + 1e-9, "uniform within plus and minus 0.2 %, over some hundreds of runs");
  findings.expect("margin of the cable, largest deviation from its force over its strength", sizes, 0.0,
                  Tolerance::round_off(1e-12, "one division"));
  double counted = 0.0, sums = 0.0, intervals = 0.0;
  for (std::size_t row = 0; row < nodes.rows(); ++row) {
    const auto number = [&](const std::string& head) { return nodes.number(row, nodes.column(head)); };
    double ends = 0.0;
    for (const char* const end : {"stopped", "undecided", "passed_under", "passed_over", "broke_through", "failed"})
      ends += number(end);
    sums += ends - number("runs");
    counted += number("stopped");
    keep_worst(intervals,
               number("kinetic_energy [J]") / (0.5 * number("mass [kg]") * std::pow(number("speed [m/s]"), 2)) - 1.0);
    keep_worst(intervals, number("probability") - number("stopped") / number("runs"));
    const std::string state{nodes.cell(row, nodes.column("state"))};
    const bool agrees = state == "stopped" ? number("probability_low") > 0.5
                        : state == "not stopped"
                            ? number("probability_high") < 0.5
                            : number("probability_low") <= 0.5 && number("probability_high") >= 0.5;
    differ.compare("state of a node", agrees, true);
  }
  // The audit has 20 runs, also those at open nodes, which it does not count.
  differ.compare("runs of the nodes and the audit", runs.rows(), map.at("runs").get<std::size_t>() + 20);
  differ.compare("stopped runs",
                 counted <= static_cast<double>(stopped) && counted == map.at("ends").at("stopped").get<double>(),
                 true);
  findings.expect("maps: ends, energies and probabilities of nodes, largest deviation",
                  std::max(std::abs(sums), intervals), 0.0,
                  Tolerance::round_off(1e-12, "sums of whole numbers, and three products"));
}

/// The nodes of the map of one column with the closed form.
void draw_boundary(const Program& program, Findings& findings) {
  const records::Csv nodes = program.csv("map/capacity.csv");
  std::array<records::Series, 3> states;
  constexpr std::array<const char*, 3> names{"stopped", "not stopped", "open"};
  for (std::size_t i = 0; i < states.size(); ++i)
    states[i].label = names[i], states[i].style = i == 1 ? records::Style::crosses : records::Style::points;
  for (std::size_t row = 0; row < nodes.rows(); ++row) {
    const auto number = [&](const char* head) { return nodes.number(row, nodes.column(head)); };
    const auto state = std::ranges::find(names, nodes.cell(row, nodes.column("state")));
    states[static_cast<std::size_t>(state - names.begin())].add(number("mass [kg]"), number("speed [m/s]"));
  }
  records::Series exact{.label = "closed form", .style = records::Style::lines};
  for (double mass = 100.0; mass <= 800.0; mass += 5.0)
    exact.add(mass, std::sqrt(2.0 * breaking_energy(program.setup()) / mass));
  records::Figure figure{.name = "one_column",
                         .title = "Rocks that a fence of one column stops",
                         .caption =
                             "Nodes of the map where runs were executed, and the speed at which the kinetic "
                             "energy breaks both halves of the cable (line).",
                         .x = {.label = "mass", .unit = "kg"},
                         .y = {.label = "speed", .unit = "m/s"},
                         .series = {exact}};
  for (records::Series& series : states)
    if (!series.x.empty()) figure.series.push_back(std::move(series));
  findings.figure(std::move(figure));
}

/// The figures of the boundary, as gnuplot has to draw them, beside capacity.json.
void check_figures(const Program& program, Differences& differ) {
  constexpr double spin = 30.0;
  program.write("fence.toml", fence(fmt::format("spin = \"{} rad/s\"\n", spin)));
  program.write("drawn.toml", question(16, ""));
  static_cast<void>(talus_output(program.folder(), {"capacity", "drawn.toml", "--out", "drawn"},
                                 picture_options::recorded_pictures()));
  const Json map = Json::parse(program.read("drawn/capacity.json")).at("maps").at(0);
  const auto median = [](const Json& line, const char* of, const char* output) {
    return 1e-3 * line.at(of).at("outputs").at(output).at("median").at("value").get<double>();
  };
  /// Whether a curve has the point; numbers are drawn with six digits.
  const auto has = [](const picture_options::Curve& curve, double x, double y) {
    for (const auto& line : curve.lines)
      for (const picture_options::Point& point : line)
        if (std::abs(point[0] / x - 1.0) < 1e-5 && std::abs(point[1] / y - 1.0) < 1e-5) return true;
    return false;
  };
  const auto curves = [&](const char* file, std::size_t count) {
    const picture_options::Picture picture = picture_options::read_picture(program.read(file));
    std::vector<picture_options::Curve> found;
    for (const picture_options::Panel& panel : picture.panels)
      found.insert(found.end(), panel.curves.begin(), panel.curves.end());
    differ.compare(fmt::format("curves of {}", file), found.size(), count);
    found.resize(count);
    return found;
  };
  const std::vector<picture_options::Curve> forces = curves("drawn/plots/boundary_forces_1.svg", 3),
                                            energies = curves("drawn/plots/boundary_energy_1.svg", 2);
  // All curves of the map and of the forces, by the nodes of capacity.csv.
  const records::Csv nodes = program.csv("drawn/capacity.csv");
  const auto all_curves = [&](const char* file) {
    std::vector<picture_options::Curve> found;
    for (const picture_options::Panel& panel : picture_options::read_picture(program.read(file)).panels)
      found.insert(found.end(), panel.curves.begin(), panel.curves.end());
    return found;
  };
  const std::vector<picture_options::Curve> of_map = all_curves("drawn/plots/envelope_1.svg"),
                                            of_force = all_curves("drawn/plots/cable_force_1.svg");
  const auto in_any = [&](const std::vector<picture_options::Curve>& all, double x, double y) {
    return std::ranges::any_of(all, [&](const picture_options::Curve& curve) { return has(curve, x, y); });
  };
  differ.compare("curves of the forces", of_force.size(), std::size_t{2});
  for (std::size_t row = 0; row < nodes.rows(); ++row) {
    const auto number = [&](const char* head) { return nodes.number(row, nodes.column(head)); };
    const double mass = number("mass [kg]"), energy = 1e-3 * number("kinetic_energy [J]");
    differ.compare("a drawn node", in_any(of_map, mass, number("speed [m/s]")), true);
    // Light and heavy rocks, up to and from the middle of the masses.
    if (of_force.size() == 2)
      differ.compare("a drawn force",
                     has(of_force[mass < 450.0 ? 0 : 1], energy, 1e-3 * number("fence.cable_force.median [N]")), true);
  }
  std::size_t lines = 0;
  for (const picture_options::Curve& curve : of_map) {
    if (!curve.label.ends_with(" kJ")) continue;
    ++lines;
    const double energy = 1e3 * std::stod(curve.label);
    for (const auto& line : curve.lines)
      for (const picture_options::Point& point : line)
        differ.compare("a line of equal energy", std::abs(0.5 * point[0] * point[1] * point[1] / energy - 1.0) < 6e-3,
                       true);
  }
  // A quarter of the energy at the middle of the right side, and that energy; of four times as much there is one point.
  differ.compare("lines of equal energy", lines, std::size_t{2});
  for (const Json& line : map.at("boundary")) {
    const double mass = line.at("mass").get<double>(), high = line.at("speed").at(1).get<double>();
    differ.compare("drawn anchor force", has(forces[0], mass, median(line, "stopped", "fence.anchor_force")), true);
    differ.compare("drawn cable force", has(forces[1], mass, median(line, "stopped", "fence.cable_force")), true);
    differ.compare("drawn hanger force", has(forces[2], mass, median(line, "stopped", "fence.hanger_force")), true);
    const double radius = own_radius * std::cbrt(mass / own_mass), turning = 0.4 * mass * radius * radius;
    differ.compare("drawn energy at the start",
                   has(energies[0], mass, 0.5e-3 * (mass * high * high + turning * spin * spin)), true);
    differ.compare("drawn energy after", has(energies[1], mass, median(line, "not_stopped", "fence.exit_energy")),
                   true);
  }
}

/// Maps that are stopped, or not, up to an end: no speed there.
void check_ends(const Program& program, Differences& differ) {
  const double energy = breaking_energy(program.setup());
  program.write("fence.toml", fence(guided));
  const auto boundary = [&](const std::string& name, const char* low, const char* high) {
    std::string text = question(8, "");
    text.replace(text.find("2 m/s"), 5, low);
    text.replace(text.find("12 m/s"), 6, high);
    program.write(name + ".toml", text);
    return program.json({"capacity", name + ".toml"}, {{"--no-plots", {}}, {"--json", {}}})
        .at("maps")
        .at(0)
        .at("boundary");
  };
  for (const Json& line : boundary("fast", "5 m/s", "13 m/s")) {
    const double mass = line.at("mass").get<double>(), exact = std::sqrt(2.0 * energy / mass);
    const bool is_below = exact < 4.9;
    differ.compare("a mass of which none is stopped", line.at("speed").at(0) == Json(0.0), is_below);
    differ.compare("its energy", line.at("kinetic_energy").at(0) == Json(0.0), is_below);
    differ.compare("its runs", line.at("stopped").is_null(), is_below);
  }
  for (const Json& line : boundary("slow", "1 m/s", "5.5 m/s")) {
    const bool is_above = std::sqrt(2.0 * energy / line.at("mass").get<double>()) > 5.7;
    differ.compare("a mass of which all are stopped", line.at("speed").at(1).is_null(), is_above);
    differ.compare("its last runs", line.at("not_stopped").is_null(), is_above);
  }
}

/// The same bytes for any number of threads, and after results were lost.
void check_bytes(const Program& program, Findings& findings, Differences& differ) {
  program.write("bytes.toml", question(8, ""));
  const auto bytes = [&](const std::string& name) {
    return program.read(name + "/capacity.csv") + program.read(name + "/capacity.json");
  };
  double differing = 0.0;
  const auto run = [&](const std::string& name, const std::string& threads) {
    static_cast<void>(
        program.run({"capacity", "bytes.toml"}, {{"--no-plots", {}}, {"--out", {name}}, {"--threads", {threads}}}));
  };
  run("one", "1");
  const std::string expected = bytes("one");
  run("two", "2");
  if (bytes("two") != expected) differing += 1.0;
  const std::string file = program.files("two/results").front();
  const std::string text = program.read(file);
  program.write(file, text.substr(0, text.size() / 2));
  run("two", "2");
  if (bytes("two") != expected) differing += 1.0;
  // A finer map keeps the runs of the coarse one.
  const auto lines_of = [&](const std::string& name) { return std::ranges::count(program.read(name), '\n'); };
  const auto before = lines_of("one/manifest.jsonl");
  program.write("bytes.toml", question(16, ""));
  run("finer", "2");
  const auto alone = lines_of("finer/manifest.jsonl");
  run("one", "2");
  if (bytes("one") != bytes("finer")) differing += 1.0;
  std::ptrdiff_t lines = 0;
  for (const std::string& results : program.files("one/results"))
    lines += lines_of(results);
  differ.compare("runs of a coarse map that a finer one needs again", lines < before + alone && lines >= alone, true);
  findings.expect("results that differ in a byte, by threads and lost results", differing, 0.0,
                  Tolerance::exact("random numbers follow from the seed, the node and the number of the trial"));
}

/// The probability of failure of lognormal speeds beside the closed form.
void check_hazard(const Program& program, Findings& findings, Differences& differ) {
  const Setup& setup = program.setup();
  const int runs = setup.coarse ? 300 : 600;
  const double p95 = 9.0, p99 = 12.0, z95 = 1.6448536269514722, z99 = 2.3263478740408408;
  const double deviation = std::log(p99 / p95) / (z99 - z95), mean = std::log(p95) - z95 * deviation;
  const double speed = std::sqrt(2.0 * breaking_energy(setup) / own_mass);
  const double exact = 0.5 * std::erfc((std::log(speed) - mean) / (std::numbers::sqrt2 * deviation));
  program.write("hazard.toml",
                question(4, fmt::format("[hazard]\nmass = \"200 kg\"\nspeed = {{ p95 = \"9 m/s\", p99 = \"12 m/s\" }}\n"
                                        "height = \"4.5 m\"\nruns = {}\n",
                                        runs)));
  const Json found = program.json({"capacity", "hazard.toml"}, {{"--no-plots", {}}, {"--json", {}}}).at("hazard");
  const double probability = found.at("probability_of_failure").get<double>();
  findings.expect("expected rocks: probability of failure, deviation from the closed form",
                  (probability - exact) / std::sqrt(exact * (1.0 - exact) / runs), 0.0,
                  Tolerance::model(4.0, "in standard deviations of that many runs"));
  differ.compare("runs of the hazard", found.at("runs").get<int>(), runs);
  differ.compare(
      "interval of the hazard",
      found.at("interval").at(0).get<double>() < probability && found.at("interval").at(1).get<double>() > probability,
      true);

  // Two equally probable rocks of a table, of which one is stopped.
  program.write("rocks.csv", "height [m],mass [kg],speed [m/s]\n4.5,200,4\n4.5,200,11\n");
  program.write("table.toml", question(4, "[hazard]\ntable = \"rocks.csv\"\nruns = 200\n"));
  const Json table = program.json({"capacity", "table.toml"}, {{"--no-plots", {}}, {"--json", {}}}).at("hazard");
  findings.expect("expected rocks: probability of failure of a table, deviation from one half",
                  (table.at("probability_of_failure").get<double>() - 0.5) / std::sqrt(0.25 / 200.0), 0.0,
                  Tolerance::model(4.0, "in standard deviations of 200 runs"));
  const Json& forces = table.at("outputs").at("fence.cable_force");
  differ.compare("force that broke the cable",
                 std::abs(forces.at("p95").at("value").get<double>() / strength - 1.0) < 0.01, true);
}

/// A rock that is higher, turned and spun within the requested changes; text, figures and exit status.
void check_changes(const Program& program, Differences& differ) {
  program.write("fence.toml", fence("spin = \"2 rad/s\"\nangle = \"0.5 rad\"\n"));
  program.write("changes.toml",
                "base = \"fence.toml\"\nmass = [\"100 kg\", \"800 kg\"]\nspeed = [\"2 m/s\", \"4 m/s\"]\n"
                "height = [\"4.25 m\", \"4.75 m\"]\n[map]\ncells = 1\nfirst_cells = 1\nruns = 4\naudit = 0\n"
                "[changes]\nspeed = 0.0\nheight = \"0.125 m\"\nangle = \"0.25 rad\"\nspin = \"1 rad/s\"\n");
  const std::string text = program.run({"capacity", "changes.toml"}, {});
  differ.compare("text", text.find("height 4.25 m: 16 runs (100 % of the full grid)") != std::string::npos, true);
  for (const char* const file : {"envelope_1.svg", "envelope_2.pdf", "cable_force_1.svg"})
    differ.compare("figure", program.has(fmt::format("changes/plots/{}", file)), true);
  static_cast<void>(program.run({"sweep", "collect", "changes"}, {}));
  const records::Csv runs = program.csv("changes/results.csv");
  double highest = 0.0, angle = 0.0, spin = 0.0;
  for (std::size_t row = 0; row < runs.rows(); ++row) {
    const auto number = [&](const std::string& head) { return runs.number(row, runs.column(head)); };
    highest = std::max(highest, std::abs(std::abs(number("fence.rock[0].position[1] [m]")) - 0.25));
    angle = std::max(angle, std::abs(number("fence.rock[0].angle [rad]") - 0.5));
    spin = std::max(spin, std::abs(number("fence.rock[0].spin [rad/s]") - 2.0));
  }
  differ.compare("rows", runs.rows(), std::size_t{32});
  differ.compare("heights", highest > 0.09 && highest <= 0.125, true);
  differ.compare("angles", angle > 0.18 && angle <= 0.25, true);
  differ.compare("spins", spin > 0.7 && spin <= 1.0, true);
  program.write("limited.toml", question(4, "[limits]\nevaluations = 10\n"));
  const ProgramEnd limited = program.end({"capacity", "limited.toml"}, {{"--no-plots", {}}});
  differ.compare("all runs failed", limited.exit_code, 3);
  differ.compare("reason of a failure",
                 limited.output.find("  failed, for example: limit of 10 evaluations\n") != std::string::npos, true);
  const ProgramEnd other = program.end({"capacity", "limited.toml"}, {{"--no-plots", {}}, {"--out", {"changes"}}});
  differ.compare("results of other limits are refused",
                 other.exit_code == 2 && other.messages.find("other limits") != std::string::npos, true);
}

/// Spins, and positions along the fence in the full model: a map for each combination, expected rocks between two ends.
void check_positions(const Program& program, Differences& differ) {
  program.write("full.toml", fence("", "symmetry = \"full\"\n"));
  program.write("positions.toml",
                "base = \"full.toml\"\nmass = [\"100 kg\", \"800 kg\"]\nspeed = [\"2 m/s\", \"4 m/s\"]\n"
                "spin = [\"-1 rad/s\", \"3 rad/s\"]\nalong = [\"-0.25 m\", \"0.125 m\"]\n[map]\ncells = 1\n"
                "first_cells = 1\nruns = 4\naudit = 0\n[changes]\nalong = \"0.0625 m\"\n[hazard]\nmass = \"150 kg\"\n"
                "speed = \"3 m/s\"\nheight = \"4.5 m\"\nspin = [\"5 rad/s\", \"7 rad/s\"]\n"
                "along = [\"-0.3 m\", \"0.3 m\"]\nruns = 200\n");
  const std::string text = program.run({"capacity", "positions.toml"}, {{"--sheet", {}}});
  for (const char* const name :
       {"height 4.5 m, spin -1 rad/s, along -0.25 m: 16 runs", "height 4.5 m, spin 3 rad/s, along 0.125 m: 16 runs"})
    differ.compare(fmt::format("map of {}", name), text.find(name) != std::string::npos, true);
  static_cast<void>(program.run({"sweep", "collect", "positions"}, {}));
  const records::Csv placed = program.csv("positions/results.csv"), maps = program.csv("positions/capacity.csv");
  double shift = 0.0, farthest = 0.0, mean_spin = 0.0, widest = 0.0;
  std::size_t expected = 0;
  for (std::size_t row = 0; row < placed.rows(); ++row) {
    const auto number = [&](const std::string& head) { return placed.number(row, placed.column(head)); };
    const double along = number("fence.rock[0].along [m]"), turning = number("fence.rock[0].spin [rad/s]");
    if (turning > 4.0) {
      ++expected, mean_spin += turning, widest = std::max(widest, std::abs(along));
      differ.compare("spin of an expected rock", turning >= 5.0 && turning <= 7.0, true);
      continue;
    }
    const double change = std::min(std::abs(along + 0.25), std::abs(along - 0.125));
    shift = std::max(shift, change), farthest = std::max(farthest, std::abs(along));
    differ.compare("spin of a map", turning == -1.0 || turning == 3.0, true);
  }
  differ.compare("expected rocks", expected, std::size_t{200});
  differ.compare("mean spin of the expected rocks", std::abs(mean_spin / 200.0 - 6.0) < 4.0 * 0.5774 / std::sqrt(200.0),
                 true);
  differ.compare("positions of the expected rocks", widest > 0.3 && widest <= 0.3625, true);
  differ.compare("positions of the maps", shift > 0.05 && shift <= 0.0625 && farthest > 0.27, true);
  differ.compare("rows of four maps", maps.rows(), std::size_t{16});
  differ.compare(
      "spin and position of a node",
      maps.number(0, maps.column("spin [rad/s]")) == -1.0 && maps.number(4, maps.column("along [m]")) == 0.125, true);
  // Rocks of a table with their spin and position.
  program.write("spinning.csv", "along [m],mass [kg],spin [rad/s],speed [m/s],height [m]\n0.2,150,6,3,4.5\n");
  program.write("table.toml",
                "base = \"full.toml\"\nmass = [\"100 kg\", \"800 kg\"]\nspeed = [\"2 m/s\", \"4 m/s\"]\n[map]\n"
                "cells = 1\nfirst_cells = 1\nruns = 4\naudit = 0\n[hazard]\ntable = \"spinning.csv\"\nruns = 3\n");
  static_cast<void>(program.run({"capacity", "table.toml"}, {{"--no-plots", {}}, {"--out", {"spinning"}}}));
  static_cast<void>(program.run({"sweep", "collect", "spinning"}, {}));
  const records::Csv spinning = program.csv("spinning/results.csv");
  std::size_t of_table = 0;
  for (std::size_t row = 0; row < spinning.rows(); ++row) {
    of_table += spinning.number(row, spinning.column("fence.rock[0].along [m]")) == 0.2 &&
                        spinning.number(row, spinning.column("fence.rock[0].spin [rad/s]")) == 6.0
                    ? 1
                    : 0;
  }
  differ.compare("rocks of a table with spin and position", of_table, std::size_t{3});
  const std::string sheet = program.read("positions/capacity.html");
  differ.compare("page to print",
                 program.has("positions/capacity.pdf") &&
                     sheet.find("Probability of failure per impact: ") != std::string::npos &&
                     sheet.find("4.5 m, 3 rad/s, at 0.125 m") != std::string::npos,
                 true);
}

/// A base in US units that gives the density, on an inclined ground.
void check_us_base(const Program& program, Differences& differ) {
  std::string inclined = records::read_whole(fs::path{TALUS_CASES} / "capacity" / "fence.toml");
  inclined.replace(inclined.find("duration = \"2 s\""), 16, "duration = \"0.01 s\"");
  inclined.replace(inclined.find("position = [\"0 ft\", \"-5 ft\"]"), 28,
                   "angle = \"10 deg\"\nposition = [\"0 ft\", \"-5 ft\"]");
  program.write("inclined.toml", inclined);
  program.write("us.toml",
                "base = \"inclined.toml\"\nmass = [\"600 lb\", \"2400 lb\"]\nspeed = [\"20 ft/s\", \"100 ft/s\"]\n"
                "height = \"6 ft\"\n[map]\ncells = 1\nfirst_cells = 1\nruns = 4\naudit = 0\n");
  static_cast<void>(program.run({"capacity", "us.toml"}, {{"--no-plots", {}}}));
  static_cast<void>(program.run({"sweep", "collect", "us"}, {}));
  const records::Csv steep = program.csv("us/results.csv");
  double raised = 0.0, sized = 0.0;
  constexpr double foot = 0.3048, own_half = 0.953951 * foot, slope = 10.0 * std::numbers::pi / 180.0;
  const double heavy = own_half * std::cbrt(2400.0 * 0.45359237 /
                                            (5.127408 * 14.593902937206365 / (foot * foot * foot) * 4.0 / 3.0 *
                                             std::numbers::pi * own_half * own_half * own_half));
  for (std::size_t row = 0; row < steep.rows(); ++row) {
    const auto number = [&](const std::string& head) { return steep.number(row, steep.column(head)); };
    const double x = number("fence.rock[0].position[0] [m]"), y = number("fence.rock[0].position[1] [m]");
    // The surface passes through the middle of the block's upper side; heights are perpendicular to it.
    const double surface =
        -5.0 * foot + 0.5 * foot * std::cos(slope) + std::tan(slope) * (x + 0.5 * foot * std::sin(slope));
    keep_worst(raised, (y - surface) * std::cos(slope) - 6.0 * foot);
    sized = std::max(sized, number("fence.rock[0].a [m]"));
  }
  differ.compare("height above an inclined ground", std::abs(raised) < 1e-9, true);
  differ.compare("size of a rock of another mass", std::abs(sized / heavy - 1.0) < 1e-9, true);
}

void check_refusals(const Program& program, Differences& differ) {
  program.write("fence.toml", fence(guided));
  program.write("ball.toml", program.run({"new", "scene"}, {}));
  std::string falling = fence("");
  falling.replace(falling.find("-5 m/s\", \"0 m/s"), 15, "0 m/s\", \"-5 m/s");
  program.write("falling.toml", falling);
  program.write("bad.csv", "mass [kg],speed [m/s]\n1,1\n");
  program.write("zero.csv", "mass [kg],speed [m/s],height [m]\n1,0,1\n");
  program.write("positions.csv", "mass [kg],speed [m/s],height [m],along [m]\n1,1,1,1\n");
  program.write("infinite.csv", "mass [kg],speed [m/s],height [m]\n1,1,inf\n");
  program.write("empty.csv", "mass [kg],speed [m/s],height [m]\n");
  const std::string mass = "mass = [\"1 kg\", \"2 kg\"]\n", speed = "speed = [\"1 m/s\", \"2 m/s\"]\n",
                    good = "base = \"fence.toml\"\n" + mass + speed;
  struct Wrong {
    std::string text, message;
    int exit_code{2};
  };
  const std::vector<Wrong> wrong{
      {"base = ", "wrong.toml:1: not TOML"},
      {mass + speed, "base: it is missing"},
      {"base = \"none.toml\"\n" + mass + speed, "none.toml: No such file", 4},
      {"base = \"ball.toml\"\n" + mass + speed, "ball.toml: it must be a fence, with a table [fence]"},
      {"base = \"falling.toml\"\n" + mass + speed,
       "rock: velocity: found none along x; it must move towards the fence"},
      {"base = \"fence.toml\"\n" + speed, "mass: it is missing"},
      {"base = \"fence.toml\"\nmass = [\"2 kg\", \"1 kg\"]\n" + speed,
       "wrong.toml:2: mass: found [\"2 kg\", \"1 kg\"]; both must be > 0"},
      {"base = \"fence.toml\"\nmass = [\"1 kg\", \"2 m\"]\n" + speed, "wrong.toml:2: mass: "},
      {good + "height = []\n", "wrong.toml:4: height: found []; it must have a quantity"},
      {good + "height = [\"-1 m\"]\n", "wrong.toml:4: height[0]: found \"-1 m\"; it must be > 0"},
      {good + "height = [3]\n", "wrong.toml:4: height[0]: found 3; the unit is missing"},
      {good + "spin = [\"1 m\"]\n", "wrong.toml:4: spin[0]: "},
      {good + "along = \"1 m\"\n",
       "fence.toml: [fence.options]: symmetry: found \"half\"; positions along the fence need \"full\""},
      {good + "[changes]\nalong = \"1 m\"\n", "positions along the fence need"},
      {good + "[hazard]\ntable = \"positions.csv\"\n", "positions along the fence need"},
      {good + "[hazard]\ntable = \"positions.csv\"\nalong = \"1 m\"\n", "hazard: along: the rows of the table give it"},
      {good + "[hazard]\ntable = \"infinite.csv\"\n",
       "infinite.csv:2: column 'height [m]': found 'inf'; it must be a finite number"},
      {good + "[hazard]\nmass = \"1 kg\"\nspeed = \"1 m/s\"\nheight = \"1 m\"\nspin = [\"2 rad/s\", \"1 rad/s\"]\n",
       "hazard: spin: found [\"2 rad/s\", \"1 rad/s\"]; the first must be at most the second"},
      {good + "heigth = \"1 m\"\n", "wrong.toml:4: heigth: "},
      {good + "set = 3\n", "wrong.toml:4: set: it must be a table of fields"},
      {good + "set = { \"fence.colums\" = 3 }\n", "colums"},
      {good + "[map]\ncells = 24\nfirst_cells = 5\n",
       "found 24 cells, 5 at first; the first must be a power of two times the second"},
      {good + "[map]\nruns = 4\nfew_runs = 5\n",
       "wrong.toml:6: map: few_runs: found 5; it must be at most the runs of a node, 4"},
      {good + "[changes]\nspeed = 2\n", "changes: speed: found 2"},
      {good + "[changes]\nangle = \"1 m\"\n", "changes: angle: "},
      {good + "[hazard]\nmass = \"1 kg\"\nspeed = \"1 m/s\"\n", "hazard: height: it is missing"},
      {good + "[hazard]\nmass = \"1 kg\"\nheight = \"1 m\"\nspeed = { p95 = \"2 m/s\", p99 = \"1 m/s\" }\n",
       "less than the percentile of 95 %"},
      {good + "[hazard]\ntable = \"bad.csv\"\n", "the column \"height [m]\" is missing"},
      {good + "[hazard]\ntable = \"zero.csv\"\n", "zero.csv:2: mass and speed must be > 0"},
      {good + "[hazard]\ntable = \"empty.csv\"\n", "found no line below the header"},
      {good + "[hazard]\ntable = \"none.csv\"\n", "none.csv", 4},
      {good + "[hazard]\ntable = \"bad.csv\"\nmass = \"1 kg\"\n", "hazard: mass: the rows of the table give it"}};
  for (const Wrong& of : wrong) {
    program.write("wrong.toml", of.text);
    const ProgramEnd end = program.end({"capacity", "wrong.toml"}, {});
    differ.compare("refusal: " + of.message,
                   end.exit_code == of.exit_code && end.messages.find(of.message) != std::string::npos, true);
  }
  fs::create_directory(program.folder().path() / "other");
  program.write("other/base.toml", "");
  program.write("wrong.toml", good);
  const ProgramEnd other = program.end({"capacity", "wrong.toml"}, {{"--out", {"other"}}});
  differ.compare(
      "refusal: a folder of something else",
      other.exit_code == 2 &&
          other.messages.find("other: found base.toml of something else; give another folder") != std::string::npos &&
          program.read("other/base.toml").empty(),
      true);
  differ.compare("nothing is written of a wrong question", program.has("wrong/sweep.json"), false);
}

void run(Findings& findings, const Setup& setup) {
  const auto group = findings.in("capacity");
  const Program program{setup};
  Differences differ;
  if (setup.needs("Wilson") || setup.needs("quantiles")) check_coverage(findings, setup);
  if (setup.needs("maps")) check_maps(findings, setup);
  if (setup.needs("one column") || setup.needs("fields") || setup.needs("outputs")) {
    check_boundary(program, findings, differ);
    draw_boundary(program, findings);
  }
  if (setup.needs("expected rocks")) check_hazard(program, findings, differ);
  if (setup.needs("differ in a byte")) check_bytes(program, findings, differ);
  if (setup.needs("outputs that differ")) {
    check_changes(program, differ);
    check_figures(program, differ);
    check_ends(program, differ);
    check_positions(program, differ);
    check_us_base(program, differ);
    check_refusals(program, differ);
  }
  differ.expect_none(findings, "outputs that differ from the request", "numbers, texts, files and refusals");
}

}  // namespace

Case definition() {
  const std::string boundary = "one column: speeds at which the cable breaks outside of the boundary, number",
                    coverage = "Wilson intervals: coverage over 1,000 seeds, largest deviation from the exact one",
                    maps = "maps: nodes whose state contradicts the interval of the full grid",
                    hazard = "expected rocks: probability of failure, deviation from the closed form";
  return {.id = "fence_capacity",
          .title = "What a fence stops",
          .requirements = {{"G16", {"capacity"}}},
          .main_checks = {boundary, hazard, coverage, "outputs that differ from the request"},
          .source = "Wilson 1927",
          .faults = {{"one_half", "energy of one half of the cable alone", boundary},
                     {"normal_interval", "p +- 1.96 sqrt(p (1 - p)/n) in place of Wilson's interval", coverage},
                     {"other_line", "the map's probability is shifted by six cells", maps}},
          .seconds = 12.0,
          .time_limit = 240.0,
          .run = run};
}

}  // namespace talus::verification::problems::fence_capacity
