#pragma once

#include <cmath>
#include <concepts>
#include <string_view>

#include "solver/integrate/advance.hpp"
#include "solver/integrate/concepts.hpp"

namespace talus {

/// Explicit Euler: q += h v, v += h a(q, v), all of the step's start (Euler 1768). First order. Not for use but to
/// compare with: without a dashpot its energy grows by 1 + (omega h)^2 a step, however short the step; with one of the
/// damping ratio xi the limit is omega h < 2 xi (xi < 1), 2/(xi + sqrt(xi^2 - 1)) beyond.
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
  static constexpr double free_fall_error = -1.0;  ///< coordinates move with the velocity of each step's start

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

  /// Nothing but room for the rates.
  void serialize(Archive& archive, const StateType& like) requires std::same_as<Scalar, double> {
    if (archive.is_loading()) rates_ = Rates{like};
  }

 private:
  Rates rates_;
};

using Euler = EulerOf<State>;

}  // namespace talus
