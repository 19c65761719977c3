#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "solver/draw/drawn_geometry.hpp"

namespace talus::app {

/// A frame's shapes as the CSV file that figures of it name; for both views.
[[nodiscard]] std::string frame_csv(const DrawnGeometry& geometry, std::size_t frame);

/// A frame as a figure of the drawing record, over its CSV file.
[[nodiscard]] nlohmann::ordered_json frame_figure(const DrawnGeometry& geometry, std::size_t frame,
                                                  const FrameStyle& style, const std::string& csv_file);

/// The scale of tensions for a page; null without cables that ever pull.
[[nodiscard]] nlohmann::ordered_json colour_scale(const DrawnGeometry& geometry);

}  // namespace talus::app
