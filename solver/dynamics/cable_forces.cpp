#include "solver/dynamics/cable_forces.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>
#include <variant>

#include "solver/base/error.hpp"
#include "solver/dynamics/law_modes.hpp"
#include "solver/dynamics/spans.hpp"

namespace talus {
namespace {

double multiplicity_of(const Model& model, const Joint& joint) {
  return joint.on_body ? model.bodies[index(joint.body)].multiplicity : 1.0;
}

}  // namespace

std::size_t CableForces::joint(const CableEnd& end) {
  const Joint wanted{end.body.has_value(), end.body.value_or(BodyId{}), in_plane(end.p), end.p.z};
  const auto found = std::find(joints_.begin(), joints_.end(), wanted);
  if (found != joints_.end()) return static_cast<std::size_t>(found - joints_.begin());
  if (!wanted.on_body) anchors_.push_back(joints_.size());
  joints_.push_back(wanted);
  constants_.body_x.push_back(wanted.p.x), constants_.body_y.push_back(wanted.p.y);
  return joints_.size() - 1;
}

CableForces::CableForces(const Model& model, const Layout& layout) {
  for (std::size_t c = 0; c < model.cables.size(); ++c) {
    const Cable& cable = model.cables[c];
    const std::size_t a = joint(cable.a), b = joint(cable.b);
    const double across = joints_[b].along - joints_[a].along;
    ends_.push_back({a, b});
    constants_.symmetry_weight_a.push_back(cable.multiplicity / multiplicity_of(model, joints_[a]));
    constants_.symmetry_weight_b.push_back(cable.multiplicity / multiplicity_of(model, joints_[b]));
    constants_.across_squared.push_back(across * across);
    constants_.rest_length.push_back(cable.rest_length);
    constants_.multiplicity.push_back(cable.multiplicity);
    std::visit(
        [&](const auto& law) {
          auto& array = std::get<CableArray<std::decay_t<decltype(law)>>>(laws_);
          indices_.push_back({cable.law.index(), array.laws.size()});
          array.cable.push_back(c);
          array.laws.push_back(law);
          array.slots.push_back(layout.cable_slots[c]);
          tangents_.push_back(law.tangent());
        },
        cable.law);
  }
  first_hanger_ = layout.first_hanger;
  for (const Hanger& hanger : model.hangers) {
    HangerJoint holder{joint({hanger.body, hanger.p}), hanger.strength, {}};
    for (std::size_t c = 0; c < ends_.size(); ++c) {
      if (ends_[c].a == holder.joint || ends_[c].b == holder.joint) holder.cables.push_back(c);
    }
    hanger_joints_.push_back(std::move(holder));
  }
}

void CableForces::list_awake(ActiveSet& active, const HangerTopology& topology) const {
  std::vector<std::size_t> listed(joints_.size(), 0);  // number of cables that end there
  const auto moves = [&](std::size_t j) { return joints_[j].on_body && active.awake[index(joints_[j].body)]; };
  const auto sleeps = [&](std::size_t j) { return joints_[j].on_body && !active.awake[index(joints_[j].body)]; };
  active.cables.resize(std::tuple_size_v<decltype(laws_)>);
  active.borders.clear();
  for_each_array(laws_, [&](const auto& array, std::size_t law) {
    active.cables[law].clear();
    for (std::size_t i = 0; i < array.laws.size(); ++i) {
      const auto [a, b] = ends_[array.cable[i]];
      const bool chained = !topology.broken.empty() && (topology.broken[a] || topology.broken[b]);
      if (!active.complete && !chained && !moves(a) && !moves(b)) continue;
      append(active.cables[law], {.index = i, .cable = array.cable[i], .a = a, .b = b, .count = 1});
      if (sleeps(a) != sleeps(b)) active.borders.push_back(array.cable[i]);
      ++listed[a], ++listed[b];
    }
  });
  std::vector<char> in_row(joints_.size(), 0);
  active.rows_only = true;
  std::size_t last = 0;
  for (std::vector<CableSpan>& spans : active.cables) {
    for (CableSpan& span : spans) {
      find_row(span, listed);
      if (span.row) std::fill_n(in_row.begin() + static_cast<std::ptrdiff_t>(span.a), span.count + 1, 1);
      active.rows_only = active.rows_only && span.row && span.a >= last;
      last = span.a;
    }
  }
  active.lines.resize(active.cables.size());
  for (std::size_t law = 0; law < active.cables.size(); ++law) {
    std::vector<CableSpan>& lines = active.lines[law];
    lines.clear();
    for (const CableSpan& span : active.cables[law]) {
      if (!span.row) continue;
      if (!lines.empty() && lines.back().cable + lines.back().count == span.cable)
        lines.back().count += span.count;
      else
        lines.push_back(span);
    }
  }
  active.joints.clear();
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    if (listed[j] > 0) append(active.joints, {j, index(joints_[j].body), 1, joints_[j].on_body, in_row[j] != 0});
  }
}

