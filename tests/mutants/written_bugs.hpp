#pragma once

#include <filesystem>
#include <vector>

#include "tests/mutants/mutant.hpp"

namespace talus::mutants {

/// The written bugs of a folder of TOML files (bugs/*.toml, in the order of their names), each found in the sources
/// below `root`. A table [[bug]] has id, file, form ("expression" or "statement"), old, new, bug, cases, and perhaps
/// source; [[bug.also]] has file, form, old, new of further places of the same bug.
/// Errors: std::runtime_error with file and line for a file that is no TOML, an unknown or missing key, a form that is
/// neither, an id used twice, no case, and an `old` that its file does not hold exactly once.
[[nodiscard]] std::vector<Mutant> written_bugs(const std::filesystem::path& folder, const std::filesystem::path& root);

}  // namespace talus::mutants
