#pragma once

#include "solver/base/memory.hpp"
#include "solver/state/state.hpp"

namespace talus {

/// Names the parts of a state. One that is put back has its sizes already: those of its scene.
inline void remember(Memory& memory, State& state) {
  memory.number("t", state.t);
  memory.numbers("q", state.q);
  memory.numbers("v", state.v);
  memory.numbers("z", state.z);
  memory.numbers("mode", state.mode);
  memory.numbers("work", state.work);
  memory.numbers("impulse", state.impulse);
}

/// Names the parts of rates of change; sizes as for a state.
inline void remember(Memory& memory, Rates& rates) {
  memory.numbers("v", rates.v);
  memory.numbers("z", rates.z);
  memory.numbers("work", rates.work);
  memory.numbers("impulse", rates.impulse);
}

}  // namespace talus