/// Finds whether a span is a row, and which of its joints are on bodies; `ends_at`: number of cables that end at each
/// joint.
void CableForces::find_row(CableSpan& span, const std::vector<std::size_t>& ends_at) const {
  if (span.b != span.a + 1 || ends_at[span.a] != 1 || ends_at[span.a + span.count] != 1) return;
  const Joint* const joints = &joints_[span.a];
  span.from = joints[0].on_body ? 0 : 1;
  span.to = joints[span.count].on_body ? span.count + 1 : span.count;
  if (span.from >= span.to || !joints[span.from].on_body) return;
  span.body = static_cast<std::ptrdiff_t>(index(joints[span.from].body)) - static_cast<std::ptrdiff_t>(span.from);
  for (std::size_t i = span.from; i < span.to; ++i) {
    if (i > 0 && i < span.count && ends_at[span.a + i] != 2) return;
    const auto body = static_cast<std::size_t>(span.body + static_cast<std::ptrdiff_t>(i));
    if (!joints[i].on_body || index(joints[i].body) != body) return;
  }
  span.row = true;
}

void CableForces::set_anchors(Workspace& work) const {
  for (const std::size_t j : anchors_)
    work.joints.set(j, joints_[j].p, {});
}

void CableForces::update(const State& state, Workspace& work) const {
  for (const JointSpan& span : work.active.joints) {
    if (span.on_body && !span.in_row) set_joints(span, constants_.body_x, constants_.body_y, work.poses, work.joints);
  }
  clear(work.pulls, work.active.reached_bodies);
  work.active.on_linear_branch = work.active.rows_only;
  keep_lines(state, work);
  for_each_span(laws_, work.active.cables, [&](const auto&, CableSpan& span) {
    if (!span.row) return evaluate_paths(span, work);
    span.on_linear_branch =
        evaluate_chain(span, constants_, work.lines, work.poses, work.joints, work.paths, work.pulls);
    work.active.on_linear_branch = work.active.on_linear_branch && span.on_linear_branch;
  });
  if (work.topology.chains.empty()) return;
  // Cables that continue through broken hangers have other paths: then no span is on its linear branch.
  work.active.on_linear_branch = false;
  for_each_span(laws_, work.active.cables, [](const auto&, CableSpan& span) { span.on_linear_branch = false; });
  for (Chain& chain : work.topology.chains)
    straighten(chain, state, work);
}

bool CableForces::pull_rows(const State& state, Workspace& work) const {
  ActiveSet& active = work.active;
  if (!active.rows_only || active.any_asleep || !hanger_joints_.empty()) return false;
  clear(work.wrenches, active.reached_bodies);
  keep_lines(state, work);
  bool on_linear_branch = true;
  for_each_span(laws_, active.cables, [&](const auto&, CableSpan& span) {
    on_linear_branch =
        chain_wrenches(span, constants_, work.lines, work.poses, work.joints, work.wrenches) && on_linear_branch;
    span.on_linear_branch = true;
  });
  return active.on_linear_branch = on_linear_branch;
}

void CableForces::keep_lines(const State& state, Workspace& work) const {
  for_each_span(laws_, work.active.lines, [&]<class L>(const CableArray<L>& array, const CableSpan& span) {
    if constexpr (HasLinearBranch<L>) talus::keep_lines(array, span, state, work.lines);
  });
}

