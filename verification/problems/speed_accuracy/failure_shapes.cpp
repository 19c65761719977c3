#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "solver/geometry/gap.hpp"
#include "solver/geometry/penetration.hpp"
#include "solver/geometry/pose.hpp"
#include "solver/geometry/superquadric.hpp"
#include "verification/problems/speed_accuracy/failure_rows.hpp"
#include "verification/reference/outlines/superellipse.hpp"
#include "verification/study/findings/expectations.hpp"
#include "verification/study/scenes/touching_pair.hpp"

namespace talus::verification::problems {
namespace {

/// Value, gradient and second derivatives of a function in world coordinates.
struct Field {
  double value{};
  Vec2 gradient;
  double xx{}, xy{}, yy{};
};

Field radial(const Superquadric& shape, Vec2 p) {
  const double n = shape.exponent, u = std::abs(p.x) / shape.half_width, v = std::abs(p.y) / shape.half_height;
  const double sum = std::pow(u, n) + std::pow(v, n), f = std::pow(sum, 1.0 / n);
  const Vec2 g{std::copysign(n * std::pow(u, n - 1.0) / shape.half_width, p.x),
               std::copysign(n * std::pow(v, n - 1.0) / shape.half_height, p.y)};
  const double xx = n * (n - 1.0) * std::pow(u, n - 2.0) / (shape.half_width * shape.half_width);
  const double yy = n * (n - 1.0) * std::pow(v, n - 2.0) / (shape.half_height * shape.half_height);
  const double first = f / (n * sum), second = (1.0 / n - 1.0) * first / sum;
  return {f, first * g, second * g.x * g.x + first * xx, second * g.x * g.y, second * g.y * g.y + first * yy};
}

Field field(const Superquadric& shape, const Pose& body, Vec2 X) {
  const Field own = radial(shape, unrotate(body.R_WB, X - body.p_WB));
  const double c = body.R_WB.cosine, s = body.R_WB.sine;
  return {own.value, body.R_WB * own.gradient, c * c * own.xx - 2.0 * c * s * own.xy + s * s * own.yy,
          c * s * (own.xx - own.yy) + (c * c - s * s) * own.xy, s * s * own.xx + 2.0 * c * s * own.xy + c * c * own.yy};
}

using Row = std::array<double, 3>;

double determinant(const Row& a, const Row& b, const Row& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// True if undamped Newton steps for f_A(X) = f_B(X), grad f_A + mu^2 grad f_B = 0 in X and mu, with the radial
/// function f = (|x/a|^n + |y/b|^n)^(1/n), converge within a hundred iterations from the midpoint of the centres.
bool newton_converges(const Superquadric& a, const Pose& A, const Superquadric& b, const Pose& B) {
  Vec2 X = 0.5 * (A.p_WB + B.p_WB);
  double mu = 0.0;
  for (int i = 0; i < 100; ++i) {
    const Field f = field(a, A, X), g = field(b, B, X);
    const double size = norm(f.gradient);
    if (!std::isfinite(size) || size == 0.0) return false;
    if (i == 0) mu = std::sqrt(size / norm(g.gradient));
    const double m = mu * mu;
    const Vec2 sum = f.gradient + m * g.gradient;
    const double apart = f.value - g.value;
    if (norm(sum) < 1e-10 * size && std::abs(apart) < 1e-10 * f.value) return true;
    // Columns of the Jacobian with respect to X and mu, and the right-hand side: Cramer's rule.
    const Row x{f.xx + m * g.xx, f.xy + m * g.xy, f.gradient.x - g.gradient.x};
    const Row y{f.xy + m * g.xy, f.yy + m * g.yy, f.gradient.y - g.gradient.y};
    const Row z{2.0 * mu * g.gradient.x, 2.0 * mu * g.gradient.y, 0.0};
    const Row right{-sum.x, -sum.y, -apart};
    const double whole = determinant(x, y, z);
    X += {determinant(right, y, z) / whole, determinant(x, right, z) / whole};
    mu += determinant(x, y, right) / whole;
  }
  return false;
}

/// Gap of two squares that overlap at a corner, displaced from the diagonal by `off` along each axis.
Gap corner_in_corner(double off) {
  const Rectangle square{0.5, 0.5};
  const Pose first{}, second{{0.9 + off, 0.9 - off}, {}, {}, 0.0};
  return gap(square, first, square, second);
}

double turned(Vec2 a, Vec2 b) { return std::acos(std::clamp(dot(a, b), -1.0, 1.0)) * 180.0 / std::numbers::pi; }

/// Fraction of pairs of aspect ratio 1 : 0.7, randomly rotated, with an overlap of 0.01, for which Newton's method
/// fails.
double newton_fails(double n, int pairs) {
  std::mt19937_64 random{1};
  std::uniform_real_distribution<double> any{-std::numbers::pi, std::numbers::pi};
  const Superquadric shape{1.0, 0.7, n};
  int failed = 0;
  for (int i = 0; i < pairs; ++i) {
    const Rotation direction = rotation(any(random));
    const Pose A{{}, rotation(any(random)), {}, 0.0};
    Pose B{{}, rotation(any(random)), {}, 0.0};
    double near = 0.0, far = 4.0;
    for (int k = 0; k < 12; ++k) {
      const double distance = 0.5 * (near + far);
      B.p_WB = direction * Vec2{distance, 0.0};
      (penetration(shape, A, shape, B) > 0.01 ? near : far) = distance;
    }
    failed += newton_converges(shape, A, shape, B) ? 0 : 1;
  }
  return static_cast<double>(failed) / pairs;
}

}  // namespace

FailureFound check_corner_normal(Findings& findings, const Setup& setup) {
  const double off = setup.has("off_the_diagonal") ? 0.05 : 0.0;
  const auto [one, other] = std::pair{corner_in_corner(off + 1e-9), corner_in_corner(off - 1e-9)};
  const double jump = turned(one.n_AB, other.n_AB);
  const double beside = turned(corner_in_corner(0.05 + 1e-9).n_AB, corner_in_corner(0.05 - 1e-9).n_AB);
  findings.expect_exact(
      {"corner_normal/jump", "corner normal: jump between offsets of -1e-9 and 1e-9 from the diagonal"}, jump, 90.0,
      "the normal is that of the nearest side, and two sides are equally near", "degrees");
  findings.expect_exact({"corner_normal/beside", "corner normal: change between the same offsets beside the diagonal"},
                        beside, 0.0, "one side is nearer", "degrees");
  findings.expect_round_off({"corner_normal/overlaps", "corner normal: difference of the overlaps at the two offsets"},
                            one.depth - other.depth, 0.0, 2.0 * 0x1p-53, "two sums of numbers up to one, mirrored");
  const Rectangle square{0.3, 0.3}, box{CornerLoop::corner.x, CornerLoop::corner.y};
  const Superquadric rounded{0.3, 0.3, 20.0}, column{CornerLoop::corner.x, CornerLoop::corner.y, 20.0};
  const int steps = setup.coarse ? 200 : 400;
  const CornerLoop sides =
      round_corner(pair_model({"", rounded, column, ContactMethod::nodes, NodeDepth::side_face}, 1000.0), 200);
  const CornerLoop nearest = round_corner(pair_model({"", square, box}, 1000.0), steps);
  const double made = sides.work / sides.energy, kept = nearest.work / nearest.energy;
  const double step = 2.0 * std::numbers::pi * CornerLoop::radius / steps;
  findings.expect_between(
      {"corner_normal/side_faces", "corner normal: work round a corner by side faces, over the energy"}, std::abs(made),
      0.05, 2.0,
      "the overlap of nodes pushed out of the nearer side face jumps at the top: the work is of the size of the energy "
      "itself, once or twice; a twentieth is beyond the bound of the other rule (next check)");
  findings.expect_truncation(
      {"corner_normal/nearest_side", "corner normal: work round a corner by the nearest side, over the energy"}, kept,
      0.0, 2.0 * step / std::sqrt(0.002 * nearest.energy), 2.0,
      "the trapezoidal rule errs by half a step times the jump of the force at each of about four kinks (case "
      "energy_slope)");
  return {fmt::format("+-1e-9 off the diagonal: {:.0f} degrees; work by side faces {:+.2f} E", jump, made),
          fmt::format("beside it: {:.0f} degrees; work by the nearest side {:+.1g} E", beside, kept)};
}

FailureFound check_common_normal(Findings& findings, const Setup& setup) {
  struct Known {
    double n, fraction;
  };
  const int pairs = setup.coarse ? 60 : 200;
  std::string fractions;
  for (const Known& known : {Known{8.0, 0.60}, Known{20.0, 0.83}, Known{50.0, 0.94}}) {
    if (setup.coarse && known.n != 50.0) continue;
    const double found = newton_fails(setup.has("ellipses") ? 2.0 : known.n, pairs);
    const double error = std::sqrt(known.fraction * (1.0 - known.fraction) / pairs);
    findings.expect_model(
        fmt::format("common normal: fraction of pairs without a solution, radial Newton, n = {:g}", known.n), found,
        known.fraction, 3.0 * error + 0.04,
        "known from 2000 pairs with other random positions, generated differently, for which 0.04 is allowed; plus "
        "three standard errors of the fraction");
    fractions += fmt::format("{}{:.0f}", fractions.empty() ? "" : ", ", 100.0 * found);
  }
  findings.expect_exact("common normal: fraction of pairs of ellipses without a solution", newton_fails(2.0, 60), 0.0,
                        "quadratic functions: known to be safe up to n = 3");
  double farthest = 0.0;
  std::mt19937_64 random{7};
  std::uniform_real_distribution<double> inside{-1.0, 1.0};
  for (int i = 0; i < 60; ++i) {
    const Vec2 p{inside(random), 0.7 * inside(random)};
    const double exact = reference::nearest_point({1.0, 0.7, 50.0}, {p.x, p.y}, 400).distance;
    keep_largest(farthest, std::abs(depth_below(Superquadric{1.0, 0.7, 50.0}, p).depth) - exact);
  }
  findings.expect_round_off("common normal: solver's nearest points, n = 50, largest error of 60 against brute force",
                            farthest, 0.0, 3e-15, "a dozen roundings of lengths up to one (case nearest_points)");
  return {fmt::format("radial Newton, n = 8, 20, 50: {} % without a solution", fractions),
          fmt::format("solver, n = 50: all 60 found, error {:.1g}", farthest)};
}

FailureFound check_high_powers(Findings& findings, const Setup& setup) {
  int lost = 0, lost_below = 0;
  double farthest = 0.0;
  for (const double x : {1e-3, 10.0}) {
    for (const double y : {1e-3, 0.5, 10.0}) {
      for (const double n : {50.0, 1000.0}) {
        const double exponent = setup.has("exponent_50") ? 50.0 : n;
        const double sum = std::pow(x, exponent) + std::pow(y, exponent);
        const double across = std::pow(x, exponent - 1.0), up = std::pow(y, exponent - 1.0);
        const bool usable = std::isfinite(sum) && sum > 0.0 && across > 0.0 && up > 0.0;
        (n == 50.0 ? lost_below : lost) += usable ? 0 : 1;
        const Superquadric shape{1.0, 0.7, n};
        const Vec2 p{x, 0.7 * y};
        const double exact = reference::nearest_point({1.0, 0.7, n}, {p.x, p.y}, 400).distance;
        const Depth found = depth_below(shape, p);
        const double error = std::abs(std::abs(found.depth) - exact) / std::max(1.0, exact);
        const bool inside = x < 1.0 && y < 1.0;
        const bool right = (found.depth > 0.0) == inside && std::isfinite(error) && std::isfinite(norm(found.normal));
        if (!right || !(error <= farthest)) farthest = right ? error : 1.0;
      }
    }
  }
  findings.expect_exact("high powers: positions, of six, with F or its gradient infinite or zero, n = 1000", lost, 6.0,
                        "10^1000 and 0.001^999 exceed the range of the format, and each position has one or the other");
  findings.expect_exact("high powers: positions, of six, with F or its gradient infinite or zero, n = 50", lost_below,
                        0.0, "10^50 and 1e-150 are within the range");
  findings.expect_round_off("high powers: solver's nearest points, x/a = 0.001 and 10, n = 50 and 1000, largest error",
                            farthest, 0.0, 2e-15, "a dozen roundings, over the larger of size and distance");
  return {fmt::format("n = 1000: F or its gradient lost at {} of 6 positions", lost),
          fmt::format("n = 50: {}; error of the solver {:.1g} for both", lost_below, farthest)};
}

}  // namespace talus::verification::problems
