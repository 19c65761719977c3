#include "solver/model/model.hpp"

#include <algorithm>

#include "solver/geometry/pose.hpp"

namespace talus {
namespace {

template <class Id, class Item>
std::optional<Id> find(const std::vector<Item>& items, std::string_view name) {
  const auto found = std::find_if(items.begin(), items.end(), [name](const Item& item) { return item.name == name; });
  if (found == items.end()) return std::nullopt;
  return static_cast<Id>(found - items.begin());
}

}  // namespace

std::optional<BodyId> find_body(const Model& model, std::string_view name) { return find<BodyId>(model.bodies, name); }
std::optional<CableId> find_cable(const Model& model, std::string_view name) {
  return find<CableId>(model.cables, name);
}
std::optional<ContactId> find_contact(const Model& model, std::string_view name) {
  return find<ContactId>(model.contacts, name);
}

bool ends_at(const CableEnd& end, const Hanger& hanger) { return end.body == hanger.body && end.p == hanger.p; }

double inertia_about_pin(const Body& body) { return body.inertia + body.mass * dot(body.p_BPin, body.p_BPin); }

Vec2 pin(const Body& body) { return body.p_WB + rotation(body.angle) * body.p_BPin; }

Vec3 reference_point(const Model& model, const CableEnd& end) {
  if (!end.body) return end.p;
  const Body& body = model.bodies[index(*end.body)];
  const Vec2 p = body.p_WB + rotation(body.angle) * in_plane(end.p);
  return {p.x, p.y, end.p.z};
}

}  // namespace talus
