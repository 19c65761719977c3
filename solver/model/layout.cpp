#include "solver/model/layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <variant>

#include "solver/base/error.hpp"

namespace talus {
namespace {

std::size_t memory_of(const auto& law) {
  return std::visit([](const auto& l) { return talus::memory_count(l); }, law);
}

/// Number of law instances of a contact. Resultant: one; for a rectangle, each corner on a half-plane, or both ends of
/// the common side with another rectangle. Nodes: one for each boundary node of either body.
std::size_t instances(const Model& model, const Contact& contact) {
  if (contact.method == ContactMethod::resultant) {
    const Shape& a = model.bodies[index(contact.a)].shape;
    const Shape& b = model.bodies[index(contact.b)].shape;
    const bool box_a = std::holds_alternative<Rectangle>(a), box_b = std::holds_alternative<Rectangle>(b);
    if (box_a && box_b) return 2;
    const bool on_plane =
        (box_a && std::holds_alternative<HalfPlane>(b)) || (box_b && std::holds_alternative<HalfPlane>(a));
    return on_plane ? 4 : 1;
  }
  return boundary_nodes(model.bodies[index(contact.a)].shape, contact.nodes[0]).size() +
         boundary_nodes(model.bodies[index(contact.b)].shape, contact.nodes[1]).size();
}

std::size_t first_coordinate(const Model& model, BodyId body) {
  std::size_t first = 0;
  for (std::size_t i = 0; i < index(body); ++i) {
    const Mobility mobility = model.bodies[i].mobility;
    first += (has_x(mobility) ? 1U : 0U) + (has_y(mobility) ? 1U : 0U) + (turns(mobility) ? 1U : 0U);
  }
  return first;
}

/// Angle of a body whose coordinates begin at `first` [rad].
double angle_at(const Body& turned, const State& state, std::size_t first) {
  if (!turns(turned.mobility)) return turned.angle;
  return state.q[first + (has_x(turned.mobility) ? 1U : 0U) + (has_y(turned.mobility) ? 1U : 0U)];
}

Pose pose_at(const Body& placed, const State& state, std::size_t first) {
  const Rotation R_WB = rotation(angle_at(placed, state, first));
  switch (placed.mobility) {
    case Mobility::free:
      return {{state.q[first], state.q[first + 1]}, R_WB, {state.v[first], state.v[first + 1]}, state.v[first + 2]};
    case Mobility::particle:
      return {{state.q[first], state.q[first + 1]}, R_WB, {state.v[first], state.v[first + 1]}, 0.0};
    case Mobility::pinned: {
      const Vec2 from_pin = R_WB * (-placed.p_BPin);
      return {pin(placed) + from_pin, R_WB, cross(state.v[first], from_pin), state.v[first]};
    }
    case Mobility::sliding_x:
      return {{state.q[first], placed.p_WB.y}, R_WB, {state.v[first], 0.0}, 0.0};
    case Mobility::sliding_y:
      return {{placed.p_WB.x, state.q[first]}, R_WB, {0.0, state.v[first]}, 0.0};
    case Mobility::guided_x: {
      const Vec2 r = R_WB * (-placed.p_BPin);
      return {
          {state.q[first], pin(placed).y + r.y}, R_WB, {state.v[first], state.v[first + 1] * r.x}, state.v[first + 1]};
    }
    case Mobility::guided_y: {
      const Vec2 r = R_WB * (-placed.p_BPin);
      return {
          {pin(placed).x + r.x, state.q[first]}, R_WB, {-state.v[first + 1] * r.y, state.v[first]}, state.v[first + 1]};
    }
    case Mobility::fixed:
      break;
  }
  return {placed.p_WB, R_WB, {}, 0.0};
}

}  // namespace

Layout::Layout(const Model& model) {
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    const auto body = static_cast<BodyId>(i);
    const Mobility mobility = model.bodies[i].mobility;
    first.push_back(coordinates.size());
    if (has_x(mobility)) coordinates.push_back({body, Axis::x});
    if (has_y(mobility)) coordinates.push_back({body, Axis::y});
    if (turns(mobility)) coordinates.push_back({body, Axis::angle});
  }
  first.push_back(coordinates.size());
  for (const Contact& contact : model.contacts) {
    contact_slots.push_back({mode_count, memory_count});
    contact_instances.push_back(instances(model, contact));
    mode_count += contact_instances.back();
    memory_count += contact_instances.back() * memory_of(contact.law);
  }
  for (const Cable& cable : model.cables) {
    cable_slots.push_back({mode_count, memory_count});
    mode_count += 1;
    memory_count += memory_of(cable.law);
  }
  for (std::size_t c = 0; c < model.contacts.size(); ++c) {
    friction_slots.push_back({mode_count, memory_count});
    if (!model.contacts[c].friction) continue;
    mode_count += contact_instances[c];
    memory_count += contact_instances[c] * talus::memory_count(*model.contacts[c].friction);
  }
  first_hanger = mode_count;
  mode_count += model.hangers.size();
  first_sleeper = mode_count;
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    if (model.sleep != Sleep::off && model.bodies[i].sleeps) sleepers.push_back(static_cast<BodyId>(i));
  }
  mode_count += sleepers.size();
}

