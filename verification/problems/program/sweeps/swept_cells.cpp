#include "verification/problems/program/sweeps/swept_cells.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "verification/problems/program/sweeps/ball_sweep.hpp"
#include "verification/record/csv.hpp"
#include "verification/record/json_node.hpp"
#include "verification/study/program/sweep_results.hpp"

namespace talus::verification::problems::swept_scenes {
namespace {

using records::Json;

constexpr double disc_stiffness = 1.7e4, diameter = 1e-3, disc_mass = 7.2e-7, cell_step = 4e-7;

/// A small cell; `fields` of [cell] beside the fixed ones.
std::string cell_text(const std::string& fields, const std::string& end) {
  return fmt::format(
      "title = \"Cell\"\nunits = \"SI\"\n[cell]\nstiffness = \"{} N/m\"\ndiameter = \"{} m\"\nmass = \"{} kg\"\n"
      "gravity = \"9.81 m/s^2\"\nrows = 4\ncolumns = 5\nwall_discs = 6\nblock_speed = \"3 m/s\"\n{}"
      "[run]\nstep = \"{} s\"\nevery = \"5 ms\"\nend = \"{}\"\n",
      disc_stiffness, diameter, disc_mass, fields, cell_step, end);
}

/// Plans, runs and collects a sweep whose text is the base and `more`; returns the exit status of the run.
int swept(const Program& program, const std::string& name, const std::string& base, const std::string& more) {
  program.write(name + "_base.toml", base);
  program.write(name + ".toml", fmt::format("base = \"{}_base.toml\"\n{}", name, more));
  program.run({"sweep", "plan", name + ".toml"});
  const int exit_code = program.end({"sweep", "run", name}).exit_code;
  program.end({"sweep", "collect", name});
  return exit_code;
}

std::string listed(const std::string& field, const std::string& values) {
  return axis(field, fmt::format("values = [{}]", values));
}

bool is_near(double value, double exact) { return std::abs(value / exact - 1.0) < 1e-12; }

/// Groups of each run beside the closed forms of its fields; all numbers beside those of the changed file alone.
void check_numbers(const Program& program, Differences& differ) {
  const std::vector<std::string> outputs{
      "cell.restitution", "cell.stiffness_number", "cell.contact_steps",    "cell.block_over_disc",
      "cell.top_normal",  "cell.top_normal.error", "cell.stress_ratio_top", "cell.stress_ratio_top.error",
      "cell.depth",       "cell.largest_overlap"};
  std::string list;
  for (const std::string& output : outputs)
    list += fmt::format("\"{}\", ", output);
  const int exit_code =
      swept(program, "cells", cell_text("restitution = 0.5\noverburden = \"8 kPa\"\n", "30 ms"),
            fmt::format("outputs = [{}\"cell.balance_error\"]\n", list) + listed("cell.seed", "3, 7") +
                listed("cell.restitution", "0.6, 0.8") + listed("cell.overburden", "\"8 kPa\", \"4 kPa\""));
  differ.compare("cells: exit status", exit_code, 0);
  const records::Csv csv = compared_sweep(program, "cells", differ);
  differ.compare("cells: rows", csv.rows(), std::size_t{8});
  const Json json = program.file("cells/results.json");
  for (std::size_t row = 0; row < csv.rows(); ++row) {
    const auto number = [&](const std::string& head) { return csv.number(row, head); };
    const double seed = row < 4 ? 3.0 : 7.0, restitution = row / 2 % 2 == 0 ? 0.6 : 0.8,
                 pressure = row % 2 == 0 ? 8e3 : 4e3;
    const double half_period = std::numbers::pi * std::sqrt(0.5 * disc_mass / disc_stiffness);
    const double block = pressure * 6.0 * diameter * diameter / 9.81;
    differ.holds("cells: order of the rows", number("cell.seed") == seed && number("cell.restitution") == restitution &&
                                                 number("cell.overburden [kPa]") == 1e-3 * pressure);
    differ.holds("cells: restitution", is_near(number("cell.restitution.result"), restitution));
    differ.holds("cells: stiffness over pressure",
                 is_near(number("cell.stiffness_number"), disc_stiffness / (pressure * diameter)));
    // Loading takes a quarter of the period, unloading with K1/e^2 a quarter of a shorter one.
    differ.holds("cells: steps in a contact",
                 is_near(number("cell.contact_steps"), 0.5 * half_period * (1.0 + restitution) / cell_step));
    differ.holds("cells: mass of the block", is_near(number("cell.block_over_disc"), block / disc_mass));
    differ.holds("cells: a standard error", number("cell.top_normal.error [N/m^2]") > 0.0);
    differ.holds("cells: end", number("time [s]") > 0.02999 && number("evaluations") == 75000.0);
    differ.holds("cells: balance error", std::abs(number("cell.balance_error")) < 1e-3);

    program.write("cell_alone.toml", cell_text(fmt::format("restitution = {}\noverburden = \"{} Pa\"\nseed = {}\n",
                                                           restitution, pressure, seed),
                                               "30 ms"));
    const Json alone = program.json({"cell", "cell_alone.toml"}, {{"--json", {}}});
    const Json& values = json.at("runs").at(row).at("values");
    for (std::size_t i = 0; i < outputs.size(); ++i) {
      std::string name = outputs[i].substr(5);
      const bool is_error = name.ends_with(".error");
      if (is_error) name.resize(name.size() - 6);
      const Json& of = alone.at(alone.at("groups").contains(name) ? "groups" : "results").at(name);
      differ.compare("cells: " + outputs[i], values.at(i).get<double>(),
                     of.at(is_error ? "error" : "value").get<double>());
    }
  }
}

/// The depth of a cell in feet is one in metres in results.json.
void check_units(const Program& program, Differences& differ) {
  std::string base = cell_text("restitution = 0.5\noverburden = \"8 kPa\"\n", "15 ms");
  const std::string more = "outputs = [\"cell.depth\"]\n" + listed("cell.seed", "1");
  swept(program, "metres", base, more);
  base.replace(base.find("\"SI\""), 4, "\"US\"");
  swept(program, "feet", base, more);
  const records::Csv metres = compared_sweep(program, "metres", differ), feet = compared_sweep(program, "feet", differ);
  differ.compare("cells: depth in feet", feet.header().back(), std::string{"cell.depth [ft]"});
  // Other units round the fields differently, and the flow is chaotic: the depths differ by their fluctuations.
  const double depth = metres.number(0, metres.header().size() - 1), last = feet.number(0, feet.header().size() - 1);
  differ.holds("cells: depth in metres", std::abs(0.3048 * last / depth - 1.0) < 0.2);
  differ.holds(
      "cells: SI in JSON",
      is_near(program.file("feet/results.json").at("runs").at(0).at("values").at(0).get<double>(), 0.3048 * last));
}

/// The restitution of a cell by a fit to the steps in a contact, which have a closed form.
void check_fit(const Program& program, Differences& differ) {
  constexpr double restitution = 0.65;
  const double half_period = std::numbers::pi * std::sqrt(0.5 * disc_mass / disc_stiffness),
               steps = 0.5 * half_period * (1.0 + restitution) / cell_step;
  program.write("fitted.csv", fmt::format("load [kPa],steps\n8,{}\n4,{}\n", steps, steps));
  std::string scene = cell_text("restitution = 0.5\noverburden = \"8 kPa\"\n", "1 ms");
  program.write("fitted_cell.toml", scene.replace(scene.find("\"5 ms\""), 6, "\"1 ms\""));
  program.write("fitted.toml",
                "scene = \"fitted_cell.toml\"\ndata = \"fitted.csv\"\n"
                "[[input]]\ncolumn = \"load [kPa]\"\nfield = \"cell.overburden\"\n"
                "[[quantity]]\ncolumn = \"steps\"\nresult = \"cell.contact_steps\"\nuncertainty = 0.1\n"
                "[[parameter]]\nfield = \"cell.restitution\"\nrange = [0.2, 0.95]\n[bootstrap]\nsamples = 0\n");
  const Json fit = program.json({"fit", "fitted.toml"}, {{"--json", {}}});
  differ.holds("cells: fitted restitution",
               std::abs(fit.at("parameters").at(0).at("value").get<double>() - restitution) < 1e-6);
  const std::string text = program.run({"fit", "fitted.toml"});
  differ.holds("cells: text of the fit", text.starts_with("1 parameter fitted to 2 values of 2 rows, "));
}

/// Runs that finish with a warning, reach a limit, are refused.
void check_ends(const Program& program, Differences& differ) {
  const std::string load = "restitution = 0.7\noverburden = \"8 kPa\"\n";
  const int exit_code = swept(program, "cell_ends", cell_text(load, "15 ms"),
                              "outputs = [\"cell.depth\", \"cell.stress_ratio_top\"]\n[limits]\nevaluations = 40000\n" +
                                  listed("cell.block_speed", "\"3 m/s\", \"100 m/s\"") +
                                  listed("run.end", "\"15 ms\", \"20 ms\", \"-1 s\""));
  differ.compare("cells: exit status with failed runs", exit_code, 6);
  const records::Csv csv = compared_sweep(program, "cell_ends", differ);
  const auto text = [&](std::size_t row, const char* head) { return std::string{csv.cell(row, head)}; };
  differ.holds("cells: finished", text(0, "end") == "finished" && text(0, "reason").empty());
  differ.compare("cells: limit", text(1, "end") + ", " + text(1, "reason") + text(1, "cell.stress_ratio_top"),
                 std::string{"limited, limit of 40000 evaluations"});
  differ.holds("cells: time at the limit", std::abs(csv.number(1, "time [s]") - 16e-3) < 1e-5);
  differ.holds("cells: refused",
               text(2, "end") == "refused" &&
                   text(2, "reason").starts_with("base.toml:17: run: end: found \"-1 s\"; it must be > 0"));
  differ.holds("cells: warning", text(3, "end") == "finished" &&
                                     text(3, "reason").starts_with("the largest overlap is ") &&
                                     !text(3, "cell.stress_ratio_top").empty());
  // Nothing touches the block in 0.1 ms, in which it falls by 0.05 um.
  std::string apart = cell_text(load, "0.1 ms");
  swept(program, "cell_apart", apart.replace(apart.find("\"5 ms\""), 6, "\"4e-6 s\""),
        "outputs = [\"cell.depth\", \"cell.stress_ratio_top\"]\n" + listed("cell.seed", "1"));
  const records::Csv without = compared_sweep(program, "cell_apart", differ);
  differ.holds("cells: depth of discs apart", std::abs(without.number(0, "cell.depth [m]") - 5e-3) < 1e-7);
  // As many runs as whole numbers in a range: a Latin hypercube has each of them once.
  program.write("seeds.toml",
                "base = \"cell_apart_base.toml\"\noutputs = [\"cell.depth\"]\n[design]\n"
                "kind = \"latin_hypercube\"\nruns = 5\n[[axis]]\nfield = \"cell.seed\"\nrange = [3, 7]\n");
  program.run({"sweep", "plan", "seeds.toml"});
  const std::string planned = program.read("seeds/manifest.jsonl");
  for (int seed = 3; seed <= 7; ++seed)
    differ.contains(fmt::format("cells: whole number {} of a range", seed), planned,
                    fmt::format("\"cell.seed\":{}}}", seed));
  differ.compare("cells: a mean that does not exist",
                 fmt::format("{}, {}{}", without.cell(0, "end"), without.cell(0, "reason"),
                             without.cell(0, "cell.stress_ratio_top")),
                 std::string{"finished, cell.stress_ratio_top has no value: what it is divided by is 0 in the means"});
  program.write("cell_output.toml",
                "base = \"cells_base.toml\"\noutputs = [\"cell.deepth\"]\n" + listed("cell.seed", "1"));
  const ProgramEnd output = program.end({"sweep", "plan", "cell_output.toml"});
  differ.ended("refusal: output of a cell", output, 2,
               "cell_output.toml:2: outputs: number of a cell 'cell.deepth' is not known; "
               "nearest: cell.depth");
  program.write("cell_error.toml",
                "base = \"cells_base.toml\"\noutputs = [\"cell.restitution.error\"]\n" + listed("cell.seed", "1"));
  differ.compare("refusal: error of a group", program.end({"sweep", "plan", "cell_error.toml"}).exit_code, 2);
  program.write("CNTRL.DAT", "0 0\n");
  program.write("deck_cell.toml", "base = \"CNTRL.DAT\"\noutputs = [\"cell.depth\"]\n" + listed("cell.seed", "1"));
  const ProgramEnd deck = program.end({"sweep", "plan", "deck_cell.toml"});
  differ.ended("refusal: a cell without units", deck, 2, "CNTRL.DAT: CNTRL.DAT has no units");
}

}  // namespace

void check_cells(const Program& program, Differences& differ) {
  check_numbers(program, differ);
  check_units(program, differ);
  check_fit(program, differ);
  check_ends(program, differ);
}

}  // namespace talus::verification::problems::swept_scenes
