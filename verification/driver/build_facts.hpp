#pragma once

#include <string>
#include <utility>
#include <vector>

namespace talus::verification {

/// Compiler name and version.
extern const char* const build_compiler;
/// Options that the code was compiled with.
extern const char* const build_flags;
/// "Release", "Debug", ...
extern const char* const build_type;
/// Library names and versions, as CMake found them or, where it does not say, as the header compiled against does.
extern const std::vector<std::pair<std::string, std::string>> build_libraries;
/// Git commit at the time of the build, or "unknown".
extern const char* const source_revision;
/// The sources differed from that commit.
extern const bool source_dirty;

}  // namespace talus::verification
