#include "reports/figures/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "verification/record/figure_points.hpp"

namespace talus::reports {
namespace {

/// A curve with more points is finer than a page can resolve.
constexpr std::size_t maximum_points = 3000;

bool drawable(const Point& point, const Figure& figure) {
  return !(figure.x.log && point.x <= 0.0) && !(figure.y.log && point.y <= 0.0);
}

/// The number of a point, or `substitute` if the series has no such numbers.
double number(const std::vector<double>& numbers, std::size_t i, double substitute) {
  return numbers.empty() ? substitute : numbers[i];
}

void demand_finite(const Series& series, const std::string& figure) {
  for (const auto* const numbers :
       {&series.x, &series.y, &series.y_low, &series.y_high, &series.line, &series.values, &series.radius}) {
    const auto wrong = std::find_if(numbers->begin(), numbers->end(), [](double n) { return !std::isfinite(n); });
    if (wrong == numbers->end()) continue;
    throw RecordError(fmt::format("figure '{}': series '{}': found {} at point {}; it must be a finite number", figure,
                                  series.label, *wrong, wrong - numbers->begin() + 1));
  }
}

/// Curve of a series; moves the points out of the series.
Curve curve_of(Series& series, const Figure& figure, std::size_t& undrawn) {
  demand_finite(series, figure.name);
  Curve curve{series.label, series.style, {}, series.look, coloured_by_value(series)};
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    const double y = series.y[i];
    Point point{series.x[i],
                y,
                number(series.y_low, i, y),
                number(series.y_high, i, y),
                number(series.line, i, 0.0),
                number(series.values, i, 0.0),
                number(series.radius, i, 0.0)};
    if (!drawable(point, figure)) {
      ++undrawn;
      continue;
    }
    // An error bar that reaches to zero or below cannot end on a log axis: it is drawn down to a tenth of the value.
    if (figure.y.log && point.low <= 0.0) point.low = 0.1 * point.y;
    curve.points.push_back(point);
  }
  for (auto* const numbers :
       {&series.x, &series.y, &series.y_low, &series.y_high, &series.line, &series.values, &series.radius}) {
    *numbers = {};
  }
  if (!has_look(series.style) && series.style != Style::outlines && series.style != Style::heat)
    curve.points = thinned(curve.points, maximum_points);
  return curve;
}

void set_limits(Extent& extent, const Axis& axis, const std::string& figure) {
  if (axis.min) extent.low = *axis.min;
  if (axis.max) extent.high = *axis.max;
  if (!(extent.low < extent.high)) {
    throw RecordError(
        fmt::format("figure '{}': axis '{}' runs from {} to {}", figure, axis.label, extent.low, extent.high));
  }
}

}  // namespace

Extent extent_of(const std::vector<double>& values, bool log) {
  const auto [minimum, maximum] = std::minmax_element(values.begin(), values.end());
  const double low = log ? std::log10(*minimum) : *minimum;
  const double high = log ? std::log10(*maximum) : *maximum;
  double margin = 0.04 * (high - low);
  if (!(margin > 1e-12 * std::max(std::abs(low), std::abs(high)))) {
    margin = log ? 0.5 : std::max(0.05 * std::abs(high), high == 0.0 ? 1.0 : 0.0);
  }
  if (log) return {std::pow(10.0, low - margin), std::pow(10.0, high + margin)};
  return {low - margin, high + margin};
}

std::vector<Point> thinned(const std::vector<Point>& points, std::size_t limit) {
  if (points.size() <= limit) return points;
  const std::size_t run = (2 * points.size() + limit - 1) / limit;
  std::vector<Point> kept{points.front()};
  for (std::size_t first = 1; first + 1 < points.size(); first += run) {
    const auto begin = points.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = points.begin() + static_cast<std::ptrdiff_t>(std::min(first + run, points.size() - 1));
    auto [minimum, maximum] = std::minmax_element(begin, end, [](const Point& a, const Point& b) { return a.y < b.y; });
    if (maximum < minimum) std::swap(minimum, maximum);
    kept.push_back(*minimum);
    if (minimum != maximum) kept.push_back(*maximum);
  }
  kept.push_back(points.back());
  return kept;
}

Plot plot_of(Figure figure) {
  Plot plot{std::move(figure), {}, {}, {}, 0};
  std::vector<double> xs;
  std::vector<double> ys;
  for (Series& series : plot.figure.series) {
    plot.curves.push_back(curve_of(series, plot.figure, plot.undrawn));
    for (const Point& point : plot.curves.back().points) {
      xs.push_back(point.x);
      ys.insert(ys.end(), {point.y, point.low, point.high});
    }
  }
  if (xs.empty()) {
    throw RecordError(fmt::format("{}{}figure '{}' is empty: no point can be drawn", plot.figure.csv,
                                  plot.figure.csv.empty() ? "" : ": ", plot.figure.name));
  }
  for (const Line& line : plot.figure.lines)
    (line.axis == 'x' ? xs : ys).push_back(line.at);
  plot.x = extent_of(xs, plot.figure.x.log);
  plot.y = extent_of(ys, plot.figure.y.log);
  set_limits(plot.x, plot.figure.x, plot.figure.name);
  set_limits(plot.y, plot.figure.y, plot.figure.name);
  return plot;
}

Plot plot_of(const Figure& figure, const std::filesystem::path& folder) {
  Figure filled = figure;
  records::read_points(filled, folder, records::Rows::some);
  return plot_of(std::move(filled));
}

}  // namespace talus::reports
