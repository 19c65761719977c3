#include "verification/study/scenes/moved_scene.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "solver/model/layout.hpp"
#include "verification/study/findings/expectations.hpp"

namespace talus::verification::problems {
namespace {

bool turns_axes(const Viewpoint& view) { return view.turn.cosine == 0.0; }

Mobility seen(Mobility mobility, const Viewpoint& view) {
  if (!turns_axes(view)) return mobility;
  switch (mobility) {
    case Mobility::sliding_x:
      return Mobility::sliding_y;
    case Mobility::sliding_y:
      return Mobility::sliding_x;
    case Mobility::guided_x:
      return Mobility::guided_y;
    case Mobility::guided_y:
      return Mobility::guided_x;
    default:
      return mobility;
  }
}

/// Point in a body's frame, which is mirrored with the body.
Vec2 on_body(Vec2 p, const Viewpoint& view) { return view.mirrored ? Vec2{-p.x, p.y} : p; }

void see_end(CableEnd& end, const Viewpoint& view) {
  const Vec2 p = end.body ? on_body(in_plane(end.p), view) : view.point(in_plane(end.p));
  end.p = {p.x, p.y, end.p.z};
}

void see_friction(const Model& model, const Layout& layout, State& state) {
  for (std::size_t c = 0; c < model.contacts.size(); ++c) {
    if (!model.contacts[c].friction || model.contacts[c].method == ContactMethod::nodes) continue;
    const Slot slot = layout.friction_slots[c];
    state.z[slot.memory] = -state.z[slot.memory];
    Mode& mode = state.mode[slot.mode];
    if (mode == CoulombFriction::slipping_forward || mode == CoulombFriction::slipping_backward)
      mode = mode == CoulombFriction::slipping_forward ? CoulombFriction::slipping_backward
                                                       : CoulombFriction::slipping_forward;
  }
}

BodyId reversed(BodyId id, const Model& model) { return static_cast<BodyId>(model.bodies.size() - 1 - index(id)); }

}  // namespace

Model seen(Model model, const Viewpoint& view) {
  model.gravity = view.direction(model.gravity);
  for (Body& body : model.bodies) {
    body.p_WB = view.point(body.p_WB);
    body.angle = view.sense(body.angle) + view.angle;
    body.p_BPin = on_body(body.p_BPin, view);
    body.force = view.direction(body.force);
    body.moment = view.sense(body.moment);
    body.mobility = seen(body.mobility, view);
    if (auto* terrain = std::get_if<Terrain>(&body.shape); terrain && view.mirrored) {
      for (Vec2& point : terrain->points)
        point = on_body(point, view);
      std::ranges::reverse(terrain->points);
    }
  }
  for (Cable& cable : model.cables) {
    see_end(cable.a, view);
    see_end(cable.b, view);
  }
  for (Hanger& hanger : model.hangers) {
    const Vec2 p = on_body(in_plane(hanger.p), view);
    hanger.p = {p.x, p.y, hanger.p.z};
  }
  return model;
}

State seen(const Model& model, State state, const Viewpoint& view) {
  const Layout layout{model};
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    const Mobility mobility = model.bodies[i].mobility;
    double* q = state.q.data() + layout.first[i];
    double* v = state.v.data() + layout.first[i];
    const bool x = has_x(mobility), y = has_y(mobility);
    if (x || y) {
      const Vec2 still = model.bodies[i].p_WB;
      const Vec2 p = view.point({x ? q[0] : still.x, y ? q[x ? 1 : 0] : still.y}) + state.t * view.boost;
      const Vec2 u = view.direction({x ? v[0] : 0.0, y ? v[x ? 1 : 0] : 0.0}) + view.boost;
      const bool along_x = turns_axes(view) ? y : x, along_y = turns_axes(view) ? x : y;
      if (along_x) *q++ = p.x, *v++ = u.x;
      if (along_y) *q++ = p.y, *v++ = u.y;
    }
    if (!turns(mobility)) continue;
    *q = view.sense(*q) + view.angle;
    *v = view.sense(*v);
  }
  if (view.mirrored) see_friction(model, layout, state);
  const Vec2 impulse = view.direction({state.impulse[0], state.impulse[1]});
  state.impulse = {impulse.x, impulse.y, view.sense(state.impulse[2]) + cross(view.shift, impulse)};
  return state;
}

Scene with_bodies_reversed(const Scene& scene) {
  Scene other = scene;
  Model& model = other.model;
  std::ranges::reverse(model.bodies);
  for (Contact& contact : model.contacts)
    contact.a = reversed(contact.a, model), contact.b = reversed(contact.b, model);
  for (Cable& cable : model.cables) {
    for (CableEnd* end : {&cable.a, &cable.b}) {
      if (end->body) end->body = reversed(*end->body, model);
    }
  }
  for (Hanger& hanger : model.hangers)
    hanger.body = reversed(hanger.body, model);
  const Layout from{scene.model}, to{model};
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    const std::size_t was = model.bodies.size() - 1 - i;
    for (std::size_t k = 0; k < to.first[i + 1] - to.first[i]; ++k) {
      other.initial.q[to.first[i] + k] = scene.initial.q[from.first[was] + k];
      other.initial.v[to.first[i] + k] = scene.initial.v[from.first[was] + k];
    }
  }
  return other;
}

Scene with_contacts_swapped(const Scene& scene) {
  Scene other = scene;
  std::ranges::reverse(other.model.contacts);
  for (Contact& contact : other.model.contacts) {
    std::swap(contact.a, contact.b);
    std::swap(contact.nodes[0], contact.nodes[1]);
  }
  State rest = rest_state(other.model);
  rest.q = scene.initial.q;
  rest.v = scene.initial.v;
  other.initial = rest;
  return other;
}

Difference difference(const State& one, const State& other) {
  Difference maximum;
  for (std::size_t i = 0; i < one.q.size(); ++i) {
    keep_largest(maximum.position, one.q[i] - other.q[i]);
    keep_largest(maximum.velocity, one.v[i] - other.v[i]);
  }
  return maximum;
}

int differing_motion(const State& one, const State& other) {
  int count = 0;
  for (std::size_t i = 0; i < one.q.size(); ++i)
    count += (one.q[i] == other.q[i] ? 0 : 1) + (one.v[i] == other.v[i] ? 0 : 1);
  return count;
}

}  // namespace talus::verification::problems
