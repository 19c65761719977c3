#pragma once

#include <string>
#include <vector>

#include "verification/problems/program/agreement/expected_files.hpp"

/// What `talus run` prints at the end of a run.
namespace talus::verification::problems::agreeing_files {

/// The lines that follow from summary.json, in their order: every number of the text, with the digits that it has
/// there. Left out are the table of impacts and notes, which other cases compare, and lines on parts of a step.
[[nodiscard]] std::vector<std::string> expected_print(const Json& summary);

/// The printed lines, without those that expected_print() leaves out.
[[nodiscard]] std::vector<std::string> compared_print(const std::string& printed);

}  // namespace talus::verification::problems::agreeing_files
