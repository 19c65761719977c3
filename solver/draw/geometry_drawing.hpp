#pragma once

#include <optional>
#include <string>

#include "solver/draw/drawn_geometry.hpp"

namespace talus::app {

/// A frame's shapes as the CSV file that figures of it name; for both views.
[[nodiscard]] std::string frame_csv(const DrawnGeometry& geometry, std::size_t frame);

/// A frame as a figure of the drawing record, over its CSV file.
[[nodiscard]] records::Figure frame_figure(const DrawnGeometry& geometry, std::size_t frame, const FrameStyle& style,
                                           const std::string& csv_file);

/// The scale of tensions for a page; nothing without cables that ever pull.
[[nodiscard]] std::optional<records::Scale> colour_scale(const DrawnGeometry& geometry);

}  // namespace talus::app
