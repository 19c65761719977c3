#pragma once

#include <functional>

#include "verification/check/case.hpp"
#include "verification/reference/impacts/restitution.hpp"
#include "verification/study/impacts/followed_impact.hpp"

/// Impacts of the case `restitution`, one for each phase of touch within a step, and their errors.
namespace talus::verification::problems {

inline constexpr double production_steps = 100.0;  ///< per contact, where the step is not varied

/// Root-mean-square error of e at xi = 0, times (steps per contact)^2: pi^2/(2 sqrt(90)).
///
/// During contact, velocity Verlet conserves v^2/2 + (w d)^2/2 (1 - (w h)^2/4). If touch occurs a fraction u of a step
/// before the first sample inside, this is v0^2/2 [1 - (w h)^2 u (1 - u)]; the end, reversed in time, is the same with
/// a fraction u'. So e - 1 = (w h)^2/2 [u'(1 - u') - u (1 - u)]. With u and u' uniform and independent, the variance of
/// u (1 - u) is 1/180, and w h = pi/N.
inline constexpr double second_order_constant = 0.520;

/// Relative uncertainty of the predicted errors at 100 steps per contact: ratio of the next power of the step to the
/// first, w h = 0.018 ... 0.039 here.
inline constexpr double next_power = 0.04;
/// The same uncertainty where an attractive contact also ends with a force jump: over 64 phases of the end that are not
/// evenly spaced but random, the mean product of the phases of both jumps is an eighth of their variance, 6 % of the
/// root mean square.
inline constexpr double uneven_end = next_power + 0.06;

[[nodiscard]] const char* word_for(EndRule rule);  ///< "attractive" or "clamped"

/// A disc on a plane, k = m = v0 = 1, whose dashpot is chosen for restitution e.
struct Bounce {
  double e{};
  EndRule rule{};
  double xi{};                    ///< damping ratio for e from the closed form
  LinearSpringDashpot law;        ///< law given to the solver, possibly with a planted fault
  reference::ImpactEvents exact;  ///< of the correct contact
};

[[nodiscard]] Bounce bounce(double e, EndRule rule, const Setup& setup);

/// The disc at distance `gap` from the plane at t = 0. Integrator and plan are set by the caller.
[[nodiscard]] Scene disc_at(const Bounce& b, double gap);

/// Builds a scene of bodies that approach at speed 1 from the given gap.
using SceneAtGap = std::function<Scene(double gap)>;

/// Runs the scene so that touch occurs at the fraction `phase` of a step; times are measured from touch.
[[nodiscard]] FollowedImpact impact_at_phase(const SceneAtGap& scene_at, const Integrator& integrator,
                                             double contact_time, double step, double phase, Findings& findings);

/// Errors over 64 phases, each with a different step; relative except for `pull`.
struct ImpactErrors {
  PhaseError restitution, contact_time, largest_depth;
  PhaseError identity;            ///< ratio of e and the square of the largest overlap, both over the exact ones
  PhaseError pull;                ///< minimum deceleration minus the exact force at the end
  double mean_restitution{};      ///< mean of e itself
  double minimum_deceleration{};  ///< minimum over all phases; < 0: attractive force
};

/// `commensurate`: a fault, all phases use the step that divides the contact time.
[[nodiscard]] ImpactErrors impact_errors(const SceneAtGap& scene_at, const reference::ImpactEvents& exact, double steps,
                                         const Integrator& integrator, Findings& findings, bool commensurate = false);

/// w h for `steps` steps per contact (the offsets of the phases add half a step on average).
[[nodiscard]] double reduced_step(const reference::ImpactEvents& exact, double steps);

/// Predicted root-mean-square relative error of e for velocity Verlet.
[[nodiscard]] double predicted_restitution_error(const Bounce& b, double steps);

/// Tolerance of the root-mean-square error of e around the prediction, on both sides, at `production_steps`.
[[nodiscard]] Tolerance near_prediction(EndRule rule);

}  // namespace talus::verification::problems
