#pragma once

#include <algorithm>
#include <cstddef>
#include <type_traits>

#include "solver/state/state.hpp"

namespace talus {

/// Moves the first `moving` coordinates with the velocities of the same state: q += h v.
template <class Scalar>
void drift_coordinates(StateOf<Scalar>& state, std::type_identity_t<Scalar> h, std::size_t moving) {
  for (std::size_t i = 0; i < moving; ++i)
    state.q[i] += h * state.v[i];
}

/// The same with all of them.
template <class Scalar>
void drift_coordinates(StateOf<Scalar>& state, std::type_identity_t<Scalar> h) {
  drift_coordinates(state, h, state.q.size());
}

/// Advances work and impulse by h times their rates.
template <class Scalar>
void book_rates(StateOf<Scalar>& state, const RatesOf<Scalar>& rates, std::type_identity_t<Scalar> h) {
  for (std::size_t i = 0; i < state.work.size(); ++i)
    state.work[i] += h * rates.work[i];
  for (std::size_t i = 0; i < state.impulse.size(); ++i)
    state.impulse[i] += h * rates.impulse[i];
}

/// Advances velocities, work and impulse by h times their rates.
template <class Scalar>
void kick_velocities(StateOf<Scalar>& state, const RatesOf<Scalar>& rates, std::type_identity_t<Scalar> h) {
  for (std::size_t i = 0, moving = std::min(rates.moving, state.v.size()); i < moving; ++i)
    state.v[i] += h * rates.v[i];
  book_rates(state, rates, h);
}

/// The same with the memory: all that has a rate of its own.
template <class Scalar>
void advance_rates(StateOf<Scalar>& state, const RatesOf<Scalar>& rates, std::type_identity_t<Scalar> h) {
  kick_velocities(state, rates, h);
  for (std::size_t i = 0; i < state.z.size(); ++i)
    state.z[i] += h * rates.z[i];
}

}  // namespace talus
