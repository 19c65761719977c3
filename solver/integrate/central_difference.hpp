#pragma once

#include <string_view>

#include "solver/integrate/advance.hpp"
#include "solver/integrate/concepts.hpp"
#include "solver/integrate/linear_limit.hpp"

namespace talus {

/// Staggered central difference of FENCE 1993 (Mustoe & Huttelmaier, Eqs. 23-24), velocities first:
///
///   v(t+h)    = v(t)     + h a(q(t+h/2), v(t))
///   q(t+3h/2) = q(t+h/2) + h v(t+h)
///
/// Between steps the state contains v at t and q at t + h/2. Dashpots use the velocity before the kick (lagged), hence
/// the linear limit omega h < 2 (sqrt(1 + xi^2) - xi).
template <class StateType>
struct CentralDifferenceOf {
  using Scalar = typename StateType::Number;

  static constexpr std::string_view name = "central_difference";
  static constexpr int order = 2;
  static constexpr StepControl step_control = StepControl::fixed;
  static constexpr int evaluations = 1;
  static constexpr int additions = 1;
  static constexpr bool kick_and_drift = true;

  static double linear_limit(double damping_ratio) { return leapfrog_limit(damping_ratio); }

  template <Splittable<StateType> System>
  void start(System& system, StateType& state, Scalar h) const {
    system.drift(state, h / 2);
  }

  template <Splittable<StateType> System>
  void step(System& system, StateType& state, Scalar h) const {
    system.kick(state, h);
    system.drift(state, h);
    state.t += h;
  }

  /// Moves coordinates, and the memory that follows them, back by half a step with the present velocity: second order,
  /// and exact without forces.
  template <class System>
  void synchronize(System& system, StateType& copy, Scalar h) const {
    // drifted() does not change what a system stores beside its state.
    if constexpr (requires { system.drifted(copy, h); }) {
      copy = system.drifted(copy, -h / 2);
    } else {
      system.drift(copy, -h / 2);
    }
  }

  /// Nothing to serialize: the stagger is in the state.
  void serialize(Archive&, const StateType&) const {}
};

using CentralDifference = CentralDifferenceOf<State>;

}  // namespace talus
