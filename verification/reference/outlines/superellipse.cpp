#include "verification/reference/outlines/superellipse.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/beta.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <limits>

#include "verification/reference/mathematics/high_precision.hpp"

namespace talus::verification::reference {
namespace {

using boost::math::tgamma;

/// (2 pi/M)^2/12 2 a b e^2 (2 - e), the common factor of a polygon's deficits.
double cut_off(const Superellipse& shape, double corners) {
  const double step = 2.0 * boost::math::constants::pi<double>() / corners, e = 2.0 / shape.n;
  return step * step / 6.0 * shape.a * shape.b * e * e * (2.0 - e);
}

/// Face of the first quadrant; `along` is the fraction of its coordinate: for the face x = a, y = b along.
struct Face {
  long double a, b, n;
  long double x(long double along) const { return a * std::pow(1.0L - std::pow(along, n), 1.0L / n); }
  long double y(long double along) const { return b * along; }
};

struct Found {
  long double distance{std::numeric_limits<long double>::infinity()};
  long double x{}, y{};
};

/// Nearest point of one face: every local minimum of the samples, in double, is refined in long double.
Found search(const Face& face, Point p, int pieces) {
  const long double px = p.x, py = p.y;
  const auto distance = [&](long double along) { return std::hypot(face.x(along) - px, face.y(along) - py); };
  const long double end = std::pow(0.5L, 1.0L / face.n);
  const auto a = static_cast<double>(face.a), b = static_cast<double>(face.b), n = static_cast<double>(face.n);
  std::vector<double> coarse;
  for (int i = 0; i <= pieces; ++i) {
    const double along = static_cast<double>(end) * i / pieces;
    coarse.push_back(std::hypot(a * std::pow(1.0 - std::pow(along, n), 1.0 / n) - p.x, b * along - p.y));
  }
  Found best;
  const auto consider = [&](long double along) {
    if (const long double d = distance(along); d < best.distance) best = {d, face.x(along), face.y(along)};
  };
  // The least distance lies within one step of the smallest sample.
  const double enough = *std::min_element(coarse.begin(), coarse.end()) + 2.0 * (a + b) / pieces;
  for (int i = 0; i <= pieces; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const bool falls = i > 0 && coarse[at - 1] < coarse[at], rises = i < pieces && coarse[at + 1] < coarse[at];
    if (falls || rises || coarse[at] > enough) continue;
    long double low = end * std::max(0, i - 1) / pieces, high = end * std::min(pieces, i + 1) / pieces;
    constexpr long double golden = 0.618033988749894848204586834365638118L;
    long double left = high - golden * (high - low), right = low + golden * (high - low);
    long double at_left = distance(left), at_right = distance(right);
    // The distance is flat at its minimum: a bracket of 1e-10 gives it to 1e-19.
    while (high - low > 1e-10L) {
      if (at_left < at_right) {
        high = right;
        right = left;
        at_right = at_left;
        left = high - golden * (high - low);
        at_left = distance(left);
      } else {
        low = left;
        left = right;
        at_left = at_right;
        right = low + golden * (high - low);
        at_right = distance(right);
      }
    }
    consider(low);
    consider(high);
  }
  return best;
}

}  // namespace

double area(const Superellipse& shape) {
  const Real50 n = shape.n, one = tgamma(Real50(1 + 1 / n));
  return nearest(Real50(4) * shape.a * shape.b * one * one / tgamma(Real50(1 + 2 / n)));
}

double polar_moment(const Superellipse& shape) {
  const Real50 n = shape.n, a = shape.a, b = shape.b;
  return nearest(4 * a * b * (a * a + b * b) * tgamma(Real50(1 / n)) * tgamma(Real50(3 / n)) /
                 (n * n * tgamma(Real50(1 + 4 / n))));
}

double area_cut_off(const Superellipse& shape, double corners) {
  return cut_off(shape, corners) * boost::math::beta(1.0 / shape.n, 1.0 / shape.n);
}

double moment_cut_off(const Superellipse& shape, double corners) {
  return cut_off(shape, corners) * (shape.a * shape.a + shape.b * shape.b) *
         boost::math::beta(1.0 / shape.n, 3.0 / shape.n);
}

double polygon_area(const std::vector<Point>& corners) {
  double sum = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point p = corners[i], q = corners[(i + 1) % corners.size()];
    sum += p.x * q.y - p.y * q.x;
  }
  return 0.5 * sum;
}

double polygon_polar_moment(const std::vector<Point>& corners) {
  double sum = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point p = corners[i], q = corners[(i + 1) % corners.size()];
    sum += (p.x * q.y - p.y * q.x) * (p.x * p.x + p.x * q.x + q.x * q.x + p.y * p.y + p.y * q.y + q.y * q.y);
  }
  return sum / 12.0;
}

double support(const Superellipse& shape, double c, double s) {
  const Real50 q = Real50(shape.n) / (Real50(shape.n) - 1);
  const Real50 u = abs(Real50(shape.a) * c), v = abs(Real50(shape.b) * s);
  if (u == 0) return nearest(v);
  if (v == 0) return nearest(u);
  return nearest(pow(Real50(pow(u, q) + pow(v, q)), Real50(1 / q)));
}

double corner_curvature(double half_axis, double n) {
  const Real50 power{n};
  return nearest((power - 1) * pow(Real50{2}, 1 / power - Real50{1} / 2) / half_axis);
}

double excess(const Superellipse& shape, Point p) {
  const Real50 u = abs(Real50(p.x) / shape.a), v = abs(Real50(p.y) / shape.b);
  return nearest(pow(u, Real50(shape.n)) + pow(v, Real50(shape.n)) - 1);
}

NearestPoint nearest_point(const Superellipse& shape, Point p, int pieces) {
  const Point folded{std::abs(p.x), std::abs(p.y)};
  const Found upright = search({shape.a, shape.b, shape.n}, folded, pieces);
  Found lying = search({shape.b, shape.a, shape.n}, {folded.y, folded.x}, pieces);
  std::swap(lying.x, lying.y);
  const Found& best = upright.distance <= lying.distance ? upright : lying;
  return {static_cast<double>(best.distance),
          {std::copysign(static_cast<double>(best.x), p.x), std::copysign(static_cast<double>(best.y), p.y)}};
}

}  // namespace talus::verification::reference
