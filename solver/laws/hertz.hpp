#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string_view>

#include "solver/laws/unilateral_spring.hpp"
#include "solver/state/state.hpp"

namespace talus {

/// Normal contact of two round bodies by Hertz (1882), with a dashpot that takes the same share of every impact
/// (Tsuji et al. 1992; Antypov & Elliott 2011):
///
///   F = 4/3 E sqrt(R) d^(3/2) + c (d/R)^(1/4) dd/dt,    d the overlap
///
/// In a plane scene the radius is a parameter of the law: the discs stand for balls. With sqrt(2/5 F_elastic d) for the
/// overlap the impact is that of a linear spring and dashpot of the damping ratio xi = c/sqrt(20/3 E R m) at any speed:
/// e and the end rules are the same. The dashpot's force starts from zero.
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
  /// At an overlap of a tenth of the radius, beyond which Hertz's theory does not hold.
  Tangent tangent() const {
    const UnilateralSpring there = spring({0.1 * radius, 0.0});
    return {1.5 * there.stiffness, there.damping};
  }

  friend constexpr bool operator==(const Hertz&, const Hertz&) = default;

 private:
  /// Energy 2/5 F d of the law over that of a linear spring to the same point, 1/2 F d.
  static constexpr double of_secant = 0.8;

  /// The linear spring and dashpot that push alike at this overlap.
  UnilateralSpring spring(Kinematics x) const {
    const double root = std::sqrt(std::max(x.deformation, 0.0) / radius);
    return {4.0 / 3.0 * modulus * radius * root, damping * std::sqrt(root), end_rule};
  }
};

}  // namespace talus
