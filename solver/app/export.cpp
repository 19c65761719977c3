#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <variant>

#include "solver/app/command.hpp"
#include "solver/base/error.hpp"
#include "solver/command_line/usage_error.hpp"
#include "solver/io/cell/lammps.hpp"
#include "solver/io/cell/read_cell.hpp"

namespace talus::app {
namespace {

struct ExportOptions {
  std::string program;
  std::string scene;
  std::string folder;
  std::optional<long> steps;  ///< default: those of the scene
  bool dashpot{false};
};

/// Error about a law that LAMMPS does not have.
InputError not_in_lammps(const ShearCell& cell, const ExportOptions& options, const std::string& remedy) {
  return InputError{fmt::format("{}: found law = {} (a restitution of {:.4g}), which LAMMPS does not have; {}",
                                options.scene, std::visit([](const auto& law) { return law.name; }, cell.law),
                                cell.restitution(), remedy)};
}

/// The cell's law in the form available in LAMMPS. Errors: InputError for a law that LAMMPS does not have, unless it
/// latches and --dashpot replaces it.
std::variant<LinearSpringDashpot, Hertz> exported_law(const ShearCell& cell, const ExportOptions& options) {
  if (const auto* linear = std::get_if<LinearSpringDashpot>(&cell.law)) return *linear;
  if (const auto* hertz = std::get_if<Hertz>(&cell.law)) {
    if (hertz->dashpot == HertzDashpot::constant || hertz->damping == 0.0) return *hertz;
    throw not_in_lammps(cell, options, "the dashpot is tsuji; it must be constant");
  }
  if (!cell.is_linear())
    throw not_in_lammps(cell, options, "it must be linear_spring_dashpot, hertz or latching_spring");
  const double kept = cell.restitution();
  if (kept < 1.0 && !options.dashpot) {
    throw not_in_lammps(cell, options,
                        "--dashpot gives springs of its stiffness while it is pressed with a dashpot of the same "
                        "restitution");
  }
  LinearSpringDashpot law{cell.stiffness(), 0.0, EndRule::clamped};
  if (kept < 1.0) law.set_restitution(kept, 0.5 * cell.mass, 0.0);
  return law;
}

/// Steps of the cell's run; its means exclude the first quarter, as in CellRun.
LammpsRun lammps_run(const CellScene& scene, const ExportOptions& options) {
  const CellPlan& plan = scene.plan;
  const long steps = options.steps.value_or(std::lround(plan.end / plan.step));
  LammpsRun run{.step = plan.step, .steps = steps, .skin = 0.3 * scene.cell.diameter};
  constexpr long fewest = 100;  // minimum number of steps for means
  if (steps < fewest) return run;
  const ShearCell& cell = scene.cell;
  const long every = std::clamp(std::lround(plan.every / plan.step), 1L, std::max(steps / 10, 1L));
  run.means = LammpsMeans{.area = cell.wall_discs * cell.diameter * cell.diameter, .every = every, .from = steps / 4};
  return run;
}

int export_scene(const ExportOptions& options) {
  const CellScene scene = read_cell(options.scene, {});
  if (scene.restart) {
    throw InputError{
        fmt::format("{}: RESTRT: found 1; the cell is written as it is filled: it must be 0", options.scene)};
  }
  const FilledCell filled = fill(scene.cell);
  const LammpsRun run = lammps_run(scene, options);
  export_lammps(options.folder,
                {filled.shapes, filled.discs, filled.box, exported_law(scene.cell, options), scene.cell.friction}, run);
  fmt::print("files: {0}: discs.data, in.discs\nrun: cd {0} && lmp -in in.discs   # {1} steps to t = {2:g}\n",
             options.folder, run.steps, static_cast<double>(run.steps) * run.step);
  if (run.means)
    fmt::print(
        "compare: the means at its end with those of talus cell {}; the flow is chaotic: runs of several "
        "seeds agree in their mean\n",
        options.scene);
  return ok;
}

}  // namespace

Command add_export(CLI::App& talus) {
  CLI::App* app = talus.add_subcommand("export", "Write a scene as another program takes it");
  const auto options = std::make_shared<ExportOptions>();
  app->add_option("PROGRAM", options->program, "lammps: its data and input file")
      ->required()
      ->check(CLI::IsMember({"lammps"}));
  app->add_option("CELL", options->scene, "CNTRL.DAT of 1989 or a scene file with [cell]: the cell at its start")
      ->required();
  app->add_option("--out", options->folder, "folder for discs.data and in.discs")->required();
  app->add_option("--steps", options->steps, "that it is to take, of the scene's length; default: to the scene's end")
      ->check(whole_between(0, 1'000'000'000));
  app->add_flag("--dashpot", options->dashpot,
                "a spring and dashpot of the same restitution for a spring that latches");
  app->footer(
      "Example:\n  talus export lammps cases/cell/ice.toml --dashpot --out lammps && cd lammps && lmp -in in.discs");
  return {app, [options] { return export_scene(*options); }};
}

}  // namespace talus::app
