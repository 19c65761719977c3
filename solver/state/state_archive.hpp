#pragma once

#include "solver/base/archive.hpp"
#include "solver/state/state.hpp"

namespace talus {

/// Serializes a state. A state to be restored must already have the sizes of its scene.
inline void serialize(Archive& archive, State& state) {
  archive.number("t", state.t);
  archive.numbers("q", state.q);
  archive.numbers("v", state.v);
  archive.numbers("z", state.z);
  archive.numbers("mode", state.mode);
  archive.numbers("work", state.work);
  archive.numbers("impulse", state.impulse);
}

/// Serializes rates of change; sizes as for a state.
inline void serialize(Archive& archive, Rates& rates) {
  archive.numbers("v", rates.v);
  archive.numbers("z", rates.z);
  archive.numbers("work", rates.work);
  archive.numbers("impulse", rates.impulse);
}

}  // namespace talus
