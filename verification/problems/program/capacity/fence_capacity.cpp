#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "verification/check/case.hpp"
#include "verification/problems/program/capacity/capacity_refusals.hpp"
#include "verification/problems/program/capacity/capacity_statistics.hpp"
#include "verification/problems/program/capacity/changed_rocks.hpp"
#include "verification/problems/program/capacity/drawn_capacity.hpp"
#include "verification/problems/program/capacity/expected_rocks.hpp"
#include "verification/problems/program/capacity/map_nodes.hpp"
#include "verification/problems/program/capacity/one_column.hpp"
#include "verification/record/csv.hpp"
#include "verification/record/json_node.hpp"
#include "verification/study/findings/expectations.hpp"
#include "verification/study/program/program_options.hpp"
#include "verification/study/program/program_run.hpp"
#include "verification/study/program/sweep_results.hpp"

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
  // As values: the audit of the interface writes files of JSON again, with other spaces.
  differ.holds("printed JSON of a map", program.file("map/capacity.json") == found);
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
  const records::Csv runs = compared_sweep(program, "map", differ), nodes = program.csv("map/capacity.csv");
  compare_nodes(nodes, runs, {own_mass, own_radius}, differ);
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
  const auto boundary = [&](const std::string& name, const char* low, const char* high, int cells = 8) {
    std::string text = question(cells, "");
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
  // The cable breaks by the lightest mass at 10 m/s, half a cell below the highest speed.
  std::size_t lightest = 0;
  for (const Json& line : boundary("highest", "6.5 m/s", "10.5 m/s", 4)) {
    const bool is_lightest = std::abs(line.at("mass").get<double>() - 100.0) < 1e-9;
    differ.compare("a mass that is stopped up to the last speed but one", line.at("speed").at(0) == Json(9.5),
                   is_lightest);
    if (!is_lightest) continue;
    ++lightest;
    differ.holds("speed at which alone a mass is not stopped", line.at("speed").at(1) == Json(10.5));
    differ.holds("its runs beyond the boundary", !line.at("not_stopped").is_null());
  }
  differ.compare("masses that are not stopped at the highest speed alone", lightest, std::size_t{1});
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
  const records::Csv runs = compared_sweep(program, "audited", differ), nodes = program.csv("audited/capacity.csv");
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
  const auto [low, high] = wilson(not_stopped, audited);
  differ.holds("interval of the contradictions", std::abs(audit.at("interval").at(0).get<double>() - low) < 1e-12 &&
                                                     std::abs(audit.at("interval").at(1).get<double>() - high) < 1e-12);
}

/// Rocks that cross only 8 of the 10 mm to the column within 0.4 s are not stopped, faster ones are: at nodes
/// between, which have no runs, the map is open, and an audit there counts none.
void check_open_audit(const Program& program, Differences& differ) {
  constexpr int audited = 6;
  program.write("fence.toml", fence(guided));
  program.write(
      "open.toml",
      fmt::format("base = \"fence.toml\"\nmass = [\"100 kg\", \"800 kg\"]\nspeed = [\"0.02 m/s\", \"3 m/s\"]\n"
                  "set = {{ \"fence.options.strength_top\" = \"{} N\" }}\n"
                  "[map]\ncells = 8\nfirst_cells = 1\nruns = 4\naudit = {}\n[changes]\nspeed = 0.01\n",
                  strength, audited));
  const std::string printed = program.run({"capacity", "open.toml"}, {{"--no-plots", {}}});
  const Json map = program.file("open/capacity.json").at("maps").at(0), audit = map.at("audit");
  program.run({"sweep", "collect", "open"});
  differ.compare("runs at the corners of an open map", map.at("runs").get<int>(), 16);
  differ.compare("stopped runs at the corners of an open map", map.at("ends").at("stopped").get<int>(), 8);
  differ.compare("runs of an open map and its audit", compared_sweep(program, "open", differ).rows(),
                 std::size_t{16 + audited});
  differ.compare("counted runs of an open audit", audit.at("runs").get<int>(), 0);
  differ.compare("contradictions of an open audit", audit.at("contradictions").get<int>(), 0);
  differ.holds("printed audit of an open map", printed.find("audit: ") == std::string::npos);
}

/// Margins of hangers that have a force: without a limit, then with one that the same forces do not reach.
void check_margins(const Program& program, Differences& differ) {
  program.write("margins.toml", question(4,
                                         "[hazard]\nmass = \"200 kg\"\nspeed = \"4 m/s\"\nheight = \"4.5 m\"\n"
                                         "runs = 8\n"));
  constexpr double limit = 4.0 * strength;
  const auto outputs_with = [&](const std::string& option, const std::string& folder) {
    program.write("fence.toml", fence(guided, option));
    const ProgramEnd end = program.end({"capacity", "margins.toml"}, {{"--no-plots", {}}, {"--out", {folder}}});
    differ.contains("printed margin of the hangers", squeezed(end.output),
                    option.empty() ? "hanger force/limit no limit\n" : "hanger force/limit median 0.");
    const records::Csv nodes = program.csv(folder + "/capacity.csv");
    for (std::size_t row = 0; row < nodes.rows(); ++row) {
      for (const char* const of : {"median", "p95"}) {
        const std::string head = fmt::format("fence.hanger_margin.{} [1]", of);
        differ.compare("a cell without a limit", nodes.cell(row, head).empty(), option.empty());
        if (option.empty()) continue;
        const double share = nodes.number(row, fmt::format("fence.hanger_force.{} [N]", of)) / limit;
        differ.holds("a margin at a node", std::abs(nodes.number(row, head) / share - 1.0) < 1e-14);
      }
    }
    differ.compare("nodes of margins", nodes.rows() > 0, true);
    return program.file(folder + "/capacity.json").at("hazard").at("outputs");
  };
  const auto largest = [](const Json& quantiles) { return quantiles.at("p95").at("value").get<double>(); };
  const Json unlimited = outputs_with("", "margins_without");
  const double force = largest(unlimited.at("fence.hanger_force"));
  differ.holds("force of the hangers", force > 0.0 && force < limit);
  differ.holds("a margin without a limit", unlimited.at("fence.hanger_margin").is_null());
  const Json limited = outputs_with(fmt::format("hanger_strength = \"{} N\"\n", limit), "margins_with");
  differ.holds("a margin with a limit", std::abs(largest(limited.at("fence.hanger_margin")) - force / limit) < 1e-12);
  program.write("fence.toml", fence(guided));
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
    check_drawn_rocks(program, findings, differ);
    check_audit(program, differ);
    check_open_audit(program, differ);
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
