#include "reports/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/csv.hpp"
#include "reports/error.hpp"

namespace talus::reports {
namespace {

/// A curve beyond this many points is finer than a page can show.
constexpr std::size_t most_points = 3000;

bool drawable(const Point& point, const Figure& figure) {
  return !(figure.x.log && point.x <= 0.0) && !(figure.y.log && point.y <= 0.0);
}

Curve curve_of(const Series& series, const Figure& figure, const Csv& csv, std::size_t& undrawn) {
  const std::size_t x = csv.column(series.x);
  const std::size_t y = csv.column(series.y);
  const bool bars = series.style == "errorbars";
  const std::size_t low = bars ? csv.column(series.y_low) : y;
  const std::size_t high = bars ? csv.column(series.y_high) : y;
  const std::size_t filter = series.where.empty() ? 0 : csv.column("series");
  const bool shapes = series.style == "shapes";
  const std::size_t line = shapes ? csv.column("line") : y;
  const std::size_t value = series.look.value.empty() ? y : csv.column(series.look.value);
  const std::size_t radius = series.look.radius.empty() ? y : csv.column(series.look.radius);
  Curve curve{series.label, series.style, {}, series.look};
  std::size_t rows = 0;
  for (std::size_t row = 0; row < csv.rows.size(); ++row) {
    if (!series.where.empty() && csv.rows[row][filter] != series.where) continue;
    ++rows;
    Point point{csv.number(row, x),    csv.number(row, y),     csv.number(row, low),   csv.number(row, high),
                csv.number(row, line), csv.number(row, value), csv.number(row, radius)};
    if (!drawable(point, figure)) {
      ++undrawn;
      continue;
    }
    // A bar that reaches to zero or below ends at the lower edge of a log axis: shown down to a tenth of its value.
    if (figure.y.log && point.low <= 0.0) point.low = 0.1 * point.y;
    curve.points.push_back(point);
  }
  if (rows == 0) {
    throw RecordError(fmt::format("{}: figure '{}': series '{}' (columns '{}', '{}'{}) has no row", csv.file.string(),
                                  figure.name, series.label, series.x, series.y,
                                  series.where.empty() ? "" : ", series = '" + series.where + "'"));
  }
  if (!has_look(series.style) && series.style != "outlines" && series.style != "heat")
    curve.points = thinned(curve.points, most_points);
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
  const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
  const double low = log ? std::log10(*least) : *least;
  const double high = log ? std::log10(*greatest) : *greatest;
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
    auto [least, greatest] = std::minmax_element(begin, end, [](const Point& a, const Point& b) { return a.y < b.y; });
    if (greatest < least) std::swap(least, greatest);
    kept.push_back(*least);
    if (least != greatest) kept.push_back(*greatest);
  }
  kept.push_back(points.back());
  return kept;
}

Plot plot_of(const Figure& figure, const std::filesystem::path& folder) {
  const Csv csv = read_csv(folder / figure.csv);
  Plot plot{figure, {}, {}, {}, 0};
  std::vector<double> xs;
  std::vector<double> ys;
  for (const Series& series : figure.series) {
    plot.curves.push_back(curve_of(series, figure, csv, plot.undrawn));
    for (const Point& point : plot.curves.back().points) {
      xs.push_back(point.x);
      ys.insert(ys.end(), {point.y, point.low, point.high});
    }
  }
  if (xs.empty()) {
    throw RecordError(fmt::format("{}: figure '{}' is empty: no point can be drawn", csv.file.string(), figure.name));
  }
  for (const LimitLine& line : figure.lines)
    (line.axis == 'x' ? xs : ys).push_back(line.at);
  plot.x = extent_of(xs, figure.x.log);
  plot.y = extent_of(ys, figure.y.log);
  set_limits(plot.x, figure.x, figure.name);
  set_limits(plot.y, figure.y, figure.name);
  return plot;
}

}  // namespace talus::reports
