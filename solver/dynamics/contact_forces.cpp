#include "solver/dynamics/contact_forces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>
#include <variant>

#include "solver/base/error.hpp"
#include "solver/dynamics/gap_update.hpp"
#include "solver/dynamics/law_instances.hpp"
#include "solver/dynamics/law_modes.hpp"
#include "solver/dynamics/starting_impacts.hpp"

namespace talus {
namespace {

/// Adds a force [F] on B, and its opposite on A, at the contact point.
void add_pair(Workspace& work, const ContactGroup& group, const Gap& gap, Vec2 on_b) {
  const std::size_t a = index(group.a), b = index(group.b);
  work.wrenches.add(b, work.poses[b].p_WB, gap.p_WC, group.symmetry_weight_b * on_b);
  work.wrenches.add(a, work.poses[a].p_WB, gap.p_WC, -group.symmetry_weight_a * on_b);
}

/// True for a body and ground.
bool is_unbounded(const Candidate& pair) { return is_unbounded(pair.bounds_a) || is_unbounded(pair.bounds_b); }

/// Step [T] in which a pair with this closing speed [L/T] moves by a distance [L] > 0 under the acceleration `pull`
/// [L/T^2]: distance = speed h + pull h^2/2, solved without cancellation.
double step_over(double distance, double speed, double pull) {
  return 2.0 * distance / (speed + std::sqrt(speed * speed + 2.0 * pull * distance));
}

/// Reduces the longest step to the one that a pair with this closing speed [L/T] allows, under the acceleration `pull`
/// [L/T^2].
void limit_step(ContactForces::TunnellingLimit& tunnelling_limit, const Candidate& pair, std::size_t contact,
                double speed, double pull) {
  const double distance = tunnelling_distance(pair);
  const double maximum = tunnelling_limit.longest_step;
  if ((speed + 0.5 * pull * maximum) * maximum <= distance) return;
  const double step = step_over(distance, speed, pull);
  if (step < maximum) tunnelling_limit = {step, static_cast<ContactId>(contact)};
}

/// Computes the gaps of the pairs marked Workspace::wanted.
template <class Laws>
void update_gaps(const Laws& laws, const State* state, Workspace& work) {
  for_each_array(laws, [&](const auto& array) { GapUpdate{array, state, work}.run(); });
}

/// Mode and stretch of an instance of friction, and the energy lost, after a step from `before`, if that is not null.
[[gnu::noinline]] void update_slider(const Slider& slider, State& state, const Workspace& work, const State* before) {
  if (state.mode[slider.slot.mode] == CoulombFriction::open && normal_force(work, slider) > 0.0)
    start_spring(state, work, slider);
  double& stretch = state.z[slider.slot.memory];
  auto settled = slider.law.return_mapping(stretch, normal_force(work, slider), viscous_stretch(work, slider));
  // A dashpot force against the spring let the spring exceed the limit: when released, the spring moves the slider.
  if (slider.dashpot > 0.0 && state.mode[slider.slot.mode] == CoulombFriction::sticking &&
      CoulombFriction::slips(settled.mode))
    settled.dissipated = slider.law.stored_energy(stretch) - slider.law.stored_energy(settled.stretch);
  // The step has integrated the work of the force as a power: the energy that the spring gave back was not lost.
  if (before && CoulombFriction::slips(before->mode[slider.slot.mode])) {
    settled.dissipated = stored_before(*before, slider) - slider.law.stored_energy(settled.stretch);
  }
  stretch = settled.stretch;
  if (talus::memory_count(*slider.group.friction) > 1) state.z[slider.slot.memory + 1] = slider.law.stiffness;
  state.mode[slider.slot.mode] = settled.mode;
  state.work[static_cast<std::size_t>(Mechanism::friction)] += slider.group.multiplicity * settled.dissipated;
}

/// Adds the force of an instance of friction to its bodies, and its power to `out`, if that is not null.
[[gnu::noinline]] void add_slider(const Slider& slider, const State& state, Workspace& work, Rates* out,
                                  bool slip_power) {
  const Gap& gap = work.gaps[slider.instance];
  const double stretch = state.z[slider.slot.memory];
  const double viscous = acting_viscous_stretch(state, work, slider);
  const double force = slider.law(stretch, normal_force(work, slider), viscous);
  add_pair(work, slider.group, gap, -force * tangent(gap));
  const bool slips = slip_power && CoulombFriction::slips(state.mode[slider.slot.mode]);
  if (out && (viscous != 0.0 || slips)) {
    const double lost = slips ? force : force - slider.law.stiffness * stretch;
    const double power = lost * slip_rate(work, slider);
    out->work[static_cast<std::size_t>(Mechanism::friction)] += slider.group.multiplicity * power;
  }
  if (out && !slips && state.mode[slider.slot.mode] != CoulombFriction::open) {
    const double area =
        std::visit([&](const auto& law) { return law.area_power(stretch, kinematics(work, slider.instance)); },
                   *slider.group.friction);
    out->work[static_cast<std::size_t>(Mechanism::friction)] += slider.group.multiplicity * area;
  }
}

}  // namespace

ContactForces::ContactForces(const Model& model, const Layout& layout) : mobility_{model} {
  std::size_t count = 0;
  for (const std::size_t instances : layout.contact_instances)
    count += instances;
  pairs_.resize(count);
  for (std::size_t c = 0; c < model.contacts.size(); ++c) {
    const Contact& contact = model.contacts[c];
    rough_ = rough_ || contact.friction.has_value();
    const Slot slot = layout.contact_slots[c];
    const std::size_t instances = layout.contact_instances[c];
    search_.add({contact.a, contact.b, bounds(model.bodies[index(contact.a)].shape),
                 bounds(model.bodies[index(contact.b)].shape), slot.mode, slot.mode + instances,
                 std::visit([](const auto& law) { return reach(law); }, contact.law)});
    std::visit(
        [&]<class L>(const L& law) {
          auto& arrays = std::get<ContactArrays<L>>(laws_);
          if constexpr (StartsByMass<L>) starts_by_mass_ = starts_by_mass_ || memory_count(law) > 0;
          ContactCompiler<L>{model, arrays, pairs_}.add(c, contact, law, slot, layout.friction_slots[c]);
        },
        contact.law);
  }
  search_.prepare(model.bodies.size());
  pair_of_.assign(layout.mode_count, candidates());
  for (std::size_t c = 0; c < candidates(); ++c) {
    const auto mark = [&](Slot slot) {
      std::fill_n(pair_of_.begin() + static_cast<std::ptrdiff_t>(slot.mode), layout.contact_instances[c], c);
    };
    mark(layout.contact_slots[c]);
    if (model.contacts[c].friction) mark(layout.friction_slots[c]);
  }
}

bool ContactForces::find(const State& state, Workspace& work) const {
  if (work.any_near) std::fill(work.near.begin(), work.near.end(), char{0});
  work.any_near = search_.find(work.poses, work.near, work.sweep);
  // Bodies may have separated within one step: what still acts is evaluated once more, so that it ends.
  if (any_set(state.mode.data(), size())) {
    work.any_near = true;
    for (std::size_t c = 0; c < candidates(); ++c) {
      const Candidate& pair = search_.pairs()[c];
      if (any_set(&state.mode[pair.first], pair.last - pair.first)) work.near[c] = Workspace::wanted;
    }
  }
  return work.any_near;
}

void ContactForces::update(const State& state, Workspace& work) const { update_gaps(laws_, &state, work); }

void ContactForces::largest_depths(const Workspace& work, std::span<double> out) const {
  bool all_near = true;
  for (std::size_t c = 0; c < candidates(); ++c) {
    const Candidate& pair = search_.pairs()[c];
    out[c] = work.near[c] ? largest_depth(work, pair.first, pair.last) : -std::numeric_limits<double>::infinity();
    all_near = all_near && work.near[c];
  }
  if (all_near) return;
  for_each_array(laws_, [&](const auto& array) {
    for (const ContactGroup& group : array.groups) {
      double& largest = out[group.candidate];
      if (!work.near[group.candidate]) largest = std::max(largest, largest_far_depth(array, group, work));
    }
  });
}

void ContactForces::update_all(Workspace& work) const {
  std::fill(work.near.begin(), work.near.end(), Workspace::wanted);
  work.any_near = candidates() > 0;
  update_gaps(laws_, nullptr, work);
}

bool ContactForces::update_of(const State& state, std::span<const std::size_t> modes, Workspace& work) const {
  std::fill(work.near.begin(), work.near.end(), char{0});
  work.any_near = false;
  for (const std::size_t mode : modes) {
    if (has(mode)) work.near[pair_of_[mode]] = Workspace::wanted, work.any_near = true;
  }
  if (work.any_near) update_gaps(laws_, &state, work);
  return work.any_near;
}

double ContactForces::update_far(const State& state, double horizon, double pull, Workspace& work) const {
  TunnellingLimit tunnelling_limit{horizon, {}};
  bool any = false;
  for (std::size_t c = 0; c < candidates(); ++c) {
    char& near = work.near[c];
    const Candidate& pair = search_.pairs()[c];
    const bool passes = !is_unbounded(pair);
    if (near) near = Workspace::known;
    if (near && !passes) continue;
    const auto distance = [&](double speed) { return horizon * (speed + 0.5 * pull * horizon); };
    if (!near && passes && cannot_touch(pair, work.poses, distance(closing_speed_bound(pair, work.poses)))) continue;
    const Pose A = work.poses[index(pair.a)], B = work.poses[index(pair.b)];
    const double speed = largest_closing_speed(pair, A, B);
    if (passes) limit_step(tunnelling_limit, pair, c, speed, pull);
    if (near || out_of_reach(pair, A, B, distance(speed))) continue;
    near = Workspace::wanted;
    any = true;
  }
  work.any_near = work.any_near || any;
  if (any) update_gaps(laws_, &state, work);
  return tunnelling_limit.longest_step;
}

void ContactForces::begin(State& state, const Workspace& work) const {
  if (!rough_) return;
  for_each_array(laws_, [&](const auto& array) {
    for (const ContactGroup& group : array.groups) {
      if (!group.friction || !work.near[group.candidate]) continue;
      const auto first = state.mode.begin() + static_cast<std::ptrdiff_t>(group.first_friction.mode);
      std::replace(first, first + static_cast<std::ptrdiff_t>(group.last - group.first), Mode{CoulombFriction::open},
                   Mode{CoulombFriction::sticking});
    }
  });
}

[[gnu::noinline]] void ContactForces::push(const State& state, Workspace& work) const {
  TALUS_ASSERT(work.evaluated != Evaluated::nothing);
  if (work.evaluated >= Evaluated::forces) return;
  for_each_near(laws_, work, [&](const auto& law, Slot slot, const ContactGroup&) {
    const Mode mode = state.mode[slot.mode];
    if (mode != 0) work.normal_forces[slot.mode] = law(kinematics(work, slot.mode), memory(law, state, slot), mode);
  });
  work.evaluated = Evaluated::forces;
}

// Inlines the visits of all laws: a call for each array would cost more than most arrays do. A slider costs more than a
// call, and it is the same for all laws. Inlined for each array, with push() and start_contacts(), which visit all laws
// once more, it took half of the time that this file compiles.
[[gnu::flatten]] void ContactForces::update_modes(State& state, Workspace& work, const State* before) const {
  if (starts_by_mass_) start_contacts(state, work);
  for_each_near(laws_, work, [&](const auto& law, Slot slot, const ContactGroup& group) {
    // The gap decides the onset: a contact that does not act stays inactive out of the reach of its law.
    if (state.mode[slot.mode] == 0 && work.gaps[slot.mode].depth < -reach(law)) return;
    update_mode(law, slot, kinematics(work, slot.mode), state, group.multiplicity);
  });
  if (!rough_) return;
  push(state, work);
  for_each_slider(laws_, rough_, state, work,
                  [&](const Slider& slider) { update_slider(slider, state, work, before); });
}

void ContactForces::memory_rates(const State& state, Workspace& work, Rates& out) const {
  push(state, work);
  for_each_slider(laws_, rough_, state, work, [&](const Slider& slider) {
    if (state.mode[slider.slot.mode] == CoulombFriction::open) return;
    out.z[slider.slot.memory] = std::visit(
        [&](const auto& law) {
          // Within a step that slips, the stretch exceeds the limit of the force.
          const double stretch = slider.law.initial_stretch(state.z[slider.slot.memory], normal_force(work, slider));
          return law.stretch_rate(stretch, slip_rate(work, slider), kinematics(work, slider.instance));
        },
        *slider.group.friction);
  });
}

void ContactForces::drift_memory(State& state, const Workspace& work, double h) const {
  for_each_slider(laws_, rough_, state, work, [&](const Slider& slider) {
    if (state.mode[slider.slot.mode] == CoulombFriction::open) return;
    double& stretch = state.z[slider.slot.memory];
    stretch = std::visit(
        [&](const auto& law) {
          return law.stretch_after(stretch, slip_rate(work, slider), kinematics(work, slider.instance), h);
        },
        *slider.group.friction);
  });
}

void ContactForces::list_woken(const Workspace& work, std::vector<BodyId>& woken) const {
  for (std::size_t c = 0; c < candidates(); ++c) {
    if (!work.near[c]) continue;
    const Candidate& pair = search_.pairs()[c];
    const auto gaps = work.gaps.begin();
    const bool touches =
        std::any_of(gaps + static_cast<std::ptrdiff_t>(pair.first), gaps + static_cast<std::ptrdiff_t>(pair.last),
                    [&pair](const Gap& gap) { return gap.depth >= -pair.reach; });
    if (!touches) continue;
    for (const BodyId body : {pair.a, pair.b}) {
      if (!work.active.awake[index(body)]) woken.push_back(body);
    }
  }
}

[[gnu::flatten]] void ContactForces::add(const State& state, Workspace& work, Rates* out, bool slip_power) const {
  const bool known = work.evaluated >= Evaluated::forces;
  for_each_near(laws_, work, [&]<class L>(const L& law, Slot slot, const ContactGroup& group) {
    const Mode mode = state.mode[slot.mode];
    if (mode == 0) return;
    LawForce& force = work.normal_forces[slot.mode];
    if (!known) force = law(kinematics(work, slot.mode), memory(law, state, slot), mode);
    const Gap& gap = work.gaps[slot.mode];
    add_pair(work, group, gap, force.total() * gap.n_AB);
    if (out)
      out->work[static_cast<std::size_t>(L::dissipation)] +=
          group.multiplicity * force.dissipative * work.rates[slot.mode];
  });
  work.evaluated = std::max(work.evaluated, Evaluated::forces);
  for_each_slider(laws_, rough_, state, work,
                  [&](const Slider& slider) { add_slider(slider, state, work, out, slip_power); });
}

/// Initialises the memory of laws that depend on the effective mass, for instances that begin to touch: m = p/u, with p
/// the impulse that stops the closing speed u. Impacts that begin together (both ends of a side that lands flat, a rock
/// between two columns) also stop each other: A p = u, with A the mobilities between them. A side that lands nearly
/// flat touches with one end first: when the other end follows, the first starts again with it if it still closes at
/// half the speed of the second, so that the smallest tilt does not change the restitution.
[[gnu::noinline]] void ContactForces::start_contacts(State& state, const Workspace& work) const {
  if (!work.any_near) return;
  StartingImpacts impacts;
  std::size_t started = 0;
  const auto for_each_impact = [&](auto&& visit) {
    for_each_array(laws_, [&](const auto& array) {
      using L = typename std::decay_t<decltype(array.laws)>::value_type;
      if constexpr (StartsByMass<L>) {
        for (const ContactGroup& group : array.groups) {
          if (!work.near[group.candidate]) continue;
          double begins = 0.0;  // largest closing speed of the instances that begin
          for (std::size_t i = group.first; i < group.last; ++i) {
            const std::size_t instance = array.slots[i].mode;
            if (state.mode[instance] == 0 && work.gaps[instance].depth >= -reach(array.laws[i]))
              begins = std::max(begins, std::max(work.rates[instance], std::numeric_limits<double>::min()));
          }
          if (begins == 0.0) continue;
          for (std::size_t i = group.first; i < group.last; ++i) {
            const std::size_t instance = array.slots[i].mode;
            if (memory_count(array.laws[i]) == 0) continue;
            const bool first = state.mode[instance] == 0;
            if (first ? work.gaps[instance].depth >= -reach(array.laws[i]) : work.rates[instance] > 0.5 * begins)
              visit(array.laws[i], array.slots[i], group);
          }
        }
      }
    });
  };
  for_each_impact([&](const auto&, Slot slot, const ContactGroup& group) {
    if (started < impacts.each.size()) impacts.each[started] = {&group, slot.mode, work.rates[slot.mode]};
    ++started;
  });
  if (started == 0) return;
  const bool together = started <= impacts.each.size();
  if (together) impacts.count = started, find_masses(mobility_, work, impacts);
  std::size_t next = 0;
  for_each_impact([&](const auto& law, Slot slot, const ContactGroup& group) {
    const double mass =
        together ? impacts.each[next++].mass : single_mass(mobility_, work, {.group = &group, .instance = slot.mode});
    law.start_contact(memory(law, state, slot), mass);
  });
}

bool ContactForces::follows(const State& state) const {
  bool found = false;
  for_each_array(laws_, [&](const auto& array) {
    using L = typename std::decay_t<decltype(array.laws)>::value_type;
    for (const ContactGroup& group : array.groups) {
      const std::size_t count = group.last - group.first;
      for (std::size_t i = group.first; Tracks<L> && i < group.last; ++i)
        found = found || memory_follows<L>(state.mode[array.slots[i].mode]);
      if (!group.friction) continue;
      const auto first = state.mode.begin() + static_cast<std::ptrdiff_t>(group.first_friction.mode);
      found = found || std::any_of(first, first + static_cast<std::ptrdiff_t>(count),
                                   [](Mode mode) { return mode > CoulombFriction::sticking; });
    }
  });
  return found;
}

ContactForces::TunnellingLimit ContactForces::tunnelling_limit(const Workspace& work, double pull) const {
  TunnellingLimit found;
  for (std::size_t c = 0; c < candidates(); ++c) {
    const Candidate& pair = search_.pairs()[c];
    if (is_unbounded(pair)) continue;
    limit_step(found, pair, c, largest_closing_speed(pair, work.poses[index(pair.a)], work.poses[index(pair.b)]), pull);
  }
  return found;
}

double ContactForces::safe_step(const Workspace& work, double horizon, double pull) const {
  double longest = horizon;
  for (const Candidate& pair : search_.pairs()) {
    if (is_unbounded(pair)) continue;
    const Pose A = work.poses[index(pair.a)], B = work.poses[index(pair.b)];
    const double speed = largest_closing_speed(pair, A, B);
    const double apart = norm(B.p_WB - A.p_WB) - furthest(pair.bounds_a) - furthest(pair.bounds_b) - pair.reach;
    // A step that enters the contact is short: the error estimate of a long one, whose last stages alone see the force,
    // is poor.
    const double distance = std::max(apart, tunnelling_distance(pair));
    if ((speed + 0.5 * pull * longest) * longest > distance) longest = step_over(distance, speed, pull);
  }
  return longest;
}

ContactForces::Overlap ContactForces::deepest_overlap(const Workspace& work) const {
  Overlap found;
  for (std::size_t c = 0; c < candidates(); ++c) {
    if (!work.near[c]) continue;
    const Candidate& pair = search_.pairs()[c];
    const double size = smaller_size(pair);
    for (std::size_t i = pair.first; i < pair.last; ++i) {
      if (work.gaps[i].depth > found.ratio * size) found = {work.gaps[i].depth / size, static_cast<ContactId>(c)};
    }
  }
  return found;
}

void ContactForces::guards(const State& state, Workspace& work, std::span<double> out) const {
  if (rough_) push(state, work);
  for_each_near(laws_, work, [&]<class L>(const L& law, Slot slot, const ContactGroup&) {
    out[slot.mode] = law.guard(kinematics(work, slot.mode), memory(law, state, slot), state.mode[slot.mode]);
  });
  for_each_slider(laws_, rough_, state, work, [&](const Slider& slider) {
    const Slot slot = slider.slot;
    out[slot.mode] = slider.law.guard(state.z[slot.memory], slip_rate(work, slider), normal_force(work, slider),
                                      state.mode[slot.mode], viscous_stretch(work, slider));
  });
}

std::vector<ContactForces::LinearContact> ContactForces::linear_contacts(const State& state,
                                                                         const Workspace& work) const {
  std::vector<LinearContact> found;
  for_each_near(laws_, work, [&]<class L>(const L& law, Slot slot, const ContactGroup& group) {
    if constexpr (HasLinearPart<L>) {
      const Tangent slopes = law.linear_part(memory(law, state, slot), state.mode[slot.mode]);
      if (slopes.stiffness == 0.0 && slopes.damping == 0.0) return;
      found.push_back(
          {group.a, group.b, work.gaps[slot.mode].n_AB, slopes, group.symmetry_weight_a, group.symmetry_weight_b});
    }
  });
  return found;
}

void ContactForces::for_each_acting(const State& state, const Workspace& work,
                                    const std::function<void(const ActingContact&)>& visit) const {
  if (!work.any_near) return;
  for_each_array(laws_, [&](const auto& array) {
    for (const ContactGroup& group : array.groups) {
      if (!work.near[group.candidate]) continue;
      for (std::size_t i = group.first; i < group.last; ++i) {
        const auto& law = array.laws[i];
        const Slot slot = array.slots[i];
        const Mode mode = state.mode[slot.mode];
        if (mode == 0) continue;
        const auto remembered = memory(law, state, slot);
        const Gap& gap = work.gaps[slot.mode];
        const Tangent slopes = local_slopes(law, kinematics(work, slot.mode), remembered, mode);
        ActingContact contact{
            group.a, group.b, gap.n_AB, gap.p_WC, slopes, group.symmetry_weight_a, group.symmetry_weight_b, {}};
        const Slot friction = group.friction ? friction_slot(group, i) : Slot{};
        if (group.friction && state.mode[friction.mode] != CoulombFriction::open) {
          const CoulombFriction spring = at(*group.friction, gap.depth);
          contact.friction = {state.mode[friction.mode], friction.memory, spring.stiffness,
                              friction_dashpot(spring, law, remembered), spring.coefficient};
        }
        visit(contact);
      }
    }
  });
}

double ContactForces::stored_energy(const State& state, const Workspace& work) const {
  double sum = 0.0;
  for_each_near(laws_, work, [&]<class L>(const L& law, Slot slot, const ContactGroup& group) {
    const double stored =
        law.stored_energy(kinematics(work, slot.mode), memory(law, state, slot), state.mode[slot.mode]);
    sum += group.multiplicity * stored;
  });
  for_each_slider(laws_, rough_, state, work, [&](const Slider& slider) {
    sum += slider.group.multiplicity * slider.law.stored_energy(state.z[slider.slot.memory]);
  });
  return sum;
}

void ContactForces::forces(const State& state, Workspace& work, std::span<double> out) const {
  push(state, work);
  std::fill_n(out.begin(), size(), 0.0);
  for_each_near(laws_, work, [&](const auto&, Slot slot, const ContactGroup&) {
    if (state.mode[slot.mode] != 0) out[slot.mode] = work.normal_forces[slot.mode].total();
  });
}

void ContactForces::friction_forces(const State& state, const Workspace& work, std::span<double> out) const {
  std::fill_n(out.begin(), size(), 0.0);
  for_each_slider(laws_, rough_, state, work, [&](const Slider& slider) {
    const double viscous = acting_viscous_stretch(state, work, slider);
    out[slider.instance] = slider.law(state.z[slider.slot.memory], normal_force(work, slider), viscous);
  });
}

}  // namespace talus