void CableForces::evaluate_paths(const CableSpan& span, Workspace& work) const {
  for (std::size_t i = 0; i < span.count; ++i) {
    const std::size_t c = span.cable + i;
    const auto [a, b] = ends_[c];
    work.paths.set(c, path(work.joints.p_WP(a), work.joints.v_WP(a), work.joints.p_WP(b), work.joints.v_WP(b),
                           constants_.across_squared[c]));
  }
}

void CableForces::update_modes(State& state, const Workspace& work) const {
  for_each_span(laws_, work.active.cables, [&](const auto& array, const CableSpan& span) {
    if (span.on_linear_branch) return;
    for_each_of(array, span, [&](const auto& law, Slot slot, std::size_t c) {
      update_mode(law, slot, kinematics(work, c), state, constants_.multiplicity[c]);
    });
  });
}

void CableForces::load(const State& state, Workspace& work, Rates* out) const {
  if (work.pulled) {
    // The forces are in the wrenches already.
  } else if (work.active.on_linear_branch) {
    copy(work.pulls, work.active.reached_bodies, work.wrenches);
  } else {
    sum_pulls(state, work, out);
    clear(work.wrenches, work.active.reached_bodies);
    for (const JointSpan& span : work.active.joints) {
      if (span.on_body) load_bodies(span, work.joints, work.wrenches);
    }
  }
  if (!out) return;
  // Anchors react to the cable forces: an impulse from outside. Anchors of sleeping cables keep the force of their last
  // evaluation.
  for (const std::size_t j : anchors_) {
    out->impulse[0] -= work.joints.force_x[j];
    out->impulse[1] -= work.joints.force_y[j];
    out->impulse[2] -= cross(work.joints.p_WP(j), work.joints.force(j));
  }
}

/// Computes tensions, law by law, and forces at the joints, for cables that are in no row or not on their linear
/// branch.
void CableForces::sum_pulls(const State& state, Workspace& work, Rates* out) const {
  JointPoints& joints = work.joints;
  for_each_span(laws_, work.active.cables, [&](const auto&, const CableSpan& span) {
    if (span.on_linear_branch) return;
    joints.clear_forces(span.a, span.row ? span.count + 1 : 1);
    if (!span.row) joints.clear_forces(span.b, span.count);
  });
  for_each_span(laws_, work.active.cables, [&]<class L>(const CableArray<L>& array, const CableSpan& span) {
    if (span.on_linear_branch) return;
    for_each_of(array, span, [&](const L& law, Slot slot, std::size_t c) {
      const LawForce force = force_of(law, slot, kinematics(work, c), state);
      work.paths.tension[c] = force.total();
      if (out)
        out->work[static_cast<std::size_t>(L::dissipation)] +=
            constants_.multiplicity[c] * force.dissipative * work.paths.length_rate[c];
    });
    sum_pulls(span, work);
  });
  for (const std::size_t j : work.topology.free_joints)
    joints.force_x[j] = joints.force_y[j] = 0.0;
}

/// Joint i of a span receives the forces of cable i and of the one before it, in one sum.
void CableForces::sum_pulls(const CableSpan& span, Workspace& work) const {
  const auto pull = [&](std::size_t i) { return work.paths.tension[span.cable + i] * work.paths.pull(span.cable + i); };
  const auto end_a = [&](std::size_t i) { return constants_.symmetry_weight_a[span.cable + i] * pull(i); };
  const auto end_b = [&](std::size_t i) { return constants_.symmetry_weight_b[span.cable + i] * pull(i); };
  work.joints.add_force(span.a, end_a(0));
  for (std::size_t i = 1; i < span.count; ++i)
    work.joints.add_force(span.a + i, end_a(i) - end_b(i - 1));
  work.joints.add_force(span.b + span.count - 1, -end_b(span.count - 1));
}

void CableForces::keep_rest(const State& state, const Workspace& work) {
  rest_pulls_.resize(size());
  for_each_cable(laws_, [&]<class L>(const L& law, Slot slot, std::size_t c) {
    const double tension = force_of(law, slot, kinematics(work, c), state).total();
    rest_pulls_[c] = tension * work.paths.pull(c);
  });
}

