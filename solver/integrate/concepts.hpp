#pragma once

#include <concepts>

#include "solver/base/memory.hpp"
#include "solver/state/state.hpp"

namespace talus {

/// A system whose motion can be advanced in two halves, each of them exact for its own part. Its states are numbers of
/// type StateType::Number.
///   drift(state, h)  moves the coordinates, and the memory that follows the motion, with the present velocities; no
///                    force is evaluated
///   kick(state, h)   brings the modes up to date, evaluates the forces once, advances velocities, work and impulse
///   drifted(state, h)  only of systems that keep something beside the state, such as what contacts remember: the state
///                      moved so, and all else left as it is
template <class S, class StateType = State>
concept Splittable = requires(S& system, StateType& state, typename StateType::Number h) {
  system.drift(state, h);
  system.kick(state, h);
};

/// A system that gives its rates of change, and drifts as above.
///   settle(state)         brings the modes up to date with coordinates and velocities
///   evaluate(state, out)  the same and the rates then, for one force evaluation
template <class S, class StateType = State>
concept Evaluable = requires(S& system, StateType& state, typename StateType::Rates& rates,
                             typename StateType::Number h) {
  system.drift(state, h);
  system.settle(state);
  system.evaluate(state, rates);
};

/// One that also gives them for a state that it leaves as it is.
///   derivative(state, out)  rates in the state's present modes; one force evaluation; the same bits each time
template <class S, class StateType = State>
concept Differentiable = Evaluable<S, StateType> &&
    requires(S& system, const StateType& fixed, typename StateType::Rates& rates) {
  system.derivative(fixed, rates);
};

/// A method of integration: it knows its system by one of the concepts above and nothing of bodies, files or observers.
/// Methods of a fixed step are templates on the states that they step, rigid bodies' or discs', in numbers of any kind
/// (`StateType::Number`, `StateType::Rates`, and a function kick_velocities(state, rates, h)).
/// Every method brings the modes up to date before each force evaluation: the classical way, and that of 1993.
///   name, order                     its name in scenes; its order on smooth motion
///   start(system, state, h)         once before the first step of length h (a staggered method shifts the state here)
///   step(system, state, h)          advances state by h, time included
///   synchronize(system, copy, h)    only of staggered methods: brings all parts of a copy of the state to the same
///   time,
///                                   state.t (see synchronized())
///   remember(memory, like)          names all that the method carries from one step to the next. After it is put back
///                                   into a method of the same name, step() goes on bit for bit, without start();
///                                   `like`, a state of the same scene, tells the sizes
///   failure()                       optional: why the method cannot go on, empty while it can; the run ends as
///   diverged
template <class I, class S>
concept IntegratorFor = requires(I integrator, S& system, State& state, const State& fixed, double h, Memory& memory) {
  { I::name } -> std::convertible_to<std::string_view>;
  { I::order } -> std::convertible_to<int>;
  integrator.start(system, state, h);
  integrator.step(system, state, h);
  integrator.remember(memory, fixed);
};

/// A method whose states hold velocities and coordinates at different times.
template <class I, class S, class StateType>
concept Staggered = requires(const I integrator, S& system, StateType& copy, typename StateType::Number h) {
  integrator.synchronize(system, copy, h);
};

/// Brings all parts of a copy of the method's state to the same time, copy.t: what observers see.
template <class I, class S, class StateType>
void synchronize(const I& integrator, S& system, StateType& copy, typename StateType::Number h) {
  if constexpr (Staggered<I, S, StateType>) integrator.synchronize(system, copy, h);
}

/// The state of a method with all parts at the same time.
template <class I, class S, class StateType>
[[nodiscard]] StateType synchronized(const I& integrator, S& system, StateType state, typename StateType::Number h) {
  synchronize(integrator, system, state, h);
  return state;
}

}  // namespace talus
