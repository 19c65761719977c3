#pragma once

#include <string>
#include <variant>
#include <vector>

#include "solver/draw/disc_drawing.hpp"
#include "solver/draw/geometry_drawing.hpp"

namespace talus::app {

/// The states of a run, for drawing. Both types have `run`, `frames` and `has_depth`; window_of, frame_figure,
/// colour_scale and player_json accept either.
using DrawnStates = std::variant<DrawnGeometry, DrawnDiscs>;

/// The files of a run's states. Errors: as read_geometry_index; InputError if the run wrote none.
[[nodiscard]] std::vector<GeometryFile> state_files(const RunFolder& run);

/// Reads the states from these files; `colour` as in PictureOptions. Errors: as read_frames and read_disc_frames;
/// InputError if `colour` is given for a run with bodies.
[[nodiscard]] DrawnStates read_states(const RunFolder& run, const std::vector<GeometryFile>& files,
                                      const std::string& colour);

}  // namespace talus::app
