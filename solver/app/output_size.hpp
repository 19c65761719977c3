#pragma once

#include <filesystem>
#include <string>

#include "solver/cell/cell_run.hpp"
#include "solver/dynamics/dynamics.hpp"
#include "solver/io/cell/read_cell.hpp"
#include "solver/io/read_scene_file.hpp"

namespace talus::app {

/// What a run writes to the folder of --out.
struct OutputSize {
  long rows{};            ///< of history.csv
  std::size_t columns{};  ///< of history.csv
  long states{};          ///< of the geometry
  double bytes{};         ///< of all files together
};

/// The expected output of `talus run FILE --out DIR`, of a run to the plan's end: rows, columns and states are counted;
/// bytes are estimated from a few steps, to some 20 %. `scene` names the files. Errors: InputError as such a run has,
/// for histories that no element of a fence has.
[[nodiscard]] OutputSize expected_output(const SceneFile& file, const Dynamics& dynamics,
                                         const std::filesystem::path& scene);

/// The same of `talus cell FILE --out DIR`; `run` is at its start and takes some steps.
[[nodiscard]] OutputSize expected_output(const CellScene& scene, CellRun& run);

/// "1001 history rows x 32 columns, 101 states of the geometry, about 1.15 MB".
[[nodiscard]] std::string output_size_text(const OutputSize& size);

}  // namespace talus::app
