#pragma once

#include <string>
#include <vector>

#include "solver/app/geometry_drawing.hpp"
#include "solver/app/history_choice.hpp"

namespace talus::app {

/// What the HTML player plays, as JSON: outlines in the axes of their bodies, and for each frame the bodies' places and
/// angles, the cables' ends and tensions; beside it the run's energies and forces as curves over time. Numbers have six
/// digits.
[[nodiscard]] std::string player_json(const DrawnGeometry& geometry, const KeptRun& histories, const Window& side,
                                      const Window& along);

}  // namespace talus::app
