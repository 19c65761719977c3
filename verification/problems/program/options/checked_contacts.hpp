#pragma once

#include "verification/study/program/program_options.hpp"

/// Contacts and bodies in the output of `talus check`; part of the case `calculation_options`.
namespace talus::verification::problems::calculation_options {

/// `check` names the worse of two bodies beyond the bound of their moment of inertia, of two overlaps at the start, and
/// of two contacts that become lighter, in any order of the scene. The larger overlap is smaller beside its body.
void check_worst_named(const Program& program, Differences& differ);

/// `check` lists the bounds of a plate's corners exactly if a corner can be lighter than the lightest of the four at
/// the start: 1/m = 1/M + x^2/I with its lever x, which is at most a where a corner is the lowest.
void check_lighter_corners(const Program& program, Differences& differ);

}  // namespace talus::verification::problems::calculation_options
