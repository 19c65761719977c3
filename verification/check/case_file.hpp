#pragma once

#include <filesystem>

namespace talus::verification {

/// The file or folder `name` of the folder `cases`: a deck, published numbers, recorded fingerprints. The folder is
/// that of the sources, or the one that replaces it.
[[nodiscard]] std::filesystem::path case_file(const std::filesystem::path& name);

/// Replaces the folder `cases`, before any case runs: a copy with changed files shows whether the cases notice.
void replace_case_folder(std::filesystem::path folder);

}  // namespace talus::verification
