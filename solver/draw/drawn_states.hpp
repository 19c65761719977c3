#pragma once

#include <string>
#include <variant>
#include <vector>

#include "solver/draw/disc_drawing.hpp"
#include "solver/draw/geometry_drawing.hpp"

namespace talus::app {

/// The states of a run as they are drawn. Both kinds have `run`, `frames` and `has_depth`, and window_of,
/// frame_figure, colour_scale and player_json take either.
using DrawnStates = std::variant<DrawnGeometry, DrawnDiscs>;

/// The files of a run's states. Errors: as read_geometry_index; InputError if the run left none.
[[nodiscard]] std::vector<GeometryFile> state_files(const RunFolder& run);

/// Reads those states; `colour` is that of PictureOptions. Errors: as read_frames and read_disc_frames; InputError if
/// bodies are to be coloured.
[[nodiscard]] DrawnStates read_states(const RunFolder& run, const std::vector<GeometryFile>& files,
                                      const std::string& colour);

}  // namespace talus::app
