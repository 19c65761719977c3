#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "solver/base/fields.hpp"
#include "solver/state/mode.hpp"

namespace talus {

/// Friction at a contact by a spring and a slider in series (Cundall & Strack 1979; Mustoe & Huttelmaier 1993, Eq. 18
/// with the sign of the stretch, which the report leaves out). With N the normal force and s the stretch of the spring,
/// which is the law's memory:
///
///   sticking   ds/dt = slip rate u,         F = k_s s + c_s u       while |F| < mu N
///   slipping   s = +-mu N/k_s,              F = +-mu N              while the bodies go on slipping that way
///   open       s = 0,                       F = 0                   without a normal force that pushes
///
/// Between two force evaluations the stretch follows the slip; each evaluation takes it back to the limit of the normal
/// force of that moment (`return_mapping`). The first evaluation of a contact comes after the touch: it starts with the slip of
/// the time since (`begin`), without which a contact that sticks would be a method of first order. A contact that is
/// there when a run begins starts unstretched.
///
/// The dashpot c_s (0: none) acts while the contact sticks. It ends the oscillation of a body at rest on its tangential
/// springs, which nothing else damps. A contact that begins to slip before its spring is at the limit, because the
/// dashpot carries a part, loads the spring at the cost of the slider; the account of friction includes that energy.
struct CoulombFriction {
  static constexpr std::array<std::string_view, 4> modes{"open", "sticking", "slipping_forward", "slipping_backward"};
  enum : Mode { open, sticking, slipping_forward, slipping_backward };

  /// Whether the slider moves in this mode.
  static constexpr bool slips(Mode mode) { return mode == slipping_forward || mode == slipping_backward; }

  double coefficient{};  ///< mu >= 0
  double stiffness{};    ///< k_s [F/L] > 0
  double damping{};      ///< c_s [F T/L] >= 0; not used if follows_normal
  /// Whether c_s/k_s is the retardation time c/k of the contact's normal law at the moment.
  bool follows_normal{};

  /// c_s of a contact whose normal law has this retardation time [T].
  constexpr double dashpot(double retardation_time) const {
    return follows_normal ? stiffness * retardation_time : damping;
  }

  /// The stretch of a contact that has slipped so far since the touch, under its first normal force [L].
  constexpr double initial_stretch(double slip, double normal) const {
    const double limit = coefficient * std::max(normal, 0.0) / stiffness;
    return std::clamp(slip, -limit, limit);
  }

  /// What a return to the limit leaves, and what it cost.
  struct ReturnMapping {
    Mode mode{};
    double stretch{};     ///< [L]
    double dissipated{};  ///< work of the slider, and of the spring let go where the contact opens [F L]
  };

  /// `stretch` as it stands after the slip so far, `normal` the normal force [F], <= 0 where nothing pushes;
  /// `viscous` = c_s u/k_s, the stretch that would add as much force as the dashpot does [L].
  constexpr ReturnMapping return_mapping(double stretch, double normal, double viscous = 0.0) const {
    if (!(normal > 0.0)) return {open, 0.0, stored_energy(stretch)};
    const double limit = coefficient * normal / stiffness;
    const double loaded = stretch + viscous;
    if (std::abs(loaded) <= limit) return {sticking, stretch, 0.0};
    const double end = std::copysign(limit, loaded);
    const bool beyond = loaded > 0.0 ? stretch > limit : stretch < -limit;
    const double dissipated =
        beyond ? coefficient * normal * (std::abs(stretch) - limit) : stored_energy(stretch) - stored_energy(end);
    return {loaded > 0.0 ? slipping_forward : slipping_backward, end, dissipated};
  }

  /// Force that resists the slip [F], with the sign of the stretch; `viscous` as above while the contact sticks, else
  /// 0.
  constexpr double operator()(double stretch, double normal, double viscous = 0.0) const {
    const double limit = coefficient * std::max(normal, 0.0);
    return std::clamp(stiffness * (stretch + viscous), -limit, limit);
  }

  /// initial_stretch(), then return_mapping() and the force, while the normal force pushes: the same bits. Number is double, or a pack of
  /// them that are computed side by side.
  template <class Number>
  [[gnu::always_inline]] constexpr void initial_stretch(const Number& slip, const Number& normal,
                                                        Number& stretch) const {
    const Number limit = coefficient * normal / stiffness, back = -limit;
    stretch = slip < back ? back : slip;
    stretch = limit < stretch ? limit : stretch;
  }
  template <class Number>
  [[gnu::always_inline]] constexpr void returned_force(const Number& normal, Number& stretch, Number& force) const {
    initial_stretch(Number{stretch}, normal, stretch);
    const Number limit = coefficient * normal, back = -limit;
    force = stiffness * stretch;
    force = force < back ? back : force;
    force = limit < force ? limit : force;
  }

  /// What return_mapping() dissipates of a stretch, by the one that it leaves.
  template <class Number>
  [[gnu::always_inline]] constexpr void dissipated(const Number& stretch, const Number& normal, const Number& left,
                                                   Number& energy) const {
    const Number none{}, was = stretch < none ? -stretch : stretch, is = left < none ? -left : left;
    const Number slid = coefficient * normal * (was - is), let_go = 0.5 * stiffness * stretch * stretch;
    energy = normal > none ? slid : let_go;
  }

  constexpr double stored_energy(double stretch) const { return 0.5 * stiffness * stretch * stretch; }

  /// Positive while the mode lasts; `slip_rate` [L/T] as in the stretch, `viscous` as above.
  constexpr double guard(double stretch, double slip_rate, double normal, Mode mode, double viscous = 0.0) const {
    if (mode == open) return -normal;
    if (mode == sticking) return coefficient * normal / stiffness - std::abs(stretch + viscous);
    return mode == slipping_forward ? slip_rate : -slip_rate;
  }

  friend constexpr bool operator==(const CoulombFriction&, const CoulombFriction&) = default;
};

/// Contacts without friction: bodies slip freely and are not turned.
struct Frictionless {
  friend constexpr bool operator==(Frictionless, Frictionless) = default;
};

}  // namespace talus
