#pragma once

#include <vector>

/// Closed-form motion of a body that rests on a plane with a constant normal force and is dragged along it against
/// friction by a spring and a slider in series.
///
/// With the slip rate v of the contact point, the stretch s of the spring, the limit L = mu N/k_s and the mobility n of
/// the contact point (a force F along the plane changes v at the rate n F/m; n = 1 for a particle, 1 + m r^2/I for a
/// disc that may roll):
///   stick   s' = v,   v' = a - n k_s s/m      while |s| < L: oscillation about s = m a/(n k_s), w = sqrt(n k_s/m)
///   slip    s = +-L,  v' = a -+ n mu N/m      while v keeps its sign: constant acceleration
/// The drive a (gravity along the plane) accelerates the centre of mass and the contact point equally, so that the
/// centre's velocity is v_0 + a t - J/m with the friction impulse J = m (v(0) + a t - v)/n.
namespace talus::verification::reference {

struct DraggedSlider {
  double mass{};                  ///< m [M] > 0
  double mobility{1.0};           ///< n >= 1
  double normal_force{};          ///< N [F] > 0
  double friction{};              ///< mu > 0
  double tangential_stiffness{};  ///< k_s [F/L] > 0
  double drive{};                 ///< a [L/T^2]
  double slip_rate{};             ///< v(0) [L/T]
  double stretch{};               ///< s(0) [L], |s| <= L
};

/// The motion at one time.
struct SliderState {
  double slip_rate{};   ///< v [L/T]
  double stretch{};     ///< s [L]
  double slipped{};     ///< slip distance of the slider in either direction [L] >= 0; dissipates mu N times it
  double speed_gain{};  ///< change of the centre's velocity since the start [L/T]
};

/// The motion up to a time, phase by phase.
class DraggedSliderMotion {
 public:
  /// `until` [T] >= 0. std::invalid_argument for a problem outside the ranges above.
  DraggedSliderMotion(const DraggedSlider& problem, double until);

  /// At 0 <= t <= until.
  [[nodiscard]] SliderState at(double t) const;

  struct Phase {
    double begin{};      ///< [T]
    int slips{};         ///< 0: sticks; +1, -1: direction of slip
    double slip_rate{};  ///< at `begin` [L/T]
    double stretch{};    ///< at `begin` [L]
    double slipped{};    ///< before `begin` [L]
  };
  [[nodiscard]] const std::vector<Phase>& phases() const { return phases_; }

 private:
  [[nodiscard]] Phase state_in(const Phase& phase, double t) const;
  [[nodiscard]] double duration(const Phase& phase) const;
  [[nodiscard]] int slip_sign(double slip_rate, double stretch) const;

  DraggedSlider problem_;
  double limit_{};      ///< L
  double rest_{};       ///< m a/(n k_s)
  double frequency_{};  ///< w
  std::vector<Phase> phases_;
};

/// Amplitude of the slip rate after slip ends on a level plane: the spring, stretched by mu N/k_s, oscillates with the
/// effective mass m/n of the contact, at most mu N sqrt(n/(m k_s)) [L/T].
[[nodiscard]] double swing_after_slip(const DraggedSlider& problem);

}  // namespace talus::verification::reference
