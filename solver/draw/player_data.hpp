#pragma once

#include <string>

#include "solver/draw/drawn_states.hpp"
#include "solver/draw/history_choice.hpp"

namespace talus::app {

/// What the HTML player plays, as JSON: outlines in the axes of their bodies, and for each frame the bodies' places and
/// angles, the cables' ends and tensions; beside it the run's energies and forces as curves over time. Numbers have six
/// digits.
[[nodiscard]] std::string player_json(const DrawnGeometry& geometry, const SavedRun& histories, const Window& side,
                                      const Window& along);

/// The same of discs: radii and walls, and for each frame places, speeds, and the pairs that push each other with their
/// forces.
[[nodiscard]] std::string player_json(const DrawnDiscs& drawn, const SavedRun& histories, const Window& side,
                                      const Window& along);

}  // namespace talus::app
