#pragma once

#include <array>
#include <concepts>
#include <string_view>
#include <vector>

#include "solver/integrate/advance.hpp"
#include "solver/integrate/concepts.hpp"
#include "solver/integrate/linear_limit.hpp"

namespace talus {

/// Classical Runge-Kutta method of order 4 (Kutta 1901) with four force evaluations per step:
///
///     0  |
///    1/2 | 1/2
///    1/2 |  0   1/2
///     1  |  0    0    1
///    ----+-------------------
///        | 1/6  1/3  1/3  1/6
///
/// Stage s is the state at the start of the step, moved by node_s h with the rates of stage s - 1; the step uses all
/// four rates with their weights. Modes are updated at every stage, so that across a change of mode the order is 2 at
/// best.
template <class StateType>
class RungeKutta4Of {
 public:
  using Scalar = typename StateType::Number;
  using Rates = typename StateType::Rates;

  static constexpr std::string_view name = "rk4";
  static constexpr int order = 4;
  static constexpr StepControl step_control = StepControl::fixed;
  static constexpr int evaluations = 4;
  static constexpr int additions = 4;

  /// The omega h at which |R(z)| first exceeds 1 (2.828 at xi = 0).
  static double linear_limit(double damping_ratio) { return first_growth(fourth_order_growth, damping_ratio); }

  template <Evaluable<StateType> System>
  requires VectorState<StateType>
  void start(System& system, StateType& state, Scalar) {
    rates_.fill(Rates{state});
    system.update_modes(state);
  }

  template <Evaluable<StateType> System>
  requires VectorState<StateType>
  void step(System& system, StateType& state, Scalar h) {
    const Scalar one{1};
    const std::array<Scalar, 4> node{Scalar{0}, one / 2, one / 2, one};
    const std::array<Scalar, 4> weight{one / 6, one / 3, one / 3, one / 6};
    // velocity_[s] is dq/dt of stage s: the stage's v, stored because the next stage overwrites it.
    for (std::size_t s = 0; s < node.size(); ++s) {
      stage_ = state;
      if (s > 0) {
        for (std::size_t i = 0; i < state.q.size(); ++i)
          stage_.q[i] += node[s] * h * velocity_[s - 1][i];
        advance_rates(stage_, rates_[s - 1], node[s] * h);
      }
      velocity_[s] = stage_.v;
      system.evaluate(stage_, rates_[s]);
    }
    for (std::size_t s = 0; s < node.size(); ++s) {
      for (std::size_t i = 0; i < state.q.size(); ++i)
        state.q[i] += weight[s] * h * velocity_[s][i];
    }
    for (std::size_t s = 0; s < node.size(); ++s)
      advance_rates(state, rates_[s], weight[s] * h);
    state.t += h;
    system.update_modes(state);
  }

  /// Restores only the sizes of the stages; nothing is carried from step to step.
  void serialize(Archive& archive, const StateType& like) requires std::same_as<Scalar, double> {
    if (archive.is_loading()) rates_.fill(Rates{like});
  }

 private:
  StateType stage_;
  std::array<Rates, 4> rates_;
  std::array<std::vector<Scalar>, 4> velocity_;
};

using RungeKutta4 = RungeKutta4Of<State>;

}  // namespace talus
