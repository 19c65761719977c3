#include "solver/dynamics/effective_mass.hpp"

namespace talus {

PointMobility::PointMobility(const Model& model) {
  bodies_.reserve(model.bodies.size());
  for (const Body& body : model.bodies)
    bodies_.push_back({body.mobility, body.mass, body.inertia, body.p_BPin});
}

// The mass matrix of a body is diagonal in its coordinates, so that the sum runs over them one by one. With r the
// vector from the centre of mass to the point, c that from the pin to the centre of mass:
//   x, y           n_x n_x/m, n_y n_y/m
//   angle, free    (r x n)^2/I
//   angle, pinned  ((r + c) x n)^2/(I + m c.c)
// Guided along x, a body turns about the point with the x of its pin and the y of its centre of mass. A turn moves the
// centre of mass by c_x along y: the inertia is I + m c_x^2, and the arm r + (c_x, 0). Guided along y: I + m c_y^2 and
// r + (0, c_y).
double PointMobility::between(BodyId body, const Pose& pose, const ImpulseLine& one, const ImpulseLine& two) const {
  const Compiled& b = bodies_[index(body)];
  const Vec2 c = pose.R_WB * (-b.p_BPin);
  const auto moving = [&](bool x, bool y) {
    return ((x ? one.n.x * two.n.x : 0.0) + (y ? one.n.y * two.n.y : 0.0)) / b.mass;
  };
  const auto turning = [&](Vec2 to_center, double inertia) {
    const auto lever = [&](const ImpulseLine& line) { return cross(line.p_WP - pose.p_WB + to_center, line.n); };
    return lever(one) * lever(two) / inertia;
  };
  switch (b.mobility) {
    case Mobility::free:
      return moving(true, true) + turning({}, b.inertia);
    case Mobility::particle:
      return moving(true, true);
    case Mobility::pinned:
      return turning(c, b.inertia + b.mass * dot(c, c));
    case Mobility::sliding_x:
      return moving(true, false);
    case Mobility::sliding_y:
      return moving(false, true);
    case Mobility::guided_x:
      return moving(true, false) + turning({c.x, 0.0}, b.inertia + b.mass * c.x * c.x);
    case Mobility::guided_y:
      return moving(false, true) + turning({0.0, c.y}, b.inertia + b.mass * c.y * c.y);
    case Mobility::fixed:
      break;
  }
  return 0.0;
}

}  // namespace talus
