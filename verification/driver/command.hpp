#pragma once

#include <filesystem>
#include <vector>

#include "verification/check/case.hpp"

namespace talus::verification {

/// The command `talus_verify` on the given cases, with the catalogue of that folder. Returns the exit status: 0 if
/// every check holds and every control turned red, 1 if not, 2 for a wrong command line, catalogue, baseline or file of
/// renames, 4 if a file cannot be read or written, 6 if the results hold and something other than time is worse than
/// the baseline. With a wrong catalogue no case runs. `read`: files and folders that cases read, beside the catalogue:
/// while they and the executable are the same, records may be reused (--reuse).
[[nodiscard]] int verify(const std::vector<Case>& cases, const std::filesystem::path& catalogue, int argc,
                         const char* const* argv, std::vector<std::filesystem::path> read = {});

}  // namespace talus::verification
