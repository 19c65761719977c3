#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "solver/app/command.hpp"
#include "solver/base/error.hpp"
#include "solver/io/cell_file.hpp"
#include "solver/io/lammps.hpp"
#include "solver/laws/restitution.hpp"

namespace talus::app {
namespace {

struct ExportOptions {
  std::string program;
  std::string scene;
  std::string folder;
  long steps{1000};
  bool dashpot{false};
};

/// What LAMMPS knows of the cell's law. Errors: InputError for springs that latch, unless dashpots may stand for them.
LinearSpringDashpot linear_law(const ShearCell& cell, const ExportOptions& options) {
  if (const auto* linear = std::get_if<LinearSpringDashpot>(&cell.law)) return *linear;
  const double kept = cell.restitution();
  if (kept < 1.0 && !options.dashpot) {
    throw InputError{
        fmt::format("{}: found springs that latch (a restitution of {:.4g}), which LAMMPS does not have; "
                    "--dashpot gives springs of the stiffness K1 with a dashpot of the same restitution",
                    options.scene, kept)};
  }
  LinearSpringDashpot law{cell.stiffness(), 0.0, EndRule::clamped};
  if (kept < 1.0) law.damping = damping(damping_ratio(kept, law.end_rule), law.stiffness, 0.5 * cell.mass);
  return law;
}

int export_scene(const ExportOptions& options) {
  const CellScene scene = read_cell(options.scene, {});
  if (scene.restart) {
    throw InputError{
        fmt::format("{}: RESTRT: found 1; the cell is written as it is filled: it must be 0", options.scene)};
  }
  const FilledCell filled = fill(scene.cell);
  export_lammps(options.folder,
                {filled.shapes, filled.discs, filled.box, linear_law(scene.cell, options), scene.cell.friction},
                {.step = scene.plan.step, .steps = options.steps, .skin = 0.3 * scene.cell.diameter});
  fmt::print("files: {}: discs.data, in.discs\nrun: cd {} && lmp -in in.discs\n", options.folder, options.folder);
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
  app->add_option("--steps", options->steps, "that it is to take, of the scene's length; default 1000")
      ->check(CLI::Range(0L, 1'000'000'000L));
  app->add_flag("--dashpot", options->dashpot,
                "a spring and dashpot of the same restitution for a spring that latches");
  app->footer(
      "Example:\n  talus export lammps cases/cell/ice.toml --dashpot --out lammps && cd lammps && lmp -in in.discs");
  return {app, [options] { return export_scene(*options); }};
}

}  // namespace talus::app
