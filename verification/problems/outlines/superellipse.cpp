#include <random>

#include "solver/geometry/gap.hpp"
#include "solver/geometry/shape.hpp"
#include "verification/problems/outlines/superellipse_findings.hpp"
#include "verification/reference/outlines/superellipse.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::superellipse {
namespace {

Superquadric superellipse_of(double n, const Setup& setup) {
  const auto [a, b] = superellipse_half_axes;
  return {setup.has("half_axis_off") ? 1.000001 * a : a, b, setup.has("exponent_off") ? 1.001 * n : n};
}

std::vector<reference::Point> polygon(double n, double corners, const Setup& setup) {
  const int count = static_cast<int>(setup.has("nodes_left_out") ? corners / 2.0 : corners);
  std::vector<reference::Point> found;
  for (const Vec2 p : boundary_nodes(Shape{superellipse_of(n, setup)}, count))
    found.push_back({p.x, p.y});
  return found;
}

/// Deficits in area and polar moment of polygons of 32 ... 2048 nodes.
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

/// Deficit over its leading order: for the last polygon, and extrapolated from the last three. The next terms are
/// nodes^(-2/n) and, for the moment, nodes^(-6/n).
std::array<double, 2> over_leading_order(const Convergence& lacking, double constant, double n) {
  std::array<double, 3> ratio{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t at = lacking.size() - 3 + i;
    ratio[i] = lacking.errors()[at] / (constant * lacking.steps()[at] * lacking.steps()[at]);
  }
  const auto without = [](double fraction, double coarse, double fine) {
    return (fine - fraction * coarse) / (1.0 - fraction);
  };
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

void check_area(Findings& findings, const Setup& setup) {
  Figure figure{.name = "polygons",
                .title = "Area of polygons of boundary nodes",
                .caption =
                    "Area deficit of polygons whose corners are the solver's boundary nodes, over the area (points), "
                    "and its leading order with the constant (lines).",
                .x = {.label = "nodes", .log = true},
                .y = {.label = "area deficit", .log = true}};
  Table table{
      .name = "areas",
      .caption =
          "Area and polar moment, and the deficits of both for a polygon of 2048 boundary nodes over their leading "
          "order; the last columns extrapolate this ratio by its next terms, nodes^(-2/n) and nodes^(-6/n).",
      .columns = {"n", "area", "moment", "deficit, area", "moment", "extrapolated, area", "moment"}};
  double farthest = 0.0;
  for (const double n : {2.0, 3.0, 4.0, 8.0, 20.0, 50.0}) {
    if (setup.coarse && n != 20.0) continue;
    const Lacking found = lacking(n, setup);
    const auto area = over_leading_order(found.of_area, reference::area_cut_off(found.shape, 1.0), n);
    const auto moment = over_leading_order(found.of_moment, reference::moment_cut_off(found.shape, 1.0), n);
    keep_largest(farthest, area[1] - 1.0), keep_largest(farthest, moment[1] - 1.0);
    // From n = 8 on the next term, nodes^(-2/n), lowers the order at all numbers of nodes.
    const double low = n > 4.0 ? 1.96 : 1.98;
    findings.expect_order({"order_of_area", fmt::format("order of the polygon's area in 1/nodes, n = {:g}", n)},
                          found.of_area, low, 2.01,
                          "chords cut off an area of second order in their length; the next term, nodes^(-2/n) of "
                          "that, slightly reduces the slope");
    findings.expect_order(
        {"order_of_polar_moment", fmt::format("order of the polygon's polar moment in 1/nodes, n = {:g}", n)},
        found.of_moment, low, 2.01, "as for the area");
    draw(figure, found);
    table.rows.push_back(cells("{:g} | {:.6f} | {:.5f} | {:.4f} | {:.4f} | {:.5f} | {:.5f}", n, found.area,
                               found.moment, area[0], moment[0], area[1], moment[1]));
  }
  findings.expect_truncation(
      {"polygon_deficits",
       "area and moment deficits of polygons, extrapolated, over the leading order: largest error, n = 2 ... 50"},
      farthest, 0.0, 1.2e-3, 1.3,
      "terms of order nodes^(-2), which both extrapolation steps amplify, by (4 q - 1)/(1 - q) with q = 2^(-2/n) and "
      "2^(-6/n): 106 and 34 at n = 50, 3550 in total, which makes 8.5e-4 of 1/2048^2; their coefficient there is 1.4, "
      "as measured from 1024 to 4096 nodes");
  if (setup.coarse) return;
  findings.table(table);
  findings.figure(figure);
}

constexpr double a = superellipse_half_axes[0], b = superellipse_half_axes[1];

/// Overlap with a plane at every angle, with body and plane at random positions.
void check_support(Findings& findings, const Setup& setup) {
  std::mt19937_64 random{1};
  std::uniform_real_distribution<double> coordinate{-3.0, 3.0}, any{-std::numbers::pi, std::numbers::pi};
  const int angles = setup.coarse ? 12 : 180;
  record_pair(Superquadric{}, HalfPlane{});
  double depth_error = 0.0, outline_error = 0.0, reach_error = 0.0;
  for (const double n : {2.0, 2.5, 3.0, 4.0, 6.0, 8.0, 12.0, 20.0, 35.0, 50.0}) {
    for (int i = 0; i < angles; ++i) {
      const Pose plane{{coordinate(random), coordinate(random)}, rotation(any(random)), {}, 0.0};
      const double turned = 2.0 * std::numbers::pi * i / angles;
      const Pose body{{coordinate(random), coordinate(random)}, rotation(turned), {}, 0.0};
      const Gap found = gap(superellipse_of(n, setup), body, HalfPlane{}, plane);
      const Vec2 up = plane.R_WB * Vec2{0.0, 1.0};
      const Vec2 down = unrotate(body.R_WB, -up);
      const double reach = reference::support({a, b, n}, down.x, down.y);
      keep_largest(depth_error, found.depth - (reach - dot(body.p_WB - plane.p_WB, up)));
      const Vec2 lowest = unrotate(body.R_WB, found.p_WC - 0.5 * found.depth * up - body.p_WB);
      keep_largest(outline_error, reference::excess({a, b, n}, {lowest.x, lowest.y}) / n);
      keep_largest(reach_error, dot(lowest, down) - reach);
    }
  }
  findings.expect_round_off(
      {"plane_overlap", "overlap of a superellipse with a plane: largest error, n = 2 ... 50, 180 angles"}, depth_error,
      0.0, 1e-14,
      "a dozen roundings of lengths up to 8: sqrt(12) x 8 x 1.1e-16 = 3e-15, and three times that for the worst of "
      "1800 positions",
      "m");
  findings.expect_round_off({"lowest_on_outline", "lowest point of a superellipse: largest deviation from its outline"},
                            outline_error, 0.0, 1e-14, "as for the overlap, over half axes down to 1.25");
  findings.expect_round_off(
      {"lowest_on_support", "lowest point of a superellipse: largest distance from the support line"}, reach_error, 0.0,
      2e-14, "as for the overlap, transformed to world axes and back", "m");
}

Figure support_figure() {
  Figure figure{.name = "support",
                .title = "Support function of a superellipse",
                .caption =
                    "Distance of the tangent from the centre against its direction, a = 1.25, b = 4: the solver's "
                    "contact with a plane (points) and the dual norm (lines).",
                .x = {.label = "direction", .unit = "degrees"},
                .y = {.label = "distance", .unit = "m"}};
  for (const double n : {2.0, 4.0, 20.0, 50.0}) {
    Series line{fmt::format("n = {:g}", n), {}, {}, Style::lines};
    Series points{fmt::format("n = {:g}, solver", n), {}, {}, Style::points};
    for (int i = 0; i <= 180; ++i) {
      const double phi = 0.5 * i * std::numbers::pi / 180.0;
      line.add(0.5 * i, reference::support({a, b, n}, std::cos(phi), std::sin(phi)));
      if (i % 10 != 0) continue;
      // The plane is below; the body is turned so that its direction phi points down.
      const Pose body{{}, rotation(-std::numbers::pi / 2.0 - phi), {}, 0.0};
      points.add(0.5 * i, gap(Superquadric{a, b, n}, body, HalfPlane{}, Pose{}).depth);
    }
    figure.series.push_back(line);
    figure.series.push_back(points);
  }
  return figure;
}

Figure depth_figure() {
  Figure figure{.name = "depth",
                .title = "Overlap of a point with a superellipse",
                .caption =
                    "Overlap of points on the line y = 3: the solver (points) and brute force (lines). It has a kink "
                    "where the nearest point jumps from the top to the side.",
                .x = {.label = "x", .unit = "m"},
                .y = {.label = "overlap", .unit = "m"}};
  for (const double n : {2.0, 4.0, 20.0}) {
    Series line{fmt::format("n = {:g}", n), {}, {}, Style::lines};
    Series points{fmt::format("n = {:g}, solver", n), {}, {}, Style::points};
    for (int i = 0; i <= 80; ++i) {
      const double x = 1.6 * i / 80.0;
      const double sign = reference::excess({a, b, n}, {x, 3.0}) < 0.0 ? 1.0 : -1.0;
      line.add(x, sign * reference::nearest_point({a, b, n}, {x, 3.0}, 200).distance);
      if (i % 4 != 0) continue;
      points.add(x, depth_below(Superquadric{a, b, n}, {x, 3.0}).depth);
    }
    figure.series.push_back(line);
    figure.series.push_back(points);
  }
  return figure;
}

/// Depth of points below the outline, inside and outside.
void check_depth(Findings& findings, const Setup& setup) {
  std::mt19937_64 random{2};
  std::uniform_real_distribution<double> any{-1.3, 1.3};
  double depth_error = 0.0, normal_error = 0.0, circle_error = 0.0;
  for (const double n : {2.0, 2.5, 3.0, 4.0, 8.0, 20.0, 50.0}) {
    const reference::Superellipse shape{a, b, n};
    for (int i = 0; i < (setup.coarse ? 4 : 150); ++i) {
      const Vec2 p{a * any(random), b * any(random)};
      const Depth found = depth_below(superellipse_of(n, setup), p);
      const reference::NearestPoint brute = reference::nearest_point(shape, {p.x, p.y}, 400);
      const double sign = reference::excess(shape, {p.x, p.y}) < 0.0 ? 1.0 : -1.0;
      keep_largest(depth_error, found.depth - sign * brute.distance);
      const Vec2 reached = p + found.depth * found.normal;
      keep_largest(normal_error, reference::excess(shape, {reached.x, reached.y}) / n);
    }
  }
  const double circle_exponent = setup.has("exponent_off") ? 2.002 : 2.0;
  for (int i = 0; i < 200; ++i) {
    const Vec2 p{any(random), any(random)};
    keep_largest(circle_error, depth_below(Superquadric{1.0, 1.0, circle_exponent}, p).depth - (1.0 - norm(p)));
  }
  findings.expect_round_off(
      {"point_overlap", "overlap of a point with a superellipse: largest error against brute force, n = 2 ... 50"},
      depth_error, 0.0, 3e-15,
      "a distance of up to 4: three units in its last place; its error is of second order in that of the nearest point",
      "m");
  findings.expect_round_off("point moved by overlap and normal: largest deviation from the outline", normal_error, 0.0,
                            3e-15, "as for the overlap, over half axes down to 1.25");
  findings.expect_round_off({"circle_overlap", "overlap of a point with a circular superellipse: largest error"},
                            circle_error, 0.0, 1e-15, "five roundings of numbers up to 2", "m");
}

void run(Findings& findings, const Setup& setup) {
  if (setup.needs("polygons")) check_area(findings, setup);
  if (setup.needs("with a plane")) check_support(findings, setup);
  if (setup.needs("overlap of a point")) check_depth(findings, setup);
  if (setup.needs("overlap of pairs")) check_pairs(findings, setup);
  if (setup.needs("contact search")) check_search(findings, setup);
  if (setup.coarse) return;
  check_scenes(findings, setup);
  findings.figure(support_figure());
  findings.figure(depth_figure());
}

}  // namespace

Case definition() {
  return {
      .id = "superellipse",
      .title = "Superellipses and the contact search",
      .requirements = {{"Eq. 1",
                        {"order_of_area", "order_of_polar_moment", "lowest_on_outline", "lowest_on_support",
                         "point_overlap", "circle_overlap"}},
                       {"A3", {"order_of_area", "order_of_polar_moment", "polygon_deficits"}},
                       {"E1", {"plane_overlap", "lowest_on_outline", "lowest_on_support"}},
                       {"E2", {"point_overlap", "circle_overlap", "pair_overlap", "pair_distance"}},
                       {"E10", {"omitted_touching", "omitted_separate", "unculled_scenes"}},
                       {"shape.superquadric",
                        {"order_of_area", "order_of_polar_moment", "polygon_deficits", "plane_overlap",
                         "lowest_on_outline", "lowest_on_support", "point_overlap", "circle_overlap", "pair_overlap",
                         "pair_distance", "omitted_touching", "omitted_separate"}},
                       {"shape.half_plane", {"plane_overlap", "omitted_touching", "omitted_separate"}},
                       {"shape.circle, shape.rectangle", {"omitted_touching", "omitted_separate", "unculled_scenes"}},
                       {"method.resultant", {"plane_overlap", "unculled_scenes"}},
                       {"method.nodes", {"point_overlap", "circle_overlap", "unculled_scenes"}},
                       {"pair.superquadric.superquadric, pair.rectangle.superquadric",
                        {"pair_overlap", "pair_distance"}},
                       {"pair.superquadric.half_plane", {"plane_overlap"}}},
      .main_checks = {"order of the polygon's area in 1/nodes, n = 20", "plane_overlap", "point_overlap",
                      "pair_overlap", "omitted_touching", "unculled_scenes"},
      .source = "Mustoe & Huttelmaier 1993, Eq. 1; Barr 1981",
      .faults = {{"exponent_off", "an exponent 0.1 % too large", "point_overlap"},
                 {"pair_exponent_off", "exponents of pairs 5 % too large", "pair_overlap"},
                 {"half_axis_off", "a half axis too long by 1e-6", "plane_overlap"},
                 {"nodes_left_out", "every other node omitted", "polygon_deficits"},
                 {"boxes_too_small", "bounding boxes of the search 10 % too narrow", "omitted_touching"}},
      .seconds = 3.0,
      .run = run};
}

}  // namespace talus::verification::problems::superellipse
