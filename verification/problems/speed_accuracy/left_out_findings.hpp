#pragma once

#include "solver/state/state.hpp"
#include "verification/check/case.hpp"

/// What the case `left_out` finds about contacts and cables that are not worked out one by one.
namespace talus::verification::problems {

/// Nought for two states whose coordinates, velocities, memories and losses are the same; else the largest difference
/// of any coordinate or velocity, or NaN if only the others differ.
[[nodiscard]] double change(const State& a, const State& b);

/// Runs in which every gap of every pair is worked out at each evaluation end in the same bits. Fault `pair_forgotten`.
void check_contacts(Findings& findings, const Setup& setup, Table& table);

/// The tensions of rows of cables are those of the laws, one by one, through a run in which cables slacken and yield.
/// Fault `line_of_another`. Without a ledger, when paths are not told, it ends in the same bits. Fault
/// `paths_of_another`.
void check_rows(Findings& findings, const Setup& setup, Table& table);

}  // namespace talus::verification::problems
