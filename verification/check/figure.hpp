#pragma once

#include <optional>
#include <string>
#include <vector>

namespace talus::verification {

/// One axis of a figure.
struct Axis {
  std::string label;            ///< What is plotted.
  std::string unit = "1";       ///< Its unit; "1" for a pure number.
  bool log = false;             ///< Logarithmic; points that are not positive are then left out, and counted.
  std::optional<double> min{};  ///< Lower end; chosen from the data if absent.
  std::optional<double> max{};  ///< Upper end; chosen from the data if absent.
};

/// How a series is drawn. `outlines` are closed lines, one after another: each ends where its first point is, and the
/// next point begins another. A figure with outlines has the same scale on both axes. `heat` colours each point of a
/// regular grid by its value.
enum class Style { points, lines, linespoints, errorbars, crosses, outlines, heat };

/// The word for `style` in the records.
[[nodiscard]] const char* name_of(Style style);

/// The style called `name`; std::invalid_argument for any other word.
[[nodiscard]] Style style_named(const std::string& name);

/// Colours for the values of heat maps, two hues that part at the middle of the range; what lies beyond has the colour
/// of its end.
struct Scale {
  std::string label;
  double min = -1.0;
  double max = 1.0;
  std::string unit = "1";
};

/// One curve or cloud of points. `y_low` and `y_high` are empty, or as long as `x` and `y` (bars from low to high);
/// `values` likewise (heat).
struct Series {
  std::string label;
  std::vector<double> x{};
  std::vector<double> y{};
  Style style = Style::linespoints;
  std::vector<double> y_low{};
  std::vector<double> y_high{};
  std::vector<double> values{};
  int panel = 0;  ///< Of the figure's panels, the one that shows it.

  /// Adds the point (at, value).
  void add(double at, double value) {
    x.push_back(at);
    y.push_back(value);
  }
};

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

/// A figure with its own data; recorded as one CSV file in long form.
struct Figure {
  std::string name;     ///< File stem, letters, digits and '_'; unique in its case.
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
};

/// std::invalid_argument, naming figure and series, if names or captions are missing, if lengths differ, if a heat
/// map has no scale, a series no panel, or if there is nothing to draw.
void demand_well_formed(const Figure& figure);

/// The number of points with a NaN or an infinity in them. Findings::figure turns any into a failed check.
[[nodiscard]] std::size_t not_finite(const Figure& figure);

/// The figure without the points that cannot be drawn (not finite, or not positive on a logarithmic axis). If there
/// were any, the caption ends with their number: they do not drop out in silence. Series left without points are
/// removed.
[[nodiscard]] Figure drawable(Figure figure);

}  // namespace talus::verification
