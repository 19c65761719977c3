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
  std::string label;            ///< The plotted quantity.
  std::string unit = "1";       ///< Its unit; "1" for a pure number.
  bool log = false;             ///< Logarithmic; points that are not positive are then omitted and counted.
  std::optional<double> min{};  ///< Lower end; chosen from the data if absent.
  std::optional<double> max{};  ///< Upper end; chosen from the data if absent.
  int divisions = 0;            ///< Number of equal grid intervals of a linear axis; 0: round numbers.
};

/// Drawing style of a series.
enum class Style {
  points,
  lines,
  linespoints,
  errorbars,
  crosses,
  outlines,  ///< Consecutive closed lines: each ends where its first point is repeated, and the next point begins
             ///< another one. A figure with outlines has the same scale on both axes.
  heat,      ///< Each point of a regular grid is coloured by its value.
  shapes,    ///< Polylines, one for each value of `Series::line`; drawn according to Look.
  circles,   ///< Circles with `Series::radius`; drawn according to Look.
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

/// Whether a style is drawn according to a Look; such series are explained in the key of the page, not of the panel.
[[nodiscard]] constexpr bool has_look(Style style) { return style == Style::shapes || style == Style::circles; }

/// Appearance of shapes and circles; a colour is "#rrggbb".
struct Look {
  std::string colour{};  ///< Line colour; empty: no line, or coloured by value.
  std::string fill{};    ///< Fill of closed lines; empty: no fill, or circles coloured by value.
  double width = 1.0;    ///< Line width.
  bool dashed = false;
};

/// Columns of the figure's CSV file that contain a series; empty where the series has no such data.
struct Columns {
  std::string x{};
  std::string y{};
  std::string where{};  ///< Only rows with this text in the column `series`; empty: all rows.
  std::string y_low{};
  std::string y_high{};
  std::string value{};
  std::string radius{};
};

/// One curve or cloud of points. `y_low` and `y_high` (error bars from low to high) are either empty or as long as `x`
/// and `y`, and so are `values` (for heat maps, and for shapes and circles coloured by value).
struct Series {
  std::string label;
  std::vector<double> x{};
  std::vector<double> y{};
  Style style = Style::linespoints;
  std::vector<double> y_low{};
  std::vector<double> y_high{};
  std::vector<double> values{};
  int panel = 0;  ///< Index of the panel that shows the series, in a figure with panels.
  Look look{};
  std::vector<double> line{};    ///< For shapes: index of the line that a point belongs to.
  std::vector<double> radius{};  ///< For circles, in units of the abscissa.
  Columns columns{};             ///< Position of the numbers in the CSV file.

  /// Adds the point (at, value).
  void add(double at, double value) {
    x.push_back(at);
    y.push_back(value);
  }
};

/// Whether the points of a series have values, or will have them once they are read.
[[nodiscard]] inline bool coloured_by_value(const Series& series) {
  return !series.values.empty() || !series.columns.value.empty();
}

/// A straight reference line y ~ x^order through (x, y) in a log-log figure, drawn dashed with its label.
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
  std::string text;
};

/// Colour scale for values. A single figure uses two hues that meet at the middle of the range; a page of shapes runs
/// from pale to dark. Values beyond the range have the colour of its end.
struct Scale {
  std::string label;
  double min = -1.0;
  double max = 1.0;
  std::string unit = "1";
};

/// A figure and its data, which a record stores in one CSV file.
struct Figure {
  std::string name;     ///< File stem, unique in its case.
  std::string title;    ///< Short, above the figure.
  std::string caption;  ///< What is shown and what it demonstrates; Markdown.
  Axis x;
  Axis y;
  std::vector<Series> series{};
  std::vector<Slope> slopes{};
  std::vector<Line> lines{};
  std::vector<std::string> panels{};  ///< Titles of panels side by side with the same axes; empty: a single panel
                                      ///< without a title.
  int columns = 1;                    ///< Number of panels in a row.
  std::optional<Scale> scale{};       ///< Required for heat maps.
  std::string csv{};                  ///< Name of the CSV file beside the record.
  std::vector<Mark> marks{};
  bool grid = true;
  bool equal = false;  ///< Equal scale on both axes; both must then have limits.
};

/// Called with the faulty part of a figure ("series[1].look", empty for the whole) and the fault; throws.
using Fail = std::function<void(const std::string& part, const std::string& fault)>;

/// Checks the rules for all figures, created or read: limits and lines of logarithmic axes > 0, existing panels and
/// scales, valid colours.
void demand_sound(const Figure& figure, const Fail& fail);

/// Checks min < max.
void demand_sound(const Scale& scale, const Fail& fail);

/// Sets the CSV file name of a figure (NAME.csv) and the columns of its series: x, y, those of error bars and values if
/// present, and in the column `series` the label in lower case with '_' in place of all but letters and digits,
/// numbered where two labels would be the same.
void name_columns(Figure& figure);

}  // namespace talus::records
