#pragma once

#include "solver/scenes/pivoted_cylinder.hpp"
#include "verification/check/case.hpp"
#include "verification/reference/impacts/pivoted_cylinder.hpp"

/// The solver's pivoted cylinder with the reference's data, started so that it is in the reference's initial state at
/// touch.
namespace talus::verification::problems {

/// Damping of one run.
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
  bool eq_21{false};   ///< use Eq. 21's damping although the contact is clamped
  bool gravity{true};  ///< off: the impact alone
};

/// Correct contact of this run as a contact of the reference: for e = 0.5 by the formula of the end rule (or always by
/// Eq. 21).
[[nodiscard]] reference::PivotedContact contact_of(const PivotedRun& run);

/// Scene with the fault of `setup` planted. The rock starts on the parabola on which it touches at the height of the
/// column's centre with no vertical speed. Integrator and plan are set by the caller.
[[nodiscard]] Scene scene_of(const PivotedRun& run, const Setup& setup);

/// Effective mass of the impact, M I_p/h^2 / (M + I_p/h^2) [slug].
[[nodiscard]] double impact_mass();

/// Damping ratio xi of the correct contact of this run.
[[nodiscard]] double damping_ratio_of(const PivotedRun& run);

/// Undamped frequency w of that contact [rad/s].
[[nodiscard]] double frequency_of(const PivotedRun& run);

/// State after the impact.
struct AfterImpact {
  double column{};           ///< speed of the centre of mass, (l/2) theta', extrapolated back to the end of contact
                             ///< [ft/s]
  double rock{};             ///< horizontal speed [ft/s]
  double largest_angle{};    ///< of the motion that follows, from its energy [rad]
  double largest_overlap{};  ///< [ft]
  double end_time{};         ///< of the contact, from touch [s]
  State at_end;              ///< first state after the contact
};

/// Runs the impact with steps of length `step` [s].
[[nodiscard]] AfterImpact impact(const PivotedRun& run, const Integrator& integrator, double step, const Setup& setup,
                                 Findings& findings);

/// Sampling interval of a converged impact, over 1/w.
inline constexpr double converged_interval = 0.005;

/// The impact with minimal truncation error: Dormand-Prince at 1e-12.
[[nodiscard]] AfterImpact converged_impact(const PivotedRun& run, const Setup& setup, Findings& findings);

}  // namespace talus::verification::problems
