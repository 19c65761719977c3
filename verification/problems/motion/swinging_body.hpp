#pragma once

#include "solver/integrate/advance.hpp"
#include "solver/integrate/concepts.hpp"

namespace talus::verification::problems {

/// One body on a spring and a dashpot, x'' = -x - c x', in numbers of any type: the smallest system that the solver's
/// integrators take. Fault: accelerations that pass through a coarser type, `Force`.
template <class Scalar, class Force = Scalar>
class SwingingBody {
 public:
  explicit SwingingBody(const Scalar& damping) : damping_{damping} { rates_.v.resize(1); }

  void drift(StateOf<Scalar>& state, const Scalar& h) { drift_coordinates(state, h); }
  void kick(StateOf<Scalar>& state, const Scalar& h) {
    evaluate(state, rates_);
    kick_velocities(state, rates_, h);
  }
  void settle(StateOf<Scalar>&) {}
  void derivative(const StateOf<Scalar>& state, RatesOf<Scalar>& out) {
    ++evaluations_;
    const Scalar acceleration = -state.q[0] - damping_ * state.v[0];
    out.v[0] = static_cast<Scalar>(static_cast<Force>(acceleration));
  }
  void evaluate(StateOf<Scalar>& state, RatesOf<Scalar>& out) { derivative(state, out); }

  /// Force evaluations so far.
  long evaluations() const { return evaluations_; }

 private:
  Scalar damping_;
  RatesOf<Scalar> rates_;
  long evaluations_{0};
};

static_assert(Splittable<SwingingBody<float>, StateOf<float>> && Differentiable<SwingingBody<float>, StateOf<float>>);

}  // namespace talus::verification::problems
