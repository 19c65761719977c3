#pragma once

#include <array>
#include <span>
#include <string_view>

#include "solver/laws/unilateral_spring.hpp"
#include "solver/state/state.hpp"

namespace talus {

/// Normal contact by a linear spring and a dashpot in parallel: F = k depth + c d(depth)/dt
/// (Mustoe & Huttelmaier 1993, Eq. 17; Cundall & Strack 1979), with the end rule as a choice.
struct LinearSpringDashpot {
  static constexpr std::string_view name = "linear_spring_dashpot";
  static constexpr std::array<std::string_view, 3> modes{"open", "touching", "released"};
  static constexpr std::size_t memory_size = 0;
  static constexpr Mechanism dissipation = Mechanism::contact_damping;
  static constexpr Mechanism release = Mechanism::contact_release;

  double stiffness{};  ///< k_n [F/L] > 0
  double damping{};    ///< c [F T/L] >= 0
  EndRule end_rule{EndRule::clamped};

  static constexpr std::array<Field<LinearSpringDashpot>, 2> fields() {
    return {{{"stiffness", dimension::stiffness, &LinearSpringDashpot::stiffness, Range::positive,
              "normal stiffness k_n: force for each unit of overlap"},
             {"damping", dimension::damping, &LinearSpringDashpot::damping, Range::non_negative,
              "dashpot coefficient c: force for each unit of closing speed"}}};
  }

  constexpr LawForce operator()(Kinematics x, std::span<const double>, Mode mode) const { return spring()(x, mode); }
  constexpr double stored_energy(Kinematics x, std::span<const double>, Mode mode) const {
    return spring().stored_energy(x, mode);
  }
  constexpr double guard(Kinematics x, std::span<const double>, Mode mode) const { return spring().guard(x, mode); }
  constexpr Reset reset(Kinematics x, std::span<double>, Mode mode) const { return spring().reset(x, mode); }
  constexpr Tangent tangent() const { return {stiffness, damping}; }
  constexpr Tangent linear_part(std::span<const double>, Mode mode) const {
    return mode == UnilateralSpring::acting ? tangent() : Tangent{};
  }

  /// While the bodies overlap nothing is remembered (settled.hpp).
  constexpr bool needs_rate() const { return damping != 0.0; }
  template <class Number>
  [[gnu::always_inline]] constexpr void settled(const Number& overlap, const Number& rate, Number&,
                                                Number& force) const {
    force = stiffness * overlap + damping * rate;
    if (end_rule == EndRule::clamped) force = force > Number{} ? force : Number{};
  }

  template <class Number>
  [[gnu::always_inline]] constexpr void kept(const Number& overlap, const Number& rate, const Number& before,
                                             const Number& force, Number& power, Number& released) const {
    power = damping * rate * rate, released = Number{};
    if (end_rule == EndRule::attractive) return;
    const Number none{}, energy = 0.5 * stiffness * overlap * overlap;
    const Number let_go = before == none ? none : energy, taken_back = before == none ? -energy : none;
    power = force > none ? power : none;
    released = force > none ? taken_back : let_go;
  }

  friend constexpr bool operator==(const LinearSpringDashpot&, const LinearSpringDashpot&) = default;

 private:
  constexpr UnilateralSpring spring() const { return {stiffness, damping, end_rule}; }
};

}  // namespace talus
