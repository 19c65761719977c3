#pragma once

#include "verification/check/case.hpp"

/// Parts of the case `cables`.
namespace talus::verification::problems {

/// A fall on an elastic cable; a throw on one with a dashpot.
void check_bungee(Findings& findings, const Setup& setup);
void check_damped_throw(Findings& findings, const Setup& setup);

/// Throws on cables that yield, single and repeated: perfectly plastic, with linear hardening, with a hardening table.
void check_yielding(Findings& findings, const Setup& setup);

/// Cables that break, at their strength or at their rupture stretch.
void check_breaking(Findings& findings, const Setup& setup);

/// Accelerations of bodies in nets of cables, in many listings, compared with a sum over the cables.
void check_nets(Findings& findings);

/// Chains of cables past broken hangers: in every listing, to their mirror image, and when one of the cables breaks.
void check_chains(Findings& findings);

/// A hanger that breaks.
void check_hanger(Findings& findings, const Setup& setup);

}  // namespace talus::verification::problems
