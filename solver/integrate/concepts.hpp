#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <vector>

#include "solver/base/archive.hpp"
#include "solver/base/named_member.hpp"
#include "solver/state/state.hpp"

namespace talus {

// Systems.

TALUS_NAMED_MEMBER(NamesDrifted, drifted);
template <class S, class StateType>
concept DriftedFits =
    !NamesDrifted<S> || requires(const S& system, const StateType& state, typename StateType::Number h) {
  { system.drifted(state, h) } -> std::same_as<StateType>;
};

/// A system whose motion can be advanced in two substeps, each exact for its part. Its states hold numbers of type
/// StateType::Number.
///   drift(state, h)  moves the coordinates, and the memory that follows the motion, with the present velocities; no
///                    force evaluation
///   kick(state, h)   updates the modes, evaluates the forces once, and advances velocities, work and impulse
/// Optional, for systems that store data beside the state, such as the memory of contacts:
///   drifted(state, h)  returns the drifted state and changes nothing else
template <class S, class StateType = State>
concept Splittable = DriftedFits<S, StateType> && requires(S& system, StateType& state, typename StateType::Number h) {
  system.drift(state, h);
  system.kick(state, h);
};

/// A system that evaluates its rates of change, and drifts as above.
///   update_modes(state)   updates the modes for the present coordinates and velocities
///   evaluate(state, out)  update_modes(), then the rates; one force evaluation
template <class S, class StateType = State>
concept Evaluable = requires(S& system, StateType& state, typename StateType::Rates& rates,
                             typename StateType::Number h) {
  system.drift(state, h);
  system.update_modes(state);
  system.evaluate(state, rates);
};

/// An Evaluable system that also evaluates the rates of a state without changing the state.
///   derivative(state, out)  rates in the state's present modes; one force evaluation; bit-identical when repeated
template <class S, class StateType = State>
concept Differentiable = Evaluable<S, StateType> &&
    requires(S& system, const StateType& fixed, typename StateType::Rates& rates) {
  system.derivative(fixed, rates);
};

// States.

/// A state with one vector of coordinates and one of velocities, such as that of rigid bodies.
template <class StateType>
concept VectorState = requires(StateType& state) {
  { state.q } -> std::same_as<std::vector<typename StateType::Number>&>;
  { state.v } -> std::same_as<std::vector<typename StateType::Number>&>;
};

// Integrators.

/// How the length of a method's steps is chosen.
enum class StepControl {
  fixed,               ///< each step has the given length
  fixed_or_tolerance,  ///< as `fixed`; with a tolerance > 0 the method chooses internal steps within it
  tolerance,           ///< internal steps chosen by a tolerance > 0
  closed_form,         ///< exact between events, for motion that is linear between events
};
/// True if steps of a given length are possible.
constexpr bool has_fixed_steps(StepControl control) {
  return control == StepControl::fixed || control == StepControl::fixed_or_tolerance;
}
/// True if a tolerance is possible.
constexpr bool takes_tolerance(StepControl control) {
  return control == StepControl::fixed_or_tolerance || control == StepControl::tolerance;
}

TALUS_NAMED_MEMBER(NamesSynchronize, synchronize);
TALUS_NAMED_MEMBER(NamesFailure, failure);
TALUS_NAMED_MEMBER(NamesEvents, events);
TALUS_NAMED_MEMBER(NamesLinearLimit, linear_limit);
TALUS_NAMED_MEMBER(NamesAmplitudeGrowth, amplitude_growth_rate);
TALUS_NAMED_MEMBER(NamesFreeFallError, free_fall_error);
TALUS_NAMED_MEMBER(NamesKickAndDrift, kick_and_drift);
TALUS_NAMED_MEMBER(NamesEndsWithEvaluation, ends_with_evaluation);

/// Constants that every method declares, checked for consistency; see IntegratorFor.
template <class I>
concept Described = requires {
  { I::name } -> std::same_as<const std::string_view&>;
  { I::order } -> std::same_as<const int&>;
  { I::step_control } -> std::same_as<const StepControl&>;
  { I::evaluations } -> std::same_as<const int&>;
  { I::additions } -> std::same_as<const int&>;
  requires(I::order > 0) == (I::step_control != StepControl::closed_form);
  requires(I::evaluations > 0) == has_fixed_steps(I::step_control);
  requires(I::additions > 0);
};

/// A method that accepts a tolerance has a member for it.
template <class I>
concept ToleranceFits = !takes_tolerance(I::step_control) || requires(I & integrator) {
  { integrator.tolerance } -> std::same_as<double&>;
};

// Signatures of the optional members, checked where they are present.
template <class I>
concept FailureFits = !NamesFailure<I> || requires(const I& integrator) {
  { integrator.failure() } -> std::same_as<const std::string&>;
};
template <class I>
concept EventsFit = !NamesEvents<I> || requires(const I& integrator) {
  { integrator.events() } -> std::same_as<long>;
};
template <class I>
concept LinearLimitFits = !NamesLinearLimit<I> || (has_fixed_steps(I::step_control) && requires(double damping_ratio) {
  { I::linear_limit(damping_ratio) } -> std::same_as<double>;
});
template <class I>
concept AmplitudeGrowthFits = !NamesAmplitudeGrowth<I> || requires {
  { I::amplitude_growth_rate } -> std::same_as<const double&>;
};
template <class I>
concept FreeFallErrorFits = !NamesFreeFallError<I> || requires {
  { I::free_fall_error } -> std::same_as<const double&>;
};
template <class I>
concept KickAndDriftFits = !NamesKickAndDrift<I> || requires {
  { I::kick_and_drift } -> std::same_as<const bool&>;
};
template <class I>
concept EndsWithEvaluationFits = !NamesEndsWithEvaluation<I> || requires {
  { I::ends_with_evaluation } -> std::same_as<const bool&>;
};
template <class I>
concept OptionalMembersFit = FailureFits<I> && EventsFit<I> && LinearLimitFits<I> && AmplitudeGrowthFits<I> &&
    FreeFallErrorFits<I> && KickAndDriftFits<I> && EndsWithEvaluationFits<I>;

/// A method whose states hold velocities and coordinates at different times.
template <class I, class S, class StateType>
concept Staggered = requires(const I& integrator, S& system, StateType& copy, typename StateType::Number h) {
  integrator.synchronize(system, copy, h);
};

/// An integration method. It accesses its system only through one of the concepts above, does not depend on bodies,
/// files or observers, and updates the modes before each force evaluation, as classical methods and that of 1993 do.
///
/// A fixed-step method is a template over its state type: `NameOf<StateType>`, and `Name` for `NameOf<State>`. It uses
/// `StateType::Number` (the type of h), `StateType::Rates` and `kick_velocities(state, rates, h)`, and, if it requires
/// a VectorState, its q and v. Only templates can step states with other numbers than double; those with one force
/// evaluation per step that do not require a VectorState also step discs (see DiscMethod). Other methods may be classes
/// for the State of rigid bodies alone.
///
/// Constants, all required:
///   name          std::string_view: its name in scenes
///   order         int: its order on smooth motion, the highest if it varies; 0 for a closed form, which has no error
///   step_control  StepControl
///   evaluations   int: force evaluations per step of given length, after start(); 0 if it has no such steps
///   additions     int: largest number of additions to any one number of the state in such a step, which sets the
///                 growth of rounding errors; for other methods, in the interval between two outputs
///
/// Members, all required:
///   I()                           default-constructible; a copy of a method continues as the original does
///   start(system, state, h)       called once before the first step of length h (a staggered method shifts the state)
///   step(system, state, h)        advances state by h, time included
///   serialize(archive, like)      serializes everything that the method carries from one step to the next. After it is
///                                 restored into a method of the same name, step() continues bit for bit, without
///                                 start(); `like`, a state of the same scene, gives the sizes
///   double tolerance              required only of methods that accept a tolerance; 0: steps have the given length
///
/// Optional; a member with another type or signature does not compile:
///   synchronize(system, copy, h) const
///                                 for staggered methods: brings all parts of a copy of the state to the same time,
///                                 copy.t (see synchronized())
///   const std::string& failure() const  why the method cannot continue, empty while it can; the run ends as diverged
///   long events() const           for methods that locate events: number of events since the start of the run
///   static double linear_limit(double damping_ratio)
///                                 for methods with steps of given length: largest stable omega h on the oscillator
///                                 q'' = -omega^2 q - 2 xi omega q', xi >= 0; 0 if every step grows. Without it, the
///                                 steps of scenes are not checked for linear instability
///   double amplitude_growth_rate  c: over each quarter of an undamped oscillation the amplitude grows by the factor
///                                 exp(c pi omega h) in the limit of small h; default 0
///   double free_fall_error        error in the coordinates of a synchronized state at time t under a constant
///                                 acceleration a, in units of a h t/2; default 0
///   bool kick_and_drift           true if each step is kick(state, h), then drift(state, h), and nothing else; default
///                                 false
///   bool ends_with_evaluation     true if the last force evaluation of a step is at its final coordinates; default
///                                 false
///
/// Nothing else in the solver depends on a method's name: see traits_of and integrator_list.hpp.
template <class I, class S, class StateType = State>
concept IntegratorFor = requires(I integrator, S& system, StateType& state, const StateType& fixed,
                                 typename StateType::Number h, Archive& archive) {
  requires Described<I> && ToleranceFits<I> && OptionalMembersFit<I> && std::semiregular<I>;
  requires !NamesSynchronize<I> || Staggered<I, S, StateType>;
  integrator.start(system, state, h);
  integrator.step(system, state, h);
  integrator.serialize(archive, fixed);
};

/// Brings all parts of a copy of the method's state to the same time, copy.t, for observers.
template <class I, class S, class StateType>
void synchronize(const I& integrator, S& system, StateType& copy, typename StateType::Number h) {
  if constexpr (Staggered<I, S, StateType>) integrator.synchronize(system, copy, h);
}

/// Returns the state of a method with all parts at the same time.
template <class I, class S, class StateType>
[[nodiscard]] StateType synchronized(const I& integrator, S& system, StateType state, typename StateType::Number h) {
  synchronize(integrator, system, state, h);
  return state;
}

/// A fixed-step method for another state type: `Rebound<I, StateType>::type` is `NameOf<StateType>` for I =
/// `NameOf<State>`. Other methods have no `type`.
template <class I, class StateType>
struct Rebound {};
template <template <class> class Method, class StateType>
struct Rebound<Method<State>, StateType> {
  using type = Method<StateType>;
};

/// Properties that a method declares, as values.
struct IntegratorTraits {
  std::string_view name;
  int order{};
  StepControl step_control{};
  int evaluations{};
  int additions{};
  double (*linear_limit)(double damping_ratio){};  ///< null: unknown
  double amplitude_growth_rate{};
  double free_fall_error{};
  bool is_staggered{};
  bool locates_events{};
  bool kick_and_drift{};
  bool ends_with_evaluation{};
};

/// Traits of a method; see IntegratorFor.
template <Described I>
requires OptionalMembersFit<I>
inline constexpr IntegratorTraits traits_of = [] {
  IntegratorTraits traits{.name = I::name,
                          .order = I::order,
                          .step_control = I::step_control,
                          .evaluations = I::evaluations,
                          .additions = I::additions,
                          .is_staggered = NamesSynchronize<I>,
                          .locates_events = NamesEvents<I>};
  if constexpr (NamesLinearLimit<I>) traits.linear_limit = &I::linear_limit;
  if constexpr (NamesAmplitudeGrowth<I>) traits.amplitude_growth_rate = I::amplitude_growth_rate;
  if constexpr (NamesFreeFallError<I>) traits.free_fall_error = I::free_fall_error;
  if constexpr (NamesKickAndDrift<I>) traits.kick_and_drift = I::kick_and_drift;
  if constexpr (NamesEndsWithEvaluation<I>) traits.ends_with_evaluation = I::ends_with_evaluation;
  return traits;
}();

}  // namespace talus
