#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "solver/base/fields.hpp"
#include "solver/draw/frame_style.hpp"
#include "solver/io/output/read_geometry.hpp"

namespace talus::app {

/// Quantity that colours the discs, except discs of walls.
enum class DiscColour {
  speed,
  force,  ///< the sum of the forces of its contacts
};

/// Discs read from a run's output, for drawing, with positions in [-period/2, period/2) along x, as in PIC.DAT.
struct DrawnDiscs {
  RunFolder run;
  std::vector<DiscFrame> frames;
  DiscColour colour{};
  double largest_force{};  ///< of a contact in all frames [F]
  double largest_radius{};
  Window window{};  ///< the field with its walls in all frames, plus the largest diameter beyond its borders
  static constexpr bool has_depth = false;
};

/// Reads the frames of the given files. Errors: as read_discs.
[[nodiscard]] DrawnDiscs read_disc_frames(RunFolder run, const std::vector<GeometryFile>& files, DiscColour colour);

/// Value that colours each disc of a frame [L/T] or [F]; includes discs of walls.
[[nodiscard]] std::vector<double> disc_values(const DiscFrame& frame, DiscColour colour);
/// The largest of these values over all frames, without discs of walls.
[[nodiscard]] double largest_value(const DrawnDiscs& drawn, DiscColour colour);
/// Width of the bar drawn for the largest contact force [L]; other bars are scaled in proportion.
[[nodiscard]] double widest_bar(const DrawnDiscs& drawn);

/// `drawn.window`; discs have only the side view.
[[nodiscard]] inline Window window_of(const DrawnDiscs& drawn, View) { return drawn.window; }

/// A frame's discs, contacts and borders as a figure, with all periodic images in `drawn.window`.
[[nodiscard]] records::Figure frame_figure(const DrawnDiscs& drawn, std::size_t frame, const FrameStyle& style);

/// The colour scale of the discs, for a page; nothing if the quantity is zero throughout.
[[nodiscard]] std::optional<records::Scale> colour_scale(const DrawnDiscs& drawn);

}  // namespace talus::app

namespace talus {
template <>
struct Names<app::DiscColour> {
  static constexpr std::array<std::string_view, 2> list{"speed", "force"};
};
}  // namespace talus
