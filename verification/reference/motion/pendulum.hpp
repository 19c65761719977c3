#pragma once

#include <string>

/// Exact motion of the rigid (mathematical or compound) pendulum  x'' = -w0^2 sin x  in elliptic functions.
///
/// Energy: x'^2/2 + w0^2 (1 - cos x) = const, so x'^2 = x'_0^2 - 4 w0^2 sin^2(x/2) from the bottom, with
/// k = x'_0/(2 w0):
/// - libration k < 1:  sin(x/2) = k sn(w0 t, k),  x' = 2 k w0 cn(w0 t, k),  period 4 K(k)/w0, amplitude 2 asin k.
///   Proof: (x'/2) cos(x/2) = k w0 cn dn and cos(x/2) = dn.
/// - from rest at amplitude A, k = sin(A/2), a quarter period later in phase: sin(x/2) = k sn(w0 t + K) = k cn/dn,
///   x' = 2 k w0 cn(w0 t + K) = -2 k k' w0 sn/dn.
/// - rotation k > 1: x/2 = am(k w0 t, 1/k), x' = 2 k w0 dn(k w0 t, 1/k), one turn in 2 K(1/k)/(k w0).
/// - separatrix k = 1: x = 2 atan(sinh(w0 t)), x' = 2 w0/cosh(w0 t).
/// For a compound pendulum w0^2 = m g h/I_p with h from pivot to centre of mass and I_p about the pivot.
/// Source: Whittaker, Analytical Dynamics (1937), art. 44; the proofs are the lines above.
namespace talus::verification::reference {

struct PendulumState {
  double angle{};  ///< x [rad], counter-clockwise from the bottom, not reduced modulo 2 pi.
  double rate{};   ///< x' [rad/T].
};

class PendulumMotion {
 public:
  /// Released at rest at the angle `amplitude` [rad], 0 < amplitude < pi, at t = 0; `frequency` w0 > 0 [rad/T].
  [[nodiscard]] static PendulumMotion from_rest(double frequency, double amplitude);
  /// Passes the bottom, x = 0, with x' = `rate` [rad/T] (> 0) at t = 0: libration, separatrix or rotation.
  [[nodiscard]] static PendulumMotion from_bottom(double frequency, double rate);

  /// Period [T], for a rotation the time of one turn; infinite on the separatrix.
  [[nodiscard]] double period() const { return static_cast<double>(4.0L * quarter_period_); }
  /// Largest angle [rad]; infinite for a rotation, pi on the separatrix.
  [[nodiscard]] double amplitude() const { return amplitude_; }
  /// x'^2/2 + w0^2 (1 - cos x) [1/T^2], the energy over the inertia, 0 at rest at the bottom.
  [[nodiscard]] double energy() const { return energy_; }

  /// State at any t (of either sign), evaluated in long double and rounded: the error is a few units in the last place
  /// of the double, times the condition of the motion, which near 180 degrees amplifies an error of t.
  [[nodiscard]] PendulumState at(double t) const;
  /// State evaluated at 50 digits from the same doubles (slow: about a millisecond).
  [[nodiscard]] PendulumState at_50_digits(double t) const;
  /// Period computed at 50 digits, printed to 45 decimal digits.
  [[nodiscard]] std::string period_45_digits() const;

 private:
  enum class Start { rest, bottom };
  PendulumMotion(Start start, double frequency, double value);
  template <class Real>
  [[nodiscard]] PendulumState evaluate(double t) const;

  Start start_;
  double frequency_;
  double value_;  // amplitude or rate, by start_
  double amplitude_{};
  double energy_{};
  long double quarter_period_{};
};

}  // namespace talus::verification::reference
