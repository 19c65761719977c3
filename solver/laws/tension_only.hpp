#pragma once

#include <array>
#include <span>
#include <string_view>

#include "solver/laws/unilateral_spring.hpp"
#include "solver/state/state.hpp"

namespace talus {

/// Tension-only cable: T = k (l - l0) + c dl/dt while this is positive, else 0
/// (Mustoe & Huttelmaier 1993, Eq. 14, there without the dashpot).
struct TensionOnly {
  static constexpr std::string_view name = "tension_only";
  static constexpr std::array<std::string_view, 3> modes{"slack", "taut", "released"};
  static constexpr std::size_t memory_size = 0;
  static constexpr Mechanism dissipation = Mechanism::cable_damping;
  static constexpr Mechanism release = Mechanism::cable_release;

  double stiffness{};  ///< k [F/L] > 0
  double damping{};    ///< c [F T/L] >= 0

  static constexpr std::array<Field<TensionOnly>, 2> fields() {
    return {{{"stiffness", dimension::stiffness, &TensionOnly::stiffness, Range::positive,
              "axial stiffness k: tension for each unit of elongation"},
             {"damping", dimension::damping, &TensionOnly::damping, Range::non_negative,
              "dashpot coefficient c: tension for each unit of lengthening speed"}}};
  }

  static constexpr bool acts(Mode mode) { return UnilateralSpring::acts(mode); }
  constexpr LawForce operator()(Kinematics x, std::span<const double>, Mode mode) const { return spring()(x, mode); }
  constexpr double stored_energy(Kinematics x, std::span<const double>, Mode mode) const {
    return spring().stored_energy(x, mode);
  }
  constexpr double guard(Kinematics x, std::span<const double>, Mode mode) const { return spring().guard(x, mode); }
  constexpr Reset reset(Kinematics x, std::span<double>, Mode mode) const { return spring().reset(x, mode); }
  constexpr Tangent tangent() const { return {stiffness, damping}; }
  constexpr LinearBranch linear_branch(std::span<const double>, Mode mode) const {
    return spring().linear_branch(mode);
  }

  friend constexpr bool operator==(const TensionOnly&, const TensionOnly&) = default;

 private:
  constexpr UnilateralSpring spring() const { return {stiffness, damping, EndRule::clamped}; }
};

}  // namespace talus
