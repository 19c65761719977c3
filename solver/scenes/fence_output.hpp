#pragma once

#include <span>
#include <string_view>

#include "solver/base/units.hpp"
#include "solver/scenes/fence_summary.hpp"

namespace talus::scenes {

/// One number of a fence's summary.
struct FenceOutput {
  std::string_view name;  ///< "fence.anchor_force"
  Dimension dimension{};
  double (*of)(const FenceSummary&){};
};

/// All of them: the largest forces (on an anchor, in a cable, in a hanger) and the largest travel of a column over the
/// run, the largest ratio of a cable's and a hanger's force to its limit, and the kinetic energy of the rocks after
/// their last contact, or at the end if they had none.
[[nodiscard]] std::span<const FenceOutput> fence_outputs();

}  // namespace talus::scenes
