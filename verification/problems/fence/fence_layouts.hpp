#pragma once

#include "solver/scenes/fence.hpp"
#include "verification/check/case.hpp"

/// Declarations shared by the parts of the case `fence_layouts`.
namespace talus::verification::problems::fence_layouts {

/// The fence of Table 2 with the current options.
[[nodiscard]] scenes::Fence fence_of_today();

/// A column that is longer and heavier than the others and has other joints; each use sets its number.
inline constexpr scenes::ChangedColumn unlike{3, 1.0, 4.6, 0.8, 7.3, -4.5};

// held_elements.cpp
/// Accelerations of a rock for each combination of held x, y and rotation, and gravity of either sign.
void check_held_elements(Findings& findings, const Setup& setup);
// fence_outlines.cpp
void check_outlines(Findings& findings);
void check_reach(Findings& findings);
// fence_warnings.cpp
void check_warnings(Findings& findings);
void check_positions(Findings& findings);
void check_duration(Findings& findings);
void check_counts(Findings& findings);
void check_ends(Findings& findings);

}  // namespace talus::verification::problems::fence_layouts
