#include "solver/geometry/shape.hpp"

#include <numbers>

#include "solver/geometry/pose.hpp"

namespace talus {

std::vector<std::string> shape_names() {
  return {std::string{NoShape::name},      std::string{Circle::name},    std::string{Rectangle::name},
          std::string{Superquadric::name}, std::string{HalfPlane::name}, std::string{Terrain::name}};
}

std::vector<Vec2> boundary_nodes(const Shape& shape, int count) {
  if (const auto* circle = std::get_if<Circle>(&shape)) {
    std::vector<Vec2> nodes;
    for (int i = 0; i < count; ++i) {
      nodes.push_back(rotation(2.0 * std::numbers::pi * i / count) * Vec2{circle->radius, 0.0});
    }
    return nodes;
  }
  if (const auto* outline = std::get_if<Superquadric>(&shape)) {
    std::vector<Vec2> nodes;
    for (int i = 0; i < count; ++i)
      nodes.push_back(boundary_point(*outline, 2.0 * std::numbers::pi * (i + 0.5) / count));
    return nodes;
  }
  if (const auto* box = std::get_if<Rectangle>(&shape)) {
    const double a = box->half_width, b = box->half_height;
    return {{a, b}, {-a, b}, {-a, -b}, {a, -b}};
  }
  return {};
}

}  // namespace talus
