#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <tuple>
#include <utility>
#include <variant>

#include "solver/base/error.hpp"
#include "solver/dynamics/contact_arrays.hpp"
#include "solver/dynamics/law_modes.hpp"
#include "solver/dynamics/workspace.hpp"

/// Visits of the law instances of contacts and of their friction: what ContactForces evaluates.
namespace talus {

/// Calls visit(array) for each array that the scene uses: the only dispatch of an evaluation.
template <class Laws, class Visit>
void for_each_array(Laws& laws, Visit&& visit) {
  const auto visit_law = [&visit](auto& law) {
    const unsigned used = law.used;
    if (used == 0) return;
    const auto visit_arrays = [&]<std::size_t... I>(std::index_sequence<I...>) {
      const auto visit_array = [&](auto& array, unsigned bit) {
        if (used & bit) visit(array);
      };
      (visit_array(std::get<I>(law.arrays), 1U << I), ...);
    };
    visit_arrays(std::make_index_sequence<std::tuple_size_v<std::decay_t<decltype(law.arrays)>>>{});
  };
  std::apply([&visit_law](auto&... law) { (visit_law(law), ...); }, laws);
}

inline Kinematics kinematics(const Workspace& work, std::size_t instance) {
  return {work.gaps[instance].depth, work.rates[instance]};
}

/// Calls visit(law, slot, group) for each law instance within reach.
template <class Laws, class Visit>
void for_each_near(const Laws& laws, const Workspace& work, Visit&& visit) {
  if (!work.any_near) return;
  for_each_array(laws, [&](const auto& array) {
    for (const ContactGroup& group : array.groups) {
      if (!work.near[group.candidate]) continue;
      for (std::size_t i = group.first; i < group.last; ++i)
        visit(array.laws[i], array.slots[i], group);
    }
  });
}

/// Slot of the friction of an instance of the group.
inline Slot friction_slot(const ContactGroup& group, std::size_t instance) {
  const std::size_t offset = instance - group.first;
  return {group.first_friction.mode + offset,
          group.first_friction.memory + offset * talus::memory_count(*group.friction)};
}

/// c_s of a contact with this friction and normal law [F T/L].
template <class L>
double friction_dashpot(const CoulombFriction& friction, const L& law, std::span<const double> memory) {
  double time = 0.0;
  if constexpr (HasRetardationTime<L>) time = law.retardation_time(memory);
  return friction.dashpot(time);
}

/// One instance of friction.
struct Slider {
  const ContactGroup& group;
  CoulombFriction law;  ///< of the group's friction at the present overlap
  Slot slot;
  std::size_t instance{};  ///< of the contact, in Workspace::gaps
  bool is_pressed{};       ///< its normal law acts, on a spring with a stiffness
  double dashpot{};        ///< c_s [F T/L]
};

/// Calls visit(slider) for each instance of friction within reach; `rough`: whether there are any.
template <class Laws, class Visit>
void for_each_slider(const Laws& laws, bool rough, const State& state, const Workspace& work, Visit&& visit) {
  if (!rough || !work.any_near) return;
  for_each_array(laws, [&](const auto& array) {
    for (const ContactGroup& group : array.groups) {
      if (!group.friction || !work.near[group.candidate]) continue;
      for (std::size_t i = group.first; i < group.last; ++i) {
        using L = typename std::decay_t<decltype(array.laws)>::value_type;
        const Slot slot = friction_slot(group, i);
        const Slot normal = array.slots[i];
        const Mode mode = state.mode[normal.mode];
        if (mode == 0 && state.mode[slot.mode] == CoulombFriction::open) continue;
        const L& law = array.laws[i];
        const CoulombFriction friction = at(*group.friction, work.gaps[normal.mode].depth);
        const double dashpot = friction_dashpot(friction, law, memory(law, state, normal));
        visit(Slider{group, friction, slot, normal.mode, mode != 0 && friction.stiffness > 0.0, dashpot});
      }
    }
  });
}

/// Normal force at a slider [F], as evaluated by push().
inline double normal_force(const Workspace& work, const Slider& slider) {
  TALUS_ASSERT(work.evaluated >= Evaluated::forces);
  return slider.is_pressed ? work.normal_forces[slider.instance].total() : 0.0;
}

/// Tangent of a gap, counter-clockwise from its normal: the direction in which slip of B past A is positive.
inline Vec2 tangent(const Gap& gap) { return {-gap.n_AB.y, gap.n_AB.x}; }

inline double slip_rate(const Workspace& work, const Slider& slider) {
  const Gap& gap = work.gaps[slider.instance];
  const Pose A = work.poses[index(slider.group.a)];
  const Pose B = work.poses[index(slider.group.b)];
  return dot(velocity_at(B, gap.p_WC) - velocity_at(A, gap.p_WC), tangent(gap));
}

/// Stretch that would add as much force as the dashpot of a contact that sticks or is about to stick [L].
inline double viscous_stretch(const Workspace& work, const Slider& slider) {
  if (slider.dashpot == 0.0 || !slider.is_pressed) return 0.0;
  return slider.dashpot / slider.law.stiffness * slip_rate(work, slider);
}

/// The same for the force of a contact, whose dashpot acts only while it sticks.
inline double acting_viscous_stretch(const State& state, const Workspace& work, const Slider& slider) {
  const bool sticks = state.mode[slider.slot.mode] == CoulombFriction::sticking;
  return sticks ? viscous_stretch(work, slider) : 0.0;
}

/// Energy stored at the last update of the modes [F L].
inline double stored_before(const State& before, const Slider& slider) {
  CoulombFriction law = slider.law;
  if (talus::memory_count(*slider.group.friction) > 1) law.stiffness = before.z[slider.slot.memory + 1];
  return law.stored_energy(before.z[slider.slot.memory]);
}

/// Initialises the spring of a contact that has just begun to push: its bodies have been approaching since they
/// touched, for the time depth/rate. Bodies that do not approach keep the stretch they have.
inline void start_spring(State& state, const Workspace& work, const Slider& slider) {
  const double rate = work.rates[slider.instance];
  if (!(rate > 0.0)) return;
  const double onset = std::visit([]<class L>(const L&) { return L::onset; }, *slider.group.friction);
  const double slip = onset * slip_rate(work, slider) * std::max(work.gaps[slider.instance].depth, 0.0) / rate;
  state.z[slider.slot.memory] = slider.law.initial_stretch(slip, normal_force(work, slider));
}

}  // namespace talus
