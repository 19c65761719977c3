#pragma once

#include <set>
#include <string>

#include "verification/study/program/program_run.hpp"

/// Files in the output folders of two runs of the program.
namespace talus::verification::problems {

/// All files in a folder of `folder`, and in its folders, relative to it. Throws std::filesystem::filesystem_error if
/// there is no such folder.
[[nodiscard]] std::set<std::string> files_of(const TemporaryFolder& folder, const std::string& out);

/// Number of files that differ between two folders; 1 if their lists of files differ, apart from those that are
/// `allowed`. Throws records::FileError if a file cannot be read, and as files_of().
[[nodiscard]] double different_files(const TemporaryFolder& folder, const std::string& one, const std::string& other,
                                     const std::set<std::string>& allowed = {});

}  // namespace talus::verification::problems
