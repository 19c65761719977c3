#pragma once

#include <concepts>
#include <string_view>

#include "solver/integrate/advance.hpp"
#include "solver/integrate/concepts.hpp"

namespace talus {

/// Taylor polynomial with the acceleration a = a(q, v) at the start of the step: q += h v + h^2/2 a, v += h a. Exact
/// for coordinates under constant acceleration; otherwise of first order, as explicit Euler. For comparison only:
/// without a dashpot its energy grows by the factor 1 + (omega h)^2/2 per step, however short the step; with damping
/// ratio xi the limit is omega h < 4 xi for xi < 1/2, and 1/xi beyond.
template <class StateType>
class TaylorOf {
 public:
  using Scalar = typename StateType::Number;
  using Rates = typename StateType::Rates;

  static constexpr std::string_view name = "taylor";
  static constexpr int order = 1;
  static constexpr StepControl step_control = StepControl::fixed;
  static constexpr int evaluations = 1;
  static constexpr int additions = 2;  ///< half kicks per velocity
  static constexpr double amplitude_growth_rate = 0.125;

  static double linear_limit(double damping_ratio) {
    return damping_ratio < 0.5 ? 4.0 * damping_ratio : 1.0 / damping_ratio;
  }

  template <Evaluable<StateType> System>
  void start(System& system, StateType& state, Scalar) {
    rates_ = Rates{state};
    system.update_modes(state);
  }

  /// Two half kicks around the drift, both with the same acceleration.
  template <Evaluable<StateType> System>
  void step(System& system, StateType& state, Scalar h) {
    system.evaluate(state, rates_);
    kick_velocities(state, rates_, h / 2);
    system.drift(state, h);
    kick_velocities(state, rates_, h / 2);
    state.t += h;
  }

  /// Restores only the size of the rates; nothing is carried from step to step.
  void serialize(Archive& archive, const StateType& like) requires std::same_as<Scalar, double> {
    if (archive.is_loading()) rates_ = Rates{like};
  }

 private:
  Rates rates_;
};

using Taylor = TaylorOf<State>;

}  // namespace talus
