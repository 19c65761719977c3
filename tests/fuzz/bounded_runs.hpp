#pragma once

#include <filesystem>

#include "solver/io/cell/read_cell.hpp"
#include "solver/io/scene/scene_file.hpp"

/// Runs of the models that readers return, within bounds of work.
namespace talus::fuzz {

/// Number of steps of a model's run, and the bounds of such a run: larger models are not run, and longer runs are
/// stopped.
struct Bounds {
  static constexpr long steps = 100;
  static constexpr long evaluations = 20'000;
  static constexpr std::size_t bodies = 1500, contacts = 20'000, nodes = 100'000, discs = 3000;
};

/// Runs a scene as `talus run` does, without files, and makes its summary. Returns true if it reached its end or its
/// 100th step within the bounds. Errors: InputError; std::logic_error for an outcome without time or reason.
bool run_scene(const SceneFile& scene, const std::filesystem::path& file);
/// The same for a cell, as `talus cell` runs it; from the discs in `start`, if given.
bool run_cell(const CellScene& scene);
bool run_cell(const CellScene& scene, FilledCell start);

/// Resumes a scene's run from a checkpoint as `talus run --resume` does. Errors: those of its readers.
bool resume_scene(const std::filesystem::path& checkpoint);
/// The same for a cell, without its files and the choices of its command line.
bool resume_cell(const std::filesystem::path& checkpoint);

/// Writes the files of a run of a scene, and of a cell, to a folder, with a checkpoint of its 20th step: "saved.json".
void leave_scene_run(const std::filesystem::path& scene, const std::filesystem::path& folder);
void leave_cell_run(const std::filesystem::path& scene, const std::filesystem::path& folder);

}  // namespace talus::fuzz
