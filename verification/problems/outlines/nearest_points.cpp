#include <random>

#include "solver/geometry/gap.hpp"
#include "solver/geometry/node_depth.hpp"
#include "verification/reference/outlines/superellipse.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::nearest_points {
namespace {

constexpr std::array exponents{1.2, 2.0, 3.0, 5.0, 8.0, 12.0, 20.0, 50.0, 200.0, 1000.0};
constexpr std::array heights{1.0, 0.7, 0.3, 0.1};
constexpr std::array kinds{"inside a corner", "anywhere inside", "outside"};

/// A random point of a kind, from up to three random numbers between 0 and 1.
Vec2 placed(std::size_t kind, const Superquadric& shape, std::mt19937_64& random) {
  std::uniform_real_distribution<double> fraction{0.0, 1.0};
  if (kind == 0) {
    const double in = (0.005 + 0.1 * fraction(random)) * shape.half_height;
    return {shape.half_width - in * (0.9 + 0.2 * fraction(random)), shape.half_height - in};
  }
  const Vec2 on = boundary_point(shape, 2.0 * std::numbers::pi * fraction(random));
  return (kind == 1 ? fraction(random) : 1.0 + 2.0 * fraction(random)) * on;
}

/// Distance by Newton's method in the parametric angle; NaN if it does not converge in 60 steps.
double newton_distance(const Superquadric& shape, Vec2 p, double start) {
  constexpr double d = 1e-4;
  const auto square = [&](double t) {
    const Vec2 from = boundary_point(shape, t) - p;
    return dot(from, from);
  };
  double t = start;
  for (int i = 0; i < 60; ++i) {
    const double up = square(t + d), here = square(t), down = square(t - d);
    const double step = -0.5 * d * (up - down) / (up - 2.0 * here + down);
    if (!std::isfinite(step)) return step;
    if (std::abs(step) < 1e-7) return std::sqrt(here);
    t += step;
  }
  return std::nan("");
}

struct Tried {
  int points{}, wrong{};
  double farthest{};  ///< largest error of the distance, relative to the half axis a = 1
  std::array<int, 3> newton_failed{};
};

Tried try_points(double n, double height, std::size_t kind, const Setup& setup) {
  const Superquadric shape{1.0, height, n};
  record_shape(shape);
  record_use("method.nodes");  // depth_below() is the overlap of a node in a superquadric
  std::mt19937_64 random{static_cast<std::uint64_t>(31.0 * n + 7.0 * height) + kind};
  Tried tried;
  const int count = setup.coarse ? 12 : kind == 0 ? 40 : 10;
  for (int i = 0; i < count; ++i) {
    const Vec2 p = placed(kind, shape, random);
    const double exact = reference::nearest_point({1.0, height, n}, {p.x, p.y}, 400).distance;
    const double below = std::atan2(std::abs(p.y) / height, std::abs(p.x));
    const std::array starts{p.x > p.y ? 0.05 : 0.5 * std::numbers::pi - 0.05, 0.25 * std::numbers::pi, below};
    const Vec2 folded{std::abs(p.x), std::abs(p.y)};
    for (std::size_t s = 0; s < starts.size() && !setup.coarse; ++s)
      tried.newton_failed[s] += std::abs(newton_distance(shape, folded, starts[s]) - exact) < 1e-3 * exact ? 0 : 1;
    const double found = setup.has("newton_for_brackets") ? newton_distance(shape, folded, starts[0])
                         : setup.has("exponent_off")      ? depth_below(Superquadric{1.0, height, 1.001 * n}, p).depth
                                                          : depth_below(shape, p).depth;
    const double error = std::abs(std::abs(found) - exact);
    ++tried.points;
    if (!(error < 1e-12)) ++tried.wrong;
    tried.farthest = std::max(tried.farthest, std::isfinite(error) ? error : 1.0);
  }
  return tried;
}

/// Distance of a point from a line of segments: minimum over all segments.
double distance_from_line(const std::vector<Vec2>& points, Vec2 p) {
  double minimum = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Vec2 along = points[i + 1] - points[i];
    const double part = std::clamp(dot(p - points[i], along) / dot(along, along), 0.0, 1.0);
    minimum = std::min(minimum, norm(p - points[i] - part * along));
  }
  return minimum;
}

