#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "solver/draw/drawing.hpp"

namespace talus::app {

/// Ends of an axis, in its own unit.
using Limits = std::optional<std::pair<double, double>>;

/// What `talus plot --history` is asked for: HPLOT's dialogue as options.
struct HistoryPlotOptions {
  std::vector<std::string> folders;
  std::vector<std::string> histories;
  std::vector<std::string> elements;
  bool all{false};  ///< all curves of a panel, else at most `most_curves` if no elements are named
  std::string abscissa{"time"};
  std::string until;  ///< last time that is drawn
  bool apart{false};  ///< a panel for each history; else for each unit
  int columns{};      ///< panels side by side; 0: one, or two from three panels on
  std::string x_title;
  std::string y_title;
  Limits x_limits;
  Limits y_limits;
  std::vector<int> divisions;  ///< of the grid, x and y; empty: round numbers
  bool no_grid{false};
  PictureOptions picture;
};

/// The histories of one run, or of several over each other, as one page. Errors: InputError for what the runs did not
/// keep; IoError.
[[nodiscard]] DrawingRequest history_drawing(const HistoryPlotOptions& options);

/// Prints what each run kept.
[[nodiscard]] int list_histories(const std::vector<std::string>& folders);

}  // namespace talus::app
