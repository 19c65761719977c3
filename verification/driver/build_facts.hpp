#pragma once

#include <string>
#include <utility>
#include <vector>

namespace talus::verification {

/// Compiler name and version.
extern const char* const build_compiler;
/// Compiler options of the build.
extern const char* const build_flags;
/// "Release", "Debug", ...
extern const char* const build_type;
/// Library names and versions from CMake or, if it has none, from the header compiled against.
extern const std::vector<std::pair<std::string, std::string>> build_libraries;
/// Git commit at the time of the build, or "unknown".
extern const char* const source_revision;
/// Whether the sources differed from that commit.
extern const bool source_dirty;

}  // namespace talus::verification
