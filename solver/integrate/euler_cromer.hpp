#pragma once

#include <string_view>

#include "solver/integrate/concepts.hpp"
#include "solver/integrate/linear_limit.hpp"

namespace talus {

/// Semi-implicit (symplectic) Euler: v += h a(q, v), then q += h v (Cromer 1981). First order; the same map as the
/// leapfrog methods except for the time at which velocities are reported.
template <class StateType>
struct EulerCromerOf {
  using Scalar = typename StateType::Number;

  static constexpr std::string_view name = "euler_cromer";
  static constexpr int order = 1;
  static constexpr StepControl step_control = StepControl::fixed;
  static constexpr int evaluations = 1;
  static constexpr int additions = 1;
  static constexpr double free_fall_error = 1.0;  ///< coordinates move with the velocity at the end of each step
  static constexpr bool kick_and_drift = true;

  static double linear_limit(double damping_ratio) { return leapfrog_limit(damping_ratio); }

  template <Splittable<StateType> System>
  void start(System&, StateType&, Scalar) const {}

  template <Splittable<StateType> System>
  void step(System& system, StateType& state, Scalar h) const {
    system.kick(state, h);
    system.drift(state, h);
    state.t += h;
  }

  void serialize(Archive&, const StateType&) const {}
};

using EulerCromer = EulerCromerOf<State>;

}  // namespace talus
