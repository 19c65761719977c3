/// What is drawn of a run, as values: figures that hold their points, pages and films of them, and players.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/record.hpp"

namespace talus::reports {

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
  std::string data;  ///< What it plays, as JSON.
};

/// All that is drawn at a time. A figure outside of pages is one picture, with the name of the figure.
struct Pictures {
  std::vector<Figure> figures{};
  std::vector<Page> pages{};
  std::vector<Film> films{};
  std::vector<Player> players{};
};

/// Demands names that cannot lead out of a folder, at least one panel on a page and one page in a film, 1 to 12 columns,
/// a delay > 0, and what records::demand_sound() demands of figures and scales. Throws RecordError naming the picture.
void demand_sound(const Pictures& pictures);

}  // namespace talus::reports
