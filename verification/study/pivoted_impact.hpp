#pragma once

#include "solver/scenes/pivoted_cylinder.hpp"
#include "verification/check/case.hpp"
#include "verification/reference/pivoted_cylinder.hpp"

/// The solver's pivoted cylinder with the reference's data, started so that it meets the reference's own start at
/// touch.
namespace talus::verification::problems {

/// The dashpot of one run.
enum class Dashpot {
  pivoted_mass,  ///< from I_p/h^2 for the column
  two_masses,    ///< Eq. 21 as printed: from m and M
};

struct PivotedRun {
  double stiffness{2e5};  ///< k_n [lbf/ft]
  Dashpot dashpot{Dashpot::pivoted_mass};
  EndRule rule{EndRule::attractive};
  ContactMethod method{ContactMethod::resultant};
  double gap{};        ///< between rock and column at t = 0 [ft]
  bool eq_21{false};   ///< take Eq. 21's damping although the contact is clamped
  bool gravity{true};  ///< off: the impact alone
};

/// The contact that this run ought to have, in the reference's terms: for e = .5 by the rule's own formula
/// (or by Eq. 21 in any case).
[[nodiscard]] reference::PivotedContact contact_of(const PivotedRun& run);

/// The scene, with the fault of `setup` planted. The rock starts on the parabola that brings it to the height of the
/// column's centre with no vertical speed when it touches. Integrator and plan are left to the caller.
[[nodiscard]] Scene scene_of(const PivotedRun& run, const Setup& setup);

/// Effective mass of the impact, M I_p/h^2 / (M + I_p/h^2) [slug].
[[nodiscard]] double impact_mass();

/// Damping ratio xi of the contact that this run ought to have.
[[nodiscard]] double damping_ratio_of(const PivotedRun& run);

/// Its undamped frequency w [rad/s].
[[nodiscard]] double frequency_of(const PivotedRun& run);

/// What the impact left behind.
struct AfterImpact {
  double column{};           ///< speed of the centre of mass, (l/2) theta', carried back to the contact's end [ft/s]
  double rock{};             ///< horizontal speed [ft/s]
  double largest_angle{};    ///< of the swing that follows, by energy [rad]
  double largest_overlap{};  ///< [ft]
  double end_time{};         ///< of the contact, from touch [s]
  State at_end;              ///< first state after the contact
};

/// Runs the impact in steps of that length [s].
[[nodiscard]] AfterImpact impact(const PivotedRun& run, const Integrator& integrator, double step, const Setup& setup,
                                 Findings& findings);

/// Interval of the samples of a converged impact, over 1/w.
inline constexpr double converged_interval = 0.005;

/// The same with errors of the step as small as they get: Dormand-Prince at 1e-12.
[[nodiscard]] AfterImpact converged_impact(const PivotedRun& run, const Setup& setup, Findings& findings);

}  // namespace talus::verification::problems
