#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string_view>

#include "solver/base/pack.hpp"
#include "solver/laws/hertz_impact.hpp"
#include "solver/laws/unilateral_spring.hpp"
#include "solver/state/state.hpp"

namespace talus {

/// Hertz (1882) normal contact of two spheres, with one of two dashpots:
///
///   F = 4/3 E sqrt(R) d^(3/2) + c (d/R)^(1/4) dd/dt    tsuji      (Tsuji et al. 1992)
///   F = 4/3 E sqrt(R) d^(3/2) + c dd/dt                constant
///
/// with the overlap d. In a plane scene discs represent spheres, and the radius is a parameter of the law.
///
/// With Tsuji's dashpot and sqrt(2/5 F_elastic d) as variable instead of the overlap, an impact at any speed is that of
/// a linear spring and dashpot of damping ratio xi = c/sqrt(20/3 E R m): e and the end rules are the same (Antypov &
/// Elliott 2011). The dashpot's force starts from zero. With the constant dashpot e depends on the speed.
///
/// The dashpot coefficient is either constant (`damping`), or follows from `damping_ratio` and the effective mass at
/// the moment of touch (HertzImpact): every impact then has the same restitution, with the constant dashpot every
/// impact at the speed `restitution_speed`; c is then the law's memory.
struct Hertz {
  static constexpr std::string_view name = "hertz";
  static constexpr std::array<std::string_view, 3> modes{"open", "touching", "released"};
  static constexpr std::size_t memory_size = 0;  ///< without a damping ratio; see memory_count()
  static constexpr Mechanism dissipation = Mechanism::contact_damping;
  static constexpr Mechanism release = Mechanism::contact_release;
  static constexpr RestitutionField restitution_field{"damping", "of two spheres, by the dashpot", false};

  double modulus{};  ///< E [F/L^2] > 0: 1/E = (1 - nu_1^2)/E_1 + (1 - nu_2^2)/E_2
  double radius{};   ///< R [L] > 0: 1/R = 1/R_1 + 1/R_2
  double damping{};  ///< c [F T/L] >= 0: dashpot, at an overlap equal to R; not used if damping_ratio > 0
  EndRule end_rule{EndRule::clamped};
  HertzDashpot dashpot{HertzDashpot::tsuji};
  double damping_ratio{};      ///< xi >= 0 of every impact (HertzImpact); 0: c equals `damping`
  double restitution_speed{};  ///< speed of the impacts with that ratio [L/T] > 0; used with the constant dashpot

  static constexpr std::array<Field<Hertz>, 3> fields() {
    return {{{"modulus", dimension::pressure, &Hertz::modulus, Range::positive,
              "effective modulus, 1/E the sum of (1 - nu^2)/E of both bodies"},
             {"radius", dimension::length, &Hertz::radius, Range::positive,
              "effective radius, 1/R the sum of both bodies' curvatures"},
             {"damping", dimension::damping, &Hertz::damping, Range::non_negative,
              "dashpot coefficient; of the dashpot tsuji at an overlap equal to the radius"}}};
  }

  static constexpr bool acts(Mode mode) { return UnilateralSpring::acts(mode); }
  /// Number of doubles of memory: one, the dashpot coefficient of the contact, with a damping ratio, else none.
  constexpr std::size_t memory_count() const { return damping_ratio > 0.0 ? 1 : 0; }
  /// Sets the memory when a contact begins, from the effective mass [M] along its normal; only with a damping ratio.
  void start_contact(std::span<double> memory, double effective_mass) const {
    memory[0] = coefficient(damping_ratio, effective_mass, restitution_speed);
  }

