#pragma once

#include <string>

/// Validation problem 1 of the 1993 report (section 5, Eqs. 26-27): a particle between two cables is struck; rigid
/// impact.
///
///        anchor
///           |  l, k            y
///   M -> .. m                  |__ x      cables along y, unstretched; the motion is along x, no gravity
///           |  l, k
///        anchor
///
/// At displacement x each cable is sqrt(l^2 + x^2) long, so its elongation is s = sqrt(l^2 + x^2) - l, its tension
/// T = k s, and m x'' = -2 T x/sqrt(l^2 + x^2). Energy: m v^2/2 + 2 k s^2/2 = m v1^2/2, with
/// cos(theta) = l/sqrt(l^2+x^2) and s = l (1 - cos theta)/cos theta: Eq. 27 as printed. Momentum and restitution give
/// Eq. 26 as printed.
///
/// Time: s_max = v1 sqrt(m/(2k)), x_max = sqrt(s_max (s_max + 2 l)), v^2 = v1^2 (1 - s/s_max)(1 + s/s_max). With
/// x = x_max sin u, L = sqrt(l^2 + x^2):  s_max - s = (x_max^2 - x^2)/(L_max + L) = x_max^2 cos^2 u/(L_max + L), so
///   dt = dx/v = f(u) du,   f(u) = sqrt(s_max (L_max + L)/(1 + s/s_max))/v1,
/// which is smooth at the turning point u = pi/2: no end-point singularity remains, and x(t) follows by inverting t(u).
namespace talus::verification::reference {

/// Any consistent system of units; the defaults are the report's (N, m, kg, s).
struct TwoCable {
  double stiffness{4.0};       ///< k [F/L] of one cable, > 0.
  double length{10.0};         ///< l [L], unstretched, > 0.
  double mass{1.0};            ///< m [M], the particle on the cables, > 0.
  double striker_mass{2.0};    ///< M [M] > 0.
  double restitution{0.5};     ///< e [-], 0 <= e <= 1.
  double approach_speed{2.0};  ///< v0 [L/T] of the striker, > 0.
};

/// Velocities along x after a rigid impact [L/T].
struct TwoCableImpact {
  double particle{};  ///< v1 = M (1 + e) v0/(M + m), Eq. 26.
  double striker{};   ///< V1 = v1 - e v0 = (M - e m) v0/(M + m).
};
[[nodiscard]] TwoCableImpact rigid_impact(const TwoCable& problem);

/// Free motion of the particle on the cables, leaving x = 0 with velocity v1 at t = 0.
class TwoCableMotion {
 public:
  /// `mass`, `stiffness`, `length` as above; `launch_speed` v1 > 0 [L/T].
  TwoCableMotion(const TwoCable& problem, double launch_speed);

  [[nodiscard]] double largest_distance() const;            ///< x_max [L].
  [[nodiscard]] double largest_angle() const;               ///< theta_max = atan(x_max/l) [rad].
  [[nodiscard]] double speed_at_distance(double x) const;   ///< v(x) [L/T], |x| <= x_max.
  [[nodiscard]] double speed_at_angle(double theta) const;  ///< v(theta), Eq. 27 [L/T].
  /// Time from x = 0 to x, 0 <= x <= x_max [T]; quadrature and substitution at 50 digits (takes milliseconds).
  [[nodiscard]] double time_to_distance(double x) const;
  [[nodiscard]] double time_to_turning() const;  ///< Time from x = 0 to x_max [T], a quarter of the period.
  [[nodiscard]] std::string time_to_turning_40_digits() const;
  /// State at any t >= 0: inversion of the quadrature in long double, about 1e-17 of x_max and v1.
  struct State {
    double position{};  ///< x [L].
    double velocity{};  ///< v [L/T].
  };
  [[nodiscard]] State at(double t) const;

 private:
  TwoCable problem_;
  double launch_speed_;
  long double quarter_period_;
};

/// Tension of one cable at distance x [F].
[[nodiscard]] double cable_tension(const TwoCable& problem, double x);

}  // namespace talus::verification::reference
