#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <string_view>
#include <utility>
#include <vector>

#include "solver/integrate/advance.hpp"
#include "solver/integrate/central_difference.hpp"
#include "solver/integrate/concepts.hpp"

namespace talus {

/// Central difference as the program FENCE of 1993 appears to have used it: forces are evaluated with the velocities of
/// the preceding step, so that dashpots lag by one and a half steps,
///
///   v(t+h)    = v(t)     + h a(q(t+h/2), v(t-h))
///   q(t+3h/2) = q(t+h/2) + h v(t+h)
///
/// (inferred: the report's Eqs. 23-24 leave open which velocity a dashpot uses, its program stored an "old element
/// velocity", and of the alternatives tried this one reproduces the printed states best). Not for new work: its damping
/// is too low, and its stability limit is lower than that of `central_difference`.
template <class StateType>
class LaggedCentralDifferenceOf {
 public:
  using Scalar = typename StateType::Number;
  using Rates = typename StateType::Rates;

  static constexpr std::string_view name = "lagged_central_difference";
  static constexpr int order = 2;
  static constexpr StepControl step_control = StepControl::fixed;
  static constexpr int evaluations = 1;
  static constexpr int additions = 1;

  /// With a dashpot, however weak, half the limit of the central difference; without one nothing lags.
  static double linear_limit(double damping_ratio) {
    const double xi = damping_ratio;
    return xi > 0.0 ? std::sqrt(1.0 + xi * xi) - xi : 2.0;
  }

  template <Evaluable<StateType> System>
  requires VectorState<StateType>
  void start(System& system, StateType& state, Scalar h) {
    old_velocity_ = state.v;
    rates_ = Rates{state};
    system.drift(state, h / 2);
  }

  template <Evaluable<StateType> System>
  requires VectorState<StateType>
  void step(System& system, StateType& state, Scalar h) {
    // After the swap the state has the velocities of the preceding step; `old_velocity_` then holds those of this
    // step.
    std::swap(state.v, old_velocity_);
    system.evaluate(state, rates_);
    advance(state.v, old_velocity_, h, rates_.v, std::min(rates_.moving, state.v.size()));
    accumulate_work(state, rates_, h);
    system.drift(state, h);
    state.t += h;
  }

  /// Same as for the central difference.
  template <class System>
  void synchronize(System& system, StateType& copy, Scalar h) const {
    CentralDifferenceOf<StateType>{}.synchronize(system, copy, h);
  }

  void serialize(Archive& archive, const StateType& like) requires std::same_as<Scalar, double> {
    if (archive.is_loading()) rates_ = Rates{like}, old_velocity_ = like.v;
    archive.numbers("old_velocity", old_velocity_);
  }

 private:
  std::vector<Scalar> old_velocity_;
  Rates rates_;
};

using LaggedCentralDifference = LaggedCentralDifferenceOf<State>;

}  // namespace talus
