#pragma once

#include <optional>
#include <string>

#include "solver/draw/drawn_geometry.hpp"

namespace talus::app {

/// A frame's outlines, cables and hangers as a figure.
[[nodiscard]] records::Figure frame_figure(const DrawnGeometry& geometry, std::size_t frame, const FrameStyle& style);

/// The colour scale of tensions, for a page; nothing if no cable has tension in any frame.
[[nodiscard]] std::optional<records::Scale> colour_scale(const DrawnGeometry& geometry);

}  // namespace talus::app
