/// Hangers in CableForces: which are overloaded, and how cables continue through broken ones.
#include "solver/dynamics/cable_forces.hpp"

#include <algorithm>
#include <vector>

#include "solver/dynamics/cable_arrays.hpp"

namespace talus {

bool CableForces::update_topology(const State& state, HangerTopology& topology) const {
  if (hanger_joints_.empty()) return false;
  const auto modes = state.mode.begin() + static_cast<std::ptrdiff_t>(first_hanger_);
  const auto last = modes + static_cast<std::ptrdiff_t>(hanger_joints_.size());
  if (std::equal(topology.modes.begin(), topology.modes.end(), modes, last)) return false;
  topology.modes.assign(modes, last);
  topology.broken.assign(joints_.size(), 0);
  topology.chains.clear();
  topology.free_joints.clear();
  for (std::size_t h = 0; h < hanger_joints_.size(); ++h) {
    topology.broken[hanger_joints_[h].joint] = topology.modes[h] != 0;
    if (topology.modes[h] != 0) topology.free_joints.push_back(hanger_joints_[h].joint);
  }
  std::vector<char> used(ends_.size(), 0);
  for (std::size_t c = 0; c < ends_.size(); ++c) {
    if (used[c] || (!topology.broken[ends_[c].a] && !topology.broken[ends_[c].b])) continue;
    topology.chains.push_back(chain_from(c, topology, used));
  }
  return true;
}

/// Finds the whole chain of a cable, beginning at an end that is held if there is one.
Chain CableForces::chain_from(std::size_t cable, const HangerTopology& topology, std::vector<char>& used) const {
  used[cable] = 1;
  Chain chain{.joints = {ends_[cable].a, ends_[cable].b}, .cables = {cable}};
  extend(chain, topology, used);
  std::reverse(chain.joints.begin(), chain.joints.end());
  std::reverse(chain.cables.begin(), chain.cables.end());
  extend(chain, topology, used);
  if (topology.broken[chain.joints.back()] && !topology.broken[chain.joints.front()]) {
    std::reverse(chain.joints.begin(), chain.joints.end());
    std::reverse(chain.cables.begin(), chain.cables.end());
  }
  const std::size_t start = chain.joints.front();
  if (!topology.broken[start]) return chain;
  const std::size_t first = chain.cables.front();
  const bool mirrored =
      (ends_[first].a == start ? constants_.symmetry_weight_a : constants_.symmetry_weight_b)[first] > 1.0;
  chain.start = mirrored && !topology.broken[chain.joints.back()] ? Chain::Start::mirrored : Chain::Start::free;
  return chain;
}

/// Extends the chain from its last joint as long as that is a broken hanger with another cable.
void CableForces::extend(Chain& chain, const HangerTopology& topology, std::vector<char>& used) const {
  for (bool found = true; found && topology.broken[chain.joints.back()];) {
    found = false;
    const std::size_t end = chain.joints.back();
    for (std::size_t c = 0; c < ends_.size() && !found; ++c) {
      if (used[c] || (ends_[c].a != end && ends_[c].b != end)) continue;
      used[c] = 1;
      chain.cables.push_back(c);
      chain.joints.push_back(ends_[c].a == end ? ends_[c].b : ends_[c].a);
      found = true;
    }
  }
}

/// Evaluates a chain as a straight line. Its joints have no mass, so that all its cables have one tension T, and each
/// has an elongation e_i = p_i + T/k_i from its own natural elongation p_i and compliance 1/k_i:
///   T = (l - sum(l0_i + p_i))/sum(1/k_i).
/// Behind a plane of symmetry the chain continues as its mirror image: it runs straight along the fence and exerts no
/// force in the plane of motion. A chain with a free start, or with a broken cable in it, has no tension. One that
/// begins and ends at one point has no length. Joints receive positions, which only outputs read, and zero velocities:
/// the rates of the cables' lengths follow from that of the chain.
void CableForces::straighten(Chain& chain, const State& state, Workspace& work) const {
  double natural = 0.0, compliance = 0.0;
  bool carries = chain.start != Chain::Start::free;
  std::vector<double> lengths, compliances;
  for (const std::size_t c : chain.cables) {
    lengths.push_back(constants_.rest_length[c]);
    compliances.push_back(1.0 / tangents_[c].stiffness);
    visit_cable(laws_, indices_[c], [&]<class L>(const L& law, Slot slot) {
      lengths.back() += natural_elongation(law, memory(law, state, slot));
      carries = carries && !is_broken<L>(state.mode[slot.mode]);
    });
    natural += lengths.back();
    compliance += compliances.back();
  }
  chain.carries = carries;
  const std::size_t first = chain.joints.front(), last = chain.joints.back();
  const Vec2 p_WStart = work.joints.p_WP(first), v_WStart = work.joints.v_WP(first);
  const Vec2 p_WEnd = work.joints.p_WP(last), v_WEnd = work.joints.v_WP(last);
  const double across = joints_[last].along - joints_[first].along;
  Path whole = chain.start == Chain::Start::held ? path(p_WStart, v_WStart, p_WEnd, v_WEnd, across * across)
                                                 : Path{std::abs(across), 0.0, {}};
  if (chain.start == Chain::Start::free) whole.length = natural;
  const double tension = carries ? (whole.length - natural) / compliance : 0.0;
  double along = 0.0;
  for (std::size_t i = 0; i < chain.cables.size(); ++i) {
    const std::size_t c = chain.cables[i];
    const double ratio = compliances[i] / compliance;
    const double length = lengths[i] + tension * compliances[i];
    const Vec2 pull = ends_[c].a == chain.joints[i] ? whole.pull_A : -whole.pull_A;
    work.paths.set(c, {length, ratio * whole.length_rate, pull});
    along += length;
    if (i + 1 == chain.cables.size()) break;
    const double part = whole.length > 0.0 ? std::clamp(along / whole.length, 0.0, 1.0) : 1.0;
    const bool held = chain.start == Chain::Start::held;
    const Vec2 p_WFrom = held ? p_WStart : p_WEnd;
    work.joints.set(chain.joints[i + 1], p_WFrom + part * (p_WEnd - p_WFrom), {});
  }
  if (chain.start != Chain::Start::held) work.joints.set(first, p_WEnd, {});
}

double CableForces::pull_on(const HangerJoint& hanger, const State& state, const Workspace& work) const {
  Vec2 pull;
  for (const std::size_t c : hanger.cables) {
    visit_cable(laws_, indices_[c], [&]<class L>(const L& law, Slot slot) {
      const double tension = force_of(law, slot, kinematics(work, c), state).total();
      pull += (ends_[c].a == hanger.joint ? constants_.symmetry_weight_a[c] : -constants_.symmetry_weight_b[c]) *
              tension * work.paths.pull(c);
    });
  }
  return norm(pull);
}

std::vector<HangerId> CableForces::overloaded(const State& state, const Workspace& work) const {
  std::vector<HangerId> found;
  double maximum = 1.0;
  for (std::size_t h = 0; h < hanger_joints_.size(); ++h) {
    if (state.mode[first_hanger_ + h] != 0) continue;
    const double ratio = pull_on(hanger_joints_[h], state, work) / hanger_joints_[h].strength;
    if (ratio < maximum) continue;
    if (ratio > maximum) found.clear();
    maximum = ratio;
    found.push_back(static_cast<HangerId>(h));
  }
  return found;
}

bool CableForces::any_chain_broken(const State& state, const Workspace& work) const {
  bool parted = false;
  for (const Chain& chain : work.topology.chains) {
    if (!chain.carries) continue;
    for (const std::size_t c : chain.cables) {
      visit_cable(laws_, indices_[c],
                  [&]<class L>(const L&, Slot slot) { parted = parted || is_broken<L>(state.mode[slot.mode]); });
    }
  }
  return parted;
}

std::vector<BodyId> CableForces::joined_bodies(HangerId hanger) const {
  std::vector<BodyId> bodies;
  for (const std::size_t c : hanger_joints_[index(hanger)].cables) {
    for (const std::size_t j : {ends_[c].a, ends_[c].b}) {
      if (joints_[j].on_body) bodies.push_back(joints_[j].body);
    }
  }
  return bodies;
}

}  // namespace talus
