#pragma once

#include "verification/check/case.hpp"
#include "verification/problems/program/agreement/expected_files.hpp"

/// The rows of history.csv of the case `agreeing_files`, column by column, beside the scenes, their laws and each
/// other.
namespace talus::verification::problems::agreeing_files {

/// Adds the checks of both histories.
void compare_histories(const Run& yard, const Run& fence, Findings& findings, const Setup& setup);

}  // namespace talus::verification::problems::agreeing_files
