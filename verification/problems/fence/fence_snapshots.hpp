#pragma once

#include "solver/scenes/fence.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems {

/// Figure of the rocks and the central column of each layer at given times [s] of an impact, seen along the fence.
[[nodiscard]] Figure snapshots(std::string name, std::string title, std::string caption, const scenes::Fence& fence,
                               const std::vector<double>& times);

}  // namespace talus::verification::problems
