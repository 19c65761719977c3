#pragma once

#include <concepts>
#include <string_view>

#include "solver/integrate/advance.hpp"
#include "solver/integrate/concepts.hpp"

namespace talus {

/// Explicit Euler: q += h v, v += h a(q, v), all of the step's start (Euler 1768). First order. Not for use but to
/// compare with: without a dashpot its energy grows by 1 + (omega h)^2 a step, however short the step; with one of the
/// damping ratio xi the limit is omega h < 2 xi (xi < 1), 2/(xi + sqrt(xi^2 - 1)) beyond.
template <class Scalar>
class EulerOf {
 public:
  static constexpr std::string_view name = "euler";
  static constexpr int order = 1;

  template <Differentiable<Scalar> System>
  void start(System& system, StateOf<Scalar>& state, Scalar) {
    rates_ = RatesOf<Scalar>{state};
    system.settle(state);
  }

  template <Differentiable<Scalar> System>
  void step(System& system, StateOf<Scalar>& state, Scalar h) {
    system.evaluate(state, rates_);
    system.drift(state, h);
    kick_velocities(state, rates_, h);
    state.t += h;
  }

  template <class System>
  const StateOf<Scalar>& synchronized(System&, const StateOf<Scalar>& state, Scalar) const {
    return state;
  }

  /// Nothing but room for the rates.
  void remember(Memory& memory, const State& like) requires std::same_as<Scalar, double> {
    if (memory.puts_back()) rates_ = Rates{like};
  }

 private:
  RatesOf<Scalar> rates_;
};

using Euler = EulerOf<double>;

}  // namespace talus
