#pragma once

#include <filesystem>
#include <vector>

#include "tests/mutants/mutant.hpp"

namespace talus::mutants {

/// The written bugs of a folder of TOML files (bugs/*.toml, in the order of their names), each located in the sources
/// below `root`. A table [[bug]] has id, file, form ("expression" or "statement"), old, new, bug, cases, and optionally
/// source; [[bug.also]] has file, form, old, new of further positions of the same bug.
/// Errors: std::runtime_error with file and line for a file that is not TOML, an unknown or missing key, a form that is
/// neither, an id used twice, a bug without cases, and an `old` that its file does not contain exactly once.
[[nodiscard]] std::vector<Mutant> written_bugs(const std::filesystem::path& folder, const std::filesystem::path& root);

}  // namespace talus::mutants
