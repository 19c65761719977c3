#pragma once

#include <string>

#include "solver/scenes/fence.hpp"

namespace talus {

/// Text of the scene file of a fence, in the units of the fence. Reading it restores the fence to the last bit.
[[nodiscard]] std::string write_fence(const scenes::Fence& fence);

}  // namespace talus
