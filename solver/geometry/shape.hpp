#pragma once

#include <array>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "solver/base/fields.hpp"
#include "solver/base/vec.hpp"
#include "solver/geometry/superquadric.hpp"

namespace talus {

/// No outline: a body without contacts.
struct NoShape {
  static constexpr std::string_view name = "none";
  static constexpr std::array<Field<NoShape>, 0> fields() { return {}; }
  friend constexpr bool operator==(const NoShape&, const NoShape&) = default;
};

/// A circle about the body's centre of mass.
struct Circle {
  static constexpr std::string_view name = "circle";
  double radius{};  ///< [L] > 0

  static constexpr std::array<Field<Circle>, 1> fields() {
    return {{{"radius", dimension::length, &Circle::radius, Range::positive, "radius about the centre of mass"}}};
  }
  friend constexpr bool operator==(const Circle&, const Circle&) = default;
};

/// A rectangle centred on the body's centre of mass, sides along the body's axes.
struct Rectangle {
  static constexpr std::string_view name = "rectangle";
  double half_width{};   ///< along the body's x axis [L] > 0
  double half_height{};  ///< along the body's y axis [L] > 0

  static constexpr std::array<Field<Rectangle>, 2> fields() {
    return {
        {{"half_width", dimension::length, &Rectangle::half_width, Range::positive, "half the side along body x"},
         {"half_height", dimension::length, &Rectangle::half_height, Range::positive, "half the side along body y"}}};
  }
  friend constexpr bool operator==(const Rectangle&, const Rectangle&) = default;
};

/// The half-plane below the body's x axis: the surface passes through the body's origin, and its outward normal is the
/// body's y axis.
struct HalfPlane {
  static constexpr std::string_view name = "half_plane";
  static constexpr std::array<Field<HalfPlane>, 0> fields() { return {}; }
  friend constexpr bool operator==(const HalfPlane&, const HalfPlane&) = default;
};

/// Uneven ground: everything below a line of points. Its first and last segments extend to infinity.
struct Terrain {
  static constexpr std::string_view name = "terrain";
  std::vector<Vec2> points{};  ///< two or more, in body coordinates, with increasing x [L]

  static constexpr std::array<Field<Terrain>, 0> fields() { return {}; }
  friend bool operator==(const Terrain&, const Terrain&) = default;
};

using Shape = std::variant<NoShape, Circle, Rectangle, Superquadric, HalfPlane, Terrain>;

/// Names of all shapes, in the order of Shape.
[[nodiscard]] std::vector<std::string> shape_names();

/// Boundary nodes of a shape in body coordinates (FENCE 1993 gave each of these nodes a separate spring and dashpot):
/// for a circle `count` points at equal spacing from body x; for a superquadric the midpoints of `count` equal
/// intervals of the parametric angle (1993: four, near the corners); for a rectangle its four corners; none for a
/// half-plane or terrain.
[[nodiscard]] std::vector<Vec2> boundary_nodes(const Shape& shape, int count);

}  // namespace talus
