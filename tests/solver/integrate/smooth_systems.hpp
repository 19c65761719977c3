#pragma once

#include <cmath>

#include "solver/integrate/advance.hpp"
#include "solver/integrate/linear_segment.hpp"
#include "solver/state/state.hpp"

/// Systems with one coordinate and smooth motion, for tests of methods.
namespace talus {

/// x'' = -x^3, a stiffening spring: smooth, nonlinear, with work that equals the change of v^2/2, so that their
/// difference must stay constant.
struct Duffing {
  long evaluations{0};

  void drift(State& state, double h) { drift_coordinates(state, h); }
  void kick(State& state, double h) {
    Rates rates{state};
    derivative(state, rates);
    kick_velocities(state, rates, h);
  }
  void update_modes(State&) {}
  void derivative(const State& state, Rates& out) {
    ++evaluations;
    out.v[0] = -state.q[0] * state.q[0] * state.q[0];
    out.work[0] = out.v[0] * state.v[0];
    out.impulse[0] = out.v[0];
  }
  void evaluate(State& state, Rates& out) { derivative(state, out); }
};

/// x'' = -4 x - 0.3 x', with the loss as work and the force as impulse: motion on one linear branch.
struct Oscillator : Duffing {
  void derivative(const State& state, Rates& out) {
    ++evaluations;
    out.v[0] = -4.0 * state.q[0] - 0.3 * state.v[0];
    out.work[0] = 0.3 * state.v[0] * state.v[0];
    out.impulse[0] = out.v[0];
  }
  void kick(State& state, double h) {
    Rates rates{state};
    derivative(state, rates);
    kick_velocities(state, rates, h);
  }
  void evaluate(State& state, Rates& out) { derivative(state, out); }
  void linear_segment(const State&, LinearSegment& out) const { out.terms = {{0, 0, 4.0, 0.3}}; }
  bool keeps_accounts() const { return true; }
};

inline State start() {
  State state;
  state.q = {1.0};
  state.v = {0.25};
  return state;
}

/// Error in phase space: the error of a single coordinate may pass through zero and show any slope.
inline double error(const State& state, const State& exact) {
  return std::hypot(state.q[0] - exact.q[0], state.v[0] - exact.v[0]);
}

/// x'' = -x - 2 xi x'.
struct Damped : Duffing {
  double xi{};

  explicit Damped(double damping_ratio) : xi{damping_ratio} {}
  void derivative(const State& state, Rates& out) {
    ++evaluations;
    out.v[0] = -state.q[0] - 2.0 * xi * state.v[0];
  }
  void kick(State& state, double h) {
    Rates rates{state};
    derivative(state, rates);
    kick_velocities(state, rates, h);
  }
  void evaluate(State& state, Rates& out) { derivative(state, out); }
};

}  // namespace talus
