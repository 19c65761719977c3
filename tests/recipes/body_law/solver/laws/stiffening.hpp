#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <string_view>

#include "solver/base/fields.hpp"
#include "solver/laws/kinematics.hpp"
#include "solver/state/state.hpp"

namespace talus {

/// Elastic cable with bilinear tension, such as a wire rope whose strands bed in before the steel carries the load. e
/// is the elongation, e_b that at which the strands have bedded in:
///
///   slack      T = 0                          until e > 0
///   taut       T = k e                        until e < 0, or e > e_b
///   bedded_in  T = k e_b + k_w (e - e_b)      until e < e_b
struct Stiffening {
  static constexpr std::string_view name = "stiffening";
  static constexpr std::array<std::string_view, 3> modes{"slack", "taut", "bedded_in"};
  static constexpr std::size_t memory_size = 0;
  static constexpr Mechanism dissipation = Mechanism::cable_damping;
  static constexpr Mechanism release = Mechanism::cable_release;
  enum : Mode { slack, taut, bedded_in };

  double stiffness{};          ///< k [F/L] > 0
  double bedding{};            ///< e_b [L] > 0
  double working_stiffness{};  ///< k_w [F/L] > 0, not below k

  static constexpr std::array<Field<Stiffening>, 3> fields() {
    return {{{"stiffness", dimension::stiffness, &Stiffening::stiffness, Range::positive,
              "axial stiffness while the strands bed in"},
             {"bedding", dimension::length, &Stiffening::bedding, Range::positive,
              "elongation at which the strands have bedded in"},
             {"working_stiffness", dimension::stiffness, &Stiffening::working_stiffness, Range::positive,
              "axial stiffness beyond this elongation"}}};
  }
  static constexpr std::array<FieldOrder<Stiffening>, 1> orders() {
    return {{{&Stiffening::working_stiffness, &Stiffening::stiffness, "a rope that has bedded in is the stiffer one"}}};
  }

  static constexpr bool acts(Mode mode) { return mode != slack; }
  constexpr LawForce operator()(Kinematics x, std::span<const double>, Mode mode) const {
    if (mode == slack) return {};
    if (mode == taut) return {stiffness * x.deformation, 0.0};
    return {stiffness * bedding + working_stiffness * (x.deformation - bedding), 0.0};
  }
  constexpr double stored_energy(Kinematics x, std::span<const double>, Mode mode) const {
    if (mode == slack) return 0.0;
    if (mode == taut) return 0.5 * stiffness * x.deformation * x.deformation;
    const double beyond = x.deformation - bedding;
    return stiffness * bedding * (0.5 * bedding + beyond) + 0.5 * working_stiffness * beyond * beyond;
  }
  constexpr double guard(Kinematics x, std::span<const double>, Mode mode) const {
    if (mode == slack) return -x.deformation;
    if (mode == taut) return std::min(x.deformation, bedding - x.deformation);
    return x.deformation - bedding;
  }
  constexpr Reset reset(Kinematics x, std::span<double>, Mode) const {
    // At the end of a branch the sign of the rate decides which one follows.
    const auto below = [&](double end) {
      return x.deformation < end || (x.deformation == end && x.deformation_rate < 0.0);
    };
    if (below(0.0)) return {slack, 0.0};
    return {below(bedding) ? taut : bedded_in, 0.0};
  }
  constexpr Tangent tangent() const { return {working_stiffness, 0.0}; }
  constexpr LinearBranch linear_branch(std::span<const double>, Mode mode) const {
    if (mode == slack) return {.low = -std::numeric_limits<double>::infinity(), .high = 0.0};
    if (mode == taut) return {.stiffness = stiffness, .low = 0.0, .high = bedding};
    return {};  // the energy is not that of one spring
  }

  friend constexpr bool operator==(const Stiffening&, const Stiffening&) = default;
};

}  // namespace talus
