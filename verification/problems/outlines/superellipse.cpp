#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "solver/geometry/gap.hpp"
#include "verification/problems/outlines/superellipse_findings.hpp"
#include "verification/reference/superellipse.hpp"

namespace talus::verification::problems {

Case superellipse();

namespace {

constexpr double a = superellipse_half_axes[0], b = superellipse_half_axes[1];

/// Overlap with a plane at every angle, both anywhere.
void check_support(Findings& findings, const Setup& setup) {
  std::mt19937_64 random{1};
  std::uniform_real_distribution<double> place{-3.0, 3.0}, any{-std::numbers::pi, std::numbers::pi};
  const int angles = setup.coarse ? 12 : 180;
  double depth_error = 0.0, outline_error = 0.0, reach_error = 0.0;
  for (const double n : {2.0, 2.5, 3.0, 4.0, 6.0, 8.0, 12.0, 20.0, 35.0, 50.0}) {
    for (int i = 0; i < angles; ++i) {
      const Pose plane{{place(random), place(random)}, rotation(any(random)), {}, 0.0};
      const double turned = 2.0 * std::numbers::pi * i / angles;
      const Pose body{{place(random), place(random)}, rotation(turned), {}, 0.0};
      const Gap found = gap(superellipse_told(n, setup), body, HalfPlane{}, plane);
      const Vec2 up = plane.R_WB * Vec2{0.0, 1.0};
      const Vec2 down = unrotate(body.R_WB, -up);
      const double reach = reference::support({a, b, n}, down.x, down.y);
      depth_error = std::max(depth_error, std::abs(found.depth - (reach - dot(body.p_WB - plane.p_WB, up))));
      const Vec2 lowest = unrotate(body.R_WB, found.p_WC - 0.5 * found.depth * up - body.p_WB);
      outline_error = std::max(outline_error, std::abs(reference::excess({a, b, n}, {lowest.x, lowest.y})) / n);
      reach_error = std::max(reach_error, std::abs(dot(lowest, down) - reach));
    }
  }
  findings.expect("overlap of a superellipse with a plane, farthest of n = 2 ... 50 at 180 angles", depth_error, 0.0,
                  Tolerance::round_off(1e-14,
                                       "a dozen roundings of lengths up to 8: sqrt(12) x 8 x 1.1e-16 = 3e-15, "
                                       "and three times that for the worst of 1800"),
                  "m");
  findings.expect("lowest point of a superellipse from its outline, farthest", outline_error, 0.0,
                  Tolerance::round_off(1e-14, "as the overlap, over half axes down to 1.25"));
  findings.expect("lowest point of a superellipse from the support line, farthest", reach_error, 0.0,
                  Tolerance::round_off(2e-14, "as the overlap, taken out and back"), "m");
}

Figure support_figure() {
  Figure figure{.name = "support",
                .title = "How far a superellipse reaches",
                .caption =
                    "Distance of the tangent from the centre against its direction, a = 1.25, b = 4: the solver's "
                    "contact with a plane (points) and the dual norm (lines).",
                .x = {.label = "direction", .unit = "degrees"},
                .y = {.label = "reach", .unit = "m"}};
  for (const double n : {2.0, 4.0, 20.0, 50.0}) {
    Series line{fmt::format("n = {:g}", n), {}, {}, Style::lines};
    Series points{fmt::format("n = {:g}, solver", n), {}, {}, Style::points};
    for (int i = 0; i <= 180; ++i) {
      const double phi = 0.5 * i * std::numbers::pi / 180.0;
      line.add(0.5 * i, reference::support({a, b, n}, std::cos(phi), std::sin(phi)));
      if (i % 10 != 0) continue;
      // The plane below, the body turned so that its direction phi looks down.
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
                .title = "Depth below the nearest point",
                .caption =
                    "Depth along the line y = 3 below the outline: the solver (points) and brute force (lines). It "
                    "kinks where the nearest point jumps from the top to the side.",
                .x = {.label = "x", .unit = "m"},
                .y = {.label = "depth", .unit = "m"}};
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
      const Depth found = depth_below(superellipse_told(n, setup), p);
      const reference::NearestPoint brute = reference::nearest_point(shape, {p.x, p.y}, 400);
      const double sign = reference::excess(shape, {p.x, p.y}) < 0.0 ? 1.0 : -1.0;
      depth_error = std::max(depth_error, std::abs(found.depth - sign * brute.distance));
      const Vec2 reached = p + found.depth * found.normal;
      normal_error = std::max(normal_error, std::abs(reference::excess(shape, {reached.x, reached.y})) / n);
    }
  }
  const double circle_exponent = setup.has("exponent_off") ? 2.002 : 2.0;
  for (int i = 0; i < 200; ++i) {
    const Vec2 p{any(random), any(random)};
    circle_error = std::max(circle_error,
                            std::abs(depth_below(Superquadric{1.0, 1.0, circle_exponent}, p).depth - (1.0 - norm(p))));
  }
  findings.expect("depth below a superellipse, farthest from brute force, n = 2 ... 50", depth_error, 0.0,
                  Tolerance::round_off(3e-15,
                                       "a distance of up to 4: three units of its last place; its error is of "
                                       "second order in that of the nearest point"),
                  "m");
  findings.expect("point at the depth along the normal from the outline, farthest", normal_error, 0.0,
                  Tolerance::round_off(3e-15, "as the depth, over half axes down to 1.25"));
  findings.expect("depth below a superellipse that is a circle, farthest", circle_error, 0.0,
                  Tolerance::round_off(1e-15, "five roundings of numbers up to 2"), "m");
}

void run(Findings& findings, const Setup& setup) {
  check_area(findings, setup);
  check_support(findings, setup);
  check_depth(findings, setup);
  check_pairs(findings, setup);
  check_search(findings, setup);
  if (setup.coarse) return;
  check_scenes(findings, setup);
  findings.figure(support_figure());
  findings.figure(depth_figure());
}

}  // namespace

