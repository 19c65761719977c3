#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <string_view>

#include "solver/base/fields.hpp"
#include "solver/laws/kinematics.hpp"
#include "solver/state/state.hpp"

namespace talus {

/// Normal contact by a latching spring, soft on first loading and stiff on unloading and reloading (Walton & Braun
/// 1986). d is the overlap, m the largest overlap since the touch, which is the law's memory, and
/// K2 = unloading_stiffness + growth K1 m:
///
///   open       F = 0                          until d >= 0; forgets m
///   loading    F = K1 d,          m = d       while the bodies close
///   unloading  F = K1 m - K2 (m - d)          until d passes m again, or F falls to 0
///   slack      F = 0, m unchanged             until d grows back to where F fell to 0, or the bodies part
///
/// The restitution is sqrt(K1/K2): independent of the speed with growth 0, else smaller at higher speeds.
struct LatchingSpring {
  static constexpr std::string_view name = "latching_spring";
  static constexpr std::array<std::string_view, 4> modes{"open", "loading", "unloading", "slack"};
  static constexpr std::size_t memory_size = 1;
  static constexpr Mechanism dissipation = Mechanism::contact_damping;
  static constexpr Mechanism release = Mechanism::contact_release;
  enum : Mode { open, loading, unloading, slack };
  static constexpr RestitutionField restitution_field{"unloading_stiffness", "e = sqrt(K1/K2)"};

  double stiffness{};            ///< K1 [F/L] > 0
  double unloading_stiffness{};  ///< K2 in the limit of small overlaps [F/L] >= K1
  double growth{};               ///< increase of K2 per unit of the largest force [1/L] >= 0

  static constexpr std::array<Field<LatchingSpring>, 3> fields() {
    return {{{"stiffness", dimension::stiffness, &LatchingSpring::stiffness, Range::positive,
              "stiffness K1 while the contact is pressed further than before"},
             {"unloading_stiffness", dimension::stiffness, &LatchingSpring::unloading_stiffness, Range::positive,
              "unloading stiffness K2, at least K1"},
             {"growth", dimension::number / dimension::length, &LatchingSpring::growth, Range::non_negative,
              "growth of K2 for each unit of the largest force"}}};
  }

  static constexpr std::array<FieldOrder<LatchingSpring>, 1> orders() {
    return {{{&LatchingSpring::unloading_stiffness, &LatchingSpring::stiffness,
              "a contact with K2 < K1 would create energy"}}};
  }

  static constexpr bool acts(Mode mode) { return mode == loading || mode == unloading; }
  constexpr LawForce operator()(Kinematics x, std::span<const double> memory, Mode mode) const {
    if (mode == unloading) return {unloading_force(x.deformation, memory[0]), 0.0};
    if (mode != loading) return {};
    // The elastic force is the derivative of the recoverable energy (K1 d)^2/(2 K2); the rest of K1 d is dissipated.
    const double force = stiffness * x.deformation, back = unloading_stiffness_at(x.deformation);
    const double lost = force - force * (stiffness / back) * (1.0 - 0.5 * growth * force / back);
    return {force - lost, lost};  // one of the two differences is exact, so that the parts add up to the force exactly
  }

  /// Kernel (contact_kernel.hpp): while the bodies overlap, one expression of the overlap and the largest overlap gives
  /// the force in loading, unloading and slack.
  static constexpr bool needs_rate() { return false; }
  template <class Number>
  [[gnu::always_inline]] constexpr void force(const Number& overlap, const Number&, Number& largest,
                                              Number& out) const {
    largest = overlap > largest ? overlap : largest;
    out = stiffness * largest - (unloading_stiffness + growth * stiffness * largest) * (largest - overlap);
    out = out > Number{} ? out : Number{};
  }

  /// Energy dissipated by first loading up to this overlap [F L]: the work done less the recoverable energy.
  constexpr double hysteresis_loss(double largest) const {
    return 0.5 * stiffness * largest * largest - energy(stiffness * largest, unloading_stiffness_at(largest));
  }