/// Points about a rectangle and uneven ground, inside and outside: compares their depths with the distance from all
/// segments, and checks that the normal leads to the outline. The ground has a sharp ridge and a notch; its end
/// segments reach far beyond the points.
void check_straight_outlines(Findings& findings, const Setup& setup) {
  const double a = 1.0, b = 0.4;
  const std::vector<Vec2> box{{a, b}, {-a, b}, {-a, -b}, {a, -b}, {a, b}};
  const std::vector<Vec2> line{{-20.0, 1.0}, {-1.0, 0.0}, {-0.2, 1.6}, {0.3, -0.7}, {1.2, 0.4}, {20.0, -2.0}};
  const auto height = [&](double x) {
    std::size_t i = 0;
    while (line[i + 1].x < x)
      ++i;
    return line[i].y + (x - line[i].x) / (line[i + 1].x - line[i].x) * (line[i + 1].y - line[i].y);
  };
  std::mt19937_64 random{1993};
  std::uniform_real_distribution<double> across{-2.0, 2.0};
  double depths = 0.0, feet = 0.0;
  const auto compare = [&](const Depth& found, const std::vector<Vec2>& outline, Vec2 p, bool inside) {
    const double distance = distance_from_line(outline, p);
    keep_worst(depths, found.depth - (inside ? distance : -distance));
    keep_worst(feet, distance_from_line(outline, p + found.depth * found.normal));
  };
  for (int i = 0; i < 2000; ++i) {
    const Vec2 p{across(random), across(random)};
    compare(depth_below(Rectangle{setup.has("wider_box") ? a + 1e-9 : a, b}, p), box, p,
            std::abs(p.x) < a && std::abs(p.y) < b);
    compare(depth_below(Terrain{line}, p), line, p, p.y < height(p.x));
  }
  const char* const reason = "a dozen roundings of lengths up to 20, the distance of the ends of the ground";
  findings.expect_round_off("overlap of points with a rectangle and with uneven ground: largest error", depths, 0.0,
                            2e-14, reason);
  findings.expect_round_off("points moved by overlap and normal: largest distance from these outlines", feet, 0.0,
                            2e-14, reason);
}

/// By the rule `centroid_ray` the overlap of a node inside is its distance from the outline along the ray from the
/// centre. The reference finds the outline on this ray by bisection.
void check_rays(Findings& findings) {
  std::mt19937_64 random{1994};
  std::uniform_real_distribution<double> fraction{0.05, 0.95};
  double worst = 0.0;
  for (const double n : {2.0, 5.0, 20.0}) {
    const Superquadric shape{1.0, 0.4, n};
    for (int i = 0; i < 50; ++i) {
      const double angle = 2.0 * std::numbers::pi * fraction(random);
      const Vec2 p = fraction(random) * boundary_point(shape, angle);
      double low = 1.0, high = 100.0;
      for (int halving = 0; halving < 70; ++halving) {
        const double s = 0.5 * (low + high);
        (std::pow(std::abs(s * p.x), n) + std::pow(std::abs(s * p.y) / 0.4, n) < 1.0 ? low : high) = s;
      }
      keep_worst(worst, depth_below(CentroidRays{shape}, p).depth - (low - 1.0) * norm(p));
    }
  }
  findings.expect_round_off("overlap along the ray from the centre: largest difference from bisection", worst, 0.0,
                            1e-14, "a power and its root, for a ray of length 1; about ten roundings");
}

