#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "verification/record/names.hpp"

namespace talus::records {

/// One axis of a figure.
struct Axis {
  std::string label;            ///< What is plotted.
  std::string unit = "1";       ///< Its unit; "1" for a pure number.
  bool log = false;             ///< Logarithmic; points that are not positive are then left out, and counted.
  std::optional<double> min{};  ///< Lower end; chosen from the data if absent.
  std::optional<double> max{};  ///< Upper end; chosen from the data if absent.
  int divisions = 0;            ///< Equal parts that the grid makes of a linear axis; 0: round numbers.
};

/// How a series is drawn.
enum class Style {
  points,
  lines,
  linespoints,
  errorbars,
  crosses,
  outlines,  ///< Closed lines one after another: each ends where its first point is, and the next point begins
             ///< another. A figure with outlines has the same scale on both axes.
  heat,      ///< Each point of a regular grid is coloured by its value.
  shapes,    ///< Polylines, each as far as `Series::line` is the same, drawn as Look says.
  circles,   ///< With `Series::radius`, drawn as Look says.
};

template <>
struct Names<Style> {
  static constexpr std::array values{std::pair{Style::points, "points"},
                                     std::pair{Style::lines, "lines"},
                                     std::pair{Style::linespoints, "linespoints"},
                                     std::pair{Style::errorbars, "errorbars"},
                                     std::pair{Style::crosses, "crosses"},
                                     std::pair{Style::outlines, "outlines"},
                                     std::pair{Style::heat, "heat"},
                                     std::pair{Style::shapes, "shapes"},
                                     std::pair{Style::circles, "circles"}};
};

/// Whether a style is drawn as a Look says, and explained in the key of the page, not of the panel.
[[nodiscard]] constexpr bool has_look(Style style) { return style == Style::shapes || style == Style::circles; }

/// How shapes and circles are drawn; a colour is "#rrggbb".
struct Look {
  std::string colour{};  ///< Of the lines; empty: none, or by value.
  std::string fill{};    ///< Of closed lines; empty: none, or of circles by value.
  double width = 1.0;    ///< Of the lines.
  bool dashed = false;
};

/// Columns of the figure's CSV file that hold a series; empty where the series has no such numbers.
struct Columns {
  std::string x{};
  std::string y{};
  std::string where{};  ///< Only rows whose column `series` holds this; empty: all rows.
  std::string y_low{};
  std::string y_high{};
  std::string value{};
  std::string radius{};
};

/// One curve or cloud of points. `y_low` and `y_high` are empty, or as long as `x` and `y` (bars from low to high);
/// `values` likewise (heat; shapes and circles that are coloured by them).
struct Series {
  std::string label;
  std::vector<double> x{};
  std::vector<double> y{};
  Style style = Style::linespoints;
  std::vector<double> y_low{};
  std::vector<double> y_high{};
  std::vector<double> values{};
  int panel = 0;  ///< Index of the panel that shows it, in a figure that has panels.
  Look look{};
  std::vector<double> line{};    ///< Of shapes: the number of the line that a point belongs to.
  std::vector<double> radius{};  ///< Of circles, in units of the abscissa.
  Columns columns{};             ///< Where the numbers stand in the CSV file.

  /// Adds the point (at, value).
  void add(double at, double value) {
    x.push_back(at);
    y.push_back(value);
  }
};

/// Whether the points of a series have values, or will have them when they are read.
[[nodiscard]] inline bool coloured_by_value(const Series& series) {
  return !series.values.empty() || !series.columns.value.empty();
}

/// A straight reference line y ~ x^order through (x, y), drawn dashed with its label, in a log-log figure.
struct Slope {
  double order = 1.0;
  double x = 1.0;
  double y = 1.0;
  std::string label;
};

/// A thin line across the figure where x or y has the value `at`.
struct Line {
  char axis = 'y';  ///< 'x' or 'y'.
  double at = 0.0;
  std::string label;
};

/// Text at a position of a figure.
struct Mark {
  double x = 0.0;
  double y = 0.0;
  std::string words;
};

/// Colours for values. In a figure of its own two hues that part at the middle of the range, on a page of shapes from
/// pale to dark; values beyond the range have the colour of its end.
struct Scale {
  std::string label;
  double min = -1.0;
  double max = 1.0;
  std::string unit = "1";
};

/// A figure and its data, which a record keeps in one CSV file.
struct Figure {
  std::string name;     ///< File stem, unique in its case.
  std::string title;    ///< Short, above the figure.
  std::string caption;  ///< What is seen and what it shows; Markdown.
  Axis x;
  Axis y;
  std::vector<Series> series{};
  std::vector<Slope> slopes{};
  std::vector<Line> lines{};
  std::vector<std::string> panels{};  ///< Titles of panels side by side with the same axes; empty: one without a title.
  int columns = 1;                    ///< Panels in a row.
  std::optional<Scale> scale{};       ///< Needed for heat maps.
  std::string csv{};                  ///< Name of the CSV file beside the record.
  std::vector<Mark> marks{};
  bool grid = true;
  bool equal = false;  ///< A unit is as long on both axes; both then have their limits.
};

/// Called with the part of a figure that is at fault ("series[1].look", empty for the whole) and the fault; throws.
using Complain = std::function<void(const std::string& part, const std::string& fault)>;

/// Demands what all figures must fulfil, whether made or read: limits and lines of logarithmic axes > 0, panels and
/// scales that exist, colours that are colours.
void demand_sound(const Figure& figure, const Complain& fail);

/// Demands min < max.
void demand_sound(const Scale& scale, const Complain& fail);

/// Names the CSV file of a figure (NAME.csv) and the columns of its series: x, y, those of bars and values if it has
/// them, and in the column `series` its label in lower case with '_' for all but letters and digits, numbered where two
/// would be the same.
void name_columns(Figure& figure);

}  // namespace talus::records
