#include "solver/dynamics/cable_forces.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "solver/dynamics/law_modes.hpp"

namespace talus {
namespace {

/// Calls visit(array, law's place in the list) for each law's cables.
template <class Laws, class Visit>
void for_each_array(const Laws& laws, Visit&& visit) {
  std::size_t law = 0;
  std::apply([&](const auto&... array) { (visit(array, law++), ...); }, laws);
}

/// Calls visit(law, slot, cable) for each cable, law by law.
template <class Laws, class Visit>
void for_each_cable(const Laws& laws, Visit&& visit) {
  for_each_array(laws, [&](const auto& array, std::size_t) {
    for (std::size_t i = 0; i < array.laws.size(); ++i)
      visit(array.laws[i], array.slots[i], array.cable[i]);
  });
}

/// The same for the cables that are listed as awake.
template <class Laws, class Visit>
void for_each_awake(const Laws& laws, const Waking& waking, Visit&& visit) {
  for_each_array(laws, [&](const auto& array, std::size_t law) {
    for (const std::size_t i : waking.cables[law])
      visit(array.laws[i], array.slots[i], array.cable[i]);
  });
}

double body_copies(const Model& model, const Joint& joint) {
  return joint.on_body ? model.bodies[index(joint.body)].copies : 1.0;
}

}  // namespace

std::size_t CableForces::joint(const CableEnd& end) {
  const Joint wanted{end.body.has_value(), end.body.value_or(BodyId{}), in_plane(end.p), end.p.z};
  const auto found = std::find(joints_.begin(), joints_.end(), wanted);
  if (found != joints_.end()) return static_cast<std::size_t>(found - joints_.begin());
  joints_.push_back(wanted);
  return joints_.size() - 1;
}

CableForces::CableForces(const Model& model, const Layout& layout) {
  for (std::size_t c = 0; c < model.cables.size(); ++c) {
    const Cable& cable = model.cables[c];
    const std::size_t a = joint(cable.a), b = joint(cable.b);
    const double across = joints_[b].along - joints_[a].along;
    ends_.push_back(
        {a, b, cable.copies / body_copies(model, joints_[a]), cable.copies / body_copies(model, joints_[b])});
    across_squared_.push_back(across * across);
    rest_lengths_.push_back(cable.rest_length);
    copies_.push_back(cable.copies);
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

void CableForces::list_awake(Waking& waking) const {
  std::vector<char> listed(joints_.size(), 0);
  const auto moves = [&](std::size_t j) { return joints_[j].on_body && waking.awake[index(joints_[j].body)]; };
  waking.cables.resize(std::tuple_size_v<decltype(laws_)>);
  for_each_array(laws_, [&](const auto& array, std::size_t law) {
    waking.cables[law].clear();
    for (std::size_t i = 0; i < array.laws.size(); ++i) {
      const auto [a, b, share_a, share_b] = ends_[array.cable[i]];
      if (!waking.whole && !moves(a) && !moves(b)) continue;
      waking.cables[law].push_back(i);
      listed[a] = listed[b] = 1;
    }
  });
  waking.joints.clear();
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    if (listed[j]) waking.joints.push_back(j);
  }
}

void CableForces::update(Workspace& work) const {
  for (const std::size_t j : work.waking.joints) {
    const Joint& joint = joints_[j];
    if (!joint.on_body) {
      work.joints[j].p_WP = joint.p;
      continue;
    }
    const Pose& body = work.poses[index(joint.body)];
    const Vec2 arm = body.R_WB * joint.p;
    work.joints[j] = {body.p_WB + arm, arm, body.v_WB + cross(body.w_WB, arm), {}};
  }
  for_each_awake(laws_, work.waking, [&](const auto&, Slot, std::size_t c) {
    const JointPoint& a = work.joints[ends_[c].a];
    const JointPoint& b = work.joints[ends_[c].b];
    work.paths[c] = path(a.p_WP, a.v_WP, b.p_WP, b.v_WP, across_squared_[c]);
  });
}

void CableForces::settle(State& state, const Workspace& work) const {
  for_each_awake(laws_, work.waking, [&](const auto& law, Slot slot, std::size_t c) {
    settle_mode(law, slot, kinematics(work, c), state, copies_[c]);
  });
}

void CableForces::add(const State& state, Workspace& work, Rates* out) const {
  for (const std::size_t j : work.waking.joints)
    work.joints[j].force = {};
  for_each_awake(laws_, work.waking, [&]<class L>(const L& law, Slot slot, std::size_t c) {
    const Mode mode = state.mode[slot.mode];
    if (mode == 0) return;
    const Path& path = work.paths[c];
    const LawForce tension = law(kinematics(work, c), memory<L>(state, slot), mode);
    const Vec2 pull = tension.total() * path.pull_A;
    work.joints[ends_[c].a].force += ends_[c].share_a * pull;
    work.joints[ends_[c].b].force -= ends_[c].share_b * pull;
    if (out) out->work[static_cast<std::size_t>(L::dissipation)] += copies_[c] * tension.dissipative * path.length_rate;
  });
  for (const std::size_t j : work.waking.joints) {
    if (!joints_[j].on_body) continue;
    const JointPoint& joint = work.joints[j];
    Wrench& wrench = work.wrenches[index(joints_[j].body)];
    wrench.force += joint.force;
    wrench.moment += cross(joint.arm, joint.force);
  }
  if (!out) return;
  // Anchors take the pull: an impulse from outside. Those of sleeping cables keep the pull of their last evaluation.
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    if (joints_[j].on_body) continue;
    const JointPoint& joint = work.joints[j];
    out->impulse[0] -= joint.force.x;
    out->impulse[1] -= joint.force.y;
    out->impulse[2] -= cross(joint.p_WP, joint.force);
  }
}

void CableForces::keep_rest(const State& state, const Workspace& work) {
  rest_pulls_.resize(size());
  for_each_cable(laws_, [&]<class L>(const L& law, Slot slot, std::size_t c) {
    const double tension = law(kinematics(work, c), memory<L>(state, slot), state.mode[slot.mode]).total();
    rest_pulls_[c] = tension * work.paths[c].pull_A;
  });
}

void CableForces::list_woken(const State& state, const Workspace& work, double share,
                             std::vector<BodyId>& woken) const {
  const auto sleeps = [&](std::size_t j) { return joints_[j].on_body && !work.waking.awake[index(joints_[j].body)]; };
  for_each_awake(laws_, work.waking, [&]<class L>(const L& law, Slot slot, std::size_t c) {
    const bool a = sleeps(ends_[c].a), b = sleeps(ends_[c].b);
    if (a == b) return;
    const double tension = law(kinematics(work, c), memory<L>(state, slot), state.mode[slot.mode]).total();
    const Vec2 change = tension * work.paths[c].pull_A - rest_pulls_[c];
    if (std::max(std::abs(change.x), std::abs(change.y)) > share * tension)
      woken.push_back(joints_[a ? ends_[c].a : ends_[c].b].body);
  });
}

void CableForces::guards(const State& state, const Workspace& work, std::span<double> out) const {
  for_each_cable(laws_, [&]<class L>(const L& law, Slot slot, std::size_t c) {
    out[slot.mode] = law.guard(kinematics(work, c), memory<L>(state, slot), state.mode[slot.mode]);
  });
}

double CableForces::stored_energy(const State& state, const Workspace& work) const {
  double sum = 0.0;
  for_each_cable(laws_, [&]<class L>(const L& law, Slot slot, std::size_t c) {
    sum += copies_[c] * law.stored_energy(kinematics(work, c), memory<L>(state, slot), state.mode[slot.mode]);
  });
  return sum;
}

void CableForces::tensions(const State& state, const Workspace& work, std::span<double> out) const {
  for_each_cable(laws_, [&]<class L>(const L& law, Slot slot, std::size_t c) {
    out[c] = law(kinematics(work, c), memory<L>(state, slot), state.mode[slot.mode]).total();
  });
}

}  // namespace talus