  LawForce operator()(Kinematics x, std::span<const double> memory, Mode mode) const {
    return spring(x, memory)(x, mode);
  }
  double stored_energy(Kinematics x, std::span<const double> memory, Mode mode) const {
    return secant_energy_ratio() * spring(x, memory).stored_energy(x, mode);
  }
  double guard(Kinematics x, std::span<const double> memory, Mode mode) const {
    return spring(x, memory).guard(x, mode);
  }
  Reset reset(Kinematics x, std::span<double> memory, Mode mode) const {
    const Reset next = spring(x, memory).reset(x, mode);
    return {next.mode, secant_energy_ratio() * next.released};
  }
  constexpr bool is_clamped() const { return end_rule == EndRule::clamped; }
  /// The linear spring and dashpot with the same force at this overlap >= 0, for a number or a pack of numbers.
  template <class Number>
  [[gnu::always_inline]] void secant(const Number& overlap, Number& k, Number& c) const {
    secant_with(damping, overlap, k, c);
  }
  /// Ratio of the law's energy, 2/5 F d, to that of the secant linear spring, 1/2 F d.
  static constexpr double secant_energy_ratio() { return 0.8; }
  /// Tangent at an overlap of 0.1 R, beyond which Hertz's theory is not valid.
  Tangent tangent() const { return tangent_with(damping); }
  Tangent tangent(double effective_mass) const { return tangent_with(coefficient_at(effective_mass)); }

  double contact_time(double effective_mass, double speed) const {
    return impact(effective_mass, speed).contact_time * impact_length(effective_mass, speed) / speed;
  }
  double restitution(double effective_mass, double speed) const { return impact(effective_mass, speed).restitution; }
  double largest_overlap(double effective_mass, double speed) const {
    return impact(effective_mass, speed).largest_overlap * impact_length(effective_mass, speed);
  }
  void set_restitution(double e, double effective_mass, double speed) {
    damping = coefficient(hertz_damping_ratio(e, dashpot, end_rule), effective_mass, speed);
    damping_ratio = 0.0;
  }
  void set_every_restitution(double e, double speed) {
    damping_ratio = hertz_damping_ratio(e, dashpot, end_rule);
    restitution_speed = speed;
  }
  bool restitution_varies() const { return dashpot == HertzDashpot::constant; }

  friend constexpr bool operator==(const Hertz&, const Hertz&) = default;

 private:
  /// L of HertzImpact [L].
  double impact_length(double effective_mass, double speed) const {
    return std::pow(effective_mass * speed * speed / (4.0 / 3.0 * modulus * std::sqrt(radius)), 0.4);
  }
  /// Dashpot coefficient of the impact with this damping ratio [F T/L]; with Tsuji's dashpot it is the same at every
  /// speed.
  double coefficient(double xi, double effective_mass, double speed) const {
    if (dashpot == HertzDashpot::tsuji) return xi * std::sqrt(20.0 / 3.0 * modulus * radius * effective_mass);
    return xi * std::sqrt(5.0) * effective_mass * speed / impact_length(effective_mass, speed);
  }
  HertzImpact impact(double effective_mass, double speed) const {
    const double c = coefficient_at(effective_mass);
    return c == 0.0 ? hertz_impact(0.0, dashpot, end_rule)
                    : hertz_impact(c / coefficient(1.0, effective_mass, speed), dashpot, end_rule);
  }
  /// The dashpot coefficient of a contact of this effective mass [F T/L].
  double coefficient_at(double effective_mass) const {
    return damping_ratio > 0.0 ? coefficient(damping_ratio, effective_mass, restitution_speed) : damping;
  }
  Tangent tangent_with(double c) const {
    const UnilateralSpring there = spring({0.1 * radius, 0.0}, std::span{&c, 1});
    return {1.5 * there.stiffness, there.damping};
  }

  /// The secant of a contact with this dashpot coefficient.
  template <class Number>
  [[gnu::always_inline]] void secant_with(double coefficient, const Number& overlap, Number& k, Number& c) const {
    Number root = overlap / radius;
    square_root(root);
    k = 4.0 / 3.0 * modulus * radius * root;
    c = Number{} + 1.0;
    if (dashpot == HertzDashpot::tsuji) {
      c = root;
      square_root(c);
    }
    c *= coefficient;
  }
  UnilateralSpring spring(Kinematics x, std::span<const double> memory) const {
    UnilateralSpring with{.end_rule = end_rule};
    secant_with(memory.empty() ? damping : memory[0], std::max(x.deformation, 0.0), with.stiffness, with.damping);
    return with;
  }
};

}  // namespace talus
