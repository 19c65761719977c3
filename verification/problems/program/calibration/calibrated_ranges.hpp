#pragma once

#include "verification/check/findings.hpp"
#include "verification/study/program/program_options.hpp"

/// Calibrations of many pairs at once; part of the case `calibrated_laws`.
namespace talus::verification::problems::calibrated_laws {

/// Compares dashpots and restitutions of ranges of pairs with the references, the minimax dashpot with a search, and
/// text, CSV and drawing with the JSON output; wrong ranges must be refused. The names of all checks begin with
/// "ranges: ".
void check_ranges(const Program& program, Findings& findings);

}  // namespace talus::verification::problems::calibrated_laws
