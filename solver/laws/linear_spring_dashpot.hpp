#pragma once

#include <array>
#include <cmath>
#include <span>
#include <string_view>

#include "solver/laws/restitution.hpp"
#include "solver/laws/unilateral_spring.hpp"
#include "solver/state/state.hpp"

namespace talus {

/// Normal contact by a linear spring and a dashpot in parallel: F = k overlap + c d(overlap)/dt
/// (Mustoe & Huttelmaier 1993, Eq. 17; Cundall & Strack 1979), with a selectable end rule.
///
/// The dashpot coefficient is either constant (`damping`), or follows from `damping_ratio` and the effective mass m_eff
/// at the moment of touch: c = 2 xi sqrt(k m_eff). A damping ratio gives every impact the same restitution, independent
/// of the bodies, their pose and their pins; c is then the law's memory.
struct LinearSpringDashpot {
  static constexpr std::string_view name = "linear_spring_dashpot";
  static constexpr std::array<std::string_view, 3> modes{"open", "touching", "released"};
  static constexpr std::size_t memory_size = 0;  ///< without a damping ratio; see memory_count()
  static constexpr Mechanism dissipation = Mechanism::contact_damping;
  static constexpr Mechanism release = Mechanism::contact_release;
  static constexpr RestitutionField restitution_field{"damping", "of two discs, by the dashpot"};

  double stiffness{};  ///< k_n [F/L] > 0
  double damping{};    ///< c [F T/L] >= 0; not used if damping_ratio > 0
  EndRule end_rule{EndRule::clamped};
  double damping_ratio{};  ///< xi >= 0 of every impact; 0: c equals `damping`

  static constexpr std::array<Field<LinearSpringDashpot>, 2> fields() {
    return {{{"stiffness", dimension::stiffness, &LinearSpringDashpot::stiffness, Range::positive,
              "normal stiffness k_n: force for each unit of overlap"},
             {"damping", dimension::damping, &LinearSpringDashpot::damping, Range::non_negative,
              "dashpot coefficient c: force for each unit of closing speed"}}};
  }

  static constexpr bool acts(Mode mode) { return UnilateralSpring::acts(mode); }
  /// Number of doubles of memory: one, the dashpot coefficient of the contact, with a damping ratio, else none.
  constexpr std::size_t memory_count() const { return damping_ratio > 0.0 ? 1 : 0; }
  /// Sets the memory when a contact begins, from the effective mass [M] along its normal; only with a damping ratio.
  void start_contact(std::span<double> memory, double effective_mass) const {
    memory[0] = tangent(effective_mass).damping;
  }

  constexpr LawForce operator()(Kinematics x, std::span<const double> memory, Mode mode) const {
    return spring(memory)(x, mode);
  }
  constexpr double stored_energy(Kinematics x, std::span<const double> memory, Mode mode) const {
    return spring(memory).stored_energy(x, mode);
  }
  constexpr double guard(Kinematics x, std::span<const double> memory, Mode mode) const {
    return spring(memory).guard(x, mode);
  }
  constexpr Reset reset(Kinematics x, std::span<double> memory, Mode mode) const {
    return spring(memory).reset(x, mode);
  }
  constexpr Tangent tangent() const { return {stiffness, damping}; }
  /// Stiffness and damping of a contact of that effective mass [M].
  Tangent tangent(double effective_mass) const {
    if (damping_ratio == 0.0) return tangent();
    return {stiffness, 2.0 * damping_ratio * std::sqrt(stiffness * effective_mass)};
  }
  constexpr Tangent linear_part(std::span<const double> memory, Mode mode) const {
    return mode == UnilateralSpring::acting ? Tangent{stiffness, coefficient(memory)} : Tangent{};
  }
  /// Retardation time c/k of the spring and dashpot [T].
  constexpr double retardation_time(std::span<const double> memory) const { return coefficient(memory) / stiffness; }
  constexpr bool is_clamped() const { return end_rule == EndRule::clamped; }

  double contact_time(double effective_mass, double /* speed */) const {
    return talus::contact_time(tangent(effective_mass), end_rule, effective_mass);
  }
  double restitution(double effective_mass, double /* speed */) const {
    return talus::restitution(damping_ratio_of(tangent(effective_mass), effective_mass), end_rule);
  }
  double largest_overlap(double effective_mass, double speed) const {
    return talus::largest_overlap(tangent(effective_mass), effective_mass, speed);
  }
  void set_restitution(double e, double effective_mass, double /* speed */) {
    damping = talus::damping(talus::damping_ratio(e, end_rule), stiffness, effective_mass);
  }
  void set_every_restitution(double e, double /* speed */) { damping_ratio = talus::damping_ratio(e, end_rule); }

  friend constexpr bool operator==(const LinearSpringDashpot&, const LinearSpringDashpot&) = default;

 private:
  constexpr double coefficient(std::span<const double> memory) const { return memory.empty() ? damping : memory[0]; }
  constexpr UnilateralSpring spring(std::span<const double> memory) const {
    return {stiffness, coefficient(memory), end_rule};
  }
};

}  // namespace talus
