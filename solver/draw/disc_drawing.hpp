#pragma once

#include <string>
#include <vector>

#include "solver/draw/frame_style.hpp"
#include "solver/io/output/read_geometry.hpp"

namespace talus::app {

/// What colours a disc that is none of a wall's.
enum class DiscColour {
  speed,
  force,  ///< the sum of the forces of its contacts
};

/// The discs that a run left, as far as they are drawn, with positions in
/// [-period/2, period/2) along x, as in PIC.DAT.
struct DrawnDiscs {
  RunFolder run;
  std::vector<DiscFrame> frames;
  DiscColour colour{};
  double largest_force{};  ///< of a contact in all frames [F]
  double largest_radius{};
  Window window{};  ///< the field with its walls in all frames, and a diameter beyond its borders
  static constexpr bool has_depth = false;
};

/// Reads those frames. Errors: as read_discs.
[[nodiscard]] DrawnDiscs read_disc_frames(RunFolder run, const std::vector<GeometryFile>& files, DiscColour colour);

/// What colours each disc of a frame [L/T] or [F]; of discs of walls too.
[[nodiscard]] std::vector<double> disc_values(const DiscFrame& frame, DiscColour colour);
/// The largest of them of free discs in all frames.
[[nodiscard]] double largest_value(const DrawnDiscs& drawn, DiscColour colour);
/// How wide the bar of the largest force is drawn; others in proportion [L].
[[nodiscard]] double widest_bar(const DrawnDiscs& drawn);

/// `drawn.window`; discs have the side view alone.
[[nodiscard]] inline Window window_of(const DrawnDiscs& drawn, View) { return drawn.window; }

/// A frame's discs, contacts and borders as a figure, with all images in `drawn.window`.
[[nodiscard]] records::Figure frame_figure(const DrawnDiscs& drawn, std::size_t frame, const FrameStyle& style);

/// The scale of what colours discs, for a page; nothing if that is zero throughout.
[[nodiscard]] std::optional<records::Scale> colour_scale(const DrawnDiscs& drawn);

}  // namespace talus::app
