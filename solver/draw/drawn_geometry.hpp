#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "solver/draw/frame_style.hpp"
#include "solver/io/output/read_geometry.hpp"

namespace talus::app {

/// The bodies and cables that a run left, read as far as it is drawn.
struct DrawnGeometry {
  RunFolder run;
  std::vector<GeometryFrame> frames;
  double largest_tension{};  ///< of all frames [F]
  bool has_depth{};          ///< not all stands at the same place along the fence
};

/// Reads those frames. Errors: InputError if a frame names a body or cable that the run does not.
[[nodiscard]] DrawnGeometry read_frames(RunFolder run, const std::vector<GeometryFile>& files);

/// The bar from a cable's joint to the outline of the body that it holds.
struct HangerBar {
  long body{};
  Vec3 joint;
  Vec3 end;  ///< point of the outline

  friend bool operator==(const HangerBar&, const HangerBar&) = default;
};

/// Those of a frame: where a joint stands outside the outline of its body.
[[nodiscard]] std::vector<HangerBar> hangers(const GeometryFrame& frame);

/// A line's image behind z = 0, where the geometry is mirrored and the line is not there already; else none.
[[nodiscard]] std::optional<GeometryLine> mirror_image(const DrawnGeometry& geometry, const GeometryLine& line);

/// The smallest window that holds all bodies but half-planes and all cables in all frames, and a margin.
[[nodiscard]] Window window_of(const DrawnGeometry& geometry, View view);

/// The body that an outline is of, as pictures name it.
[[nodiscard]] const DrawnBody& body_of(const DrawnGeometry& geometry, const GeometryLine& outline);

/// Half of the width of a body at the start [L].
[[nodiscard]] double half_width(const DrawnGeometry& geometry, long body);

/// Whether a line ends where it began, as the outlines of all bodies but ground do.
[[nodiscard]] bool is_closed(const GeometryLine& line);

/// The mean of a closed line's points.
[[nodiscard]] Vec3 middle(const GeometryLine& line);

/// Lowest and highest point of a line [L].
[[nodiscard]] std::pair<double, double> heights(const GeometryLine& line);

}  // namespace talus::app
