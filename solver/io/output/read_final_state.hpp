#pragma once

#include <filesystem>
#include <vector>

#include "solver/scenes/fence.hpp"

namespace talus {

/// The cables with plastic stretch at the end of a run, from final_state.json in its folder, for the next impact on the
/// same fence. Errors: IoError; InputError naming the file if it is not a final state, has other units than `units`, or
/// has a broken part: a fence is repaired before the next rock.
[[nodiscard]] std::vector<scenes::StretchedCable> read_stretched_cables(const std::filesystem::path& folder,
                                                                        const UnitSystem& units);

}  // namespace talus
