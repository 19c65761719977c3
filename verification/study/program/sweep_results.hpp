#pragma once

#include "verification/record/csv.hpp"
#include "verification/record/json_node.hpp"
#include "verification/study/program/program_options.hpp"

namespace talus::verification::problems {

/// Compares the two files of a collected sweep of which no run is missing: results.csv, in the units of its heads, and
/// results.json, in SI units: parameters, ends with their counts, and outputs of each run.
void compare_sweep(const records::Csv& csv, const records::Json& json, Differences& differ);

/// Both files of a folder, whose table it returns.
records::Csv compared_sweep(const Program& program, const std::string& folder, Differences& differ);

}  // namespace talus::verification::problems
