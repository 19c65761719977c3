#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "verification/check/case.hpp"
#include "verification/check/case_file.hpp"
#include "verification/problems/program/capacity/capacity_refusals.hpp"
#include "verification/problems/program/capacity/capacity_statistics.hpp"
#include "verification/problems/program/capacity/drawn_capacity.hpp"
#include "verification/problems/program/capacity/expected_rocks.hpp"
#include "verification/problems/program/capacity/one_column.hpp"
#include "verification/record/csv.hpp"
#include "verification/record/json_node.hpp"
#include "verification/record/whole_file.hpp"
#include "verification/study/findings/expectations.hpp"
#include "verification/study/program/program_options.hpp"
#include "verification/study/program/program_run.hpp"

namespace talus::verification::problems::fence_capacity {
namespace {

using records::Json;

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
    differ.holds("energy of a boundary",
                 std::abs(line.at("kinetic_energy").at(0).get<double>() / (0.5 * mass * low * low) - 1.0) < 1e-12);
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
    differ.holds("runs at the boundary",
                 stopped.at("ends").at("stopped").get<int>() > passed.at("ends").at("stopped").get<int>());
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
  differ.holds("height of the base's rock", std::abs(map.at("height").get<double>() + ground_top) < 1e-12);
  differ.compare("audit", map.at("audit").at("contradictions").get<int>(), 0);
  differ.contains("printed audit", program.run({"capacity", "map.toml"}, {{"--no-plots", {}}}),
                  "  audit: 0 of 20 runs at nodes without any ended otherwise than the map says\n");
  differ.holds("rock of the base", std::abs(found.at("rock").at("mass").get<double>() - own_mass) < 1e-9);