void CableForces::list_woken(const State& state, const Workspace& work, double fraction,
                             std::vector<BodyId>& woken) const {
  for (const std::size_t c : work.active.borders) {
    visit_cable(laws_, indices_[c], [&]<class L>(const L& law, Slot slot) {
      const double tension = force_of(law, slot, kinematics(work, c), state).total();
      const Vec2 change = tension * work.paths.pull(c) - rest_pulls_[c];
      if (std::max(std::abs(change.x), std::abs(change.y)) <= fraction * tension) return;
      const Joint& a = joints_[ends_[c].a];
      const bool asleep = a.on_body && !work.active.awake[index(a.body)];
      woken.push_back((asleep ? a : joints_[ends_[c].b]).body);
    });
  }
}

bool CableForces::follows(const State& state) const {
  bool found = false;
  for_each_cable(laws_, [&]<class L>(const L&, Slot slot, std::size_t) {
    found = found || memory_follows<L>(state.mode[slot.mode]);
  });
  return found;
}

bool CableForces::none_ends(const Workspace& work, double horizon) const {
  TALUS_ASSERT(work.has_geometry());
  if (!hanger_joints_.empty()) return false;
  return size() == 0 || (work.active.on_linear_branch &&
                         remains_linear(0, size(), constants_.rest_length, work.lines, work.paths, horizon));
}

bool CableForces::guards(const State& state, const Workspace& work, double horizon, std::span<double> out) const {
  bool any = !hanger_joints_.empty();
  for_each_span(laws_, work.active.cables, [&]<class L>(const CableArray<L>& array, const CableSpan& span) {
    if (span.on_linear_branch &&
        remains_linear(span.cable, span.count, constants_.rest_length, work.lines, work.paths, horizon))
      return;
    any = true;
    for_each_of(array, span, [&](const L& law, Slot slot, std::size_t c) {
      out[slot.mode] = law.guard(kinematics(work, c), memory(law, state, slot), state.mode[slot.mode]);
    });
  });
  for (std::size_t h = 0; h < hanger_joints_.size(); ++h) {
    if (state.mode[first_hanger_ + h] == 0)
      out[first_hanger_ + h] = hanger_joints_[h].strength - pull_on(hanger_joints_[h], state, work);
  }
  return any;
}

void CableForces::for_each_taut(const State& state, const Workspace& work,
                                const std::function<void(const TautCable&)>& visit) const {
  const auto goes_past_a_hanger = [&](std::size_t c) {
    return std::any_of(work.topology.chains.begin(), work.topology.chains.end(), [c](const Chain& chain) {
      return std::find(chain.cables.begin(), chain.cables.end(), c) != chain.cables.end();
    });
  };
  for_each_cable(laws_, [&]<class L>(const L& law, Slot slot, std::size_t c) {
    const Mode mode = state.mode[slot.mode];
    if (mode == 0 || goes_past_a_hanger(c)) return;
    visit({c, local_slopes(law, kinematics(work, c), memory(law, state, slot), mode), constants_.symmetry_weight_a[c],
           constants_.symmetry_weight_b[c]});
  });
}

double CableForces::stored_energy(const State& state, const Workspace& work) const {
  double sum = 0.0;
  if (work.active.on_linear_branch && work.active.complete) {
    for_each_span(laws_, work.active.lines, [&](const auto&, const CableSpan& span) {
      sum = add_line_energies(sum, span, constants_, work.lines, work.paths);
    });
    return sum;
  }
  for_each_cable(laws_, [&]<class L>(const L& law, Slot slot, std::size_t c) {
    sum += constants_.multiplicity[c] *
           law.stored_energy(kinematics(work, c), memory(law, state, slot), state.mode[slot.mode]);
  });
  return sum;
}

void CableForces::tensions(const State& state, const Workspace& work, std::span<double> out) const {
  TALUS_ASSERT(work.has_geometry());
  if (work.active.on_linear_branch && work.active.complete) {
    // The linear branch of a slack cable gives -0; adding 0 removes the sign.
    for (std::size_t c = 0; c < size(); ++c)
      out[c] = work.paths.tension[c] + 0.0;
    return;
  }
  for_each_cable(laws_, [&]<class L>(const L& law, Slot slot, std::size_t c) {
    out[c] = force_of(law, slot, kinematics(work, c), state).total();
  });
}

}  // namespace talus
