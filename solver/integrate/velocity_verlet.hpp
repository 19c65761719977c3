#pragma once

#include <concepts>
#include <string_view>

#include "solver/integrate/advance.hpp"
#include "solver/integrate/concepts.hpp"
#include "solver/state/state_memory.hpp"

namespace talus {

/// Velocity Verlet (Swope et al. 1982): half a kick, a drift, half a kick, with one force evaluation a step.
///
///   v' = v + h/2 a_n;   q += h v';   a_{n+1} = a(q, v');   v = v' + h/2 a_{n+1}
///
/// Its memory is a_n, evaluated at the half-step velocity v': dashpots see that velocity.
template <class Scalar>
class VelocityVerletOf {
 public:
  static constexpr std::string_view name = "velocity_verlet";
  static constexpr int order = 2;

  template <Differentiable<Scalar> System>
  void start(System& system, StateOf<Scalar>& state, Scalar) {
    rates_ = RatesOf<Scalar>{state};
    system.evaluate(state, rates_);
  }

  template <Differentiable<Scalar> System>
  void step(System& system, StateOf<Scalar>& state, Scalar h) {
    kick_velocities(state, rates_, h / 2);
    system.drift(state, h);
    system.evaluate(state, rates_);
    kick_velocities(state, rates_, h / 2);
    state.t += h;
  }

  template <class System>
  const StateOf<Scalar>& synchronized(System&, const StateOf<Scalar>& state, Scalar) const {
    return state;
  }

  void remember(Memory& memory, const State& like) requires std::same_as<Scalar, double> {
    if (memory.puts_back()) rates_ = Rates{like};
    memory.part("rates", [&] { talus::remember(memory, rates_); });
  }

 private:
  RatesOf<Scalar> rates_;
};

using VelocityVerlet = VelocityVerletOf<double>;

}  // namespace talus
