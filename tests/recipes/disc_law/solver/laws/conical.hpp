#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string_view>

#include "solver/base/pack.hpp"
#include "solver/laws/restitution.hpp"
#include "solver/laws/unilateral_spring.hpp"
#include "solver/state/state.hpp"

namespace talus {

/// Normal contact by a quadratic spring, as of a cone on a plane (Sneddon 1965), with a dashpot in proportion to the
/// root of the overlap d. With s = d/d_r,
///
///   F = k d_r s^2 + c s^(1/2) dd/dt
///
/// In the variables dtau = s^(1/2) dt and dy = s^(1/2) dd an impact is that of a linear spring 3k/2 with the dashpot c
/// (Antypov & Elliott 2011, there for Hertz's law): its restitution does not depend on the speed, and follows from the
/// damping ratio xi = c/(2 sqrt(3/2 k m_eff)).
struct Conical {
  static constexpr std::string_view name = "conical";
  static constexpr std::array<std::string_view, 3> modes{"open", "touching", "released"};
  static constexpr std::size_t memory_size = 0;
  static constexpr Mechanism dissipation = Mechanism::contact_damping;
  static constexpr Mechanism release = Mechanism::contact_release;
  static constexpr RestitutionField restitution_field{"damping", "of two discs, by the dashpot"};

  double stiffness{};   ///< k [F/L] > 0: F/d at the overlap d_r
  double at_overlap{};  ///< d_r [L] > 0
  double damping{};     ///< c [F T/L] >= 0: dashpot at the overlap d_r
  EndRule end_rule{EndRule::clamped};

  static constexpr std::array<Field<Conical>, 3> fields() {
    return {{{"stiffness", dimension::stiffness, &Conical::stiffness, Range::positive,
              "force over overlap at the stated overlap"},
             {"at_overlap", dimension::length, &Conical::at_overlap, Range::positive,
              "overlap for which stiffness and damping are stated, e.g. the largest expected"},
             {"damping", dimension::damping, &Conical::damping, Range::non_negative,
              "dashpot coefficient at the stated overlap"}}};
  }

  static constexpr bool acts(Mode mode) { return UnilateralSpring::acts(mode); }
  LawForce operator()(Kinematics x, std::span<const double>, Mode mode) const { return spring(x)(x, mode); }
  double stored_energy(Kinematics x, std::span<const double>, Mode mode) const {
    return secant_energy_ratio() * spring(x).stored_energy(x, mode);
  }
  double guard(Kinematics x, std::span<const double>, Mode mode) const { return spring(x).guard(x, mode); }
  Reset reset(Kinematics x, std::span<double>, Mode mode) const {
    const Reset next = spring(x).reset(x, mode);
    return {next.mode, secant_energy_ratio() * next.released};
  }
  constexpr bool is_clamped() const { return end_rule == EndRule::clamped; }
  /// The linear spring and dashpot with the same force at this overlap >= 0, for a number or a pack of numbers.
  template <class Number>
  [[gnu::always_inline]] void secant(const Number& overlap, Number& k, Number& c) const {
    k = overlap / at_overlap;
    c = k;
    square_root(c);
    k *= stiffness;
    c *= damping;
  }
  /// Ratio of the law's energy, 1/3 F d, to that of the secant linear spring, 1/2 F d.
  static constexpr double secant_energy_ratio() { return 2.0 / 3.0; }
  /// Tangent at the stated overlap; larger overlaps are stiffer.
  constexpr Tangent tangent() const { return {2.0 * stiffness, damping}; }

  double contact_time(double effective_mass, double speed) const {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double end = talus::contact_time(linear(), end_rule, effective_mass);
    // The integral of dtau/s^(1/2). Its integrand grows as tau^(-1/3) at both ends: with tau = u^3 from either end it
    // is smooth. The midpoint rule is then accurate to 1e-5.
    if (end == infinity) return end;
    constexpr int parts = 500;
    const double half = std::cbrt(0.5 * end);
    double time = 0.0;
    for (int i = 0; i < parts; ++i) {
      const double u = half * (i + 0.5) / parts, tau = u * u * u;
      for (const double at : {tau, end - tau})
        time += 3.0 * u * u * (half / parts) / std::cbrt(1.5 * linear_overlap(at, effective_mass, speed) / at_overlap);
    }
    return time;
  }
  double restitution(double effective_mass, double /* speed */) const {
    return talus::restitution(damping_ratio_of(linear(), effective_mass), end_rule);
  }
  double largest_overlap(double effective_mass, double speed) const {
    const double root = std::cbrt(1.5 * talus::largest_overlap(linear(), effective_mass, speed) / at_overlap);
    return at_overlap * root * root;
  }
  void set_restitution(double e, double effective_mass, double /* speed */) {
    damping = talus::damping(talus::damping_ratio(e, end_rule), linear().stiffness, effective_mass);
  }

  friend constexpr bool operator==(const Conical&, const Conical&) = default;

 private:
  /// The spring and dashpot of the linear impact.
  constexpr Tangent linear() const { return {1.5 * stiffness, damping}; }
  /// y of the linear impact [L] at the time tau since touch [T].
  double linear_overlap(double tau, double effective_mass, double speed) const {
    const double decay = 0.5 * damping / effective_mass, square = 1.5 * stiffness / effective_mass - decay * decay;
    const double w = std::sqrt(std::abs(square)), e = std::exp(-decay * tau);
    if (w * tau < 1e-8) return speed * e * tau;
    if (square > 0.0) return speed * e * std::sin(w * tau) / w;
    return speed * (std::exp((w - decay) * tau) - std::exp(-(w + decay) * tau)) / (2.0 * w);
  }
  UnilateralSpring spring(Kinematics x) const {
    UnilateralSpring with{.end_rule = end_rule};
    secant(std::max(x.deformation, 0.0), with.stiffness, with.damping);
    return with;
  }
};

}  // namespace talus
