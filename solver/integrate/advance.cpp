#include "solver/integrate/advance.hpp"

namespace talus {

void drift_coordinates(State& state, double h) {
  for (std::size_t i = 0; i < state.q.size(); ++i)
    state.q[i] += h * state.v[i];
}

void book_rates(State& state, const Rates& rates, double h) {
  for (std::size_t i = 0; i < state.work.size(); ++i)
    state.work[i] += h * rates.work[i];
  for (std::size_t i = 0; i < state.impulse.size(); ++i)
    state.impulse[i] += h * rates.impulse[i];
}

void kick_velocities(State& state, const Rates& rates, double h) {
  for (std::size_t i = 0; i < state.v.size(); ++i)
    state.v[i] += h * rates.v[i];
  book_rates(state, rates, h);
}

void advance_rates(State& state, const Rates& rates, double h) {
  kick_velocities(state, rates, h);
  for (std::size_t i = 0; i < state.z.size(); ++i)
    state.z[i] += h * rates.z[i];
}

}  // namespace talus
