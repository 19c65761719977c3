#pragma once

#include <string>
#include <vector>

#include "solver/scenes/fence_summary.hpp"

namespace talus::scenes {

/// What in the geometry of a fence is unlikely to be meant, in words with its numbers: columns that overlap along the
/// fence, ground inside columns, a sag larger than the span.
[[nodiscard]] std::vector<std::string> implausible_geometry(const Fence& fence, const FenceScene& made);

/// The same of a run: a rock that flies away, or never touches the fence.
[[nodiscard]] std::vector<std::string> implausible_motion(const Fence& fence, const FenceSummary& summary);

}  // namespace talus::scenes
