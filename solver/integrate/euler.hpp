#pragma once

#include <cmath>
#include <concepts>
#include <string_view>

#include "solver/integrate/advance.hpp"
#include "solver/integrate/concepts.hpp"

namespace talus {

/// Explicit Euler: q += h v, v += h a(q, v), both with the values at the start of the step (Euler 1768). First order.
/// For comparison only: without a dashpot its energy grows by the factor 1 + (omega h)^2 per step, however short the
/// step; with damping ratio xi the limit is omega h < 2 xi for xi < 1, and 2/(xi + sqrt(xi^2 - 1)) beyond.
template <class StateType>
class EulerOf {
 public:
  using Scalar = typename StateType::Number;
  using Rates = typename StateType::Rates;

  static constexpr std::string_view name = "euler";
  static constexpr int order = 1;
  static constexpr StepControl step_control = StepControl::fixed;
  static constexpr int evaluations = 1;
  static constexpr int additions = 1;
  static constexpr double amplitude_growth_rate = 0.25;
  static constexpr double free_fall_error = -1.0;  ///< coordinates move with the velocity at the start of each step

  static double linear_limit(double damping_ratio) {
    const double xi = damping_ratio;
    return xi < 1.0 ? 2.0 * xi : 2.0 / (xi + std::sqrt(xi * xi - 1.0));
  }

  template <Evaluable<StateType> System>
  void start(System& system, StateType& state, Scalar) {
    rates_ = Rates{state};
    system.update_modes(state);
  }

  template <Evaluable<StateType> System>
  void step(System& system, StateType& state, Scalar h) {
    system.evaluate(state, rates_);
    system.drift(state, h);
    kick_velocities(state, rates_, h);
    state.t += h;
  }

  /// Restores only the size of the rates; nothing is carried from step to step.
  void serialize(Archive& archive, const StateType& like) requires std::same_as<Scalar, double> {
    if (archive.is_loading()) rates_ = Rates{like};
  }

 private:
  Rates rates_;
};

using Euler = EulerOf<State>;

}  // namespace talus
