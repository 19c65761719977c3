#pragma once

#include "verification/check/findings.hpp"

/// What the case `restitution` finds about calibration: curves over the damping ratio, and the solver's own formulas
/// and searches against the reference.
namespace talus::verification::problems {

/// e measured over the whole range of damping ratios, both end rules, beside the closed forms: a figure.
void find_calibration_curves(Findings& findings);

/// What Eq. 21 gives when the contact is clamped: checks, a table and a figure.
void find_clamped_eq_21(Findings& findings);

/// damping_ratio, restitution, contact_time, largest_overlap of the solver against the reference's.
void check_solver_formulas(Findings& findings);

/// The advised step keeps its bound at phases that the advice did not try.
void check_step_advice(Findings& findings);

/// The search by simulation on the pivoted cylinder reaches its target and tends to the effective mass's damping.
void check_scene_calibration(Findings& findings);

}  // namespace talus::verification::problems
