#pragma once

#include <string>

namespace talus {

/// "0.1.0".
extern const char* const version_number;
/// Compiler name and version.
extern const char* const build_compiler;
/// "Release", "Debug", ...
extern const char* const build_type;
/// Git commit at the time of the build, or "unknown".
extern const char* const source_revision;
/// Whether the sources differed from that commit.
extern const bool source_dirty;

/// Version, revision and build of a program, a line each, without a line end after the last one.
[[nodiscard]] std::string version_text(const std::string& program);

}  // namespace talus
