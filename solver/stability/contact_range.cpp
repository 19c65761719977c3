#include "solver/stability/contact_range.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <variant>

namespace talus {
namespace {

double lever(const NoShape&, Vec2) { return 0.0; }
double lever(const HalfPlane&, Vec2) { return 0.0; }
double lever(const Terrain&, Vec2) { return 0.0; }
/// All normal lines pass through the centre.
double lever(const Circle&, Vec2 point) { return norm(point); }
/// The normals at a corner lie between those of its sides.
double lever(const Rectangle& shape, Vec2 point) {
  double largest = 0.0;
  for (const double x : {shape.half_width, -shape.half_width}) {
    for (const double y : {shape.half_height, -shape.half_height}) {
      const Vec2 from = Vec2{x, y} - point;
      largest = std::max({largest, std::abs(from.x), std::abs(from.y)});
      // A normal across the line from the point to the corner.
      if (from.x * from.y * x * y < 0.0) largest = std::max(largest, norm(from));
    }
  }
  return largest;
}
double lever(const Superquadric& shape, Vec2 point) {
  constexpr int points = 2048;  // the lever is stationary at its maximum: it is missed by less than 1e-4
  double largest = 0.0;
  for (int i = 0; i < points; ++i) {
    const double t = 2.0 * std::numbers::pi * (i + 0.5) / points;
    const Vec2 p = boundary_point(shape, t);
    largest = std::max(largest, std::abs(cross(p - point, outward_normal(shape, p))));
  }
  return largest;
}

/// Bounds of the inverse effective mass of a body at a contact [1/M].
struct MobilityRange {
  double smallest{};
  double largest{};
};
MobilityRange mobility_range(const Dynamics& dynamics, BodyId id) {
  const Body& body = dynamics.model().bodies[index(id)];
  const Layout& layout = dynamics.layout();
  MobilityRange found;
  bool x = false, y = false;
  for (std::size_t i = layout.first[index(id)]; i < layout.first[index(id) + 1]; ++i) {
    const Axis axis = layout.coordinates[i].axis;
    x = x || axis == Axis::x, y = y || axis == Axis::y;
    if (axis != Axis::angle) continue;
    // A guided body yields at most as much as a free one: its guide only takes away motions.
    const bool is_pinned = body.mobility == Mobility::pinned;
    const double l = largest_lever(body.shape, is_pinned ? body.p_BPin : Vec2{});
    found.largest += l * l / (is_pinned ? dynamics.inertias()[i] : body.inertia);
  }
  if (x || y) found.largest += 1.0 / body.mass;
  if (x && y) found.smallest = 1.0 / body.mass;
  return found;
}

}  // namespace

double largest_lever(const Shape& shape, Vec2 point) {
  return std::visit([point](const auto& of) { return lever(of, point); }, shape);
}

double contact_time(const ContactLaw& law, double effective_mass) {
  if (!std::isfinite(effective_mass)) return std::numeric_limits<double>::infinity();
  return std::visit(
      [effective_mass]<class L>(const L& of) {
        if constexpr (OneSided<L> && HasLinearPart<L> && KnowsImpacts<L>) return of.contact_time(effective_mass, 0.0);
        return std::numbers::pi * std::sqrt(effective_mass / tangent(of, effective_mass).stiffness);
      },
      law);
}

std::vector<ContactRange> contact_ranges(const Dynamics& dynamics) {
  std::vector<ContactRange> ranges;
  const Model& model = dynamics.model();
  std::vector<MobilityRange> mobilities;
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    mobilities.push_back(mobility_range(dynamics, static_cast<BodyId>(b)));
  for (std::size_t c = 0; c < model.contacts.size(); ++c) {
    const Contact& contact = model.contacts[c];
    const MobilityRange &a = mobilities[index(contact.a)], &b = mobilities[index(contact.b)];
    ContactRange range{.contact = static_cast<ContactId>(c),
                       .smallest_mass = 1.0 / (a.largest + b.largest),
                       .largest_mass = 1.0 / (a.smallest + b.smallest)};
    const Tangent slopes = std::visit([&](const auto& law) { return tangent(law, range.smallest_mass); }, contact.law);
    range.highest_frequency = std::sqrt(slopes.stiffness / range.smallest_mass);
    range.damping_ratio = slopes.damping / (2.0 * std::sqrt(slopes.stiffness * range.smallest_mass));
    range.shortest_time = contact_time(contact.law, range.smallest_mass);
    ranges.push_back(range);
  }
  return ranges;
}

}  // namespace talus