  constexpr double stored_energy(Kinematics x, std::span<const double> memory, Mode mode) const {
    if (mode == loading) return energy(stiffness * x.deformation, unloading_stiffness_at(x.deformation));
    if (mode == unloading) return energy(unloading_force(x.deformation, memory[0]), unloading_stiffness_at(memory[0]));
    return 0.0;
  }

  constexpr double guard(Kinematics x, std::span<const double> memory, Mode mode) const {
    if (mode == open) return -x.deformation;
    // By rounding, the overlap may be below the largest overlap while the bodies still close.
    if (mode == loading)
      return x.deformation > 0.0 && x.deformation >= memory[0] ? x.deformation_rate : x.deformation - memory[0];
    const double left = unloading_force(x.deformation, memory[0]) / unloading_stiffness;
    if (mode == slack) return std::min(x.deformation, -left);
    return std::min(memory[0] - x.deformation, left);
  }

  constexpr Reset reset(Kinematics x, std::span<double> memory, Mode mode) const {
    if (x.deformation < 0.0 || (x.deformation == 0.0 && x.deformation_rate < 0.0)) {
      memory[0] = 0.0;
      return {open, 0.0};
    }
    const bool further = x.deformation > memory[0] || (x.deformation == memory[0] && x.deformation_rate > 0.0);
    if (mode == open || further) {
      memory[0] = x.deformation;
      return {loading, 0.0};
    }
    return {unloading_force(x.deformation, memory[0]) > 0.0 ? unloading : slack, 0.0};
  }

  /// The largest overlap follows the overlap in loading.
  static constexpr bool memory_follows(Mode mode) { return mode == loading; }
  constexpr void track(Kinematics x, std::span<double> memory, Mode mode) const {
    if (mode == loading) memory[0] = std::max(memory[0], x.deformation);
  }

  /// The stiffest branch in the limit of small overlaps; with growth, K2 is larger after larger overlaps.
  constexpr Tangent tangent() const { return {unloading_stiffness, 0.0}; }
  constexpr Tangent linear_part(std::span<const double> memory, Mode mode) const {
    return {mode == loading ? stiffness : mode == unloading ? unloading_stiffness_at(memory[0]) : 0.0, 0.0};
  }

  /// A quarter period with K1 and one with K2 (Walton & Braun 1986).
  double contact_time(double effective_mass, double speed) const {
    const double loading_frequency = std::sqrt(stiffness / effective_mass);
    const double back = unloading_stiffness_at(largest_overlap(effective_mass, speed));
    return 0.5 * std::numbers::pi * (1.0 / loading_frequency + 1.0 / std::sqrt(back / effective_mass));
  }
  double restitution(double effective_mass, double speed) const {
    return std::sqrt(stiffness / unloading_stiffness_at(largest_overlap(effective_mass, speed)));
  }
  double largest_overlap(double effective_mass, double speed) const {
    return speed / std::sqrt(stiffness / effective_mass);
  }
  /// K2 in the limit of small overlaps; not below K1 where the growth alone gives a smaller restitution.
  void set_restitution(double e, double effective_mass, double speed) {
    const double grown = growth == 0.0 ? 0.0 : growth * stiffness * largest_overlap(effective_mass, speed);
    unloading_stiffness = std::max(stiffness / (e * e) - grown, stiffness);
  }
  bool restitution_varies() const { return growth > 0.0; }

  friend constexpr bool operator==(const LatchingSpring&, const LatchingSpring&) = default;

 private:
  /// K2 for this largest overlap [F/L].
  constexpr double unloading_stiffness_at(double largest) const {
    return unloading_stiffness + growth * stiffness * largest;
  }
  constexpr double unloading_force(double overlap, double largest) const {
    return stiffness * largest - unloading_stiffness_at(largest) * (largest - overlap);
  }
  static constexpr double energy(double force, double back) { return 0.5 * force * force / back; }
};

}  // namespace talus
