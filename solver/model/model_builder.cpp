#include "solver/model/model_builder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "solver/base/error.hpp"
#include "solver/model/reach.hpp"

namespace talus {
namespace {

void check_name(std::string_view kind, const std::string& name, const std::set<std::string, std::less<>>& used) {
  if (name.empty()) throw InputError{fmt::format("a {} has no name; each requires a unique one", kind)};
  if (used.contains(name)) throw InputError{fmt::format("{} '{}' exists already; names must differ", kind, name)};
}

void check_number(std::string_view kind, std::string_view name, std::string_view field, Range range, double value) {
  if (std::isfinite(value) && contains(range, value)) return;
  throw InputError{fmt::format("{} '{}': {} is {}; it must be {}", kind, name, field, value, text_of(range))};
}

template <class T>
void check_fields(std::string_view kind, std::string_view name, const T& value) {
  for (const auto& field : T::fields())
    check_number(kind, name, field.name, field.range, value.*field.member);
}

void check_vector(std::string_view kind, std::string_view name, std::string_view field, Vec2 value) {
  check_number(kind, name, field, Range::any, value.x);
  check_number(kind, name, field, Range::any, value.y);
}

template <class L>
void check_orders(std::string_view kind, std::string_view name, const L& law) {
  if constexpr (HasOrders<L>) {
    for (const auto& order : L::orders()) {
      if (law.*order.larger >= law.*order.smaller) continue;
      throw InputError{fmt::format("{} '{}': {} is {}; it must be >= {}, which is {}", kind, name,
                                   field_name(order.larger), law.*order.larger, field_name(order.smaller),
                                   law.*order.smaller)};
    }
  }
}

template <HasYieldTable L>
void check_table(std::string_view cable, const L& law) {
  YieldPoint before{0.0, law.yield};
  for (const YieldPoint& point : law.table) {
    if (!(point.stretch > before.stretch && point.force >= before.force && std::isfinite(point.force))) {
      throw InputError{
          fmt::format("cable '{}': table has ({:.6g}, {:.6g}) after ({:.6g}, {:.6g}); stretches must grow "
                      "and forces not fall, from (0, yield) on",
                      cable, point.stretch, point.force, before.stretch, before.force)};
    }
    before = point;
  }
}

std::string_view shape_name(const Shape& shape) {
  return std::visit([](const auto& s) { return s.name; }, shape);
}

/// True for ground: a shape that fills everything below a line.
bool is_ground(const Shape& shape) {
  return std::holds_alternative<HalfPlane>(shape) || std::holds_alternative<Terrain>(shape);
}

void check_terrain(std::string_view body, const Terrain& terrain) {
  if (terrain.points.size() < 2)
    throw InputError{
        fmt::format("body '{}': terrain has {} points; it needs two or more", body, terrain.points.size())};
  for (std::size_t i = 0; i + 1 < terrain.points.size(); ++i) {
    const Vec2 one = terrain.points[i], next = terrain.points[i + 1];
    if (next.x > one.x && std::isfinite(next.x) && std::isfinite(one.x) && std::isfinite(next.y) &&
        std::isfinite(one.y))
      continue;
    throw InputError{fmt::format("body '{}': terrain has x = {:.6g} after {:.6g}; x must grow from point to point",
                                 body, next.x, one.x)};
  }
}

/// True if the solver has a gap function for the two shapes with this method.
bool has_gap(const Shape& a, const Shape& b, ContactMethod method) {
  const auto is_box = [](const Shape& s) { return std::holds_alternative<Rectangle>(s); };
  const auto is_plane = [](const Shape& s) { return std::holds_alternative<HalfPlane>(s); };
  const auto is_outline = [](const Shape& s) { return std::holds_alternative<Superquadric>(s); };
  const auto is_round = [](const Shape& s) { return std::holds_alternative<Circle>(s); };
  const bool outlined = !std::holds_alternative<NoShape>(a) && !std::holds_alternative<NoShape>(b);
  if (method == ContactMethod::nodes) return outlined && !(is_ground(a) && is_ground(b));
  const auto is_angular = [&](const Shape& s) { return is_box(s) || is_outline(s); };
  return outlined && (is_round(a) || is_round(b) || (is_angular(a) && (is_angular(b) || is_plane(b))) ||
                      (is_plane(a) && is_angular(b)));
}

/// Checks that the geometry gives a law that acts at a distance a true distance. Errors: InputError.
void check_reach(const Contact& contact, std::string_view law, const Shape& a, const Shape& b) {
  const std::string refusal_reason = reach_error(contact.method, contact.node_depth, a, b);
  if (!refusal_reason.empty())
    throw InputError{fmt::format("contact '{}': law {}: {}", contact.name, law, refusal_reason)};
}

/// True if two cables in series have the same tension when the elongation divides between them by their compliances.
bool one_tension(const CableLaw& a, const CableLaw& b) {
  const auto tangent = [](const CableLaw& law) { return std::visit([](const auto& l) { return l.tangent(); }, law); };
  const double one = tangent(a).damping * tangent(b).stiffness, other = tangent(b).damping * tangent(a).stiffness;
  const auto largest_yield = [](const CableLaw& law) {
    return std::visit(
        []<class L>(const L& l) {
          if constexpr (Yields<L>) return l.largest_yield();
          return std::numeric_limits<double>::infinity();
        },
        law);
  };
  // Cables with different plastic elongations still reach the same largest force.
  const bool yield_alike = largest_yield(a) == largest_yield(b);
  return a.index() == b.index() && yield_alike && std::abs(one - other) <= 1e-12 * std::abs(one + other);
}

/// Checks the cables at a hanger: one, or two that can continue as one.
void check_hanger(const Hanger& hanger, const Model& model) {
  std::vector<const Cable*> cables;
  for (const Cable& cable : model.cables) {
    if (ends_at(cable.a, hanger) || ends_at(cable.b, hanger)) cables.push_back(&cable);
  }
  if (cables.empty() || cables.size() > 2) {
    throw InputError{
        fmt::format("hanger '{}': {} cables end at its point; it must be one or two", hanger.name, cables.size())};
  }
  if (!one_tension(cables.front()->law, cables.back()->law)) {
    throw InputError{
        fmt::format("hanger '{}': cables '{}' and '{}' must have the same law and largest yield force, and dashpots in "
                    "proportion to their stiffnesses",
                    hanger.name, cables[0]->name, cables[1]->name)};
  }
}

}  // namespace

BodyId ModelBuilder::add(Body body) {
  check_name("body", body.name, body_names_);
  const bool moves = body.mobility != Mobility::fixed;
  const bool turns = talus::turns(body.mobility);
  if (moves) check_number("body", body.name, "mass", Range::positive, body.mass);
  if (turns) check_number("body", body.name, "inertia", Range::positive, body.inertia);
  check_number("body", body.name, "angle", Range::any, body.angle);
  check_number("body", body.name, "moment", Range::any, body.moment);
  check_vector("body", body.name, "position", body.p_WB);
  check_vector("body", body.name, "pin", body.p_BPin);
  check_vector("body", body.name, "force", body.force);
  std::visit([&](const auto& shape) { check_fields("body", body.name, shape); }, body.shape);
  if (const auto* outline = std::get_if<Superquadric>(&body.shape); outline && !(outline->exponent > 1.0)) {
    throw InputError{fmt::format("body '{}': exponent is {}; it must be > 1", body.name, outline->exponent)};
  }
  if (!moves && !(body.force == Vec2{}))
    throw InputError{fmt::format("body '{}': a fixed body takes no force", body.name)};
  if (!turns && body.moment != 0.0)
    throw InputError{fmt::format("body '{}': it cannot turn and takes no moment", body.name)};
  if (body.sleeps && body.mobility != Mobility::free) {
    throw InputError{fmt::format("body '{}': only a free body can sleep", body.name)};
  }
  if (moves && is_ground(body.shape)) {
    throw InputError{
        fmt::format("body '{}': a {} cannot move; its mobility must be fixed", body.name, shape_name(body.shape))};
  }
  if (const auto* terrain = std::get_if<Terrain>(&body.shape)) check_terrain(body.name, *terrain);
  body_names_.insert(body.name);
  model_.bodies.push_back(std::move(body));
  return static_cast<BodyId>(model_.bodies.size() - 1);
}

CableId ModelBuilder::add(Cable cable) {
  check_name("cable", cable.name, cable_names_);
  for (const CableEnd& end : {cable.a, cable.b}) {
    TALUS_DEMAND(!end.body || index(*end.body) < model_.bodies.size());
    check_vector("cable", cable.name, "end", in_plane(end.p));
    check_number("cable", cable.name, "end", Range::any, end.p.z);
  }
  check_number("cable", cable.name, "rest_length", Range::non_negative, cable.rest_length);
  std::visit(
      [&]<class L>(const L& law) {
        check_fields("cable", cable.name, law);
        check_orders("cable", cable.name, law);
        if constexpr (HasYieldTable<L>) check_table(cable.name, law);
      },
      cable.law);
  const auto moves = [this](const CableEnd& end) {
    return end.body && model_.bodies[index(*end.body)].mobility != Mobility::fixed;
  };
  if (!moves(cable.a) && !moves(cable.b)) {
    throw InputError{
        fmt::format("cable '{}': neither end can move; at least one must be on a body that does", cable.name)};
  }
  if (norm(reference_point(model_, cable.b) - reference_point(model_, cable.a)) == 0.0) {
    throw InputError{fmt::format("cable '{}': both ends are at the same point; they must be apart", cable.name)};
  }
  cable_names_.insert(cable.name);
  model_.cables.push_back(std::move(cable));
  return static_cast<CableId>(model_.cables.size() - 1);
}

ContactId ModelBuilder::add(Contact contact) {
  check_name("contact", contact.name, contact_names_);
  TALUS_DEMAND(index(contact.a) < model_.bodies.size() && index(contact.b) < model_.bodies.size());
  const Body& a = model_.bodies[index(contact.a)];
  const Body& b = model_.bodies[index(contact.b)];
  if (contact.a == contact.b) {
    throw InputError{fmt::format("contact '{}': body '{}' against itself; name two bodies", contact.name, a.name)};
  }
  if (a.mobility == Mobility::fixed && b.mobility == Mobility::fixed) {
    throw InputError{fmt::format("contact '{}': neither '{}' nor '{}' can move", contact.name, a.name, b.name)};
  }
  if (!has_gap(a.shape, b.shape, contact.method)) {
    throw InputError{
        fmt::format("contact '{}': no contact between shapes '{}' and '{}' by method '{}'; known pairs: circle "
                    "with circle, rectangle, superquadric, half_plane, terrain; rectangle and superquadric with "
                    "rectangle, superquadric, half_plane",
                    contact.name, shape_name(a.shape), shape_name(b.shape), name_of(contact.method))};
  }
  if (contact.method == ContactMethod::nodes &&
      (std::ranges::any_of(contact.nodes, [](int n) { return n < 3 || n > 100000; }))) {
    throw InputError{fmt::format("contact '{}': nodes is {}, {}; each must be from 3 to 100000", contact.name,
                                 contact.nodes[0], contact.nodes[1])};
  }
  std::visit(
      [&]<class L>(const L& law) {
        check_fields("contact", contact.name, law);
        check_orders("contact", contact.name, law);
        if constexpr (HasDampingRatio<L>)
          check_number("contact", contact.name, "damping_ratio", Range::non_negative, law.damping_ratio);
        if (reach(law) > 0.0) check_reach(contact, L::name, a.shape, b.shape);
      },
      contact.law);
  if (contact.friction)
    std::visit([&](const auto& law) { check_fields("contact", contact.name, law); }, *contact.friction);
  contact_names_.insert(contact.name);
  model_.contacts.push_back(std::move(contact));
  return static_cast<ContactId>(model_.contacts.size() - 1);
}

HangerId ModelBuilder::add(Hanger hanger) {
  check_name("hanger", hanger.name, hanger_names_);
  TALUS_DEMAND(index(hanger.body) < model_.bodies.size());
  check_number("hanger", hanger.name, "strength", Range::positive, hanger.strength);
  const Body& body = model_.bodies[index(hanger.body)];
  if (body.mobility == Mobility::fixed) {
    throw InputError{fmt::format("hanger '{}': body '{}' is fixed; what hangs must move", hanger.name, body.name)};
  }
  for (const Hanger& other : model_.hangers) {
    if (other.body != hanger.body || !(other.p == hanger.p)) continue;
    throw InputError{
        fmt::format("hanger '{}': it is at the point of hanger '{}'; a point has one", hanger.name, other.name)};
  }
  check_hanger(hanger, model_);
  hanger_names_.insert(hanger.name);
  model_.hangers.push_back(std::move(hanger));
  return static_cast<HangerId>(model_.hangers.size() - 1);
}

Model ModelBuilder::build() const {
  if (!std::isfinite(model_.gravity.x) || !std::isfinite(model_.gravity.y)) throw InputError{"gravity must be finite"};
  if (model_.bodies.empty()) throw InputError{"the scene has no body; it needs at least one"};
  // Cables may have been added after the hangers.
  for (const Hanger& hanger : model_.hangers)
    check_hanger(hanger, model_);
  return model_;
}

}  // namespace talus
