#pragma once

#include <string_view>

#include "solver/integrate/concepts.hpp"

namespace talus {

/// Semi-implicit (symplectic) Euler: v += h a(q, v), then q += h v (Cromer 1981). First order; the same map as the
/// leapfrog methods but for the time at which its velocities are read.
template <class Scalar>
struct EulerCromerOf {
  static constexpr std::string_view name = "euler_cromer";
  static constexpr int order = 1;

  template <Splittable<Scalar> System>
  void start(System&, StateOf<Scalar>&, Scalar) const {}

  template <Splittable<Scalar> System>
  void step(System& system, StateOf<Scalar>& state, Scalar h) const {
    system.kick(state, h);
    system.drift(state, h);
    state.t += h;
  }

  template <class System>
  const StateOf<Scalar>& synchronized(System&, const StateOf<Scalar>& state, Scalar) const {
    return state;
  }

  void remember(Memory&, const StateOf<Scalar>&) const {}
};

using EulerCromer = EulerCromerOf<double>;

}  // namespace talus
