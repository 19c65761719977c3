#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "solver/base/fields.hpp"
#include "solver/laws/kinematics.hpp"
#include "solver/state/state.hpp"

namespace talus {

/// A law that is in no list, for tests: surfaces that attract each other before they touch, as by van der Waals forces.
/// With s the overlap and d the range, while s > -d
///
///   F = k s (1 + s/d) + c ds/dt
///
/// which is attractive between -d and 0 and repulsive beyond; the spring's energy is 0 at -d.
struct Cohesive {
  static constexpr std::string_view name = "cohesive";
  static constexpr std::array<std::string_view, 2> modes{"apart", "near"};
  static constexpr std::size_t memory_size = 0;
  static constexpr Mechanism dissipation = Mechanism::contact_damping;
  static constexpr Mechanism release = Mechanism::contact_release;

  double stiffness{};  ///< k [F/L] > 0
  double range{};      ///< d [L] > 0
  double damping{};    ///< c [F T/L] >= 0

  static constexpr std::array<Field<Cohesive>, 3> fields() {
    return {{{"stiffness", dimension::stiffness, &Cohesive::stiffness, Range::positive, "stiffness where it touches"},
             {"range", dimension::length, &Cohesive::range, Range::positive, "distance from which it attracts"},
             {"damping", dimension::damping, &Cohesive::damping, Range::non_negative, "dashpot coefficient"}}};
  }

  constexpr double reach() const { return range; }
  static constexpr bool acts(Mode mode) { return mode == 1; }
  constexpr LawForce operator()(Kinematics x, std::span<const double>, Mode mode) const {
    if (mode == 0) return {};
    return {stiffness * x.deformation * (1.0 + x.deformation / range), damping * x.deformation_rate};
  }
  constexpr double stored_energy(Kinematics x, std::span<const double>, Mode mode) const {
    if (mode == 0) return 0.0;
    const double s = x.deformation;
    return stiffness * (0.5 * s * s + s * s * s / (3.0 * range) - range * range / 6.0);
  }
  constexpr double guard(Kinematics x, std::span<const double>, Mode mode) const {
    return mode == 0 ? -(x.deformation + range) : x.deformation + range;
  }
  constexpr Reset reset(Kinematics x, std::span<double>, Mode) const {
    const double inside = x.deformation + range;
    return {static_cast<Mode>(inside > 0.0 || (inside == 0.0 && x.deformation_rate >= 0.0) ? 1 : 0), 0.0};
  }
  /// Slope at half the range of overlap.
  constexpr Tangent tangent() const { return {2.0 * stiffness, damping}; }

  constexpr bool needs_rate() const { return damping != 0.0; }
  template <class Number>
  [[gnu::always_inline]] constexpr void force(const Number& overlap, const Number& rate, Number&, Number& out) const {
    out = stiffness * overlap * (1.0 + overlap / range) + damping * rate;
  }
  template <class Number>
  [[gnu::always_inline]] constexpr void dissipated_power(const Number&, const Number& rate, const Number&,
                                                         const Number&, Number& power, Number& released) const {
    power = damping * rate * rate, released = Number{};
  }

  friend constexpr bool operator==(const Cohesive&, const Cohesive&) = default;
};

}  // namespace talus
