#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "solver/draw/drawing.hpp"

namespace talus::app {

/// Limits of an axis, in the axis's unit.
using Limits = std::optional<std::pair<double, double>>;

/// Options of `talus plot --history`, corresponding to HPLOT's dialogue.
struct HistoryPlotOptions {
  std::vector<std::string> folders;
  std::vector<std::string> histories;
  std::vector<std::string> elements;
  bool all{false};  ///< all curves of a panel, else at most `maximum_curves` if no elements are named
  std::string abscissa{"time"};
  std::string until;  ///< last time that is drawn
  bool apart{false};  ///< one panel for each history; else one for each unit
  int columns{};      ///< panels side by side; 0: automatic, two for three or more panels, else one
  std::string x_title;
  std::string y_title;
  Limits x_limits;
  Limits y_limits;
  std::vector<int> divisions;  ///< of the grid, x and y; empty: round numbers
  bool no_grid{false};
  PictureOptions picture;
};

/// The histories of one run, or of several runs in the same panels, as one page. Errors: InputError for histories that
/// the runs did not save; IoError.
[[nodiscard]] DrawingRequest history_drawing(const HistoryPlotOptions& options);

/// Prints the saved histories of each run.
[[nodiscard]] int list_histories(const std::vector<std::string>& folders);

}  // namespace talus::app
