#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/dynamics/springs.hpp"

namespace talus {

/// One spring of a scene in the terms of step limits.
struct SpringAdvice {
  std::string name;  ///< of the contact (with the instance's number where it has several) or cable
  bool contact{};    ///< contact or cable
  Spring spring;
  double frequency{};      ///< sqrt(k/m_eff) [rad/T]
  double damping_ratio{};  ///< c/(2 sqrt(k m_eff))
  double contact_time{};   ///< of an impact by this spring alone [T]; for a cable half its period
};

/// What the stiffness of a scene implies for its step, with every contact closed and every cable taut at the given
/// state.
struct StepAdvice {
  std::vector<SpringAdvice> springs;
  double highest_frequency{};  ///< largest natural frequency of the whole [rad/T]; 0 without springs
  double damping_ratio{};      ///< of that mode
  double shortest_contact{};   ///< shortest contact time [T]; infinite without contacts
};
[[nodiscard]] StepAdvice advise_step(const Dynamics& dynamics, const State& state);

/// Largest stable h omega of a method on a damped oscillator of damping ratio xi, dashpot velocities taken as the
/// method takes them: 2 (sqrt(1 + xi^2) - xi) for the leapfrog methods, the boundary of |R(z)| = 1 for rk4 (2.828 at xi
/// = 0). Empty for odeint's steppers. It is a limit of growth, not of accuracy, and one-sided contacts gain energy well
/// below it.
[[nodiscard]] std::optional<double> linear_limit(std::string_view integrator, double damping_ratio);

}  // namespace talus