Case superellipse() {
  return {
      .id = "superellipse",
      .title = "Superellipses and the contact search",
      .requirements = {{"Eq. 1", {"polygon's area", "polar moment", "lowest point", "depth below a superellipse"}},
                       {"A3", {"polygon"}},
                       {"E1", {"superellipse with a plane", "lowest point of a superellipse"}},
                       {"E2", {"depth below a superellipse", "pairs of superellipses"}},
                       {"E10", {"contact search", "random scenes"}},
                       {"shape.superquadric", {"polygon", "superellipse", "contact search"}},
                       {"shape.half_plane", {"superellipse with a plane", "contact search"}},
                       {"shape.circle", {"contact search", "random scenes"}},
                       {"shape.rectangle", {"contact search", "random scenes"}},
                       {"method.resultant", {"superellipse with a plane", "random scenes"}},
                       {"method.nodes", {"depth below a superellipse", "random scenes"}},
                       {"pair.superquadric.superquadric", {"pairs of superellipses"}},
                       {"pair.rectangle.superquadric", {"pairs of superellipses"}},
                       {"pair.superquadric.half_plane", {"superellipse with a plane"}}},
      .main_checks = {"order of the polygon's area in 1/nodes, n = 20",
                      "overlap of a superellipse with a plane, farthest of n = 2 ... 50 at 180 angles",
                      "depth below a superellipse, farthest from brute force, n = 2 ... 50",
                      "overlap of pairs of superellipses and rectangles, farthest from brute force",
                      "touching pairs that the contact search leaves out",
                      "random scenes with other contacts or accelerations when nothing is left out"},
      .source = "Mustoe & Huttelmaier 1993, Eq. 1; Barr 1981",
      .faults =
          {{"exponent_off", "an exponent .1 % too large",
            "depth below a superellipse, farthest from brute force, n = 2 ... 50"},
           {"pair_exponent_off", "the exponents of pairs 5 % too large",
            "overlap of pairs of superellipses and rectangles, farthest from brute force"},
           {"half_axis_off", "a half axis a millionth too long",
            "overlap of a superellipse with a plane, farthest of n = 2 ... 50 at 180 angles"},
           {"nodes_left_out", "every other node left out",
            "what polygons lack of area and moment, extrapolated, over the leading order, farthest of n = 2 ... 50"},
           {"boxes_too_small", "boxes of the search a tenth too narrow",
            "touching pairs that the contact search leaves out"}},
      .run = run};
}

}  // namespace talus::verification::problems
