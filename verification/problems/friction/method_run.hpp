#pragma once

#include <variant>

#include "verification/study/toolkit.hpp"

namespace talus::verification::problems {

/// Runs any system that the integrators accept for `steps` equal steps from t = 0. Returns the synchronised state at
/// the end, with positions and velocities at the same time.
template <class System>
State run_method(System& system, Integrator integrator, State state, double step, long steps) {
  record_use(integrator);
  return std::visit(
      [&](auto& method) -> State {
        system.begin(state);
        method.start(system, state, step);
        for (long n = 0; n < steps; ++n)
          method.step(system, state, step);
        return synchronized(method, system, state, step);
      },
      integrator);
}

}  // namespace talus::verification::problems
