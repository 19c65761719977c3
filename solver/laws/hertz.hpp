#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string_view>

#include "solver/laws/unilateral_spring.hpp"
#include "solver/state/state.hpp"

namespace talus {

/// Hertz (1882) normal contact of two spheres, with a dashpot that gives a restitution independent of the impact speed
/// (Tsuji et al. 1992; Antypov & Elliott 2011):
///
///   F = 4/3 E sqrt(R) d^(3/2) + c (d/R)^(1/4) dd/dt,    d the overlap
///
/// In a plane scene discs represent spheres, and the radius is a parameter of the law. With sqrt(2/5 F_elastic d) as
/// variable instead of the overlap, an impact at any speed is that of a linear spring and dashpot of damping ratio
/// xi = c/sqrt(20/3 E R m): e and the end rules are the same. The dashpot's force starts from zero.
struct Hertz {
  static constexpr std::string_view name = "hertz";
  static constexpr std::array<std::string_view, 3> modes{"open", "touching", "released"};
  static constexpr std::size_t memory_size = 0;
  static constexpr Mechanism dissipation = Mechanism::contact_damping;
  static constexpr Mechanism release = Mechanism::contact_release;

  double modulus{};  ///< E [F/L^2] > 0: 1/E = (1 - nu_1^2)/E_1 + (1 - nu_2^2)/E_2
  double radius{};   ///< R [L] > 0: 1/R = 1/R_1 + 1/R_2
  double damping{};  ///< c [F T/L] >= 0: dashpot at an overlap equal to R
  EndRule end_rule{EndRule::clamped};

  static constexpr std::array<Field<Hertz>, 3> fields() {
    return {{{"modulus", dimension::pressure, &Hertz::modulus, Range::positive,
              "effective modulus, 1/E the sum of (1 - nu^2)/E of both bodies"},
             {"radius", dimension::length, &Hertz::radius, Range::positive,
              "effective radius, 1/R the sum of both bodies' curvatures"},
             {"damping", dimension::damping, &Hertz::damping, Range::non_negative,
              "dashpot coefficient at an overlap equal to the radius"}}};
  }

  static constexpr bool acts(Mode mode) { return UnilateralSpring::acts(mode); }
  LawForce operator()(Kinematics x, std::span<const double>, Mode mode) const { return spring(x)(x, mode); }
  double stored_energy(Kinematics x, std::span<const double>, Mode mode) const {
    return of_secant * spring(x).stored_energy(x, mode);
  }
  double guard(Kinematics x, std::span<const double>, Mode mode) const { return spring(x).guard(x, mode); }
  Reset reset(Kinematics x, std::span<double>, Mode mode) const {
    const Reset next = spring(x).reset(x, mode);
    return {next.mode, of_secant * next.released};
  }
  /// Tangent at an overlap of 0.1 R, beyond which Hertz's theory is not valid.
  Tangent tangent() const {
    const UnilateralSpring there = spring({0.1 * radius, 0.0});
    return {1.5 * there.stiffness, there.damping};
  }

  friend constexpr bool operator==(const Hertz&, const Hertz&) = default;

 private:
  /// Ratio of the law's energy, 2/5 F d, to that of the secant linear spring, 1/2 F d.
  static constexpr double of_secant = 0.8;

  /// The linear spring (secant) and dashpot with the same force at this overlap.
  UnilateralSpring spring(Kinematics x) const {
    const double root = std::sqrt(std::max(x.deformation, 0.0) / radius);
    return {4.0 / 3.0 * modulus * radius * root, damping * std::sqrt(root), end_rule};
  }
};

}  // namespace talus
