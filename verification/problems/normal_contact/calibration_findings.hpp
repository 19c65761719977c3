#pragma once

#include "verification/check/findings.hpp"

/// Checks of calibration in the case `restitution`: curves against the damping ratio, and the solver's formulas and
/// searches against the reference.
namespace talus::verification::problems {

/// Compares e with the closed forms over the whole range of damping ratios, for both end rules: checks and a figure.
void find_calibration_curves(Findings& findings);

/// Checks the restitution that Eq. 21 gives when the contact is clamped, with tables and a figure.
void find_clamped_eq_21(Findings& findings);

/// Checks damping_ratio, restitution, contact_time and largest_overlap of the solver against the reference.
void check_solver_formulas(Findings& findings);

/// Checks that the advised step satisfies its error bound at phases that the advice did not sample.
void check_step_advice(Findings& findings);

/// Checks that the calibration of the pivoted cylinder by simulation reaches its target, and that its damping tends to
/// that of the effective mass.
void check_scene_calibration(Findings& findings);

}  // namespace talus::verification::problems
