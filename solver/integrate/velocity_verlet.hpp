#pragma once

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
class VelocityVerlet {
 public:
  static constexpr std::string_view name = "velocity_verlet";
  static constexpr int order = 2;

  template <Differentiable System>
  void start(System& system, State& state, double) {
    rates_ = Rates{state};
    system.evaluate(state, rates_);
  }

  template <Differentiable System>
  void step(System& system, State& state, double h) {
    kick_velocities(state, rates_, 0.5 * h);
    system.drift(state, h);
    system.evaluate(state, rates_);
    kick_velocities(state, rates_, 0.5 * h);
    state.t += h;
  }

  template <class System>
  const State& synchronized(System&, const State& state, double) const {
    return state;
  }

  void remember(Memory& memory, const State& like) {
    if (memory.puts_back()) rates_ = Rates{like};
    memory.part("rates", [&] { talus::remember(memory, rates_); });
  }

 private:
  Rates rates_;
};

}  // namespace talus
