/// A figure with its numbers read and its limits determined, ready to draw.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "reports/base/record.hpp"

namespace talus::reports {

/// One point; low and high are the ends of its error bar (equal to y without one). For a shape: the line it belongs to
/// and the value that determines its colour; for a circle: its radius and that value.
struct Point {
  double x{}, y{}, low{}, high{};
  double line{}, value{}, radius{};
};

/// One curve's points, in the order of the file.
struct Curve {
  std::string label;
  Style style{};
  std::vector<Point> points;
  Look look{};
  bool by_value{};  ///< coloured by Point::value
};

/// Limits of one axis, low < high.
struct Extent {
  double low{}, high{};
};

struct Plot {
  Figure figure;  ///< without its points
  std::vector<Curve> curves;
  Extent x;
  Extent y;
  std::size_t undrawn{};  ///< points at or below zero, which a log axis cannot show
};

/// The plot of a figure whose series contain their points. Throws RecordError when a number is not finite or there is
/// nothing to draw.
[[nodiscard]] Plot plot_of(Figure figure);

/// Reads the figure's CSV file in `folder`. Throws RecordError (file, column, line) when file or column is missing, a
/// cell is not a number, a series has no row, or there is nothing to draw.
[[nodiscard]] Plot plot_of(const Figure& figure, const std::filesystem::path& folder);

/// Limits that contain all values with a small margin; a single value is given a width. Values must be > 0 when log.
[[nodiscard]] Extent extent_of(const std::vector<double>& values, bool log);

/// The curve reduced to at most about `limit` points: of each block of neighbours only the lowest and highest point is
/// kept, so that the drawn line covers the same pixels.
[[nodiscard]] std::vector<Point> thinned(const std::vector<Point>& points, std::size_t limit);

}  // namespace talus::reports
