#pragma once

#include <filesystem>
#include <string>

#include "solver/cell/cell_run.hpp"
#include "solver/dynamics/dynamics.hpp"
#include "solver/io/cell/read_cell.hpp"
#include "solver/io/read_scene_file.hpp"

namespace talus::app {

/// Size of a run's output in the folder of --out.
struct OutputSize {
  long rows{};            ///< of history.csv
  std::size_t columns{};  ///< of history.csv
  long states{};          ///< of the geometry
  double bytes{};         ///< of all files together
};

/// The expected output of `talus run FILE --out DIR` for a run to the plan's end: rows, columns and states are exact;
/// bytes are estimated from a few steps, to about 20 %. `scene` is the scene's file, whose name the output files take.
/// Errors: InputError, as in the run, for histories that no element of the fence has.
[[nodiscard]] OutputSize expected_output(const SceneFile& file, const Dynamics& dynamics,
                                         const std::filesystem::path& scene);

/// The expected output of `talus cell FILE --out DIR`; `run` must be at its start and is advanced by some steps.
[[nodiscard]] OutputSize expected_output(const CellScene& scene, CellRun& run);

/// The size as text, e.g. "1001 history rows x 32 columns, 101 states of the geometry, about 1.15 MB".
[[nodiscard]] std::string output_size_text(const OutputSize& size);

}  // namespace talus::app
