#include "verification/problems/program/capacity/changed_rocks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "verification/check/case_file.hpp"
#include "verification/problems/program/capacity/map_nodes.hpp"
#include "verification/problems/program/capacity/one_column.hpp"
#include "verification/record/csv.hpp"
#include "verification/record/json_node.hpp"
#include "verification/record/whole_file.hpp"
#include "verification/study/findings/expectations.hpp"
#include "verification/study/program/program_run.hpp"
#include "verification/study/program/sweep_results.hpp"

namespace talus::verification::problems::fence_capacity {

using records::Json;

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
  const records::Csv runs = compared_sweep(program, "places", differ);
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

/// Limits the evaluations so that some runs fail, those that need more without the limit: the exit status must be 6.
void check_failed_runs(const Program& program, Differences& differ) {
  const std::string map =
      "base = \"fence.toml\"\nmass = [\"100 kg\", \"800 kg\"]\nspeed = [\"2 m/s\", \"4 m/s\"]\n[map]\n"
      "cells = 1\nfirst_cells = 1\nruns = 4\naudit = 0\n";
  program.write("unlimited.toml", map);
  differ.compare("no run failed", program.end({"capacity", "unlimited.toml"}, {{"--no-plots", {}}}).exit_code, 0);
  program.run({"sweep", "collect", "unlimited"});
  const records::Csv runs = compared_sweep(program, "unlimited", differ);
  std::vector<double> evaluations;
  for (std::size_t row = 0; row < runs.rows(); ++row)
    evaluations.push_back(runs.number(row, "evaluations"));
  std::ranges::sort(evaluations);
  if (evaluations.size() < 2) return differ.holds("runs with evaluations", false);
  // The widest gap, since evaluations are compared with the limit after each step but the last one.
  std::size_t below = 0;
  for (std::size_t i = 1; i + 1 < evaluations.size(); ++i)
    if (evaluations[i + 1] - evaluations[i] > evaluations[below + 1] - evaluations[below]) below = i;
  program.write("some.toml", map + fmt::format("[limits]\nevaluations = {}\n",
                                               std::lround(0.5 * (evaluations[below] + evaluations[below + 1]))));
  const ProgramEnd some = program.end({"capacity", "some.toml"}, {{"--no-plots", {}}});
  differ.compare("exit status if some runs failed", some.exit_code, 6);
  const records::Csv nodes = program.csv("some/capacity.csv");
  double failed = 0.0;
  for (std::size_t row = 0; row < nodes.rows(); ++row)
    failed += nodes.number(row, "failed");
  differ.compare("failed runs of a map", failed, static_cast<double>(evaluations.size() - below - 1));
}

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
  const records::Csv runs = compared_sweep(program, "changes", differ);
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
  check_failed_runs(program, differ);
  check_tilted_rocks(program, differ);
}

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
  differ.contains("printed ends of spins and positions", text,
                  "\n  mass 150 kg; speed 3 m/s; height 4.5 m; spin 5 to 7 rad/s; along -0.3 to 0.3 m\n");
  differ.compare("ends of spins and positions", program.file("positions/capacity.json").at("hazard").at("rocks"),
                 Json{{"mass", {{"value", 150.0}}},
                      {"speed", {{"value", 3.0}}},
                      {"height", {{"value", 4.5}}},
                      {"spin", {{"from", 5.0}, {"to", 7.0}}},
                      {"along", {{"from", -0.3}, {"to", 0.3}}}});
  program.run({"sweep", "collect", "positions"});
  const records::Csv placed = compared_sweep(program, "positions", differ),
                     maps = program.csv("positions/capacity.csv");
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
  differ.compare("largest change of the position",
                 program.file("positions/capacity.json").at("changes").at("along").get<double>(), 0.0625);
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
  const records::Csv spinning = compared_sweep(program, "spinning", differ);
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
                                    sheet.find("4.5 m, 3 rad/s, at 0.125 m") != std::string::npos &&
                                    sheet.find("mass 150 kg; speed 3 m/s; height 4.5 m; spin 5 to 7 rad/s; along -0.3 "
                                               "to 0.3 m") != std::string::npos);
}

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
  differ.contains("printed table of rocks", text, "\n rows of us.csv (1)\n");
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
  differ.compare("table of rocks", us.at("hazard").at("rocks"), Json{{"table", "us.csv"}, {"rows", 1}});
  const auto is_near = [](double found, double exact) { return std::abs(found / exact - 1.0) < 1e-12; };
  differ.holds("rock of a base in US units", is_near(own.at("speed").get<double>(), 65.0 * foot) &&
                                                 is_near(own.at("spin").get<double>(), 34.0) &&
                                                 is_near(own.at("along").get<double>(), foot));
  const records::Csv nodes = program.csv("us/capacity.csv");
  for (std::size_t row = 0; row < nodes.rows(); ++row)
    differ.holds("position of a node in feet", is_near(nodes.number(row, "along [ft]"), 1.0));
  program.run({"sweep", "collect", "us"});
  const records::Csv steep = compared_sweep(program, "us", differ);
  double raised = 0.0, sized = 0.0;
  compare_nodes(nodes, steep, {own.at("mass").get<double>(), 0.953951 * foot}, differ);
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

}  // namespace talus::verification::problems::fence_capacity
