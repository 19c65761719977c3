#include "solver/scenes/fence_element.hpp"

#include <utility>

#include "solver/geometry/gap.hpp"

namespace talus::scenes {
namespace {

/// 1993 replaced power 0 by this value: exponent 2/0.1 = 20 (fitted to the listing of sample2).
constexpr double blunt_power = 0.1;

/// Exponent of an outline other than a rectangle.
double exponent(const FenceElement& e) {
  if (e.outline == ElementOutline::ellipse) return 2.0;
  if (e.outline == ElementOutline::superquadric) return e.exponent;
  if (e.power == 0.0) return e.solid == ElementSolid::ellipsoid ? 2.0 : 2.0 / blunt_power;
  return 2.0 / e.power;
}

/// The exact outline. A circle is a shape with a simpler gap, but with the nodes of 1993 a circle described by a power
/// keeps the nodes of its superquadric.
Shape outline(const FenceElement& e, FenceContact contact) {
  if (e.outline == ElementOutline::rectangle) return Rectangle{e.a, e.b};
  const double n = exponent(e);
  const bool of_nodes = contact != FenceContact::resultant && e.outline == ElementOutline::by_power && e.power != 0.0;
  if (n == 2.0 && e.a == e.b && !of_nodes) return Circle{e.a};
  return Superquadric{e.a, e.b, n};
}

/// Mobility that an element's fixities leave; the fixed point is the pin.
Mobility mobility(const FenceElement& e) {
  const auto [x, y, turn] = e.held;
  if (x && y) return turn ? Mobility::fixed : Mobility::pinned;
  if (x) return turn ? Mobility::sliding_y : Mobility::guided_y;
  if (y) return turn ? Mobility::sliding_x : Mobility::guided_x;
  return turn ? Mobility::particle : Mobility::free;
}

}  // namespace

MassProperties mass_properties(const FenceElement& e) {
  switch (e.solid) {
    case ElementSolid::ellipsoid:
      return ellipsoid(e.a, e.b, e.density);
    case ElementSolid::block:
      return block(e.a, e.b, e.density);
    case ElementSolid::cylinder:
      break;
  }
  return cylinder(e.a, e.b, e.density);
}

int node_count(const FenceElement& e) { return 4 * (e.points - 1); }

Body body(const FenceElement& e, std::string name, FenceContact contact) {
  const MassProperties solid = mass_properties(e);
  Body made{.name = std::move(name), .mass = solid.mass, .inertia = solid.inertia};
  made.mobility = mobility(e);
  made.shape = outline(e, contact);
  made.p_WB = e.position;
  made.angle = e.angle;
  made.p_BPin = e.fixed_point;
  if (made.mobility != Mobility::fixed) made.force = e.force;
  if (turns(made.mobility)) made.moment = e.moment;
  return made;
}

double height_over(const Body& ground, const Pose& pose, Vec2 p) {
  if (const auto* terrain = std::get_if<Terrain>(&ground.shape)) return -depth_below(*terrain, p - pose.p_WB).depth;
  return dot(p - pose.p_WB, pose.R_WB * Vec2{0.0, 1.0});
}

}  // namespace talus::scenes
