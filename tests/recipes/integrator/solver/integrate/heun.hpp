#pragma once

#include <concepts>
#include <string_view>
#include <vector>

#include "solver/integrate/advance.hpp"
#include "solver/integrate/concepts.hpp"

namespace talus {

/// Explicit trapezoidal rule (Heun 1900): a step with the rates at its start, then the same step with the mean of the
/// rates at both ends. Second order, also with dashpots. Without damping its amplitudes grow by (omega h)^4/8 per step,
/// however short the step; it therefore declares no linear limit.
template <class StateType>
class HeunOf {
 public:
  using Scalar = typename StateType::Number;
  using Rates = typename StateType::Rates;

  static constexpr std::string_view name = "heun";
  static constexpr int order = 2;
  static constexpr StepControl step_control = StepControl::fixed;
  static constexpr int evaluations = 2;
  static constexpr int additions = 2;

  template <Evaluable<StateType> System>
  requires VectorState<StateType>
  void start(System& system, StateType& state, Scalar) {
    at_start_ = Rates{state}, at_end_ = Rates{state};
    system.update_modes(state);
  }

  template <Evaluable<StateType> System>
  requires VectorState<StateType>
  void step(System& system, StateType& state, Scalar h) {
    const Scalar half = h / 2;
    const std::vector<Scalar> before = state.v;
    system.evaluate(state, at_start_);
    end_ = state;
    for (std::size_t i = 0; i < state.q.size(); ++i)
      end_.q[i] += h * before[i];
    advance_rates(end_, at_start_, h);
    const std::vector<Scalar> after = end_.v;
    system.evaluate(end_, at_end_);
    for (std::size_t i = 0; i < state.q.size(); ++i) {
      state.q[i] += half * before[i];
      state.q[i] += half * after[i];
    }
    advance_rates(state, at_start_, half);
    advance_rates(state, at_end_, half);
    state.t += h;
    system.update_modes(state);
  }

  /// Restores only the sizes of the rates; nothing is carried from step to step.
  void serialize(Archive& archive, const StateType& like) requires std::same_as<Scalar, double> {
    if (archive.is_loading()) at_start_ = Rates{like}, at_end_ = Rates{like};
  }

 private:
  StateType end_;
  Rates at_start_, at_end_;
};

using Heun = HeunOf<State>;

}  // namespace talus
