#pragma once

/// Bodies that slide to rest, or roll from rest, on contacts with a spring and a dashpot along the normal and another
/// pair along the surface, with the Coulomb limit.
namespace talus::verification::reference {

/// A rectangle that slides to rest on level ground on both ends of its lower side. It starts upright with a horizontal
/// speed at the instant at which it touches the ground.
///
/// While both corners slip, F = mu N. With the momentum balances m x'' = -mu N, m y'' = N - m g:
///   x' = v_0 - mu (g t + y'),   x = v_0 t - mu (g t^2/2 + y - y_0).
/// If the vertical oscillation after touch has decayed when the block stops, at T = v_0/(mu g), its corners carry m g
/// and it has sunk by d = m g/(2 k):
///   x(T) = v_0^2/(2 mu g) + mu d.
/// Then the corners stick and the springs recover. The tangential springs were stretched by mu N_i/k_s: they recover
/// their mean, mu d k/k_s. The moment of friction, mu m g h, had tilted the block by mu m g h/(2 k b^2): its centre
/// returns by h times that angle, mu d (h/b)^2.
struct SlidingBlock {
  double mass{};              ///< m [M]
  double half_width{};        ///< b [L]
  double half_height{};       ///< h [L]
  double normal_stiffness{};  ///< k of one corner [F/L]
  double shear_stiffness{};   ///< k_s of one corner [F/L]
  double friction{};          ///< mu
  double gravity{};           ///< g [L/T^2]
  double speed{};             ///< v_0 [L/T]
};

/// Time at which the corners stop, v_0/(mu g) [T].
[[nodiscard]] double stopping_time(const SlidingBlock& block);
/// Displacement of the centre along the ground when all oscillations have decayed [L].
[[nodiscard]] double stopped_displacement(const SlidingBlock& block);

/// A disc that rolls down an incline from rest without slip, with the overlap d = m g cos(angle)/k.
///
/// Friction acts at the arm r_a = r - d/2, half-way through the overlap. With its force F = k_s s, s the stretch of the
/// spring and s' = x' - r_a w its rate: m x'' = m g sin(angle) - F, I w' = F r_a. Eliminating F and integrating twice:
///   (1 + q) x = g sin(angle) t^2/2 + q s,   q = I/(m r_a^2).
/// After the initial oscillation s is constant: F = q m g sin(angle)/(1 + q), and r_a w = x'.
struct RollingDisc {
  double mass{};              ///< m [M]
  double inertia{};           ///< I about its centre [M L^2]
  double radius{};            ///< r [L]
  double normal_stiffness{};  ///< k [F/L]
  double shear_stiffness{};   ///< k_s [F/L]
  double gravity{};           ///< g [L/T^2]
  double angle{};             ///< of the incline below the horizontal [rad]
};

/// Displacement of its centre along the incline [L] and magnitude of its spin [rad/T], after the initial oscillation
/// has decayed.
[[nodiscard]] double rolled_displacement(const RollingDisc& disc, double t);
[[nodiscard]] double rolled_spin(const RollingDisc& disc, double t);

}  // namespace talus::verification::reference
