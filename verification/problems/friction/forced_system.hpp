#pragma once

#include <functional>

#include "solver/dynamics/rigid_body_system.hpp"
#include "solver/integrate/advance.hpp"
#include "verification/reference/smooth_motion.hpp"

namespace talus::verification::problems {

/// The solver's system with an acceleration from outside on its first three coordinates, a function of time.
///
/// The time is the place of a clock, a particle of the scene that goes at speed 1 and on which nothing acts: so each
/// method sees it at the very moment of its places, in every stage.
class ForcedSystem {
 public:
  using Forcing = std::function<reference::Triple(double t)>;

  /// `clock`: coordinate that is the time.
  ForcedSystem(const Dynamics& dynamics, std::size_t clock, Forcing forcing)
      : system_{dynamics, false}, clock_{clock}, forcing_{std::move(forcing)}, rates_{rest_state(dynamics.model())} {}

  void drift(State& state, double h) { system_.drift(state, h); }
  void kick(State& state, double h) {
    evaluate(state, rates_);
    kick_velocities(state, rates_, h);
  }
  void begin(State& state) { system_.begin(state); }
  void settle(State& state) { system_.settle(state); }
  void derivative(const State& state, Rates& out) {
    system_.derivative(state, out);
    add(state, out);
  }
  void evaluate(State& state, Rates& out) {
    system_.evaluate(state, out);
    add(state, out);
  }
  long evaluations() const { return system_.evaluations(); }

 private:
  void add(const State& state, Rates& out) const {
    const reference::Triple extra = forcing_(state.q[clock_]);
    for (std::size_t i = 0; i < extra.size(); ++i)
      out.v[i] += static_cast<double>(extra[i]);
  }

  RigidBodySystem system_;
  std::size_t clock_;
  Forcing forcing_;
  Rates rates_;
};

}  // namespace talus::verification::problems
