#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "solver/geometry/shape.hpp"
#include "verification/check/convergence.hpp"
#include "verification/problems/outlines/superellipse_findings.hpp"
#include "verification/reference/superellipse.hpp"

namespace talus::verification::problems {

Superquadric superellipse_told(double n, const Setup& setup) {
  const auto [a, b] = superellipse_half_axes;
  return {setup.has("half_axis_off") ? 1.000001 * a : a, b, setup.has("exponent_off") ? 1.001 * n : n};
}

namespace {

std::vector<reference::Point> polygon(double n, double corners, const Setup& setup) {
  const int count = static_cast<int>(setup.has("nodes_left_out") ? corners / 2.0 : corners);
  std::vector<reference::Point> found;
  for (const Vec2 p : boundary_nodes(Shape{superellipse_told(n, setup)}, count))
    found.push_back({p.x, p.y});
  return found;
}

/// What polygons of 32 ... 2048 nodes lack.
struct Lacking {
  reference::Superellipse shape;
  double area{}, moment{};  ///< of the shape itself
  Convergence of_area, of_moment;
};

Lacking lacking(double n, const Setup& setup) {
  Lacking found{{superellipse_half_axes[0], superellipse_half_axes[1], n}, 0.0, 0.0, {}, {}};
  found.area = reference::area(found.shape);
  found.moment = reference::polar_moment(found.shape);
  for (const double corners : doublings(32.0, 7)) {
    const auto nodes = polygon(n, corners, setup);
    found.of_area.add(1.0 / corners, found.area - reference::polygon_area(nodes));
    found.of_moment.add(1.0 / corners, found.moment - reference::polygon_polar_moment(nodes));
  }
  return found;
}

/// What polygons lack over its leading order, the last of them and extrapolated from the last three: the next terms are
/// nodes^(-2/n) and, of the moment, nodes^(-6/n).
std::array<double, 2> over_leading_order(const Convergence& lacking, double constant, double n) {
  std::array<double, 3> ratio{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t at = lacking.size() - 3 + i;
    ratio[i] = lacking.errors()[at] / (constant * lacking.steps()[at] * lacking.steps()[at]);
  }
  const auto without = [](double share, double coarse, double fine) { return (fine - share * coarse) / (1.0 - share); };
  const double first = std::pow(0.5, 2.0 / n), second = std::pow(0.5, 6.0 / n);
  return {ratio[2], without(second, without(first, ratio[0], ratio[1]), without(first, ratio[1], ratio[2]))};
}

void draw(Figure& figure, const Lacking& found) {
  Series points{fmt::format("n = {:g}", found.shape.n), {}, {}, Style::points};
  Series line{fmt::format("n = {:g}, leading order", found.shape.n), {}, {}, Style::lines};
  for (std::size_t i = 0; i < found.of_area.size(); ++i) {
    const double corners = 1.0 / found.of_area.steps()[i];
    points.add(corners, found.of_area.errors()[i] / found.area);
    line.y.push_back(reference::area_cut_off(found.shape, corners) / found.area);
  }
  line.x = points.x;
  figure.series.push_back(points);
  figure.series.push_back(line);
}

}  // namespace

void check_area(Findings& findings, const Setup& setup) {
  Figure figure{.name = "polygons",
                .title = "Area of polygons of boundary nodes",
                .caption =
                    "What a polygon whose corners are the solver's boundary nodes lacks of the area, over the area: "
                    "points; lines: leading order, with its constant.",
                .x = {.label = "nodes", .log = true},
                .y = {.label = "area that is lacking", .log = true}};
  Table table{.name = "areas",
              .caption =
                  "Area and polar moment, and what a polygon of 2048 boundary nodes lacks of both over the leading "
                  "order; the last columns extrapolate that ratio by its next terms, nodes^(-2/n) and nodes^(-6/n).",
              .columns = {"n", "area", "moment", "lacking, area", "moment", "extrapolated, area", "moment"}};
  double farthest = 0.0;
  for (const double n : {2.0, 3.0, 4.0, 8.0, 20.0, 50.0}) {
    if (setup.coarse && n != 20.0) continue;
    const Lacking found = lacking(n, setup);
    const auto area = over_leading_order(found.of_area, reference::area_cut_off(found.shape, 1.0), n);
    const auto moment = over_leading_order(found.of_moment, reference::moment_cut_off(found.shape, 1.0), n);
    farthest = std::max({farthest, std::abs(area[1] - 1.0), std::abs(moment[1] - 1.0)});
    // From n = 8 on the next term, nodes^(-2/n), is felt all along.
    const double low = n > 4.0 ? 1.96 : 1.98;
    findings.expect_order(
        fmt::format("order of the polygon's area in 1/nodes, n = {:g}", n), found.of_area, low, 2.01,
        "chords cut off the square of their length; the next term, nodes^(-2/n) of that, takes a little "
        "of the slope");
    findings.expect_order(fmt::format("order of the polygon's polar moment in 1/nodes, n = {:g}", n), found.of_moment,
                          low, 2.01, "as the area");
    draw(figure, found);
    table.rows.push_back({fmt::format("{:g}", n), fmt::format("{:.6f}", found.area),
                          fmt::format("{:.5f}", found.moment), fmt::format("{:.4f}", area[0]),
                          fmt::format("{:.4f}", moment[0]), fmt::format("{:.5f}", area[1]),
                          fmt::format("{:.5f}", moment[1])});
  }
  findings.expect(
      "what polygons lack of area and moment, extrapolated, over the leading order, farthest of n = 2 ... 50", farthest,
      0.0,
      Tolerance::truncation(
          1.2e-3, 1.3,
          "measured at n = 50: the terms of nodes^(-2), which both steps of the extrapolation enlarge, "
          "1/(1 - 2^(-2/n)) and 1/(1 - 2^(-6/n)) times, together 1700 times"));
  if (setup.coarse) return;
  findings.table(table);
  findings.figure(figure);
}

}  // namespace talus::verification::problems
