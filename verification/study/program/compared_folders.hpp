#pragma once

#include <set>
#include <string>

#include "verification/study/program/program_run.hpp"

/// Files that two runs of the program have left.
namespace talus::verification::problems {

/// All files in a folder of `folder`, and in its folders, relative to it.
[[nodiscard]] std::set<std::string> files_of(const TemporaryFolder& folder, const std::string& out);

/// Number of files that differ between two folders; 1 if one of both has other files, besides those that are `allowed`.
/// Throws records::FileError if a file cannot be read.
[[nodiscard]] double different_files(const TemporaryFolder& folder, const std::string& one, const std::string& other,
                                     const std::set<std::string>& allowed = {});

}  // namespace talus::verification::problems
