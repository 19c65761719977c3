#pragma once

#include <functional>

#include "verification/check/case.hpp"
#include "verification/reference/restitution.hpp"
#include "verification/study/followed_impact.hpp"

/// Impacts of the case `restitution`: one for each phase at which surfaces can meet within a step, and their errors.
namespace talus::verification::problems {

inline constexpr double production_steps = 100.0;  ///< per contact, where the step is not varied

/// Root-mean-square error of e at xi = 0, times (steps per contact)^2: pi^2/(2 sqrt(90)).
///
/// Inside, velocity Verlet conserves v^2/2 + (w d)^2/2 (1 - (w h)^2/4). Touched at the share u of a step before the
/// first sample inside, that is v0^2/2 [1 - (w h)^2 u (1 - u)]; the end, backwards in time, is alike with a share u'.
/// So e - 1 = (w h)^2/2 [u'(1 - u') - u (1 - u)]. With u and u' even and independent the variance of u (1 - u) is
/// 1/180, and w h = pi/N.
inline constexpr double second_order_constant = 0.520;

/// Relative uncertainty of the predicted errors at 100 steps per contact: the next power of the step, w h = .018 ...
/// .039 here, over the first.
inline constexpr double next_power = 0.04;
/// The same where an attractive contact ends with a jump of its own: over 64 phases of the end that are not even but
/// random, the mean product of both jumps' phases is an eighth of their variance, 6 % of the root mean square.
inline constexpr double uneven_end = next_power + 0.06;

[[nodiscard]] const char* word_for(EndRule rule);  ///< "attractive" or "clamped"

/// A disc on a plane, k = m = v0 = 1, whose dashpot is to give restitution e.
struct Bounce {
  double e{};
  EndRule rule{};
  double xi{};                    ///< the closed form's, for e
  LinearSpringDashpot law;        ///< what the solver is given: a fault may spoil it
  reference::ImpactEvents exact;  ///< of the right contact
};

[[nodiscard]] Bounce bounce(double e, EndRule rule, const Setup& setup);

/// The disc, so far from the plane at t = 0. Integrator and plan are left to the caller.
[[nodiscard]] Scene disc_at(const Bounce& b, double gap);

/// A scene of bodies that approach at speed 1 from that gap.
using SceneAtGap = std::function<Scene(double gap)>;

/// Runs the scene so that it touches at the share `phase` of a step; times count from touch.
[[nodiscard]] FollowedImpact impact_at_phase(const SceneAtGap& scene_at, const Integrator& integrator,
                                             double contact_time, double step, double phase, Findings& findings);

/// Errors over 64 phases with a step of its own each, relative but for the pull.
struct ImpactErrors {
  PhaseError restitution, contact_time, largest_depth;
  PhaseError identity;          ///< e over the square of the largest depth, both over the exact ones
  PhaseError pull;              ///< least deceleration less the exact force at the end
  double mean_restitution{};    ///< e itself
  double least_deceleration{};  ///< of all phases; < 0: pulled
};

/// `commensurate`: a fault, all phases at the step that divides the contact time.
[[nodiscard]] ImpactErrors impact_errors(const SceneAtGap& scene_at, const reference::ImpactEvents& exact, double steps,
                                         const Integrator& integrator, Findings& findings, bool commensurate = false);

/// w h at so many steps per contact (the offsets of the phases add half a step on average).
[[nodiscard]] double reduced_step(const reference::ImpactEvents& exact, double steps);

/// Root-mean-square relative error of e that velocity Verlet is predicted to make.
[[nodiscard]] double predicted_restitution_error(const Bounce& b, double steps);

/// How near to the prediction the root mean square of e has to come, on both sides, at `production_steps`.
[[nodiscard]] Tolerance near_prediction(EndRule rule);

}  // namespace talus::verification::problems
