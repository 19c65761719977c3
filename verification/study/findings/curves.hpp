#pragma once

#include <string>
#include <utility>
#include <vector>

#include "verification/check/figure.hpp"

/// Helpers for curves and points in figures.
namespace talus::verification::problems {

/// Curve through the points (x, f(x)), drawn as a line.
template <class Function>
[[nodiscard]] Series curve(std::string label, std::vector<double> x, Function&& f) {
  Series made{.label = std::move(label), .style = Style::lines};
  for (const double at : x)
    made.y.push_back(f(at));
  made.x = std::move(x);
  return made;
}

/// Measured points; x and y have the same length.
[[nodiscard]] inline Series points(std::string label, std::vector<double> x, std::vector<double> y) {
  return {.label = std::move(label), .x = std::move(x), .y = std::move(y), .style = Style::points};
}

/// The numbers first h, (first + 1) h, ... last h.
[[nodiscard]] inline std::vector<double> multiples(double h, int first, int last) {
  std::vector<double> all;
  for (int i = first; i <= last; ++i)
    all.push_back(h * i);
  return all;
}

/// The series with line style.
[[nodiscard]] inline Series as_line(Series series) {
  series.style = Style::lines;
  return series;
}

}  // namespace talus::verification::problems