void run(Findings& findings, const Setup& setup) {
  if (setup.needs("along the ray")) check_rays(findings);
  if (setup.needs("uneven ground") || setup.needs("these outlines")) check_straight_outlines(findings, setup);
  if (!setup.needs("nearest point")) return;
  Table table{.name = "map",
              .caption =
                  "Points tested (all four b), points for which the solver's search does not find the nearest point, "
                  "and percentage for which Newton's method fails from the middle of the side, from the corner, and "
                  "from below the point.",
              .columns = {"n", "points", "wrong", "Newton: side", "corner", "below"}};
  std::array<Series, 3> lines{Series{"Newton from the side", {}, {}, Style::linespoints},
                              Series{"from the corner", {}, {}, Style::linespoints},
                              Series{"from below the point", {}, {}, Style::linespoints}};
  Series solver{"solver", {}, {}, Style::points};
  std::array<double, 3> farthest{};
  std::array<int, 3> wrong{};
  double fewest_at_large = 1.0, maximum_at_small = 0.0;  // fractions of points for which Newton's method fails
  for (const double n : exponents) {
    if (setup.coarse && n != 50.0) continue;
    Tried sum;
    for (const double height : heights) {
      for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
        const Tried tried = try_points(n, height, kind, setup);
        sum.points += tried.points;
        sum.wrong += tried.wrong;
        wrong[kind] += tried.wrong;
        farthest[kind] = std::max(farthest[kind], tried.farthest);
        for (std::size_t s = 0; s < 3; ++s)
          sum.newton_failed[s] += tried.newton_failed[s];
      }
    }
    std::vector<std::string> row{fmt::format("{:g}", n), fmt::format("{}", sum.points), fmt::format("{}", sum.wrong)};
    for (std::size_t s = 0; s < 3; ++s) {
      const double fraction = static_cast<double>(sum.newton_failed[s]) / sum.points;
      row.push_back(fmt::format("{:.0f} %", 100.0 * fraction));
      lines[s].add(n, fraction);
      if (n >= 200.0) fewest_at_large = std::min(fewest_at_large, fraction);
      if (n >= 2.0 && n <= 12.0) maximum_at_small = std::max(maximum_at_small, fraction);
    }
    solver.add(n, static_cast<double>(sum.wrong) / sum.points);
    table.rows.push_back(row);
  }
  for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
    findings.expect_exact(
        {"nearest_points", fmt::format("points for which the nearest point is not found, {}", kinds[kind])},
        wrong[kind], 0.0, "a bracket is never lost, and no interval contains two minima");
    findings.expect_round_off(
        {"distances",
         fmt::format("distance from the nearest point: largest error against brute force, {}", kinds[kind])},
        farthest[kind], 0.0, 1e-14,
        "a dozen roundings of lengths up to 3: sqrt(12) x 3 x 1.1e-16, three times that for the worst of 1600 points, "
        "and as much again for n < 2, where a coordinate beside an axis is the power 1/n of a small number");
  }
  if (setup.coarse) return;
  const auto group = findings.in("newton");
  group->expect_between("failures of Newton's method at exponents of 200 and 1000, smallest fraction of three starts",
                        fewest_at_large, 0.5, 1.0,
                        "the corner, where the parametric angle hardly moves the point, is most of the quadrant: more "
                        "than half of the 240 points, with a standard error of 0.03");
  group->expect_between("failures of Newton's method at exponents of 2 to 12, largest fraction of three starts",
                        maximum_at_small, 0.05, 0.3,
                        "it fails where the distance is nearly constant or the start is at a maximum of it: for some "
                        "points, not for most; 240 points with a standard error of 0.03");
  findings.table(table);
  findings.figure({.name = "failures",
                   .title = "Failed searches",
                   .caption = "Fraction of points for which the nearest point is not found.",
                   .x = {.label = "exponent n", .log = true},
                   .y = {.label = "fraction", .min = 0.0, .max = 1.0},
                   .series = {lines[0], lines[1], lines[2], solver}});
}

}  // namespace

Case definition() {
  return {.id = "nearest_points",
          .title = "Nearest-point search: map of convergence",
          .requirements = {{"E2", {"nearest_points", "distances", "newton"}},
                           {"shape.superquadric", {"nearest_points", "distances"}},
                           {"method.nodes",
                            {"points for which the nearest point is not found, inside a corner",
                             "distance from the nearest point: largest error against brute force, inside a corner"}}},
          .main_checks = {"points for which the nearest point is not found, inside a corner",
                          "distance from the nearest point: largest error against brute force, inside a corner"},
          .source = "Barr 1981; Alefeld, Potra & Shi 1995, ACM Trans. Math. Softw. 21:327",
          .faults = {{"newton_for_brackets", "Newton's method from the middle of a side",
                      "points for which the nearest point is not found, inside a corner"},
                     {"wider_box", "a rectangle wider by 2e-9",
                      "overlap of points with a rectangle and with uneven ground: largest error"},
                     {"exponent_off", "an exponent 0.1 % too large",
                      "distance from the nearest point: largest error against brute force, inside a corner"}},
          .run = run};
}

}  // namespace talus::verification::problems::nearest_points
