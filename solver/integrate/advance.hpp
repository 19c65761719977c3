#pragma once

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

#include "solver/base/pack.hpp"
#include "solver/base/rows.hpp"
#include "solver/state/state.hpp"

namespace talus {

/// out = x + h rate for the first `count` numbers; out may be x.
template <class Scalar>
void advance(std::vector<Scalar>& out, const std::vector<Scalar>& x, std::type_identity_t<Scalar> h,
             const std::vector<Scalar>& rate, std::size_t count) {
  if constexpr (std::is_same_v<Scalar, double>) {
    if (count >= pack_size) return add_scaled(out.data(), x.data(), h, rate.data(), count);
  }
  for (std::size_t i = 0; i < count; ++i)
    out[i] = x[i] + h * rate[i];
}

/// Moves the first `moving` coordinates with the velocities of the same state: q += h v.
template <class Scalar>
void drift_coordinates(StateOf<Scalar>& state, std::type_identity_t<Scalar> h, std::size_t moving) {
  advance(state.q, state.q, h, state.v, moving);
}

/// Moves all coordinates with the velocities of the same state: q += h v.
template <class Scalar>
void drift_coordinates(StateOf<Scalar>& state, std::type_identity_t<Scalar> h) {
  drift_coordinates(state, h, state.q.size());
}

/// Advances work and impulse by h times their rates.
template <class Scalar>
void accumulate_work(StateOf<Scalar>& state, const RatesOf<Scalar>& rates, std::type_identity_t<Scalar> h) {
  if (!rates.accounts) return;
  for (std::size_t i = 0; i < state.work.size(); ++i)
    state.work[i] += h * rates.work[i];
  for (std::size_t i = 0; i < state.impulse.size(); ++i)
    state.impulse[i] += h * rates.impulse[i];
}

/// Advances velocities, work and impulse by h times their rates.
template <class Scalar>
void kick_velocities(StateOf<Scalar>& state, const RatesOf<Scalar>& rates, std::type_identity_t<Scalar> h) {
  advance(state.v, state.v, h, rates.v, std::min(rates.moving, state.v.size()));
  accumulate_work(state, rates, h);
}

/// Advances velocities, work, impulse and memory by h times their rates: all of the state but q and t.
template <class Scalar>
void advance_rates(StateOf<Scalar>& state, const RatesOf<Scalar>& rates, std::type_identity_t<Scalar> h) {
  kick_velocities(state, rates, h);
  for (std::size_t i = 0; i < state.z.size(); ++i)
    state.z[i] += h * rates.z[i];
}

}  // namespace talus
