/// What is to be drawn of a run, beside the CSV files that it names; `plot.json`.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "verification/record/figure.hpp"

namespace talus::records {

/// Figures side by side, row by row, under one title. Shapes with a label are explained once, below all panels.
struct Page {
  std::string name;  ///< File stem.
  std::string title;
  int columns = 1;
  std::vector<Figure> panels;
  std::optional<Scale> scale{};  ///< Of the values of shapes and circles.
};

/// Pages one after the other as one picture that moves.
struct Film {
  std::string name;    ///< File stem.
  double delay = 0.0;  ///< From page to page [s] > 0.
  std::vector<Page> pages;
};

/// A page for a browser that plays a run.
struct Player {
  std::string name;  ///< File stem.
  std::string title;
  std::string data;  ///< JSON file with what it plays.
};

struct Plots {
  std::string title{};
  std::vector<Figure> figures{};
  std::vector<Page> pages{};
  std::vector<Film> films{};
  std::vector<Player> players{};
};

/// The JSON text of plot.json (schema 1).
[[nodiscard]] std::string text_of(const Plots& plots);

/// Reads plot.json. FileError if the file cannot be read; RecordError (file and path) if it is not what the schema says
/// or nothing is to be drawn. Keys that hold a default may be absent.
[[nodiscard]] Plots read_plots(const std::filesystem::path& file);

}  // namespace talus::records
