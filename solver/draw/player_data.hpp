#pragma once

#include <string>

#include "solver/draw/drawn_states.hpp"
#include "solver/draw/history_choice.hpp"

namespace talus::app {

/// Input of the HTML player as JSON: outlines in body axes, and for each frame the bodies' positions and angles and the
/// cables' ends and tensions; also the run's energies and forces as curves over time. Numbers have six digits.
[[nodiscard]] std::string player_json(const DrawnGeometry& geometry, const SavedRun& histories, const Window& side,
                                      const Window& along);

/// Input of the HTML player for discs: radii and walls, and for each frame positions, speeds, and the pairs in contact
/// with their forces; also curves over time, as for bodies.
[[nodiscard]] std::string player_json(const DrawnDiscs& drawn, const SavedRun& histories, const Window& side,
                                      const Window& along);

}  // namespace talus::app
