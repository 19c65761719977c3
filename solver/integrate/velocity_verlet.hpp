#pragma once

#include <concepts>
#include <string_view>

#include "solver/integrate/advance.hpp"
#include "solver/integrate/concepts.hpp"
#include "solver/integrate/linear_limit.hpp"
#include "solver/state/state_archive.hpp"

namespace talus {

/// Velocity Verlet (Swope et al. 1982): half a kick, a drift, half a kick, with one force evaluation per step.
///
///   v' = v + h/2 a_n;   q += h v';   a_{n+1} = a(q, v');   v = v' + h/2 a_{n+1}
///
/// The method carries a_n, evaluated at the half-step velocity v': dashpots use that velocity.
template <class StateType>
class VelocityVerletOf {
 public:
  using Scalar = typename StateType::Number;
  using Rates = typename StateType::Rates;

  static constexpr std::string_view name = "velocity_verlet";
  static constexpr int order = 2;
  static constexpr StepControl step_control = StepControl::fixed;
  static constexpr int evaluations = 1;
  static constexpr int additions = 2;  ///< half kicks per velocity
  static constexpr bool ends_with_evaluation = true;

  static double linear_limit(double damping_ratio) { return leapfrog_limit(damping_ratio); }

  template <Evaluable<StateType> System>
  void start(System& system, StateType& state, Scalar) {
    rates_ = Rates{state};
    system.evaluate(state, rates_);
  }

  template <Evaluable<StateType> System>
  void step(System& system, StateType& state, Scalar h) {
    kick_velocities(state, rates_, h / 2);
    system.drift(state, h);
    system.evaluate(state, rates_);
    kick_velocities(state, rates_, h / 2);
    state.t += h;
  }

  void serialize(Archive& archive, const StateType& like) requires std::same_as<Scalar, double> {
    if (archive.is_loading()) rates_ = Rates{like};
    using talus::serialize;
    archive.scope("rates", [&] { serialize(archive, rates_); });
  }

 private:
  Rates rates_;
};

using VelocityVerlet = VelocityVerletOf<State>;

}  // namespace talus
