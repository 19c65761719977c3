#pragma once

#include <vector>

/// A mass that draws a cable, falling or thrown, while the cable stays elastic, yields, hardens or breaks.
///
/// With the elongation e, the plastic elongation p and the yield force Y(p), piecewise linear between given points, the
/// tension is k (e - p) <= Y(p). For a mass whose kinetic energy goes into the cable, drawn from p0 to p1,
///   E = integral of Y dp from p0 to p1 + Y(p1)^2/(2 k)          (1)
/// at the turning point: the first term is dissipated, the second is recovered. On each linear segment (1) is quadratic
/// in p1; it is solved at 50 digits.
namespace talus::verification::reference {

/// Cable that yields and may break.
struct YieldingCable {
  struct Point {
    double stretch{};  ///< p [L]
    double force{};    ///< Y [F]
  };
  double stiffness{};         ///< k [F/L] > 0
  std::vector<Point> points;  ///< the first at p = 0; elongations increase, forces do not decrease
  double last_slope{};        ///< slope of Y beyond the last point [F/L] >= 0
};

/// Yield force Y(p).
[[nodiscard]] double yield_force(const YieldingCable& cable, double stretch);

/// Elongation at which a cable with plastic elongation p yields again [L].
[[nodiscard]] double yield_elongation(const YieldingCable& cable, double stretch);

/// Result of one draw: outward until the mass turns, and back until the cable is slack.
struct CableDraw {
  double peak_tension{};  ///< [F]
  double stretch{};       ///< plastic elongation p afterwards [L]
  double lost{};          ///< plastic work [F L]
  double exit_speed{};    ///< of the mass when the cable is slack again [L/T]
};

/// Draw by a mass thrown with `speed` away from the anchor of a cable with plastic elongation `stretch`, without
/// gravity. std::invalid_argument unless k, m and the first force are > 0 and the points are as above.
[[nodiscard]] CableDraw draw(const YieldingCable& cable, double mass, double speed, double stretch = 0.0);

/// Draw of a perfectly plastic cable in closed form: exit speed Y/sqrt(k m) and plastic elongation
/// (m v^2/2 - Y^2/(2 k))/Y if v > Y/sqrt(k m), else v and 0.
[[nodiscard]] CableDraw perfectly_plastic_draw(double stiffness, double yield, double mass, double speed);

/// Stored energy of an elastic cable that breaks at this tension, T^2/(2 k) [F L], and the speed of the mass after it.
[[nodiscard]] double broken_energy(double stiffness, double tension);
[[nodiscard]] double speed_kept(double stiffness, double tension, double mass, double speed);

/// Plastic work up to a plastic elongation, integral of Y dp from 0 [F L].
[[nodiscard]] double plastic_work(const YieldingCable& cable, double stretch);

/// Speed of a mass after its cable, initially without plastic elongation, breaks at this plastic elongation: the cable
/// has taken the plastic work and Y^2/(2 k), which it releases. std::invalid_argument unless the mass reaches this
/// elongation.
[[nodiscard]] double speed_kept(const YieldingCable& cable, double mass, double speed, double stretch);

/// A mass that falls freely over a height before its elastic cable is taut; d_s = m g/k.
struct Bungee {
  double stiffness{};  ///< k [F/L] > 0
  double mass{};       ///< [M] > 0
  double gravity{};    ///< [L/T^2] > 0
  double height{};     ///< free fall until taut [L] >= 0
};

/// Largest elongation d_s (1 + sqrt(1 + 2 h/d_s)) [L].
[[nodiscard]] double bungee_depth(const Bungee& bungee);
/// Time from rest to rest at the top, 2 [sqrt(2 h/g) + (pi/2 + asin((1 + 2 h/d_s)^(-1/2)))/w] [T].
[[nodiscard]] double bungee_period(const Bungee& bungee);

}  // namespace talus::verification::reference