State rest_state(const Model& model) {
  const Layout layout{model};
  State state;
  for (const Coordinate& coordinate : layout.coordinates) {
    const Body& body = model.bodies[index(coordinate.body)];
    state.q.push_back(coordinate.axis == Axis::x ? body.p_WB.x : coordinate.axis == Axis::y ? body.p_WB.y : body.angle);
  }
  state.v.assign(state.q.size(), 0.0);
  state.z.assign(layout.memory_count, 0.0);
  state.mode.assign(layout.mode_count, Mode{0});
  return state;
}

void set_velocity(const Model& model, State& state, BodyId body, Vec2 v_WB, double w_WB) {
  set_velocity(model, Layout{model}, state, body, v_WB, w_WB);
}

void set_velocity(const Model& model, const Layout& layout, State& state, BodyId body, Vec2 v_WB, double w_WB) {
  const Body& moved = model.bodies[index(body)];
  std::size_t next = layout.first[index(body)];
  const bool along_x = has_x(moved.mobility), along_y = has_y(moved.mobility);
  if ((!along_x && v_WB.x != 0.0) || (!along_y && v_WB.y != 0.0)) {
    throw InputError{fmt::format("body '{}' is {} and has no independent velocity{}; give {}", moved.name,
                                 name_of(moved.mobility),
                                 along_x   ? " along y"
                                 : along_y ? " along x"
                                           : "",
                                 turns(moved.mobility) ? "its angular velocity" : "none")};
  }
  if (!turns(moved.mobility) && w_WB != 0.0) {
    throw InputError{
        fmt::format("body '{}' is {} and cannot turn; give no angular velocity", moved.name, name_of(moved.mobility))};
  }
  if (along_x) state.v[next++] = v_WB.x;
  if (along_y) state.v[next++] = v_WB.y;
  if (turns(moved.mobility)) state.v[next] = w_WB;
  const auto sleeper = std::lower_bound(layout.sleepers.begin(), layout.sleepers.end(), body);
  if (sleeper != layout.sleepers.end() && *sleeper == body) {
    state.mode[layout.first_sleeper + static_cast<std::size_t>(sleeper - layout.sleepers.begin())] = Mode{1};
  }
}

double angle(const Model& model, const State& state, BodyId body) {
  return angle_at(model.bodies[index(body)], state, first_coordinate(model, body));
}

Pose pose(const Model& model, const State& state, BodyId body) {
  return pose_at(model.bodies[index(body)], state, first_coordinate(model, body));
}

double angle(const Model& model, const Layout& layout, const State& state, BodyId body) {
  return angle_at(model.bodies[index(body)], state, layout.first[index(body)]);
}

Pose pose(const Model& model, const Layout& layout, const State& state, BodyId body) {
  return pose_at(model.bodies[index(body)], state, layout.first[index(body)]);
}

std::string name(const Model& model, const Coordinate& coordinate) {
  constexpr std::array<std::string_view, 3> axes{"x", "y", "angle"};
  return fmt::format("{}.{}", model.bodies[index(coordinate.body)].name,
                     axes[static_cast<std::size_t>(coordinate.axis)]);
}

}  // namespace talus
