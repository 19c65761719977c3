#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "solver/base/fields.hpp"
#include "solver/laws/kinematics.hpp"
#include "solver/state/mode.hpp"

namespace talus {

/// Contact friction by a spring and a slider in series (Cundall & Strack 1979; Mustoe & Huttelmaier 1993, Eq. 18
/// with the sign of the stretch, which the report omits). N is the normal force and s the stretch of the spring, which
/// is the law's memory:
///
///   sticking   ds/dt = slip rate u,         F = k_s s + c_s u       while |F| < mu N
///   slipping   s = +-mu N/k_s,              F = +-mu N              while the slip rate keeps its sign
///   open       s = 0,                       F = 0                   while N is not compressive
///
/// Between two force evaluations the stretch follows the slip; each evaluation limits it to mu N/k_s with the current
/// normal force (`return_mapping`). The first evaluation of a contact comes after the touch; it starts with the slip
/// accumulated since the touch (`initial_stretch`), otherwise a sticking contact would reduce the method to first
/// order. A contact that exists at the start of a run starts unstretched.
///
/// The dashpot c_s (0: none) acts while the contact sticks. It damps the oscillation of a body at rest on its
/// tangential springs, which is otherwise undamped. If the dashpot carries part of the force, a contact begins to slip
/// before its spring is at the limit; the stretch then jumps to the limit, and the friction energy is reduced by the
/// increase of the spring's energy.
struct CoulombFriction {
  static constexpr std::string_view name = "linear";
  static constexpr std::size_t memory_size = 1;  ///< stretch [L]
  static constexpr double onset = 1.0;           ///< stretch at the first evaluation over the slip since touch
  static constexpr std::string_view stiffness_rule = "shear_stiffness";
  static constexpr std::array<std::string_view, 4> modes{"open", "sticking", "slipping_forward", "slipping_backward"};
  enum : Mode { open, sticking, slipping_forward, slipping_backward };

  /// Whether the slider moves in this mode.
  static constexpr bool slips(Mode mode) { return mode == slipping_forward || mode == slipping_backward; }

  double coefficient{};  ///< mu >= 0
  double stiffness{};    ///< k_s [F/L] > 0
  double damping{};      ///< c_s [F T/L] >= 0; not used if follows_normal
  /// Whether c_s/k_s equals the current retardation time c/k of the contact's normal law.
  bool follows_normal{};

  static constexpr std::array<Field<CoulombFriction>, 3> fields() {
    return {{{"friction", dimension::number, &CoulombFriction::coefficient, Range::non_negative,
              "coefficient of Coulomb friction"},
             {"shear_stiffness", dimension::stiffness, &CoulombFriction::stiffness, Range::positive,
              "tangential stiffness k_s of friction that sticks"},
             {"shear_damping", dimension::damping, &CoulombFriction::damping, Range::non_negative,
              "tangential dashpot of friction that sticks"}}};
  }

  // The interface of a friction law, see IsFrictionLaw and HasFrictionKernel.
  constexpr CoulombFriction at(double) const { return *this; }
  constexpr CoulombFriction stiffest() const { return *this; }
  constexpr double stretch_rate(double, double slip_rate, Kinematics) const { return slip_rate; }
  constexpr double stretch_after(double stretch, double slip_rate, Kinematics, double h) const {
    return stretch + h * slip_rate;
  }
  constexpr double area_power(double, Kinematics) const { return 0.0; }
  template <class Number>
  [[gnu::always_inline]] constexpr void stiffness_at(const Number&, Number& k) const {
    k = Number{} + stiffness;
  }
  template <class Number>
  [[gnu::always_inline]] constexpr void move_stretch(const Number& stretch, const Number& slip_rate, const Number&,
                                                     const Number&, double h, Number& moved) const {
    moved = stretch + h * slip_rate;
  }
  template <class Number>
  [[gnu::always_inline]] constexpr void area_power(const Number&, const Number&, const Number&, Number& power) const {
    power = Number{};
  }
  /// By default the spring is as stiff as the normal one, and the dashpot has the normal law's retardation time.
  constexpr void follow(double normal_stiffness, bool normal_damping) {
    stiffness = normal_stiffness;
    follows_normal = normal_damping;
  }

  /// mu N/k_s of a normal force [L]; 0 where there is no stiffness.
  constexpr double stretch_limit(double normal) const {
    return stiffness > 0.0 ? coefficient * std::max(normal, 0.0) / stiffness : 0.0;
  }

  /// Dashpot coefficient c_s [F T/L] of a contact whose normal law has this retardation time [T].
  constexpr double dashpot(double retardation_time) const {
    return follows_normal ? stiffness * retardation_time : damping;
  }

  /// Stretch at the first evaluation of a contact [L], from the slip since the touch [L] and the normal force [F]: the
  /// slip within the limit.
  constexpr double initial_stretch(double slip, double normal) const {
    const double limit = stretch_limit(normal);
    return std::clamp(slip, -limit, limit);
  }

  /// Result of a return mapping to the friction limit.
  struct ReturnMapping {
    Mode mode{};
    double stretch{};     ///< [L]
    double dissipated{};  ///< work of the slider, or the spring's energy where the contact opens [F L]
  };

  /// Limits the trial stretch: `stretch` [L] includes the slip so far, `normal` is the normal force [F] (<= 0: not
  /// compressive), `viscous` = c_s u/k_s is the stretch equivalent to the dashpot's force [L].
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

  /// Force that resists the slip [F], with the sign of the stretch; `viscous` as in return_mapping() while the contact
  /// sticks, else 0.
  constexpr double operator()(double stretch, double normal, double viscous = 0.0) const {
    const double limit = coefficient * std::max(normal, 0.0);
    return std::clamp(stiffness * (stretch + viscous), -limit, limit);
  }

  constexpr double stored_energy(double stretch) const { return 0.5 * stiffness * stretch * stretch; }

  /// Positive while the mode lasts; `slip_rate` [L/T] is ds/dt while sticking, `viscous` as in return_mapping().
  constexpr double guard(double stretch, double slip_rate, double normal, Mode mode, double viscous = 0.0) const {
    if (mode == open) return -normal;
    if (mode == sticking)
      return (stiffness > 0.0 ? coefficient * normal / stiffness : 0.0) - std::abs(stretch + viscous);
    return mode == slipping_forward ? slip_rate : -slip_rate;
  }

  friend constexpr bool operator==(const CoulombFriction&, const CoulombFriction&) = default;
};

/// Contacts without friction: bodies slip freely and receive no torque.
struct Frictionless {
  friend constexpr bool operator==(Frictionless, Frictionless) = default;
};

}  // namespace talus
