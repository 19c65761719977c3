#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "solver/draw/drawing.hpp"

namespace talus::app {

/// Options of `talus plot` without --history.
struct RunFigureOptions {
  std::filesystem::path folder;       ///< of the run
  std::filesystem::path target;       ///< of the pictures
  std::vector<std::string> elements;  ///< bodies, contacts and cables, by name or number; empty: all of them
  bool all{false};                    ///< draw all curves; else at most `maximum_curves` in a figure
  std::vector<std::string> formats;
};

/// The figures described by the run's plot.json, with the points of its CSV files. Errors: InputError for an element
/// that no figure has, or for a file that was not written by a run; IoError.
[[nodiscard]] DrawingRequest run_drawing(const RunFigureOptions& options);

}  // namespace talus::app
