#pragma once

#include <string_view>

#include "solver/integrate/concepts.hpp"

namespace talus {

/// Semi-implicit (symplectic) Euler: v += h a(q, v), then q += h v (Cromer 1981). First order; the same map as the
/// leapfrog methods but for the time at which its velocities are read.
struct EulerCromer {
  static constexpr std::string_view name = "euler_cromer";
  static constexpr int order = 1;

  template <Splittable System>
  void start(System&, State&, double) const {}

  template <Splittable System>
  void step(System& system, State& state, double h) const {
    system.kick(state, h);
    system.drift(state, h);
    state.t += h;
  }

  template <class System>
  const State& synchronized(System&, const State& state, double) const {
    return state;
  }

  void remember(Memory&, const State&) const {}
};

}  // namespace talus
