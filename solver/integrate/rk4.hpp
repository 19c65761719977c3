#pragma once

#include <array>
#include <string_view>

#include "solver/integrate/advance.hpp"
#include "solver/integrate/concepts.hpp"

namespace talus {

/// The classical Runge-Kutta method of order 4 (Kutta 1901) with four force evaluations a step. Modes settle at every
/// stage, so that across a change of mode it is a method of order 2 at best.
class RungeKutta4 {
 public:
  static constexpr std::string_view name = "rk4";
  static constexpr int order = 4;

  template <Differentiable System>
  void start(System& system, State& state, double) {
    rates_.fill(Rates{state});
    system.settle(state);
  }

  template <Differentiable System>
  void step(System& system, State& state, double h) {
    constexpr std::array<double, 4> node{0.0, 0.5, 0.5, 1.0};
    constexpr std::array<double, 4> weight{1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0};
    // velocity_[s] is dq/dt of stage s: the stage's own v, kept because the next stage overwrites it.
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
    system.settle(state);
  }

  template <class System>
  const State& synchronized(System&, const State& state, double) const {
    return state;
  }

  /// Nothing but room for the stages.
  void remember(Memory& memory, const State& like) {
    if (memory.puts_back()) rates_.fill(Rates{like});
  }

 private:
  State stage_;
  std::array<Rates, 4> rates_;
  std::array<std::vector<double>, 4> velocity_;
};

}  // namespace talus
