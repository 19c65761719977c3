#pragma once

#include <filesystem>
#include <vector>

#include "solver/scenes/fence.hpp"

namespace talus {

/// The cables that a run has drawn out, from final_state.json in its folder, for the next impact on the same fence.
/// Errors: IoError; InputError naming the file for one that is none, that is of other units than `units`, or that ends
/// with something broken: a fence is mended before the next rock.
[[nodiscard]] std::vector<scenes::StretchedCable> read_stretched_cables(const std::filesystem::path& folder,
                                                                        const UnitSystem& units);

}  // namespace talus
