#include "reports/figures/gnuplot_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <vector>

#include "reports/figures/gnuplot_text.hpp"

namespace talus::reports {
namespace {

std::string data_block(const std::string& name, const std::string& rows) {
  return fmt::format("{} << END\n{}END\n", name, rows);
}

/// Rows of a curve; outlines have an empty row after each closed one.
std::string line_rows(const Curve& curve) {
  std::string text;
  const Point* first = nullptr;
  for (const Point& point : curve.points) {
    text += fmt::format("{:.9g} {:.9g} {:.9g} {:.9g}\n", point.x, point.y, point.low, point.high);
    if (curve.style != Style::outlines) continue;
    const bool closed = first && first->x == point.x && first->y == point.y;
    if (closed) text += "\n";
    first = closed ? nullptr : first ? first : &point;
  }
  return text;
}

/// Rows with an empty one between two lines; the third number is the colour of the value.
std::string shape_rows(const Curve& curve, const ColourScale& scale) {
  std::string text;
  double line = curve.points.front().line;
  for (const Point& point : curve.points) {
    if (point.line != line) text += "\n";
    line = point.line;
    text += fmt::format("{:.6g} {:.6g} {}\n", point.x, point.y, scale.colour(point.value));
  }
  return text;
}

/// Rows of a grid with the red, green and blue components of each value.
std::string heat_rows(const Curve& curve, const ColourScale& scale) {
  std::string text;
  for (const Point& point : curve.points) {
    const long colour = scale.colour(point.value);
    text += fmt::format("{:.6g} {:.6g} {} {} {}\n", point.x, point.y, colour / 65536, colour / 256 % 256, colour % 256);
  }
  return text;
}

/// Shapes never appear in the key of a panel: the page explains them. Filled ones are drawn one after the other
/// with their borders, so that those in front cover those behind.
std::string shape_command(const Curve& curve, const std::string& block) {
  const Look& look = curve.look;
  if (!look.fill.empty()) {
    const std::string border = look.colour.empty() ? "noborder" : fmt::format("border lc rgb '{}'", look.colour);
    return fmt::format("{} using 1:2 with filledcurves closed fc rgb '{}' lw {:g} fs transparent solid 0.85 {} notitle",
                       block, look.fill, look.width, border);
  }
  const bool by_value = curve.by_value;
  return fmt::format("{} using 1:2{} with lines lw {:g} dt {} lc rgb {} notitle", block, by_value ? ":3" : "",
                     look.width, look.dashed ? "(6,4)" : "1", by_value ? "variable" : fmt::format("'{}'", look.colour));
}

std::string line_command(const Curve& curve, const std::string& block, std::size_t index) {
  const std::string title = curve.label.empty() ? "notitle" : "title " + gnuplot_text(curve.label);
  const std::string with = curve.style == Style::errorbars  ? "yerrorbars"
                           : curve.style == Style::crosses  ? "points"
                           : curve.style == Style::outlines ? "lines"
                                                            : name_of(curve.style);
  const std::string columns = curve.style == Style::errorbars ? "1:2:3:4" : "1:2";
  const std::string crosses = curve.style == Style::crosses ? " pt 2 ps 0.7" : "";
  const std::string colour = curve.look.colour.empty() ? "" : fmt::format(" lc rgb '{}'", curve.look.colour);
  // The preamble has seven colours; lines without points are distinguished by dashes from the eighth on.
  constexpr std::size_t colours = 7;
  constexpr std::array dashes{"", " dt (8,4)", " dt (2,3)", " dt (10,3,2,3)"};
  const std::string dash = curve.style == Style::lines ? dashes[index / colours % dashes.size()] : "";
  return fmt::format("{} using {} with {} linetype {}{}{}{} {}", block, columns, with, index + 1, colour, dash, crosses,
                     title);
}

/// Number of corners, enough to be invisible: a circle of 1/100 of the picture width has 18, of 1/10 has 40.
int corners(double radius, double width) { return std::clamp(16 + static_cast<int>(500.0 * radius / width), 16, 48); }

/// Circles one after the other, each closed, as polygons: gnuplot draws circles with so fine a polygon that 3000 discs
/// make an SVG of 11 MB.
std::string circle_rows(const std::vector<Point>& circles, double width) {
  std::string text;
  for (const Point& circle : circles) {
    const int count = corners(circle.radius, width);
    for (int k = 0; k < count; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / count;
      text += fmt::format("{:.6g} {:.6g}\n", circle.x + circle.radius * std::cos(angle),
                          circle.y + circle.radius * std::sin(angle));
    }
    text += "\n";
  }
  return text;
}

/// Draws all circles of one colour together, because gnuplot fills each curve with one colour.
CurveScript circles_script(const Curve& curve, const std::string& block, const ColourScale& scale) {
  const Look& look = curve.look;
  std::map<long, std::vector<Point>> by_colour;
  double left = curve.points.front().x, right = left;
  for (const Point& point : curve.points) {
    by_colour[curve.by_value ? scale.colour(point.value) : std::stol(look.fill.substr(1), nullptr, 16)].push_back(
        point);
    left = std::min(left, point.x - point.radius), right = std::max(right, point.x + point.radius);
  }
  const std::string border = look.colour.empty() ? "noborder" : fmt::format("border lc rgb '{}'", look.colour);
  CurveScript script;
  for (const auto& [colour, circles] : by_colour) {
    const std::string name = fmt::format("{}_{:06x}", block, colour);
    script.data += data_block(name, circle_rows(circles, right - left));
    script.command += fmt::format("{}{} using 1:2 with filledcurves closed fc rgb {} lw {:g} fs solid {} notitle",
                                  script.command.empty() ? "" : ", ", name, colour, look.width, border);
  }
  return script;
}

}  // namespace

CurveScript curve_script(const Curve& curve, const std::string& block, std::size_t index, const ColourScale& scale) {
  if (curve.style == Style::circles) return circles_script(curve, block, scale);
  if (curve.style == Style::shapes) return {data_block(block, shape_rows(curve, scale)), shape_command(curve, block)};
  if (curve.style == Style::heat) {
    return {data_block(block, heat_rows(curve, scale)), fmt::format("{} using 1:2:3:4:5 with rgbimage notitle", block)};
  }
  return {data_block(block, line_rows(curve)), line_command(curve, block, index)};
}

}  // namespace talus::reports
