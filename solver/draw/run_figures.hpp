#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "solver/draw/drawing.hpp"

namespace talus::app {

/// What `talus plot` without --history draws of a run.
struct RunFigureOptions {
  std::filesystem::path folder;       ///< of the run
  std::filesystem::path target;       ///< of the pictures
  std::vector<std::string> elements;  ///< bodies, contacts and cables, by name or number; empty: all of them
  bool all{false};                    ///< all curves; else at most `most_curves` in a figure
  std::vector<std::string> formats;
};

/// The figures that the run's plot.json describes, with the points of its CSV files. Errors: InputError for an element
/// that no figure has, or for a file that is not what a run leaves; IoError.
[[nodiscard]] DrawingRequest run_drawing(const RunFigureOptions& options);

}  // namespace talus::app
