#pragma once

#include <cmath>
#include <limits>

#include "solver/base/vec.hpp"

namespace talus {

/// The plane, or a strip or rectangle of it that is periodic. The rectangle above may slide over the one below at a
/// constant rate (Lees & Edwards 1972): uniform shear without walls.
struct PeriodicBox {
  static constexpr double unbounded = std::numeric_limits<double>::infinity();

  double width{unbounded};   ///< period along x [L] > 0
  double height{unbounded};  ///< period along y [L] > 0
  double shear_rate{};       ///< du/dy of the mean flow [1/T]; needs a height

  bool repeats_x() const { return width < unbounded; }
  bool repeats_y() const { return height < unbounded; }
  /// Velocity of the box above over this one [L/T].
  double sliding() const { return repeats_y() ? shear_rate * height : 0.0; }
  /// The boundary shear displacement `shear_displacement`, reduced by whole widths to within half a width [L].
  double offset(double shear_displacement) const {
    return repeats_x() ? shear_displacement - width * std::round(shear_displacement / width) : shear_displacement;
  }

  /// An image of a point: number of boxes to the right and up.
  struct Image {
    double right{};
    double up{};
  };
  /// The image of a point that is nearest to another, by their difference d = point - other.
  Image nearest(Vec2 d, double at_offset) const {
    Image image;
    if (repeats_y()) image.up = -std::round(d.y / height);
    if (repeats_x()) image.right = -std::round((d.x + image.up * at_offset) / width);
    return image;
  }
  /// Vector from a point to its image [L].
  Vec2 shift(Image image, double at_offset) const {
    return {(image.right == 0.0 ? 0.0 : image.right * width) + (image.up == 0.0 ? 0.0 : image.up * at_offset),
            image.up == 0.0 ? 0.0 : image.up * height};
  }
};

}  // namespace talus
