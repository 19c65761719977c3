#pragma once

#include <string>
#include <vector>

#include "solver/scenes/fence_summary.hpp"

namespace talus::scenes {

/// Messages, with numbers, about fence geometry that is probably a mistake: columns that overlap along the fence,
/// ground inside columns, a sag larger than the span.
[[nodiscard]] std::vector<std::string> implausible_geometry(const Fence& fence, const FenceScene& made);

/// Messages about a run that is probably a mistake: a rock that flies away, or never touches the fence.
[[nodiscard]] std::vector<std::string> implausible_motion(const Fence& fence, const FenceSummary& summary);

}  // namespace talus::scenes
