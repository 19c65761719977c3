#include "verification/problems/speed_accuracy/common_normal.hpp"

#include <array>
#include <cmath>

namespace talus::verification::problems {
namespace {

/// A function's value, gradient and second derivatives in the world.
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

}  // namespace

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
    // Columns of the matrix of derivatives by X and mu, and the right-hand side: Cramer's rule.
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

}  // namespace talus::verification::problems
