#pragma once

#include <vector>

#include "verification/reference/outlines/superellipse.hpp"

/// Brute-force overlap test of two outlines: many points of each boundary are tested one by one against the other.
namespace talus::verification::reference {

enum class OutlineKind { circle, rectangle, superellipse, half_plane };

/// An outline placed in the plane: its origin at (x, y), turned counter-clockwise by `angle`. A half-plane is the
/// region below its local x axis.
struct Outline {
  OutlineKind kind{};
  Superellipse size{};  ///< half axes of a rectangle, radius of a circle in a
  double x{}, y{}, angle{};
};

/// True if the world point lies inside.
[[nodiscard]] bool contains(const Outline& outline, Point world);

/// `count` boundary points in world coordinates, none of a half-plane: at equal steps along each side of a rectangle,
/// with its corners if count is a multiple of 4, and at equal steps of the parametric angle otherwise.
[[nodiscard]] std::vector<Point> boundary(const Outline& outline, int count);

/// True if a point of one boundary lies in the other outline. Overlaps narrower than the point spacing may be missed.
[[nodiscard]] bool overlap_by_points(const Outline& a, const Outline& b, int count = 400);

/// Length of the shortest displacement of b after which it no longer overlaps a (for separate outlines, minus their
/// distance), by brute force: the displacement along each of many directions by bisection of overlap_by_points(), the
/// shortest refined by golden sections; the distance of the polygons of boundary points. With a multiple of 4 for
/// `count`, rectangles are exact; a polygon lies within up to (2 pi/count)^2/8 of the longer half axis of its ellipse.
[[nodiscard]] double minimum_displacement(const Outline& a, const Outline& b, int count);

}  // namespace talus::verification::reference
