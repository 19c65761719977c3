/// The pictures of a run, as values: figures with their points, pages and animations, and players.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "reports/base/record.hpp"

namespace talus::reports {

/// Formats in which figures and pages can be drawn: PostScript, PDF, SVG and PNG.
inline constexpr std::array picture_formats{"ps", "pdf", "svg", "png"};
/// Those that are drawn unless others are requested: all but PostScript.
[[nodiscard]] inline std::vector<std::string> default_formats() {
  return {picture_formats.begin() + 1, picture_formats.end()};
}

/// Figures in rows and columns under one title. Shapes with a label are explained once, below all panels.
struct Page {
  std::string name;  ///< File stem.
  std::string title;
  int columns = 1;
  std::vector<Figure> panels;
  std::optional<Scale> scale{};  ///< Scale of the values of shapes and circles.
};

/// Pages shown one after the other as an animation.
struct Film {
  std::string name;    ///< File stem.
  double delay = 0.0;  ///< Time per page [s] > 0.
  std::vector<Page> pages;
};

/// An HTML page that plays a run.
struct Player {
  std::string name;  ///< File stem.
  std::string title;
  std::string data;  ///< Data to play, as JSON.
};

/// All pictures drawn together. A figure outside of pages becomes one picture, with the name of the figure.
struct Pictures {
  std::vector<Figure> figures{};
  std::vector<Page> pages{};
  std::vector<Film> films{};
  std::vector<Player> players{};
};

/// Checks that names cannot lead out of a folder, that a page has at least one panel and 1 to 12 columns, a film at
/// least one page and a delay > 0, and the demands of records::demand_sound() on figures and scales. Throws RecordError
/// with the name of the picture.
void demand_sound(const Pictures& pictures);

}  // namespace talus::reports
