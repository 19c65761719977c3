#pragma once

#include "solver/dynamics/dynamics.hpp"

namespace talus {

/// Calls visit(coordinate, derivative) for each coordinate of a body: the derivative of direction . p_WP, with p_WP a
/// point of the body [1 or L/rad, times the direction].
template <class Visit>
void for_each_gradient(const Dynamics& dynamics, const Workspace& work, BodyId body, Vec2 p_WP, Vec2 direction,
                       Visit&& visit) {
  const Layout& layout = dynamics.layout();
  const Body& moved = dynamics.model().bodies[index(body)];
  Vec2 center = moved.mobility == Mobility::pinned ? pin(moved) : work.poses[index(body)].p_WB;
  // With the coordinate along its guide fixed, a guided body turns about the point that has the position of its pin
  // along the guide and that of its centre of mass across the guide.
  const Vec2 pin_now = world_point(work.poses[index(body)], moved.p_BPin);
  if (moved.mobility == Mobility::guided_x) center.x = pin_now.x;
  if (moved.mobility == Mobility::guided_y) center.y = pin_now.y;
  for (std::size_t i = layout.first[index(body)]; i < layout.first[index(body) + 1]; ++i) {
    const Axis axis = layout.coordinates[i].axis;
    visit(i, axis == Axis::x ? direction.x : axis == Axis::y ? direction.y : dot(cross(1.0, p_WP - center), direction));
  }
}

}  // namespace talus
