/// A run's wish to be drawn (`plot.json`).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "reports/record.hpp"

namespace talus::reports {

/// Figures side by side, row by row, under one title. Shapes with a label are explained once, below all panels.
struct Page {
  std::string name;  ///< file stem
  std::string title;
  int columns{1};
  std::vector<Figure> panels;
  std::optional<Scale> scale;
  std::optional<double> panel_high{};  ///< [cm]; chosen from the width if absent
  bool two_hues{};                     ///< of the scale: blue against red, else pale to dark
};

/// Pages one after the other as one picture that moves.
struct Film {
  std::string name;  ///< file stem
  double delay{};    ///< from page to page [s] > 0
  std::vector<Page> pages;
};

/// A page for a browser that plays a run; what it plays stands in a file beside the record.
struct Player {
  std::string name;  ///< file stem
  std::string title;
  std::string data;  ///< JSON file
};

struct Plots {
  std::string title;
  std::vector<Figure> figures;
  std::vector<Page> pages;
  std::vector<Film> films;
  std::vector<Player> players;
};

/// Reads plot.json. FileError if the file cannot be read; RecordError (file and path) if it is not what the schema says
/// or nothing is to be drawn.
[[nodiscard]] Plots read_plots(const std::filesystem::path& file);

}  // namespace talus::reports
