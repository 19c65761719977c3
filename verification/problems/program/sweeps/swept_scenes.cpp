#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "verification/check/case.hpp"
#include "verification/problems/program/sweeps/ball_sweep.hpp"
#include "verification/problems/program/sweeps/dakota_files.hpp"
#include "verification/problems/program/sweeps/failed_runs.hpp"
#include "verification/problems/program/sweeps/served_runs.hpp"
#include "verification/problems/program/sweeps/sweep_engines.hpp"
#include "verification/problems/program/sweeps/sweep_refusals.hpp"
#include "verification/problems/program/sweeps/swept_cells.hpp"
#include "verification/problems/program/sweeps/swept_fences.hpp"
#include "verification/record/csv.hpp"
#include "verification/record/json_node.hpp"
#include "verification/reference/impacts/restitution.hpp"
#include "verification/study/findings/expectations.hpp"
#include "verification/study/program/program_options.hpp"
#include "verification/study/program/program_run.hpp"

namespace talus::verification::problems::swept_scenes {
namespace {

namespace fs = std::filesystem;
using records::Json;

/// The impact of a run, with the fields that it may change.
struct BallImpact {
  double mass{2.0}, speed{5.0}, stiffness{1e5}, damping{100.0};

  reference::ImpactEvents events(const Setup& setup) const {
    const double factor = setup.has("other_damping") ? 1.01 : 1.0;
    return reference::impact_events({stiffness, factor * damping, mass, speed}, reference::EndRule::clamped);
  }
};

/// Worst errors over all runs.
struct Worst {
  double velocity{}, overlap{}, json{}, spaced{}, strata{}, quantile{};
};

/// The rows beside the closed form, with the columns of the fields in their order.
void compare_rows(const Program& program, const std::string& name, const records::Csv& csv, Worst& worst,
                  Differences& differ) {
  const Setup& setup = program.setup();
  const Json json = program.file(name + "/results.json");
  std::set<std::string> ids;
  for (std::size_t row = 0; row < csv.rows(); ++row) {
    BallImpact impact;
    for (std::size_t column = 0; column < csv.header().size(); ++column) {
      const std::string& head = csv.header()[column];
      if (head == "body.ball.mass [kg]") impact.mass = csv.number(row, column);
      if (head == "body.ball.mass [g]") impact.mass = 1e-3 * csv.number(row, column);
      if (head == "body.ball.velocity[0] [m/s]") impact.speed = csv.number(row, column);
      if (head == "contact.hit.damping [N s/m]") impact.damping = csv.number(row, column);
      if (head == "contact.hit.stiffness [N/m]") impact.stiffness = csv.number(row, column);
    }
    const reference::ImpactEvents exact = impact.events(setup);
    const double after = csv.number(row, "ball.vx.end [m/s]"), deepest = csv.number(row, "ball.x.max [m]") + radius;
    keep_worst(worst.velocity, after / (-exact.restitution * impact.speed) - 1.0);
    keep_worst(worst.overlap, (deepest / exact.largest_depth - 1.0) / std::pow(exact.frequency * step, 2));
    const Json& object = json.at("runs").at(row);
    keep_worst(worst.json, object.at("values").at(0).get<double>() - after);
    keep_worst(worst.json, object.at("values").at(1).get<double>() + radius - deepest);
    differ.compare("number", std::string{csv.cell(row, 0)}, fmt::format("{}", row + 1));
    differ.compare("number in JSON", object.at("number").get<std::size_t>(), row + 1);
    differ.compare("id", object.at("id").get<std::string>(), std::string{csv.cell(row, 1)});
    differ.compare("end", std::string{csv.cell(row, "end")}, std::string{"finished"});
    differ.holds("new id", ids.insert(std::string{csv.cell(row, 1)}).second);
  }
}

const std::string outputs = "base = \"ball.toml\"\noutputs = [\"ball.vx.end\", \"ball.x.max\"]\n";

std::string grid_text() {
  return "title = \"Rebounds\"\n" + outputs +
         axis("contact.hit.damping", "values = [\"0 N s/m\", \"50 N s/m\", \"400 N s/m\"]") +
         axis("body.ball.velocity[0]", "range = [\"1 m/s\", \"5 m/s\"]\ncount = 5") +
         axis("body.ball.mass", "range = [\"500 g\", \"8000 g\"]\ncount = 3\nspacing = \"logarithmic\"") +
         "[[constraint]]\nfield = \"body.ball.mass\"\nat_most = \"7.9 kg\"\n"
         "[[constraint]]\nfield = \"contact.hit.damping\"\nat_least = \"45 N s/m\"\n"
         "[[constraint]]\nfield = \"body.ball.velocity[0]\"\nat_most = \"4 m/s\"\nfactor = 1.1\n";
}

/// A grid with constraints: all combinations, the last axis first.
void check_grid(const Program& program, Worst& worst, Differences& differ) {
  const records::Csv csv = collected(program, "grid", grid_text(), differ);
  compare_rows(program, "grid", csv, worst, differ);
  std::size_t row = 0;
  for (const double damping : {50.0, 400.0}) {
    for (const double speed : {1.0, 2.0, 3.0, 4.0}) {
      for (const double mass : {500.0, 2000.0}) {
        if (row == csv.rows()) break;
        const std::vector<double> expected{damping, speed, mass};
        for (std::size_t i = 0; i < expected.size(); ++i)
          keep_worst(worst.spaced, csv.number(row, i + 2) / expected[i] - 1.0);
        ++row;
      }
    }
  }
  differ.compare("rows of the grid", csv.rows(), std::size_t{16});
  differ.compare("expected rows of the grid", row, std::size_t{16});
  const std::string planned = program.run({"sweep", "plan", "grid.toml"}, {{"--out", {"other"}}});
  differ.holds("runs of the plan", planned.starts_with("16 runs, without 29 that do not satisfy the constraints\n"));
  const Json json = program.json({"sweep", "plan", "grid.toml"}, {{"--out", {"other"}}, {"--json", {}}});
  differ.compare("runs of the plan in JSON", json.at("runs").get<std::size_t>(), std::size_t{16});
  differ.compare("runs left out", json.at("left_out").get<std::size_t>(), std::size_t{29});
  differ.compare("folder of the plan", json.at("folder").get<std::string>(), std::string{"other"});
  differ.compare("base of the plan", program.file("other/sweep.json").at("base").get<std::string>(),
                 std::string{"base.toml"});
  differ.holds("the plan's estimates", json.at("evaluations").get<double>() > 0.0 &&
                                           json.at("processor_time").get<double>() > 0.0 &&
                                           json.at("bytes").get<double>() > 0.0);
  // The estimate of the bytes: results of three runs, scaled.
  double bytes = 0.0;
  for (const auto& entry : fs::directory_iterator{program.folder().path() / "grid" / "results"})
    bytes += static_cast<double>(fs::file_size(entry.path()));
  differ.holds("estimated bytes, within a tenth", std::abs(json.at("bytes").get<double>() / bytes - 1.0) < 0.1);
  // Likewise of the evaluations: each run has the same steps, and as many events but for a few.
  double evaluations = 0.0;
  for (std::size_t i = 0; i < csv.rows(); ++i)
    evaluations += csv.number(i, "evaluations");
  differ.holds("estimated evaluations, within a tenth",
               std::abs(json.at("evaluations").get<double>() / evaluations - 1.0) < 0.1);
}

/// Largest distance of the numbers of points in equal parts of [0, 1) from one.
double strata_error(std::vector<double> probabilities) {
  std::vector<int> in_part(probabilities.size());
  for (const double probability : probabilities) {
    const auto part = static_cast<std::size_t>(probability * static_cast<double>(probabilities.size()));
    if (part < in_part.size()) ++in_part[part];
  }
  double error = 0.0;
  for (const int count : in_part)
    error = std::max(error, std::abs(count - 1.0));
  return error;
}

/// Sampled designs: the probabilities of the values, of which each part must have one.
void check_samples(const Program& program, Worst& worst, Differences& differ) {
  const Setup& setup = program.setup();
  std::set<std::string> tables;
  for (const char* kind : {"sobol", "latin_hypercube", "random"}) {
    const bool is_random = std::string{kind} == "random";
    for (const int seed : {1, 2}) {
      const std::string name = fmt::format("{}_{}", kind, seed);
      const std::string used = setup.has("random_points") ? "random" : kind;
      const records::Csv csv = collected(
          program, name,
          outputs + fmt::format("[design]\nkind = \"{}\"\nruns = 64\nseed = {}\n", used, seed) +
              axis("body.ball.velocity[0]", "quantiles = [[0, \"1 m/s\"], [0.75, \"2 m/s\"], [1, \"6 m/s\"]]") +
              axis("contact.hit.stiffness", "range = [\"4e4 N/m\", \"4e6 N/m\"]\nspacing = \"logarithmic\"") +
              axis("contact.hit.damping", "values = [\"20 N s/m\", \"40 N s/m\"]"),
          differ);
      compare_rows(program, name, csv, worst, differ);
      std::vector<double> speeds, stiffnesses;
      int weak = 0;
      for (std::size_t row = 0; row < csv.rows(); ++row) {
        const double v = csv.number(row, 2);
        speeds.push_back(v < 2.0 ? 0.75 * (v - 1.0) : 0.75 + 0.25 * (v - 2.0) / 4.0);
        stiffnesses.push_back(std::log10(csv.number(row, 3) / 4e4) / 2.0);
        weak += csv.number(row, 4) == 20.0 ? 1 : 0;
      }
      differ.compare("runs of a design", csv.rows(), std::size_t{64});
      differ.holds("different points for each design and seed",
                   tables.insert(program.read(name + "/manifest.jsonl")).second);
      if (is_random) {
        // The standard error of a fraction of 64 is at most 1/16.
        keep_worst(worst.quantile, weak / 64.0 - 0.5);
        keep_worst(worst.quantile,
                   static_cast<double>(std::ranges::count_if(speeds, [](double p) { return p < 0.75; })) / 64.0 - 0.75);
      } else {
        keep_worst(worst.strata, strata_error(speeds));
        keep_worst(worst.strata, strata_error(stiffnesses));
        differ.compare("half of the runs have each value", weak, 32);
      }
    }
  }
}

/// A Latin hypercube of many runs: each axis takes its parts in a random order, independent of those of other axes.
void check_orders(const Program& program, Differences& differ) {
  constexpr std::size_t runs = 2500;
  const std::array<std::pair<const char*, const char*>, 4> axes{{{"body.ball.mass", "kg"},
                                                                 {"body.ball.velocity[0]", "m/s"},
                                                                 {"body.ball.velocity[1]", "m/s"},
                                                                 {"contact.hit.damping", "N s/m"}}};
  std::string text = outputs + fmt::format("[design]\nkind = \"latin_hypercube\"\nruns = {}\nseed = 2\n", runs);
  for (const auto& [field, unit] : axes)
    text += axis(field, fmt::format("range = [\"1 {0}\", \"2 {0}\"]", unit));
  program.write("orders.toml", text);
  program.run({"sweep", "plan", "orders.toml"});
  std::array<std::vector<double>, 4> points;  // in [0, 1)
  std::istringstream lines{program.read("orders/manifest.jsonl")};
  for (std::string line; std::getline(lines, line);) {
    const Json run = Json::parse(line);
    for (std::size_t i = 0; i < axes.size(); ++i)
      points[i].push_back(std::stod(run.at("parameters").at(axes[i].first).get<std::string>()) - 1.0);
  }
  differ.compare("runs of a large design", points[0].size(), runs);
  // Of n numbers in a random order (n - 1)/2 are smaller than their position on average, with a variance of (n + 1)/12
  // (Eulerian numbers): over all axes 0.5 +- 0.0029. If each place is exchanged with any other one, 0.527 are smaller.
  int smaller = 0;
  for (const std::vector<double>& of : points)
    for (std::size_t run = 0; run < of.size(); ++run)
      smaller += of[run] < static_cast<double>(run) / runs ? 1 : 0;
  differ.holds("random order of the parts of an axis", std::abs(smaller / (4.0 * runs) - 0.5) < 4.5 * 0.0029);
  for (std::size_t a = 0; a < axes.size(); ++a) {
    double product = 0.0;
    const std::vector<double>& other = points[(a + 1) % axes.size()];
    for (std::size_t run = 0; run < other.size(); ++run)
      product += 12.0 * (points[a][run] - 0.5) * (other[run] - 0.5) / runs;
    differ.holds("independent orders of two axes", std::abs(product) < 4.5 / std::sqrt(runs));
  }
}

/// A field beside another one that is varied, an even range on both sides of 0, and what is written of a plan.
void check_plans(const Program& program, Differences& differ) {
  const std::string head = "title = \"Plan\"\nbase = \"ball.toml\"\noutputs = [\"ball.vx.end\"]\n";
  program.write("fields.toml", head +
                                   "[[axis]]\nfield = \"body.ball.velocity[0]\"\nvalues = [\"1 m/s\", \"2 m/s\", "
                                   "\"3 m/s\"]\n[[axis]]\nfield = \"body.ball.velocity[1]\"\nvalues = [\"0 m/s\", "
                                   "\"150 cm/s\", \"2.5 m/s\"]\n[[constraint]]\nfield = \"body.ball.velocity[1]\"\n"
                                   "at_most = \"body.ball.velocity[0]\"\n");
  differ.holds("runs within a limit that is varied",
               program.run({"sweep", "plan", "fields.toml"})
                   .starts_with("6 runs, without 3 that do not satisfy the constraints\n"));
  // 3 times 0.7 is less than 2.1 by round-off, 3 times 1.1 more than 3.3.
  program.write("edge.toml", head +
                                 "[[axis]]\nfield = \"body.ball.velocity[0]\"\nvalues = [\"2.1 m/s\", \"3.3 m/s\"]\n"
                                 "[[axis]]\nfield = \"body.ball.velocity[1]\"\nvalues = [\"0.7 m/s\", \"1.1 m/s\"]\n"
                                 "[[constraint]]\nfield = \"body.ball.velocity[0]\"\n"
                                 "at_most = \"body.ball.velocity[1]\"\nfactor = 3\n[[constraint]]\n"
                                 "field = \"body.ball.velocity[0]\"\nat_least = \"body.ball.velocity[1]\"\n"
                                 "factor = 3\n");
  differ.holds("runs at their limits but for round-off",
               program.run({"sweep", "plan", "edge.toml"}).starts_with("2 runs, without 2 that"));
  const Json plan = program.file("fields/sweep.json");
  differ.holds("sweep.json", plan.at("title").get<std::string>() == "Plan" && plan.at("runs").get<int>() == 6 &&
                                 plan.at("outputs") == Json{"ball.vx.end"} && plan.at("limits").empty());
  program.write("even.toml", head +
                                 "[[axis]]\nfield = \"body.ball.velocity[1]\"\nrange = [\"-1 m/s\", \"1 m/s\"]\n"
                                 "count = 3\n[limits]\nevaluations = 100000\ntime = \"2 s\"\n");
  const records::Csv even = collected(program, "even", program.read("even.toml"), differ);
  for (std::size_t row = 0; row < 3; ++row)
    differ.holds("a range on both sides of 0",
                 even.number(row, "body.ball.velocity[1] [m/s]") == static_cast<double>(row) - 1.0);
  // Quantiles on a grid: in the middle of equally probable parts.
  program.write("middles.toml", head +
                                    "[[axis]]\nfield = \"body.ball.velocity[0]\"\ncount = 4\n"
                                    "quantiles = [[0, \"1 m/s\"], [0.75, \"2 m/s\"], [1, \"6 m/s\"]]\n");
  const records::Csv middles = collected(program, "middles", program.read("middles.toml"), differ);
  differ.compare("points of quantiles on a grid", middles.rows(), std::size_t{4});
  std::size_t point = 0;
  for (const double exact : {1.0 + 0.125 / 0.75, 1.5, 1.0 + 0.625 / 0.75, 4.0}) {
    if (point == middles.rows()) break;
    differ.holds("a quantile on a grid",
                 std::abs(middles.number(point++, "body.ball.velocity[0] [m/s]") / exact - 1.0) < 1e-15);
  }
  // Values in several units are texts, as they are written.
  program.write("mixed.toml", head + "[[axis]]\nfield = \"body.ball.mass\"\nvalues = [\"2 kg\", \"1500 g\"]\n");
  const records::Csv mixed = collected(program, "mixed", program.read("mixed.toml"), differ);
  differ.compare("column of values in several units", mixed.header().at(2), std::string{"body.ball.mass"});
  differ.compare("values in several units", fmt::format("{}, {}", mixed.cell(0, 2), mixed.cell(1, 2)),
                 std::string{"2 kg, 1500 g"});
  differ.compare("limits in sweep.json", program.file("even/sweep.json").at("limits"),
                 Json{{"time", 2.0}, {"evaluations", 100000}});
}

/// A base in US units, one run of which has SI units: the table is in US units, JSON in SI.
void check_units(const Program& program, Differences& differ) {
  std::string scene = ball_scene("exact");
  scene.replace(scene.find("\"SI\""), 4, "\"US\"");
  program.write("feet.toml", scene);
  const records::Csv csv = collected(
      program, "units",
      "base = \"feet.toml\"\noutputs = [\"ball.vx.end\"]\n" + axis("units", "values = [\"US\", \"SI\"]"), differ);
  const Json json = program.file("units/results.json");
  constexpr double foot = 0.3048;
  for (std::size_t row = 0; row < 2; ++row) {
    const double velocity = csv.number(row, "ball.vx.end [ft/s]") * foot;
    differ.holds("velocity in SI",
                 std::abs(json.at("runs").at(row).at("values").at(0).get<double>() / velocity - 1.0) < 1e-15);
    differ.holds("velocity of a run in other units",
                 std::abs(velocity / (csv.number(0, "ball.vx.end [ft/s]") * foot) - 1.0) < 1e-11);
  }
}

/// Fields from a file, and the second run with the same parameters.
void check_table(const Program& program, Worst& worst, Differences& differ) {
  program.write("balls.csv", "# measured\nv [m/s],m [kg],note\n3,2,a\n1.5,0.5,b\n3,2,c\n");
  const records::Csv csv =
      collected(program, "table",
                outputs +
                    "[[axis]]\ntable = \"balls.csv\"\ncolumns = { \"body.ball.mass\" = \"m [kg]\", "
                    "\"body.ball.velocity[0]\" = \"v [m/s]\" }\n" +
                    axis("contact.hit.damping", "values = [\"80 N s/m\"]"),
                differ);
  compare_rows(program, "table", csv, worst, differ);
  differ.compare("rows of a table", csv.rows(), std::size_t{3});
  if (csv.rows() != 3) return;
  const std::size_t mass = csv.column("body.ball.mass [kg]"), speed = csv.column("body.ball.velocity[0] [m/s]");
  differ.holds("second row of the table", csv.number(1, mass) == 0.5 && csv.number(1, speed) == 1.5);
  differ.holds("third row of the table", csv.number(2, mass) == 2.0 && csv.number(2, speed) == 3.0);
  // A column of texts: each row is the run of the scene with that integrator.
  program.write("methods.csv", "method,h [s]\nrk4,1e-4\nvelocity_verlet,2e-4\n");
  const records::Csv methods = collected(program, "methods",
                                         "base = \"ball.toml\"\noutputs = [\"ball.vx.end\"]\n[[axis]]\n"
                                         "table = \"methods.csv\"\ncolumns = { \"run.integrator\" = \"method\", "
                                         "\"run.step\" = \"h [s]\" }\n",
                                         differ);
  const std::vector<std::pair<std::string, std::string>> expected{{"rk4", "0.0001"}, {"velocity_verlet", "0.0002"}};
  for (std::size_t row = 0; row < expected.size(); ++row) {
    differ.compare("a text of the table", std::string{methods.cell(row, "run.integrator")}, expected[row].first);
    std::string scene = ball_scene(expected[row].first);
    const std::size_t line = scene.find("\nstep = ") + 1;
    scene.replace(line, scene.find('\n', line) - line, fmt::format("step = \"{} s\"", expected[row].second));
    program.write("method.toml", scene);
    const Json summary = program.json({"run", "method.toml"}, {{"--json", {}}});
    for (const Json& body : summary.at("bodies"))
      if (body.at("name").get<std::string>() == "ball")
        differ.compare("run of a text", methods.number(row, "ball.vx.end [m/s]"),
                       body.at("velocity").at(0).get<double>());
  }
}

/// The same bytes for parts in any order, threads, and after lost, cut and repeated results.
void check_bytes(const Program& program, Findings& findings, Differences& differ) {
  const Setup& setup = program.setup();
  program.write("parts.toml", grid_text());
  const auto bytes = [&](const std::string& name) {
    return program.read(name + "/results.csv") + program.read(name + "/results.json");
  };
  const auto plan = [&](const std::string& name) { program.run({"sweep", "plan", "parts.toml"}, {{"--out", {name}}}); };
  plan("whole");
  program.run({"sweep", "run", "whole"}, {{"--threads", {"1"}}});
  program.run({"sweep", "collect", "whole"});
  const std::string expected = bytes("whole");
  double differing = 0.0;
  const auto compare = [&](const std::string& name) {
    const ProgramEnd end = program.end({"sweep", "collect", name});
    if (end.exit_code != 0 || bytes(name) != expected) differing += 1.0;
  };

  plan("parts");
  for (const char* shard : {"3/3", "1/3", "2/3"}) {
    if (setup.has("part_left_out") && std::string{shard} == "1/3") continue;
    const std::string printed = program.run({"sweep", "run", "parts"}, {{"--shard", {shard}}, {"--threads", {"2"}}});
    const std::string part = fmt::format(", part {} of 3: ", shard[0]);
    differ.contains("part", printed, part);
  }
  compare("parts");
  if (setup.has("part_left_out")) {
    findings.expect("collected files that differ in a byte, by part, threads and lost results", differing, 0.0,
                    Tolerance::exact("the manifest gives parameters and order"));
    return;
  }
  // A process that was killed: the last line has no end; the run is done again.
  const std::vector<std::string> files = program.files("parts/results");
  differ.compare("a file of results for each process", files.size(), std::size_t{3});
  const std::string& cut = files.front();
  const std::string text = program.read(cut);
  program.write(cut, text.substr(0, text.size() - 30));
  const ProgramEnd refused = program.end({"sweep", "collect", "parts"});
  differ.ended("a missing run is refused", refused, 2, "1 of 16 runs have no result");
  differ.compare("a missing run is accepted", program.end({"sweep", "collect", "parts"}, {{"--partial", {}}}).exit_code,
                 0);
  differ.compare("rows without the missing one", program.csv("parts/results.csv").rows(), std::size_t{15});
  program.run({"sweep", "run", "parts"});
  compare("parts");
  differ.compare("only the missing run is done", program.files("parts/results").size(), std::size_t{4});
  program.run({"sweep", "run", "parts"});
  differ.compare("nothing is done again", program.files("parts/results").size(), std::size_t{4});
  program.write("parts/results/copy.jsonl", program.read(program.files("whole/results").front()));
  const ProgramEnd doubled = program.end({"sweep", "collect", "parts"});
  differ.ended("repeated results are refused", doubled, 2, "has several results, as have 16 in all");
  program.run({"sweep", "collect", "parts"}, {{"--partial", {}}});
  if (bytes("parts") != expected) differing += 1.0;
  // Without the files that it names all runs have one result, or none.
  const std::string named = doubled.messages.substr(0, doubled.messages.find(" and run the sweep"));
  for (const std::string& file : program.files("parts/results"))
    if (named.find(file) != std::string::npos) program.write(file, "");
  program.run({"sweep", "run", "parts"});
  compare("parts");
  findings.expect("collected files that differ in a byte, by part, threads and lost results", differing, 0.0,
                  Tolerance::exact("the manifest gives parameters and order"));

  // A longer axis: the results of the runs that both plans have count.
  std::string longer = grid_text();
  const std::size_t at = longer.find("\"400 N s/m\"");
  program.write("parts.toml", longer.insert(at, "\"100 N s/m\", "));
  plan("whole");
  const Json status = program.json({"sweep", "status", "whole"}, {{"--json", {}}});
  differ.compare("missing after a longer axis", status.at("missing").get<int>(), 8);
  // A shorter axis: the results of runs beyond it are those of others; a copy repeats all results.
  std::string shorter = grid_text();
  program.write("parts.toml", shorter.erase(shorter.find(", \"400 N s/m\""), 13));
  plan("whole");
  program.write("whole/results/copy.jsonl", program.read(program.files("whole/results").front()));
  const Json others = program.json({"sweep", "status", "whole"}, {{"--json", {}}});
  for (const auto& [member, count] : {std::pair{"runs", 8}, {"missing", 0}, {"duplicates", 8}, {"of_others", 16}})
    differ.compare(fmt::format("{} after a shorter axis", member), others.at(member).get<int>(), count);
  differ.compare("status after a shorter axis", program.run({"sweep", "status", "whole"}),
                 std::string{"8 of 8 runs done: 8 finished\n8 results of runs that have another one\n"
                             "16 results of runs that are not in the plan\n"});
  program.write("ball.toml", ball_scene("velocity_verlet"));
  const ProgramEnd other = program.end({"sweep", "plan", "parts.toml"}, {{"--out", {"whole"}}});
  differ.ended("results of another base are refused", other, 2, "found results of a sweep with another base");
  // Such results that were copied, or written by a process that began before the plan.
  plan("other");
  static_cast<void>(program.end({"sweep", "run", "other"}));
  program.write("parts/results/other.jsonl", program.read(program.files("other/results").front()));
  differ.ended("copied results of another base are refused", program.end({"sweep", "collect", "parts"}), 2,
               "parts/results/other.jsonl:1: the result is of another base");
  program.write("ball.toml", ball_scene("exact"));
}

void run(Findings& findings, const Setup& setup) {
  const auto group = findings.in("sweep");
  const Program program{setup};
  program.write("ball.toml", ball_scene("exact"));
  Worst worst;
  Differences differ;
  check_grid(program, worst, differ);
  if (setup.needs("points")) check_samples(program, worst, differ);
  if (setup.needs("files")) check_bytes(program, findings, differ);
  check_table(program, worst, differ);
  if (setup.needs("outputs that differ")) {
    check_fences(program, differ);
    check_cells(program, differ);
    check_dakota(program, differ);
    check_server(program, differ);
    check_failures(program, differ);
    check_engines(program, grid_text(), differ);
    check_units(program, differ);
    check_plans(program, differ);
    check_orders(program, differ);
    check_refusals(program, differ);
  }
  findings.expect("velocity after the impact over the exact one, largest deviation from 1", worst.velocity, 0.0,
                  Tolerance::model(1e-11, "the integrator `exact` has closed forms; events are located to round-off"));
  findings.expect("largest overlap less the exact one, over its square of frequency and step, largest", worst.overlap,
                  0.0,
                  Tolerance::truncation(0.125, 1.0,
                                        "the extreme is that of the states, the nearest within half a step: "
                                        "(w h)^2/8 of the overlap; with a dashpot less curved"));
  findings.expect("values of JSON less those of CSV, largest", worst.json, 0.0,
                  Tolerance::round_off(1e-15, "both write all digits; one sum"));
  findings.expect("points of the grid over the exact ones, largest deviation from 1", worst.spaced, 0.0,
                  Tolerance::round_off(1e-15, "a power and a product"));
  findings.expect("Sobol sequence and Latin hypercube: points in each of 64 equal parts of an axis less one, largest",
                  worst.strata, 0.0, Tolerance::exact("a property of both designs"));
  findings.expect("random points: fraction below a quantile less its probability, largest", worst.quantile, 0.0,
                  Tolerance::model(0.22, "3.5 times the largest standard error, 1/16"));
  differ.expect_none(findings, "outputs that differ from the request", "numbers, texts, files and refusals");
}

}  // namespace

Case definition() {
  const std::string velocity = "velocity after the impact over the exact one, largest deviation from 1",
                    bytes = "collected files that differ in a byte, by part, threads and lost results",
                    strata =
                        "Sobol sequence and Latin hypercube: points in each of 64 equal parts of an axis less one, "
                        "largest";
  return {.id = "swept_scenes",
          .title = "Sweeps: many runs of a scene with changed fields",
          .requirements = {{"G15", {"sweep"}}},
          .main_checks = {velocity, bytes, strata, "outputs that differ from the request"},
          .source = "Sobol 1967; Joe & Kuo 2008",
          .faults = {{"other_damping", "a hundredth more damping", velocity},
                     {"random_points", "independent points in place of the designs", strata},
                     {"part_left_out", "one of three parts is not run", bytes}},
          .seconds = 6.0,
          .run = run};
}

}  // namespace talus::verification::problems::swept_scenes
