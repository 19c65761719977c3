#pragma once

#include <vector>

/// The outline |x/a|^n + |y/b|^n = 1: area, polar moment, support function and nearest points, by methods other than
/// those of the solver.
namespace talus::verification::reference {

struct Superellipse {
  double a{}, b{};  ///< half axes [L] > 0
  double n{2.0};    ///< exponent >= 1
};

struct Point {
  double x{}, y{};
};

/// Area 4 a b Gamma(1 + 1/n)^2/Gamma(1 + 2/n) [L^2], at 50 digits.
[[nodiscard]] double area(const Superellipse& shape);

/// Integral of x^2 + y^2 over the area: 4 a b (a^2 + b^2) Gamma(1/n) Gamma(3/n)/(n^2 Gamma(1 + 4/n)) [L^4], at 50
/// digits.
[[nodiscard]] double polar_moment(const Superellipse& shape);

/// Deficit of area and moment of a polygon with its corners at equal steps 2 pi/M of the parametric angle t, x = a c^e,
/// y = b s^e, e = 2/n, to leading order in 1/M. A chord cuts off (dt^3/12) |x' y'' - y' x''| of area, and that
/// integrand is a b e^2 (2 - e) (c s)^(e - 1), so that with the beta function
///   area   (2 pi/M)^2/12 2 a b e^2 (2 - e) B(e/2, e/2)
///   moment (2 pi/M)^2/12 2 a b (a^2 + b^2) e^2 (2 - e) B(e/2, 3 e/2).
[[nodiscard]] double area_cut_off(const Superellipse& shape, double corners);
[[nodiscard]] double moment_cut_off(const Superellipse& shape, double corners);

/// Area and polar moment about the origin of a closed polygon, counter-clockwise (shoelace formulas).
[[nodiscard]] double polygon_area(const std::vector<Point>& corners);
[[nodiscard]] double polygon_polar_moment(const std::vector<Point>& corners);

/// Largest x c + y s over the area: the dual norm (|a c|^q + |b s|^q)^(1/q), q = n/(n - 1) (Hoelder), at 50 digits;
/// n > 1.
[[nodiscard]] double support(const Superellipse& shape, double c, double s);

/// Curvature at the rounded corner, where both terms are 1/2, for a = b: (n - 1) 2^(1/n - 1/2)/a [1/L], at 50 digits.
/// With F = (x^n + y^n)/n, x = y = 2^(-1/n): F_x = F_y = x^(n-1), F_xx = F_yy = (n - 1) x^(n-2), and the curvature
/// (F_xx F_y^2 + F_yy F_x^2)/|grad F|^3 = 2 (n - 1) x^(3n-4)/(2^(3/2) x^(3n-3)) = (n - 1)/(sqrt(2) x).
[[nodiscard]] double corner_curvature(double half_axis, double n);

/// x/a|^n + |y/b|^n - 1 at 50 digits: negative inside.
[[nodiscard]] double excess(const Superellipse& shape, Point p);

/// Distance of a point from the outline by brute force: both faces of its quadrant are sampled at `pieces` equal steps,
/// and each local minimum is refined by golden sections, with a 64-bit mantissa.
struct NearestPoint {
  double distance{};  ///< [L] >= 0
  Point p;
};
[[nodiscard]] NearestPoint nearest_point(const Superellipse& shape, Point p, int pieces = 2000);

}  // namespace talus::verification::reference
