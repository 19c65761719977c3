#pragma once

#include <string>
#include <utility>
#include <vector>

namespace talus::verification {

/// Compiler options of the build.
extern const char* const build_flags;
/// Library names and versions from CMake or, if it has none, from the header compiled against.
extern const std::vector<std::pair<std::string, std::string>> build_libraries;

}  // namespace talus::verification
