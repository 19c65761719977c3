#pragma once

#include "verification/check/case.hpp"
#include "verification/study/program/program_run.hpp"

/// Scenes on both sides of what is refused, a run that diverges, and lines that represent bodies; part of the case
/// `scene_fields`.
namespace talus::verification::problems::scene_fields {

/// Pairs of scenes that differ in one number: one runs, the other one is refused with a message.
void check_refused(const TemporaryFolder& folder, Findings& findings, const Setup& setup);

/// Two bodies, of which the second one leaves the range of doubles: the run names its coordinate.
void check_diverging(const TemporaryFolder& folder, Findings& findings);

/// Bodies without a shape: in the geometry, one with a pin or a guide is the line from its pin to its centre.
void check_lines(const TemporaryFolder& folder, Findings& findings);

}  // namespace talus::verification::problems::scene_fields