  // Each run, as a sweep lists it.
  program.run({"sweep", "collect", "map"});
  const records::Csv runs = program.csv("map/results.csv"), nodes = program.csv("map/capacity.csv");
  double geometry = 0.0, speeds = 0.0, sizes = 0.0;
  std::size_t stopped = 0;
  std::vector<double> changes;
  for (std::size_t row = 0; row < runs.rows(); ++row) {
    const auto number = [&](const std::string& head) { return runs.number(row, head); };
    const double radius = own_radius * std::cbrt(number("fence.rock[0].mass [kg]") / own_mass);
    keep_worst(geometry, number("fence.rock[0].a [m]") / radius - 1.0);
    keep_worst(geometry, number("fence.rock[0].b [m]") / radius - 1.0);
    keep_worst(geometry, number("fence.rock[0].position[0] [m]") - (own_x + radius - own_radius));
    keep_worst(geometry, number("fence.rock[0].position[1] [m]"));
    // Speeds lie on the grid, but for the changes.
    const double spacing = 10.0 / cells, speed = -number("fence.rock[0].velocity[0] [m/s]");
    const double change = speed / (2.0 + spacing * std::round((speed - 2.0) / spacing)) - 1.0;
    keep_worst(speeds, change / 0.002);
    changes.push_back(change);
    keep_worst(sizes, number("fence.cable_margin") - number("fence.cable_force [N]") / strength);
    stopped += runs.cell(row, "verdict") == "stopped" ? 1 : 0;
  }
  // Some 500 uniform numbers: the nearest two are some 1e-8 apart; those of one node in another's place are equal.
  std::ranges::sort(changes);
  const auto equal =
      std::ranges::adjacent_find(changes, [](double below, double above) { return above - below < 1e-13; });
  differ.holds("random numbers of one trial in another", equal == changes.end());
  findings.expect("fields of the runs: size and place of the rock, largest deviation", geometry, 0.0,
                  Tolerance::round_off(1e-12, "a cube root, and sums of a few terms of 1 m"));
  findings.expect_between("fields of the runs: largest change of speed over the requested one", std::abs(speeds), 0.98,
                          1.0 + 1e-9, "uniform within plus and minus 0.2 %, over some hundreds of runs");
  findings.expect("margin of the cable, largest deviation from its force over its strength", sizes, 0.0,
                  Tolerance::round_off(1e-12, "one division"));
  double counted = 0.0, worst = 0.0;
  for (std::size_t row = 0; row < nodes.rows(); ++row) {
    const auto number = [&](const std::string& head) { return nodes.number(row, head); };
    double ends = 0.0;
    for (const char* const end : {"stopped", "undecided", "passed_under", "passed_over", "broke_through", "failed"})
      ends += number(end);
    keep_worst(worst, ends - number("runs"));
    counted += number("stopped");
    keep_worst(worst,
               number("kinetic_energy [J]") / (0.5 * number("mass [kg]") * std::pow(number("speed [m/s]"), 2)) - 1.0);
    keep_worst(worst, number("probability") - number("stopped") / number("runs"));
    const std::string state{nodes.cell(row, "state")};
    const bool agrees = state == "stopped" ? number("probability_low") > 0.5
                        : state == "not stopped"
                            ? number("probability_high") < 0.5
                            : number("probability_low") <= 0.5 && number("probability_high") >= 0.5;
    differ.holds("state of a node", agrees);
  }
  // The audit has 20 runs, also those at open nodes, which it does not count.
  differ.compare("runs of the nodes and the audit", runs.rows(), map.at("runs").get<std::size_t>() + 20);
  differ.holds("stopped runs",
               counted <= static_cast<double>(stopped) && counted == map.at("ends").at("stopped").get<double>());
  findings.expect("maps: ends, energies and probabilities of nodes, largest deviation", worst, 0.0,
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
    const auto number = [&](const char* head) { return nodes.number(row, head); };
    const auto state = std::ranges::find(names, nodes.cell(row, "state"));
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

/// "4.1 to 4.3", or "below 4.3" and "above 4.1" where an end is not in the map, in a unit of this size.
std::string printed_range(const Json& range, double unit) {
  const auto number = [&](std::size_t end) { return fmt::format("{:.4g}", range.at(end).get<double>() / unit); };
  if (range.at(1).is_null()) return "above " + number(0);
  return range.at(0) == Json(0.0) ? "below " + number(1) : number(0) + " to " + number(1);
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
    const std::string printed = squeezed(program.run({"capacity", name + ".toml"}, {{"--no-plots", {}}}));
    Json lines = program.file(name + "/capacity.json").at("maps").at(0).at("boundary");
    for (const Json& line : lines) {
      differ.contains("printed boundary", printed,
                      fmt::format(" {:.4g} {} {} ", line.at("mass").get<double>(), printed_range(line.at("speed"), 1.0),
                                  printed_range(line.at("kinetic_energy"), 1000.0)));
    }
    return lines;
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
  // In cells of 1 m/s from 4.4 m/s on, no node is closer than 0.3 m/s to the speed at which the cable breaks for one of
  // the five masses listed, which the changes of a node and the column vary by less than 0.1 m/s: a mass is stopped up
  // to the last node below its speed.
  constexpr double lowest = 4.4;
  std::size_t at_lowest = 0;
  for (const Json& line : boundary("lowest", "4.4 m/s", "12.4 m/s")) {
    const double mass = line.at("mass").get<double>(), exact = std::sqrt(2.0 * energy / mass);
    const double last = exact < lowest ? 0.0 : lowest + std::floor(exact - lowest);
    differ.holds("speed up to which a mass is stopped", std::abs(line.at("speed").at(0).get<double>() - last) < 1e-12);
    differ.holds("energy up to which a mass is stopped",
                 std::abs(line.at("kinetic_energy").at(0).get<double>() - 0.5 * mass * last * last) < 1e-9);
    at_lowest += last == lowest ? 1 : 0;
  }
  differ.compare("masses that are stopped at the lowest speed alone", at_lowest, std::size_t{1});
}

/// Rocks whose centre is 0.25 m above the column: the lightest, whose radius is 0.238 m, pass over it at any energy.
void check_factor(const Program& program, Differences& differ) {
  program.write("fence.toml", fence(guided));
  program.write("over.toml", question(4, fmt::format("height = \"{} m\"\n", 1.25 - ground_top)));
  const double slowest = 0.5 * 100.0 * 2.0 * 2.0;
  const std::string text = program.run({"capacity", "over.toml"}, {{"--no-plots", {}}});
  const Json map = program.file("over/capacity.json").at("maps").at(0);
  double stopped = 0.0;
  for (const Json& line : map.at("boundary"))
    stopped = std::max(stopped, line.at("kinetic_energy").at(0).get<double>());
  const double factor = map.at("energy_factor").get<double>();
  differ.holds("factor between energies of masses", std::abs(factor / (stopped / slowest) - 1.0) < 1e-12);
  // One cell below the breaking energy of the other masses is at least half of it.
  differ.holds("size of the factor between energies", factor > 0.5 * breaking_energy(program.setup()) / slowest);
  differ.contains("printed factor between energies", text,
                  fmt::format("differs by a factor of {:.3g} between masses\n", factor));
}

/// The same bytes for any number of threads, and after results were lost.
void check_bytes(const Program& program, Findings& findings, Differences& differ) {
  program.write("bytes.toml", question(8, ""));
  const auto bytes = [&](const std::string& name) {
    return program.read(name + "/capacity.csv") + program.read(name + "/capacity.json");
  };
  double differing = 0.0;
  const auto run = [&](const std::string& name, const std::string& threads) {
    program.run({"capacity", "bytes.toml"}, {{"--no-plots", {}}, {"--out", {name}}, {"--threads", {threads}}});
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
  const auto runs_of = [&](const std::string& name) {
    std::map<std::pair<double, double>, double> runs;
    const records::Csv nodes = program.csv(name + "/capacity.csv");
    for (std::size_t row = 0; row < nodes.rows(); ++row)
      runs[{nodes.number(row, "mass [kg]"), nodes.number(row, "speed [m/s]")}] = nodes.number(row, "runs");
    return runs;
  };
  const auto coarse = runs_of("one");
  program.write("bytes.toml", question(16, ""));
  run("finer", "2");
  const auto alone = lines_of("finer/manifest.jsonl");
  run("one", "2");
  if (bytes("one") != bytes("finer")) differing += 1.0;
  std::ptrdiff_t lines = 0;
  for (const std::string& results : program.files("one/results"))
    lines += lines_of(results);
  double shared = 0.0;
  for (const auto& [node, runs] : runs_of("finer"))
    if (const auto found = coarse.find(node); found != coarse.end()) shared += std::min(runs, found->second);
  // Both begin with 25 nodes of 4 runs each.
  differ.holds("runs of a coarse map that a finer one has, too", shared >= 100.0);
  // The audit can have more in common.
  differ.holds("runs of a coarse map that a finer one needs again",
               static_cast<double>(lines) <= static_cast<double>(before + alone) - shared && lines >= alone);
  findings.expect("results that differ in a byte, by threads and lost results", differing, 0.0,
                  Tolerance::exact("random numbers follow from the seed, the node and the number of the trial"));
}

/// Rocks that are not stopped at nodes of which the map says, from others, that they are: with speeds that are changed
/// by 10 % close below the boundary, some of them.
void check_audit(const Program& program, Differences& differ) {
  constexpr double lightest = 198.0, heaviest = 200.0;
  constexpr int audited = 200;
  const double limit = std::sqrt(2.0 * breaking_energy(program.setup()) / heaviest);
  program.write("fence.toml", fence(guided));
  program.write("audited.toml",
                fmt::format("base = \"fence.toml\"\nmass = [\"{} kg\", \"{} kg\"]\nspeed = [\"{} m/s\", \"{} m/s\"]\n"
                            "set = {{ \"fence.options.strength_top\" = \"{} N\" }}\n"
                            "[map]\ncells = 8\nfirst_cells = 1\nruns = 20\naudit = {}\n[changes]\nspeed = 0.1\n",
                            lightest, heaviest, 0.91 * limit, 0.93 * limit, strength, audited));
  const std::string printed = program.run({"capacity", "audited.toml"}, {{"--no-plots", {}}});
  const Json map = program.file("audited/capacity.json").at("maps").at(0), audit = map.at("audit");
  program.run({"sweep", "collect", "audited"});
  const records::Csv runs = program.csv("audited/results.csv"), nodes = program.csv("audited/capacity.csv");
  int not_stopped = 0;
  for (std::size_t row = 0; row < runs.rows(); ++row)
    not_stopped += runs.cell(row, "verdict") == "stopped" ? 0 : 1;
  for (std::size_t row = 0; row < nodes.rows(); ++row) {
    if (!nodes.cell(row, "runs").empty())
      not_stopped -= static_cast<int>(nodes.number(row, "runs") - nodes.number(row, "stopped"));
  }
  differ.holds("rocks of the audit that are not stopped", not_stopped > 2 && not_stopped < audited / 5);
  differ.compare("contradictions of the audit", audit.at("contradictions").get<int>(), not_stopped);
  differ.contains("printed contradictions", printed,
                  fmt::format("  audit: {} of {} runs at nodes", not_stopped, audited));
  differ.compare("ends of the audit", audit.at("ends").at("stopped").get<int>(), audited - not_stopped);
  // Wilson's interval: the roots of (k - n p)^2 = z^2 n p (1 - p).
  constexpr double z2 = 1.959963984540054 * 1.959963984540054, n = audited;
  const double k = not_stopped, half = std::sqrt(z2 * (k * (n - k) / n + 0.25 * z2));
  differ.holds("interval of the contradictions",
               std::abs(audit.at("interval").at(0).get<double>() - (k + 0.5 * z2 - half) / (n + z2)) < 1e-12 &&
                   std::abs(audit.at("interval").at(1).get<double>() - (k + 0.5 * z2 + half) / (n + z2)) < 1e-12);
}

/// Margins of hangers that have a force: without a limit, then with one that the same forces do not reach.
void check_margins(const Program& program, Differences& differ) {
  program.write("margins.toml", question(4,
                                         "[hazard]\nmass = \"200 kg\"\nspeed = \"4 m/s\"\nheight = \"4.5 m\"\n"
                                         "runs = 8\n"));
  const auto outputs_with = [&](const std::string& option, const std::string& folder) {
    program.write("fence.toml", fence(guided, option));
    const ProgramEnd end = program.end({"capacity", "margins.toml"}, {{"--no-plots", {}}, {"--out", {folder}}});
    differ.contains("printed margin of the hangers", squeezed(end.output),
                    option.empty() ? "hanger force/limit no limit\n" : "hanger force/limit median 0.");
    const records::Csv nodes = program.csv(folder + "/capacity.csv");
    for (std::size_t row = 0; row < nodes.rows(); ++row)
      differ.compare("a cell without a limit", nodes.cell(row, "fence.hanger_margin.p95 [1]").empty(), option.empty());
    differ.compare("nodes of margins", nodes.rows() > 0, true);
    return program.file(folder + "/capacity.json").at("hazard").at("outputs");
  };
  const auto largest = [](const Json& quantiles) { return quantiles.at("p95").at("value").get<double>(); };
  const Json unlimited = outputs_with("", "margins_without");
  const double limit = 4.0 * strength, force = largest(unlimited.at("fence.hanger_force"));
  differ.holds("force of the hangers", force > 0.0 && force < limit);
  differ.holds("a margin without a limit", unlimited.at("fence.hanger_margin").is_null());
  const Json limited = outputs_with(fmt::format("hanger_strength = \"{} N\"\n", limit), "margins_with");
  differ.holds("a margin with a limit", std::abs(largest(limited.at("fence.hanger_margin")) - force / limit) < 1e-12);
  program.write("fence.toml", fence(guided));
}

/// Tilted elongated rocks of other sizes: they start as far in front of that of the base as they reach further, a
/// larger one in its bounding box, a smaller one as an ellipse.
void check_tilted_rocks(const Program& program, Differences& differ) {
  constexpr double angle = 0.5, long_axis = 2.0 * own_radius, start_x = 1.25;
  std::string text = fence("angle = \"0.5 rad\"\n");
  const std::string b = fmt::format("b = \"{} m\"\nmass", own_radius);
  text.replace(text.find(b), b.size(), fmt::format("b = \"{} m\"\nmass", long_axis));
  const std::string position = fmt::format("position = [\"{} m\"", own_x);
  text.replace(text.find(position), position.size(), fmt::format("position = [\"{} m\"", start_x));
  program.write("fence.toml", text);
  program.write(
      "places.toml",
      fmt::format("base = \"fence.toml\"\nmass = [\"{} kg\", \"{} kg\"]\nspeed = [\"2 m/s\", \"4 m/s\"]\n[map]\n"
                  "cells = 1\nfirst_cells = 1\nruns = 4\naudit = 0\n",
                  0.125 * own_mass, 8.0 * own_mass));
  program.run({"capacity", "places.toml"}, {{"--no-plots", {}}});
  program.run({"sweep", "collect", "places"});
  const records::Csv runs = program.csv("places/results.csv");
  const double across = own_radius * std::cos(angle), along = long_axis * std::sin(angle);
  for (std::size_t row = 0; row < runs.rows(); ++row) {
    const double size = runs.number(row, "fence.rock[0].a [m]") / own_radius;
    const double reach = size > 1.0 ? across + along : std::hypot(across, along);
    differ.holds("sizes", std::abs(size - 2.0) < 1e-12 || std::abs(size - 0.5) < 1e-12);
    differ.holds("places of tilted rocks", std::abs(runs.number(row, "fence.rock[0].position[0] [m]") -
                                                    (start_x + (size - 1.0) * reach)) < 1e-12);
  }
  differ.compare("tilted rocks", runs.rows(), std::size_t{16});
}

/// A rock that is higher, turned and spun within the requested changes; text, figures and exit status.
void check_changes(const Program& program, Differences& differ) {
  program.write("fence.toml", fence("spin = \"2 rad/s\"\nangle = \"0.5 rad\"\n"));
  program.write("changes.toml",
                "base = \"fence.toml\"\nmass = [\"100 kg\", \"800 kg\"]\nspeed = [\"2 m/s\", \"4 m/s\"]\n"
                "height = [\"4.25 m\", \"4.75 m\"]\n[map]\ncells = 1\nfirst_cells = 1\nruns = 4\naudit = 0\n"
                "[changes]\nspeed = 0.0\nheight = \"0.125 m\"\nangle = \"0.25 rad\"\nspin = \"1 rad/s\"\n");
  const std::string text = program.run({"capacity", "changes.toml"});
  differ.contains("text", text, "height 4.25 m: 16 runs (100 % of the full grid)");
  differ.contains("names of files", text, "\nchanges/capacity.csv\nchanges/capacity.json\nchanges/plots/");
  for (const char* const file : {"envelope_1.svg", "envelope_2.pdf", "cable_force_1.svg"})
    differ.holds("figure", program.has(fmt::format("changes/plots/{}", file)));
  program.run({"sweep", "collect", "changes"});
  const records::Csv runs = program.csv("changes/results.csv");
  double highest = 0.0, angle = 0.0, spin = 0.0;
  for (std::size_t row = 0; row < runs.rows(); ++row) {
    const auto number = [&](const std::string& head) { return runs.number(row, head); };
    keep_largest(highest, std::abs(number("fence.rock[0].position[1] [m]")) - 0.25);
    keep_largest(angle, number("fence.rock[0].angle [rad]") - 0.5);
    keep_largest(spin, number("fence.rock[0].spin [rad/s]") - 2.0);
  }
  differ.compare("rows", runs.rows(), std::size_t{32});
  differ.compare("changes in capacity.json", program.file("changes/capacity.json").at("changes"),
                 Json{{"speed", 0.0}, {"height", 0.125}, {"angle", 0.25}, {"spin", 1.0}, {"along", 0.0}});
  differ.holds("heights", highest > 0.09 && highest <= 0.125);
  differ.holds("angles", angle > 0.18 && angle <= 0.25);
  differ.holds("spins", spin > 0.7 && spin <= 1.0);
  program.write("limited.toml", question(4, "[limits]\nevaluations = 10\n"));
  const ProgramEnd limited = program.end({"capacity", "limited.toml"}, {{"--no-plots", {}}});
  differ.compare("all runs failed", limited.exit_code, 3);
  differ.contains("reason of a failure", limited.output, "  failed, for example: limit of 10 evaluations\n");
  const ProgramEnd other = program.end({"capacity", "limited.toml"}, {{"--no-plots", {}}, {"--out", {"changes"}}});
  differ.ended("results of other limits are refused", other, 2, "other limits");
  check_tilted_rocks(program, differ);
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
  const std::string text = "\n" + program.run({"capacity", "positions.toml"}, {{"--sheet", {}}});
  for (const char* const name :
       {"height 4.5 m, spin -1 rad/s, along -0.25 m: 16 runs", "height 4.5 m, spin 3 rad/s, along 0.125 m: 16 runs"})
    differ.contains(fmt::format("map of {}", name), text, fmt::format("\n{}", name));
  program.run({"sweep", "collect", "positions"});
  const records::Csv placed = program.csv("positions/results.csv"), maps = program.csv("positions/capacity.csv");
  double shift = 0.0, farthest = 0.0, mean_spin = 0.0, widest = 0.0, products = 0.0;
  std::size_t expected = 0;
  std::set<double> positions;
  for (std::size_t row = 0; row < placed.rows(); ++row) {
    const auto number = [&](const std::string& head) { return placed.number(row, head); };
    const double along = number("fence.rock[0].along [m]"), turning = number("fence.rock[0].spin [rad/s]");
    if (turning > 4.0) {
      ++expected, mean_spin += turning, widest = std::max(widest, std::abs(along));
      products += (turning - 6.0) * along;
      differ.holds("spin of an expected rock", turning >= 5.0 && turning <= 7.0);
      continue;
    }
    const double change = std::min(std::abs(along + 0.25), std::abs(along - 0.125));
    keep_largest(shift, change), keep_largest(farthest, along);
    differ.holds("spin of a map", turning == -1.0 || turning == 3.0);
    // Uniform random numbers: rocks of other spins have other ones.
    differ.holds("a position of one run alone", positions.insert(along).second);
  }
  differ.compare("expected rocks", expected, std::size_t{200});
  differ.holds("mean spin of the expected rocks", std::abs(mean_spin / 200.0 - 6.0) < 4.0 * 0.5774 / std::sqrt(200.0));
  differ.holds("positions of the expected rocks", widest > 0.3 && widest <= 0.3625);
  // Four standard deviations; with one random number for both the mean product is 0.1.
  differ.holds("spins and positions are independent",
               std::abs(products / 200.0) < 4.0 * 0.5774 * 0.1753 / std::sqrt(200.0));
  differ.holds("positions of the maps", shift > 0.05 && shift <= 0.0625 && farthest > 0.27);
  differ.compare("rows of four maps", maps.rows(), std::size_t{16});
  differ.holds("spin and position of a node",
               maps.number(0, "spin [rad/s]") == -1.0 && maps.number(4, "along [m]") == 0.125);
  // Rocks of a table with their spin and position.
  program.write("spinning.csv", "along [m],mass [kg],spin [rad/s],speed [m/s],height [m]\n0.2,150,6,3,4.5\n");
  program.write("table.toml",
                "base = \"full.toml\"\nmass = [\"100 kg\", \"800 kg\"]\nspeed = [\"2 m/s\", \"4 m/s\"]\n[map]\n"
                "cells = 1\nfirst_cells = 1\nruns = 4\naudit = 0\n[hazard]\ntable = \"spinning.csv\"\nruns = 3\n");
  program.run({"capacity", "table.toml"}, {{"--no-plots", {}}, {"--out", {"spinning"}}});
  program.run({"sweep", "collect", "spinning"});
  const records::Csv spinning = program.csv("spinning/results.csv");
  std::size_t of_table = 0;
  for (std::size_t row = 0; row < spinning.rows(); ++row) {
    of_table += spinning.number(row, "fence.rock[0].along [m]") == 0.2 &&
                        spinning.number(row, "fence.rock[0].spin [rad/s]") == 6.0
                    ? 1
                    : 0;
  }
  differ.compare("rocks of a table with spin and position", of_table, std::size_t{3});
  const std::string sheet = program.read("positions/capacity.html");
  differ.holds("page to print", program.has("positions/capacity.pdf") &&
                                    sheet.find("Probability of failure per impact: ") != std::string::npos &&
                                    sheet.find("4.5 m, 3 rad/s, at 0.125 m") != std::string::npos);
}

/// Bases in US units: a deck, and a scene that gives the density, on an inclined ground, with a rock beside mid-span.
void check_us_base(const Program& program, Differences& differ) {
  std::string inclined = records::read_whole(case_file("capacity/fence.toml"));
  inclined.replace(inclined.find("duration = \"2 s\""), 16, "duration = \"0.01 s\"");
  inclined.replace(inclined.find("position = [\"0 ft\", \"-5 ft\"]"), 28,
                   "angle = \"10 deg\"\nposition = [\"0 ft\", \"-5 ft\"]");
  inclined.insert(inclined.find("spin = \"34 rad/s\""), "along = \"1 ft\"\n");
  program.write("inclined.toml", inclined + "[fence.options]\nsymmetry = \"full\"\n");
  program.write("us.toml",
                "base = \"inclined.toml\"\nmass = [\"600 lb\", \"2400 lb\"]\nspeed = [\"20 ft/s\", \"100 ft/s\"]\n"
                "height = \"6 ft\"\n[map]\ncells = 1\nfirst_cells = 1\nruns = 4\naudit = 0\n[changes]\n"
                "along = \"0.5 ft\"\n[hazard]\ntable = \"us.csv\"\nruns = 1\n");
  // A deck of 1993 and the scene that it is converted to.
  std::string deck = records::read_whole(case_file("fence/table_2.DAT"));
  deck.replace(deck.find("0.03418558 100000"), 17, "0.17 200");
  program.write("deck.DAT", deck);
  program.run({"convert", "deck.DAT", "converted.toml"});
  for (const char* const base : {"deck.DAT", "converted.toml"}) {
    program.write(fmt::format("of_{}.toml", base),
                  fmt::format("base = \"{}\"\nmass = [\"600 lb\", \"2400 lb\"]\nspeed = [\"20 ft/s\", \"100 ft/s\"]\n"
                              "[map]\ncells = 1\nfirst_cells = 1\nruns = 4\naudit = 0\n",
                              base));
    program.run({"capacity", fmt::format("of_{}.toml", base)}, {{"--no-plots", {}}});
  }
  differ.holds("nodes of a deck", program.read("of_deck.DAT/capacity.csv").starts_with("height [ft]"));
  differ.compare("map of a deck", program.read("of_deck.DAT/capacity.csv"),
                 program.read("of_converted.toml/capacity.csv"));
  program.write("us.csv", "mass [lb],speed [m/s],height [ft]\n2000,10,6\n");
  const std::string text = squeezed(program.run({"capacity", "us.toml"}, {{"--no-plots", {}}}));
  const Json us = program.file("us/capacity.json"), expected = us.at("hazard").at("outputs"), own = us.at("rock");
  constexpr double foot = 0.3048, pound = 0.45359237, kip = 1e3 * pound * 9.80665;
  for (const auto& [label, output, unit, size] :
       {std::tuple{"anchor force", "fence.anchor_force", "kip", kip},
        std::tuple{"energy after the last contact", "fence.exit_energy", "kip ft", kip * foot}}) {
    const Json& of = expected.at(output);
    differ.contains("printed percentiles", text,
                    fmt::format("{} median {:.4g}, 95th percentile {:.4g} {}\n", label,
                                of.at("median").at("value").get<double>() / size,
                                of.at("p95").at("value").get<double>() / size, unit));
  }
  const auto is_near = [](double found, double exact) { return std::abs(found / exact - 1.0) < 1e-12; };
  differ.holds("rock of a base in US units", is_near(own.at("speed").get<double>(), 65.0 * foot) &&
                                                 is_near(own.at("spin").get<double>(), 34.0) &&
                                                 is_near(own.at("along").get<double>(), foot));
  const records::Csv nodes = program.csv("us/capacity.csv");
  for (std::size_t row = 0; row < nodes.rows(); ++row)
    differ.holds("position of a node in feet", is_near(nodes.number(row, "along [ft]"), 1.0));
  program.run({"sweep", "collect", "us"});
  const records::Csv steep = program.csv("us/results.csv");
  double raised = 0.0, sized = 0.0;
  constexpr double own_half = 0.953951 * foot, slope = 10.0 * std::numbers::pi / 180.0;
  const auto half_of = [&](double pounds) {
    return own_half * std::cbrt(pounds * pound /
                                (5.127408 * 14.593902937206365 / (foot * foot * foot) * 4.0 / 3.0 * std::numbers::pi *
                                 own_half * own_half * own_half));
  };
  std::size_t of_table = 0;
  for (std::size_t row = 0; row < steep.rows(); ++row) {
    const auto number = [&](const std::string& head) { return steep.number(row, head); };
    const double x = number("fence.rock[0].position[0] [m]"), y = number("fence.rock[0].position[1] [m]");
    // The surface passes through the middle of the block's upper side; heights are perpendicular to it.
    const double surface =
        -5.0 * foot + 0.5 * foot * std::cos(slope) + std::tan(slope) * (x + 0.5 * foot * std::sin(slope));
    keep_worst(raised, (y - surface) * std::cos(slope) - 6.0 * foot);
    sized = std::max(sized, number("fence.rock[0].a [m]"));
    differ.holds("changes about the position of the base's rock",
                 std::abs(number("fence.rock[0].along [m]") - foot) <= 0.5 * foot + 1e-12);
    const double speed =
        std::hypot(number("fence.rock[0].velocity[0] [m/s]"), number("fence.rock[0].velocity[1] [m/s]"));
    const bool has_size = std::abs(number("fence.rock[0].a [m]") / half_of(2000.0) - 1.0) < 1e-9;
    of_table += has_size && std::abs(speed - 10.0) <= 0.1 ? 1 : 0;
  }
  differ.holds("height above an inclined ground", std::abs(raised) < 1e-9);
  differ.holds("size of a rock of another mass", std::abs(sized / half_of(2400.0) - 1.0) < 1e-9);
  differ.compare("rocks of a table in US units", of_table, std::size_t{1});
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
    check_factor(program, differ);
    check_positions(program, differ);
    check_drawn_rocks(program, differ);
    check_audit(program, differ);
    check_margins(program, differ);
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
          .run = run};
}

}  // namespace talus::verification::problems::fence_capacity
