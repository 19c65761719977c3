#pragma once

#include <vector>

#include "verification/reference/superellipse.hpp"

/// Whether two outlines overlap, by brute force: many points of each boundary, tried one by one in the other.
namespace talus::verification::reference {

enum class OutlineKind { circle, rectangle, superellipse, half_plane };

/// An outline placed in the plane: its own axes at (x, y), turned counter-clockwise by `angle`. A half-plane is all
/// that lies below its own x axis.
struct Outline {
  OutlineKind kind{};
  Superellipse size{};  ///< half axes of a rectangle, radius of a circle in a
  double x{}, y{}, angle{};
};

/// Does the world point lie inside?
[[nodiscard]] bool contains(const Outline& outline, Point world);

/// `count` points of the boundary in the world, none of a half-plane: on the sides of a rectangle at equal steps, of
/// the others at equal steps of the parametric angle.
[[nodiscard]] std::vector<Point> boundary(const Outline& outline, int count);

/// Does a point of one boundary lie in the other? If so they overlap; overlaps narrower than the points' spacing may be
/// missed.
[[nodiscard]] bool overlap_by_points(const Outline& a, const Outline& b, int count = 400);

/// Length of the shortest displacement of b after which it no longer overlaps a (of outlines apart, minus their
/// distance), by brute force: the displacement along each of many directions by bisection of overlap_by_points(), the
/// shortest refined by golden sections; the distance over all pairs of points. Of curved outlines off by about
/// (2 pi/count)^2/8 of their radius.
[[nodiscard]] double least_displacement(const Outline& a, const Outline& b, int count);

}  // namespace talus::verification::reference
