#include "tests/fuzz/bounded_runs.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "solver/app/life_cycle.hpp"
#include "solver/app/run/run_summary.hpp"
#include "solver/app/run/scene_run.hpp"
#include "solver/app/scene_request.hpp"
#include "solver/base/archive.hpp"
#include "solver/base/error.hpp"
#include "solver/cell/cell_run.hpp"
#include "solver/io/cell/cell_restart.hpp"
#include "solver/io/cell/write_cell.hpp"
#include "solver/io/cell/write_cell_plot.hpp"
#include "solver/io/file/atomic_file.hpp"
#include "solver/io/file/toml_document.hpp"
#include "solver/io/output/checkpoint.hpp"
#include "solver/io/output/write_summary.hpp"
#include "solver/io/read_scene_file.hpp"
#include "solver/stability/step_advice.hpp"

namespace talus::fuzz {
namespace {

namespace fs = std::filesystem;

/// Steps before the checkpoint of a run is written.
constexpr long saved_steps = 20;

bool is_large(const Model& model) {
  std::size_t nodes = 0;
  for (const Contact& contact : model.contacts)
    nodes += static_cast<std::size_t>(contact.nodes[0]) + static_cast<std::size_t>(contact.nodes[1]);
  return model.bodies.size() > Bounds::bodies || model.contacts.size() > Bounds::contacts || nodes > Bounds::nodes;
}

/// Advances the run by up to 100 steps and makes its record. Returns whether it stayed within the bounds.
bool advance(app::SceneRun& run) {
  bool cut = false;
  long steps = 0;
  const long before = run.run_state().evaluations;
  const auto stop = [&](const Snapshot&) {
    cut = run.run_state().evaluations - before > Bounds::evaluations;
    return cut || ++steps >= Bounds::steps;
  };
  Progress progress;
  const Outcome outcome = run.proceed(stop, &progress);
  if (outcome.kind == Outcome::Kind::diverged && (outcome.message.empty() || !std::isfinite(outcome.time)))
    throw std::logic_error{fmt::format("diverged at {} because of '{}'", outcome.time, outcome.message)};
  const RunRecord record = run.record(outcome);
  if (summary_json(record).empty() || app::run_summary(record, run.parts(), true).empty())
    throw std::logic_error{"a run without a summary"};
  return !cut;
}

bool advance(CellRun& run, const CellScene& scene) {
  const long first = run.steps();
  while (!run.finished() && run.failure().empty() && run.steps() - first < Bounds::steps)
    run.advance();
  const CellOutcome outcome{run.outcome(), {}};
  if (cell_summary_json(scene, run, outcome).empty() || cell_history(scene, run).columns.empty() ||
      cell_state_vtp(run).empty())
    throw std::logic_error{"a cell without a summary"};
  return true;
}

/// A sample is half a contact time, which may be any number of steps.
bool is_large(const CellScene& scene) {
  return scene.cell.free_discs() + 2 * static_cast<std::size_t>(scene.cell.wall_discs) > Bounds::discs ||
         !(scene.cell.contact_time() / scene.plan.step < 1e4) || !(scene.plan.outputs() < 1e6);
}

Checkpoint saved(const fs::path& scene) {
  Checkpoint checkpoint;
  checkpoint.scene_file = scene.string();
  checkpoint.scene_fnv1a = fnv1a(read_text(scene));
  return checkpoint;
}

}  // namespace

bool run_scene(const SceneFile& scene, const fs::path& file) {
  if (is_large(scene.scene.model)) return false;
  app::SceneRun run{scene, {}, file, {}};
  if (run.dynamics().layout().coordinates.size() <= maximum_watched_coordinates)
    static_cast<void>(step_verdict(scene.scene, advise_step(run.dynamics(), scene.scene.initial)));
  return advance(run);
}

bool run_cell(const CellScene& scene) {
  if (is_large(scene)) return false;
  CellRun run{scene.cell, scene.plan};
  return advance(run, scene);
}

bool run_cell(const CellScene& scene, FilledCell start) {
  CellRun run{scene.cell, scene.plan, std::move(start)};
  return advance(run, scene);
}

bool resume_scene(const fs::path& checkpoint) {
  app::SceneOptions options;
  options.resume = checkpoint.parent_path();
  const app::SceneRequest request = app::scene_request(options);
  app::SceneRun run{request.file, {}, request.name(), {.sheet = request.sheet, .impacts = request.impacts}};
  app::restore(request.run, [&](Archive& archive) {
    run.serialize(archive);
    if (const auto names = archive.left_over(); !names.empty()) throw InputError{"found " + names.front()};
  });
  return advance(run);
}

bool resume_cell(const fs::path& checkpoint) {
  app::RunOptions options;
  options.resume = checkpoint.parent_path();
  const app::RunRequest request = app::run_request("cell", options, {});
  const CellScene scene = read_cell(request.scene, {});
  CellRun run{scene.cell, scene.plan};
  app::restore(request, [&](Archive& archive) {
    std::string choice;
    archive.scope("choices", [&] { archive.text("integrator", choice); });
    archive.scope("run", [&] { run.serialize(archive); });
    if (const auto names = archive.left_over(); !names.empty()) throw InputError{"found " + names.front()};
  });
  return advance(run, scene);
}

void leave_scene_run(const fs::path& scene, const fs::path& folder) {
  fs::create_directories(folder);
  const SceneFile file = read_scene_file(scene);
  app::SceneRun run{file, folder, scene, {.frames = 3}};
  Progress progress;
  const RunRecord record = run.record(run.proceed({}, &progress));
  run.write(record);
  write_whole(folder / "summary.json", summary_json(record));

  app::SceneRun interrupted{file, {}, scene, {}};
  long steps = 0;
  static_cast<void>(interrupted.proceed([&](const Snapshot&) { return ++steps >= saved_steps; }, &progress));
  Archive archive;
  interrupted.serialize(archive);
  Checkpoint checkpoint = saved(scene);
  checkpoint.integrator = name(file.scene.integrator), checkpoint.tolerance = tolerance(file.scene.integrator);
  checkpoint.step = file.scene.plan.step, checkpoint.end = file.scene.plan.end;
  checkpoint.steps = interrupted.run_state().step;
  checkpoint.memory = archive.items();
  write_whole(folder / "saved.json", checkpoint_text(checkpoint, TALUS_VERSION));
}

void leave_cell_run(const fs::path& scene, const fs::path& folder) {
  fs::create_directories(folder);
  const CellScene read = read_cell(scene, {});
  CellRun run{read.cell, read.plan};
  while (run.steps() < saved_steps)
    run.advance();
  Archive archive;
  std::string choice;
  archive.scope("choices", [&] { archive.text("integrator", choice); });
  archive.scope("run", [&] { run.serialize(archive); });
  Checkpoint checkpoint = saved(scene);
  checkpoint.integrator = read.plan.integrator;
  checkpoint.step = read.plan.step, checkpoint.end = read.plan.end;
  checkpoint.steps = run.steps();
  checkpoint.memory = archive.items();
  write_whole(folder / "saved.json", checkpoint_text(checkpoint, TALUS_VERSION));
  write_whole(folder / "RESTART.DAT", cell_restart_text(read.cell, run.discs(), run.steps()));
  write_whole(folder / "cell.vtp", cell_state_vtp(run));
  write_whole(folder / "plot.json", cell_plot_json(read, run));
}

}  // namespace talus::fuzz
