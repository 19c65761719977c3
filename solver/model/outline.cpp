#include "solver/model/outline.hpp"

#include <numbers>
#include <variant>

namespace talus {

std::vector<Vec2> outline(const Body& body, double reach) {
  constexpr int parts = 96;
  const Shape& shape = body.shape;
  std::vector<Vec2> points;
  if (std::holds_alternative<NoShape>(shape)) {
    if (has_pin(body.mobility)) points = {body.p_BPin, {0.0, 0.0}};
    return points;
  }
  if (std::holds_alternative<HalfPlane>(shape)) return {{-reach, 0.0}, {reach, 0.0}};
  if (const auto* terrain = std::get_if<Terrain>(&shape)) return terrain->points;
  if (const auto* r = std::get_if<Rectangle>(&shape)) {
    points = {{r->half_width, r->half_height},
              {-r->half_width, r->half_height},
              {-r->half_width, -r->half_height},
              {r->half_width, -r->half_height}};
  } else {
    const auto* circle = std::get_if<Circle>(&shape);
    const Superquadric round =
        circle ? Superquadric{circle->radius, circle->radius, 2.0} : std::get<Superquadric>(shape);
    for (int i = 0; i < parts; ++i)
      points.push_back(boundary_point(round, 2.0 * std::numbers::pi * i / parts));
  }
  points.push_back(points.front());
  return points;
}

}  // namespace talus
