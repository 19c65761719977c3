#pragma once

#include "verification/check/case.hpp"
#include "verification/record/json_node.hpp"
#include "verification/study/program/program_run.hpp"

/// The drawing on the sheet of a half fence, recorded in place of being drawn; part of the case `two_rocks`.
namespace talus::verification::problems::two_rocks {

/// Compares the lines drawn in `out/sheet.html` with the states, ground and history of sheet.json.
void check_drawn_sheet(const TemporaryFolder& folder, const records::Json& sheet, Findings& findings);

}  // namespace talus::verification::problems::two_rocks
