#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "solver/draw/frame_style.hpp"
#include "solver/io/output/read_geometry.hpp"

namespace talus::app {

/// Bodies and cables read from a run's output, for drawing.
struct DrawnGeometry {
  RunFolder run;
  std::vector<GeometryFrame> frames;
  double largest_tension{};  ///< of all frames [F]
  bool has_depth{};          ///< positions along the fence (z) differ
};

/// Reads the frames of the given files. Errors: InputError if a frame names a body or cable that the run does not have.
[[nodiscard]] DrawnGeometry read_frames(RunFolder run, const std::vector<GeometryFile>& files);

/// The bar from a cable's joint to the outline of the body it is attached to.
struct HangerBar {
  long body{};
  Vec3 joint;
  Vec3 end;  ///< point of the outline

  friend bool operator==(const HangerBar&, const HangerBar&) = default;
};

/// Hanger bars of a frame, one for each joint that lies outside the outline of its body.
[[nodiscard]] std::vector<HangerBar> hangers(const GeometryFrame& frame);

/// A line's mirror image at z = 0, if the geometry is mirrored and the line is not in the plane z = 0; else nothing.
[[nodiscard]] std::optional<GeometryLine> mirror_image(const DrawnGeometry& geometry, const GeometryLine& line);

/// The smallest window that contains all bodies except half-planes and all cables in all frames, plus a margin.
[[nodiscard]] Window window_of(const DrawnGeometry& geometry, View view);

/// The body of an outline, with the name used in pictures.
[[nodiscard]] const DrawnBody& body_of(const DrawnGeometry& geometry, const GeometryLine& outline);

/// Half the width of a body in the first frame [L].
[[nodiscard]] double half_width(const DrawnGeometry& geometry, long body);

/// Whether a line is closed (last point equal to the first), as the outlines of all bodies except ground are.
[[nodiscard]] bool is_closed(const GeometryLine& line);

/// Mean of a closed line's points.
[[nodiscard]] Vec3 middle(const GeometryLine& line);

/// Lowest and highest point of a line [L].
[[nodiscard]] std::pair<double, double> heights(const GeometryLine& line);

}  // namespace talus::app
