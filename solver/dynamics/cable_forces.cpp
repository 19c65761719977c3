#include "solver/dynamics/cable_forces.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "solver/dynamics/law_modes.hpp"

namespace talus {
namespace {

/// Calls visit(law, slot, cable) for each cable, law by law.
template <class Laws, class Visit>
void for_each_cable(const Laws& laws, Visit&& visit) {
  const auto each = [&](const auto& array) {
    for (std::size_t i = 0; i < array.laws.size(); ++i)
      visit(array.laws[i], array.slots[i], array.cable[i]);
  };
  std::apply([&](const auto&... array) { (each(array), ...); }, laws);
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

void CableForces::update(Workspace& work) const {
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const Joint& joint = joints_[j];
    if (!joint.on_body) {
      work.joints[j].p_WP = joint.p;
      continue;
    }
    const Pose& body = work.poses[index(joint.body)];
    const Vec2 arm = body.R_WB * joint.p;
    work.joints[j] = {body.p_WB + arm, arm, body.v_WB + cross(body.w_WB, arm), {}};
  }
  for (std::size_t c = 0; c < ends_.size(); ++c) {
    const JointPoint& a = work.joints[ends_[c].a];
    const JointPoint& b = work.joints[ends_[c].b];
    work.paths[c] = path(a.p_WP, a.v_WP, b.p_WP, b.v_WP, across_squared_[c]);
  }
}

void CableForces::settle(State& state, const Workspace& work) const {
  for_each_cable(laws_, [&](const auto& law, Slot slot, std::size_t c) {
    settle_mode(law, slot, kinematics(work, c), state, copies_[c]);
  });
}

void CableForces::add(const State& state, Workspace& work, Rates* out) const {
  for (JointPoint& joint : work.joints)
    joint.force = {};
  for_each_cable(laws_, [&]<class L>(const L& law, Slot slot, std::size_t c) {
    const Mode mode = state.mode[slot.mode];
    if (mode == 0) return;
    const Path& path = work.paths[c];
    const LawForce tension = law(kinematics(work, c), memory<L>(state, slot), mode);
    const Vec2 pull = tension.total() * path.pull_A;
    work.joints[ends_[c].a].force += ends_[c].share_a * pull;
    work.joints[ends_[c].b].force -= ends_[c].share_b * pull;
    if (out) out->work[static_cast<std::size_t>(L::dissipation)] += copies_[c] * tension.dissipative * path.length_rate;
  });
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const JointPoint& joint = work.joints[j];
    if (joints_[j].on_body) {
      Wrench& wrench = work.wrenches[index(joints_[j].body)];
      wrench.force += joint.force;
      wrench.moment += cross(joint.arm, joint.force);
    } else if (out) {
      // The anchor takes the pull: an impulse from outside.
      out->impulse[0] -= joint.force.x;
      out->impulse[1] -= joint.force.y;
      out->impulse[2] -= cross(joint.p_WP, joint.force);
    }
  }
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
