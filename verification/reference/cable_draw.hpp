#pragma once

#include <vector>

/// A mass that draws a cable: falling, or thrown at it, while the cable stays elastic, yields, hardens or breaks.
///
/// With the elongation e, the plastic stretch p and the yield force Y(p), straight between given points, the tension is
/// k (e - p) <= Y(p). Of a mass whose kinetic energy goes into the cable, drawn out from p0 to p1,
///   E = integral of Y dp from p0 to p1 + Y(p1)^2/(2 k)          (1)
/// at the turn: the first part is lost, the second comes back. On each straight piece (1) is quadratic in p1; it is
/// solved at 50 digits.
namespace talus::verification::reference {

/// A cable that yields, and may break.
struct YieldingCable {
  struct Point {
    double stretch{};  ///< p [L]
    double force{};    ///< Y [F]
  };
  double stiffness{};         ///< k [F/L] > 0
  std::vector<Point> points;  ///< the first at p = 0; stretches and forces grow, forces may stay
  double last_slope{};        ///< of Y behind the last point [F/L] >= 0
};

/// Y(p).
[[nodiscard]] double yield_force(const YieldingCable& cable, double stretch);

/// Elongation at which a cable drawn out to p yields on [L].
[[nodiscard]] double yield_elongation(const YieldingCable& cable, double stretch);

/// One draw: out until the mass turns, and back until the cable is slack.
struct CableDraw {
  double peak_tension{};  ///< [F]
  double stretch{};       ///< p afterwards [L]
  double lost{};          ///< plastic work [F L]
  double exit_speed{};    ///< of the mass when the cable is slack again [L/T]
};

/// A mass thrown with `speed` away from the anchor of a cable with plastic stretch `stretch`, without gravity.
/// std::invalid_argument unless k, m, the first force > 0, and points as above.
[[nodiscard]] CableDraw draw(const YieldingCable& cable, double mass, double speed, double stretch = 0.0);

/// The same of a perfectly plastic cable, in closed form: exit speed Y/sqrt(k m) and stretch (m v^2/2 - Y^2/(2 k))/Y if
/// v > Y/sqrt(k m), else v and 0.
[[nodiscard]] CableDraw perfectly_plastic_draw(double stiffness, double yield, double mass, double speed);

/// Energy that an elastic cable holds when it breaks at this tension, T^2/(2 k) [F L], and the speed that a mass keeps.
[[nodiscard]] double broken_energy(double stiffness, double tension);
[[nodiscard]] double speed_kept(double stiffness, double tension, double mass, double speed);

/// Energy that goes into drawing a cable out to this plastic stretch, integral of Y dp from 0 [F L].
[[nodiscard]] double plastic_work(const YieldingCable& cable, double stretch);

/// Speed that a mass keeps whose cable, not drawn out before, breaks at this plastic stretch: of its energy the cable has
/// taken the plastic work, and Y^2/(2 k), which it releases. std::invalid_argument unless the mass gets so far.
[[nodiscard]] double speed_kept(const YieldingCable& cable, double mass, double speed, double stretch);

/// A mass that falls a height before its elastic cable is taut; d_s = m g/k.
struct Bungee {
  double stiffness{};  ///< k [F/L] > 0
  double mass{};       ///< [M] > 0
  double gravity{};    ///< [L/T^2] > 0
  double height{};     ///< fallen until taut [L] >= 0
};

/// Largest elongation d_s (1 + sqrt(1 + 2 h/d_s)) [L].
[[nodiscard]] double bungee_depth(const Bungee& bungee);
/// Time from rest to rest at the top, 2 [sqrt(2 h/g) + (pi/2 + asin((1 + 2 h/d_s)^(-1/2)))/w] [T].
[[nodiscard]] double bungee_period(const Bungee& bungee);

}  // namespace talus::verification::reference
