#pragma once

#include <filesystem>
#include <string>

#include "verification/record/mutants.hpp"

namespace talus::mutants {

/// The results as JSON of mutation-testing-report-schema 2 (Stryker), for viewers of mutation tests: a file for each
/// mutated source with its text, a test for each case. Mutants and cases are identified by their ids.
/// Errors: records::FileError if a source below `root` cannot be read.
[[nodiscard]] std::string schema_report(const records::Mutants& mutants, const std::filesystem::path& root);

}  // namespace talus::mutants
