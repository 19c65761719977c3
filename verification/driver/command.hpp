#pragma once

#include <filesystem>
#include <vector>

#include "verification/check/case.hpp"

namespace talus::verification {

/// Runs the command `talus_verify` on the given cases, with the catalogue in the given folder. With an invalid
/// catalogue no case runs. `read` lists files and folders, besides the catalogue, that cases read: as long as they and
/// the executable are unchanged, records may be reused (--reuse). Returns the exit status: 0 if every check passes and
/// every control turned red, 1 if not, 2 for an invalid command line, catalogue, baseline or file of renames, 4 if a
/// file cannot be read or written, 6 if all checks and controls pass but something other than time is worse than the
/// baseline.
[[nodiscard]] int verify(std::vector<Case> cases, const std::filesystem::path& catalogue, int argc,
                         const char* const* argv, std::vector<std::filesystem::path> read = {});

}  // namespace talus::verification
