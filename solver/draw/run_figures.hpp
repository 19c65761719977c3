#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace talus::app {

/// What `talus plot` without --history draws of a run.
struct RunFigureOptions {
  std::filesystem::path folder;       ///< of the run
  std::filesystem::path target;       ///< of the pictures
  std::vector<std::string> elements;  ///< bodies, contacts and cables, by name or number; empty: all of them
  bool all{false};                    ///< all curves; else at most `most_curves` in a figure
  std::vector<std::string> formats;
};

/// Draws the figures that the run's plot.json describes, and prints how many curves are left out; the exit code of
/// talus_report. Errors: InputError for an element that no figure has; IoError.
[[nodiscard]] int draw_run_figures(const RunFigureOptions& options);

}  // namespace talus::app
