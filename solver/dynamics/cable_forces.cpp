#include "solver/dynamics/cable_forces.hpp"

#include <utility>
#include <variant>

#include "solver/dynamics/law_modes.hpp"

namespace talus {
namespace {

CableForces::End compiled(const CableEnd& end) {
  return end.body ? CableForces::End{true, *end.body, end.p} : CableForces::End{false, {}, end.p};
}

Vec2 velocity(const CableForces::End& end, Vec3 p_W, const Workspace& work) {
  return end.on_body ? velocity_at(work.poses[index(end.body)], in_plane(p_W)) : Vec2{};
}

/// Calls visit(law, slot, cable) for each cable, law by law.
template <class Laws, class Visit>
void for_each_cable(const Laws& laws, Visit&& visit) {
  const auto each = [&](const auto& array) {
    for (std::size_t i = 0; i < array.laws.size(); ++i)
      visit(array.laws[i], array.slots[i], array.cable[i]);
  };
  std::apply([&](const auto&... array) { (each(array), ...); }, laws);
}

/// Pulls one end with the force; at a point of the world the anchor takes it, which is an impulse from outside.
void pull(const CableForces::End& end, Vec2 force, Workspace& work, Rates* out) {
  if (end.on_body) {
    const Vec2 p_W = in_plane(position(end, work));
    add_force(work.wrenches[index(end.body)], work.poses[index(end.body)].p_WB, p_W, force);
  } else if (out) {
    out->impulse[0] -= force.x;
    out->impulse[1] -= force.y;
    out->impulse[2] -= cross(in_plane(end.p), force);
  }
}

}  // namespace

Vec3 position(const CableForces::End& end, const Workspace& work) {
  if (!end.on_body) return end.p;
  const Vec2 p = world_point(work.poses[index(end.body)], in_plane(end.p));
  return {p.x, p.y, end.p.z};
}

CableForces::CableForces(const Model& model, const Layout& layout) {
  for (std::size_t c = 0; c < model.cables.size(); ++c) {
    const Cable& cable = model.cables[c];
    ends_.push_back({compiled(cable.a), compiled(cable.b)});
    rest_lengths_.push_back(cable.rest_length);
    std::visit(
        [&](const auto& law) {
          auto& array = std::get<CableArray<std::decay_t<decltype(law)>>>(laws_);
          array.cable.push_back(c);
          array.laws.push_back(law);
          array.slots.push_back(layout.cable_slots[c]);
          tangents_.push_back(law.tangent());
        },
        cable.law);
  }
}

void CableForces::update(Workspace& work) const {
  for (std::size_t c = 0; c < ends_.size(); ++c) {
    const Vec3 p_WA = position(ends_[c].a, work);
    const Vec3 p_WB = position(ends_[c].b, work);
    work.paths[c] = path(p_WA, velocity(ends_[c].a, p_WA, work), p_WB, velocity(ends_[c].b, p_WB, work));
  }
}

void CableForces::settle(State& state, const Workspace& work) const {
  for_each_cable(laws_, [&](const auto& law, Slot slot, std::size_t c) {
    settle_mode(law, slot, {elongation(work, c), work.paths[c].length_rate}, state, Mechanism::cable_release);
  });
}

void CableForces::add(const State& state, Workspace& work, Rates* out) const {
  for_each_cable(laws_, [&]<class L>(const L& law, Slot slot, std::size_t c) {
    const Mode mode = state.mode[slot.mode];
    if (mode == 0) return;
    const Path& path = work.paths[c];
    const LawForce tension = law({elongation(work, c), path.length_rate}, memory<L>(state, slot), mode);
    const Vec2 on_a = tension.total() * path.pull_A;
    pull(ends_[c].a, on_a, work, out);
    pull(ends_[c].b, -on_a, work, out);
    if (out) out->work[static_cast<std::size_t>(Mechanism::cable_damping)] += tension.dissipative * path.length_rate;
  });
}

void CableForces::guards(const State& state, const Workspace& work, std::span<double> out) const {
  for_each_cable(laws_, [&]<class L>(const L& law, Slot slot, std::size_t c) {
    out[slot.mode] =
        law.guard({elongation(work, c), work.paths[c].length_rate}, memory<L>(state, slot), state.mode[slot.mode]);
  });
}

double CableForces::stored_energy(const State& state, const Workspace& work) const {
  double sum = 0.0;
  for_each_cable(laws_, [&]<class L>(const L& law, Slot slot, std::size_t c) {
    sum += law.stored_energy({elongation(work, c), work.paths[c].length_rate}, memory<L>(state, slot),
                             state.mode[slot.mode]);
  });
  return sum;
}

void CableForces::tensions(const State& state, const Workspace& work, std::span<double> out) const {
  for_each_cable(laws_, [&]<class L>(const L& law, Slot slot, std::size_t c) {
    out[c] =
        law({elongation(work, c), work.paths[c].length_rate}, memory<L>(state, slot), state.mode[slot.mode]).total();
  });
}

}  // namespace talus
