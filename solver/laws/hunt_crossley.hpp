#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string_view>

#include "solver/base/pack.hpp"
#include "solver/laws/hunt_crossley_impact.hpp"
#include "solver/laws/kinematics.hpp"
#include "solver/laws/unilateral_spring.hpp"
#include "solver/state/state.hpp"

namespace talus {

/// Normal contact whose damping grows with the overlap (Hunt & Crossley 1975), with a power of the overlap d:
///
///   F = k d (d/d_r)^(n - 1) (1 + a dd/dt)
///
/// The force is continuous at touch, and it does not pull where an impact ends. It would pull in a contact that is torn
/// apart faster than 1/a: there it is zero (mode released). The restitution decreases with the speed v and depends on
/// a v alone, for every exponent (HuntCrossleyImpact).
struct HuntCrossley {
  static constexpr std::string_view name = "hunt_crossley";
  static constexpr std::array<std::string_view, 3> modes{"open", "touching", "released"};
  static constexpr std::size_t memory_size = 0;
  static constexpr Mechanism dissipation = Mechanism::contact_damping;
  static constexpr Mechanism release = Mechanism::contact_release;
  static constexpr RestitutionField restitution_field{"hysteresis", "by the damping that grows with the overlap"};

  double stiffness{};          ///< k [F/L] > 0: F/d at the reference overlap
  double reference_overlap{};  ///< d_r [L] > 0
  double exponent{};           ///< n in [1, 100]: 1 linear, 3/2 as by Hertz
  double hysteresis{};         ///< a [T/L] >= 0

  static constexpr std::array<Field<HuntCrossley>, 4> fields() {
    return {{{"stiffness", dimension::stiffness, &HuntCrossley::stiffness, Range::positive,
              "force over overlap at the reference overlap"},
             {"reference_overlap", dimension::length, &HuntCrossley::reference_overlap, Range::positive,
              "overlap at which force over overlap is the stiffness, e.g. the largest expected"},
             {"exponent", dimension::number, &HuntCrossley::exponent, Range::one_to_hundred,
              "power of the overlap: 1 linear, 1.5 as by Hertz"},
             {"hysteresis", dimension::number / dimension::velocity, &HuntCrossley::hysteresis, Range::non_negative,
              "growth of the force for each unit of closing speed, relative to the elastic force"}}};
  }

  static constexpr bool acts(Mode mode) { return UnilateralSpring::acts(mode); }
  LawForce operator()(Kinematics x, std::span<const double>, Mode mode) const { return spring(x)(x, mode); }
  double stored_energy(Kinematics x, std::span<const double>, Mode mode) const {
    return secant_energy_ratio() * spring(x).stored_energy(x, mode);
  }
  double guard(Kinematics x, std::span<const double>, Mode mode) const {
    // Of the force only the sign of 1 + a dd/dt matters; its product with the overlap keeps the unit.
    if (mode == UnilateralSpring::open) return -x.deformation;
    const double pull = x.deformation * (1.0 + hysteresis * x.deformation_rate);
    return std::min(x.deformation, mode == UnilateralSpring::acting ? pull : -pull);
  }
  Reset reset(Kinematics x, std::span<double>, Mode mode) const {
    const Reset next = spring(x).reset(x, mode);
    return {next.mode, secant_energy_ratio() * next.released};
  }
  static constexpr bool is_clamped() { return true; }
  /// The linear spring and dashpot with the same force at this overlap >= 0, for a number or a pack of numbers. (Within
  /// rounding of 1 + a dd/dt = 0 the sign of their sum may differ from that of guard().)
  template <class Number>
  [[gnu::always_inline]] void secant(const Number& overlap, Number& k, Number& c) const {
    k = Number{} + 1.0;
    if (exponent != 1.0) {
      k = overlap / reference_overlap;
      // The exponents in use do not depend on the library's pow.
      if (exponent == 1.5)
        square_root(k);
      else if (exponent != 2.0)
        raise_to_power(k, exponent - 1.0);
    }
    k *= stiffness;
    c = k * overlap * hysteresis;
  }
  /// Ratio of the law's energy, F d/(n + 1), to that of the secant linear spring, 1/2 F d.
  constexpr double secant_energy_ratio() const { return 2.0 / (exponent + 1.0); }
  /// Tangent at the reference overlap; larger overlaps are stiffer if n > 1.
  constexpr Tangent tangent() const { return {exponent * stiffness, hysteresis * stiffness * reference_overlap}; }

  double contact_time(double effective_mass, double speed) const {
    return impact(speed).contact_time * impact_length(effective_mass, speed) / speed;
  }
  double restitution(double /* effective_mass */, double speed) const {
    return hunt_crossley_restitution(hysteresis * speed);
  }
  double largest_overlap(double effective_mass, double speed) const {
    return impact(speed).largest_overlap * impact_length(effective_mass, speed);
  }
  void set_restitution(double e, double /* effective_mass */, double speed) { set_every_restitution(e, speed); }
  void set_every_restitution(double e, double speed) { hysteresis = hunt_crossley_damping_number(e) / speed; }
  static constexpr bool restitution_varies() { return true; }

  friend constexpr bool operator==(const HuntCrossley&, const HuntCrossley&) = default;

 private:
  HuntCrossleyImpact impact(double speed) const { return hunt_crossley_impact(hysteresis * speed, exponent); }
  /// L of HuntCrossleyImpact [L].
  double impact_length(double effective_mass, double speed) const {
    const double of_energy = effective_mass * speed * speed / (stiffness * reference_overlap * reference_overlap);
    return reference_overlap * std::pow(of_energy, 1.0 / (exponent + 1.0));
  }

  UnilateralSpring spring(Kinematics x) const {
    UnilateralSpring with{.end_rule = EndRule::clamped};
    secant(std::max(x.deformation, 0.0), with.stiffness, with.damping);
    return with;
  }
};

}  // namespace talus
