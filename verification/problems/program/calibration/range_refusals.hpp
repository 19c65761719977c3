#pragma once

#include "verification/study/program/program_options.hpp"

/// Wrong ranges of impacts; part of the case `calibrated_laws`.
namespace talus::verification::problems::calibrated_laws {

/// Compares the messages of wrong ranges, each with its end.
void compare_range_refusals(const Program& program, Differences& differ);

}  // namespace talus::verification::problems::calibrated_laws
