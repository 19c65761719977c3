#include "solver/dynamics/dynamics.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>

#include "solver/base/error.hpp"
#include "solver/dynamics/gap_update.hpp"

namespace talus {
namespace {

double inertia(const Model& model, const Coordinate& coordinate) {
  const Body& body = model.bodies[index(coordinate.body)];
  if (coordinate.axis != Axis::angle) return body.mass;
  // Inertia of a guided body in its reference position. It depends on the angle, because turning moves the centre of
  // mass across the guide.
  const Vec2 r = body.p_WB - pin(body);
  if (body.mobility == Mobility::guided_x) return body.inertia + body.mass * r.x * r.x;
  if (body.mobility == Mobility::guided_y) return body.inertia + body.mass * r.y * r.y;
  return body.mobility == Mobility::pinned ? inertia_about_pin(body) : body.inertia;
}

}  // namespace

Dynamics::Dynamics(const Model& model)
    : model_{model},
      gravity_magnitude_{norm(model.gravity)},
      layout_{model},
      bodies_{model_, layout_},
      contacts_{model_, layout_},
      cables_{model_, layout_} {
  for (const Coordinate& coordinate : layout_.coordinates)
    inertias_.push_back(inertia(model_, coordinate));
  follows_motion_ = std::any_of(model_.contacts.begin(), model_.contacts.end(),
                                [](const Contact& contact) { return contact.friction.has_value(); });
  if (layout_.sleepers.empty()) return;
  find_rest();
}

/// Stores the cable forces at rest, and which sleepers are not in equilibrium under these forces, their weight and
/// their applied load.
void Dynamics::find_rest() {
  Workspace work = workspace();
  State rest = rest_state(model_);
  std::fill(rest.mode.begin() + static_cast<std::ptrdiff_t>(layout_.first_sleeper), rest.mode.end(), Mode{1});
  update_all(rest, work);
  cables_.update_modes(rest, work);
  cables_.keep_rest(rest, work);
  Rates accelerations{rest};
  cables_.load(rest, work, nullptr);
  bodies_.rates(work, accelerations, false);
  for (const BodyId body : layout_.sleepers) {
    const auto first = accelerations.v.begin() + static_cast<std::ptrdiff_t>(layout_.first[index(body)]);
    if (std::any_of(first, first + 3, [](double a) { return a != 0.0; })) unbalanced_sleepers_.push_back(body);
  }
}

Workspace Dynamics::workspace() const {
  const std::size_t bodies = model_.bodies.size();
  Workspace work{.poses = Poses(bodies),
                 .wrenches = Wrenches(bodies),
                 .pulls = Wrenches(bodies),
                 .joints = JointPoints(cables_.joints().size()),
                 .paths = Paths(cables_.size()),
                 .lines = CableLinearization(cables_.size()),
                 .gaps = std::vector<Gap>(contacts_.size()),
                 .rates = std::vector<double>(contacts_.size()),
                 .normal_forces = std::vector<LawForce>(contacts_.size()),
                 .active = {},
                 .topology = {},
                 .sweep = {},
                 .near = std::vector<char>(contacts_.candidates())};
  bodies_.set_fixed_poses(work);
  cables_.set_anchors(work);
  const State rest = rest_state(model_);
  cables_.update_topology(rest, work.topology);
  list_awake(rest, work, true);
  work.active.modes.clear();  // valid for no state yet
  return work;
}

/// Lists the sleeping bodies of the state, and the active set. In the evaluation after a change of modes the active set
/// is the whole scene, so that bodies and cables that remain asleep have their poses, paths and forces from then.
void Dynamics::list_awake(const State& state, Workspace& work, bool whole) const {
  ActiveSet& active = work.active;
  const auto modes = state.mode.begin() + static_cast<std::ptrdiff_t>(layout_.first_sleeper);
  active.modes.assign(modes, state.mode.end());
  active.awake.assign(model_.bodies.size(), 1);
  for (std::size_t i = 0; i < layout_.sleepers.size(); ++i)
    active.awake[index(layout_.sleepers[i])] = static_cast<char>(active.modes[i]);
  active.any_asleep = std::find(active.modes.begin(), active.modes.end(), Mode{0}) != active.modes.end();
  active.complete = whole;
  bodies_.list_awake(active);
  cables_.list_awake(active, work.topology);
  const auto last = std::find(active.awake.rbegin(), active.awake.rend(), char{1});
  const auto awake = static_cast<std::size_t>(active.awake.rend() - last);
  active.moving = layout_.first[awake];
  active.reached_bodies = whole ? model_.bodies.size() : awake;
  for (const JointSpan& span : active.joints) {
    if (span.on_body) active.reached_bodies = std::max(active.reached_bodies, span.body + span.count);
  }
}

std::size_t Dynamics::moving(const State& state, const Workspace& work) const {
  if (layout_.sleepers.empty()) return work.active.moving;
  const auto modes = state.mode.begin() + static_cast<std::ptrdiff_t>(layout_.first_sleeper);
  const std::vector<Mode>& known = work.active.modes;
  return std::equal(known.begin(), known.end(), modes, state.mode.end()) ? work.active.moving : state.q.size();
}

/// Updates the topology and the active set to the state's hangers and sleepers.
void Dynamics::follow_modes(const State& state, Workspace& work) const {
  const bool topology_changed = cables_.update_topology(state, work.topology);
  if (!layout_.sleepers.empty()) {
    const auto modes = state.mode.begin() + static_cast<std::ptrdiff_t>(layout_.first_sleeper);
    const bool changed =
        topology_changed || !std::equal(work.active.modes.begin(), work.active.modes.end(), modes, state.mode.end());
    const bool was_whole = work.active.complete && work.evaluated == Evaluated::loads;
    if (changed || was_whole) list_awake(state, work, changed);
  }
}

void Dynamics::update(const State& state, Workspace& work, Need need) const {
  follow_modes(state, work);
  bodies_.set_poses(state, work);
  work.pulled = need == Need::rates && cables_.pull_rows(state, work);
  const bool near = contacts_.find(state, work);
  // Velocities take a twenty-fifth of a small fence's step: computed only if needed below.
  if (!work.pulled || near) bodies_.set_velocities(state, work);
  if (!work.pulled) cables_.update(state, work);
  if (near) contacts_.update(state, work);
  work.evaluated = Evaluated::geometry;
}

void Dynamics::evaluate(State& state, Workspace& work, Rates& out, bool ledger) const {
  update(state, work, Need::rates);
  update_modes(state, work);
  rates(state, work, out, ledger);
}

void Dynamics::update_everywhere(const State& state, Workspace& work) const {
  const bool topology_changed = cables_.update_topology(state, work.topology);
  const auto modes = state.mode.begin() + static_cast<std::ptrdiff_t>(layout_.first_sleeper);
  const std::vector<Mode>& known = work.active.modes;
  const bool changed = !std::equal(known.begin(), known.end(), modes, state.mode.end());
  if (topology_changed || changed || !work.active.complete) list_awake(state, work, true);
  bodies_.update(state, work);
  cables_.update(state, work);
  if (contacts_.find(state, work)) contacts_.update(state, work);
  work.pulled = false;
  work.evaluated = Evaluated::geometry;
}

void Dynamics::update_all(const State& state, Workspace& work) const {
  cables_.update_topology(state, work.topology);
  // Without sleepers all cables are always listed, whichever hangers are broken.
  if (!layout_.sleepers.empty()) list_awake(state, work, true);
  bodies_.update(state, work);
  cables_.update(state, work);
  contacts_.update_all(work);
  work.pulled = false;
  work.evaluated = Evaluated::geometry;
}

void Dynamics::begin(State& state, Workspace& work) const {
  contacts_.begin(state, work);
  update_modes(state, work);
}

bool Dynamics::update_modes(State& state, Workspace& work, const State* before) const {
  TALUS_ASSERT(work.evaluated != Evaluated::nothing);
  work.evaluated = Evaluated::geometry;  // forces were computed in the previous modes
  // Calls without effect would take a thirtieth of a small fence's step.
  if (work.any_near) contacts_.update_modes(state, work, before);
  if (!work.active.on_linear_branch) cables_.update_modes(state, work);
  if (!model_.hangers.empty() && (handle_broken_chains(state, work) || break_hangers(state, work))) {
    update_modes(state, work);
    return true;
  }
  if (!work.active.any_asleep) return false;
  std::vector<BodyId> woken;
  std::copy_if(unbalanced_sleepers_.begin(), unbalanced_sleepers_.end(), std::back_inserter(woken),
               [&work](BodyId body) { return !work.active.awake[index(body)]; });
  contacts_.list_woken(work, woken);
  cables_.list_woken(state, work, model_.sleep == Sleep::exact ? 0.0 : 1e-13, woken);
  if (woken.empty()) return false;
  wake(state, woken);
  // The cables of a woken body may wake its neighbours.
  update(state, work);
  update_modes(state, work);
  return true;
}

void Dynamics::wake(State& state, const std::vector<BodyId>& bodies) const {
  for (const BodyId body : bodies) {
    const auto found = std::lower_bound(layout_.sleepers.begin(), layout_.sleepers.end(), body);
    if (found == layout_.sleepers.end() || *found != body) continue;
    state.mode[layout_.first_sleeper + static_cast<std::size_t>(found - layout_.sleepers.begin())] = Mode{1};
  }
}

/// Breaks the most overloaded hangers, and records the energy that the cables lose as they straighten. False if no
/// hanger is overloaded.
bool Dynamics::break_hangers(State& state, Workspace& work) const {
  const std::vector<HangerId> overloaded = cables_.overloaded(state, work);
  if (overloaded.empty()) return false;
  const Energy before = cable_energy(state, work);
  for (const HangerId hanger : overloaded) {
    state.mode[layout_.first_hanger + index(hanger)] = Mode{1};
    wake(state, cables_.joined_bodies(hanger));
  }
  relax(state, work, before, Mechanism::hanger_break);
  return true;
}

/// Releases the chains in which a cable broke: its tension, and the energy stored in the other cables, are lost at
/// once. False if no cable broke in a chain.
bool Dynamics::handle_broken_chains(State& state, Workspace& work) const {
  if (!cables_.any_chain_broken(state, work)) return false;
  relax(state, work, cable_energy(state, work), Mechanism::cable_break);
  return true;
}

Dynamics::Energy Dynamics::cable_energy(const State& state, const Workspace& work) const {
  return {cables_.stored_energy(state, work), std::accumulate(state.work.begin(), state.work.end(), 0.0)};
}

/// Evaluates the cables after a break, and records the energy that they lose beyond that of the changes of mode.
void Dynamics::relax(State& state, Workspace& work, Energy before, Mechanism loss) const {
  update(state, work);
  cables_.update_modes(state, work);
  const Energy after = cable_energy(state, work);
  state.work[static_cast<std::size_t>(loss)] += (before.stored - after.stored) - (after.lost - before.lost);
}

void Dynamics::memory_rates(const State& state, Workspace& work, Rates& out) const {
  if (!follows_motion_) return;  // and nothing else writes to out.z
  std::fill(out.z.begin(), out.z.end(), 0.0);
  contacts_.memory_rates(state, work, out);
}

void Dynamics::rates(const State& state, Workspace& work, Rates& out, bool ledger, bool slip_power) const {
  TALUS_ASSERT(work.evaluated != Evaluated::nothing && !(work.pulled && work.evaluated == Evaluated::loads));
  if (ledger || out.accounts) {
    out.work.fill(0.0);
    out.impulse.fill(0.0);
  }
  out.accounts = ledger;
  memory_rates(state, work, out);
  Rates* const accounts = ledger ? &out : nullptr;
  // Cables first: the doubled cable force of a half model and the two cable forces of a full model then give the same
  // sum to the last bit.
  cables_.load(state, work, accounts);
  if (work.any_near) contacts_.add(state, work, accounts, slip_power);
  work.evaluated = Evaluated::loads;
  bodies_.rates(work, out, ledger);
}

bool Dynamics::guards(const State& state, Workspace& work, std::span<double> out, double horizon) const {
  TALUS_ASSERT(work.has_geometry());
  std::fill(out.begin(), out.end(), std::numeric_limits<double>::infinity());
  contacts_.guards(state, work, out);
  return cables_.guards(state, work, horizon, out) || work.any_near;
}

void Dynamics::guards_of(const State& state, std::span<const std::size_t> modes, Workspace& work,
                         std::span<double> out) const {
  follow_modes(state, work);
  bodies_.update(state, work);
  work.evaluated = Evaluated::geometry;
  for (const std::size_t mode : modes)
    out[mode] = std::numeric_limits<double>::infinity();
  if (contacts_.update_of(state, modes, work)) contacts_.guards(state, work, out);
  const bool of_cables =
      std::any_of(modes.begin(), modes.end(), [this](std::size_t mode) { return !contacts_.has(mode); });
  if (of_cables) {
    work.pulled = false;
    cables_.update(state, work);
    cables_.guards(state, work, std::numeric_limits<double>::infinity(), out);
  }
  work.evaluated = Evaluated::nothing;
}

bool Dynamics::follows(const State& state) const { return contacts_.follows(state) || cables_.follows(state); }

double Dynamics::safe_step(const Workspace& work, double horizon) const {
  return contacts_.safe_step(work, horizon, gravity_magnitude_);
}

double Dynamics::longest_step(const Workspace& work) const {
  return contacts_.tunnelling_limit(work, gravity_magnitude_).longest_step;
}

std::vector<double> Dynamics::lengths() const {
  std::vector<double> lengths;
  for (std::size_t i = 0; i < inertias_.size(); ++i) {
    const Coordinate& coordinate = layout_.coordinates[i];
    const double mass = model_.bodies[index(coordinate.body)].mass;
    lengths.push_back(coordinate.axis == Axis::angle ? std::sqrt(inertias_[i] / mass) : 1.0);
  }
  return lengths;
}

void Dynamics::wake_all(State& state) const {
  std::fill(state.mode.begin() + static_cast<std::ptrdiff_t>(layout_.first_sleeper), state.mode.end(), Mode{1});
}

Energies Dynamics::energies(const State& state, const Workspace& work) const {
  TALUS_ASSERT(work.has_geometry());
  Energies sum = bodies_.energies(state, work);
  sum.contacts = contacts_.stored_energy(state, work);
  sum.cables = cables_.stored_energy(state, work);
  return sum;
}

Momenta Dynamics::momenta(const Workspace& work) const {
  TALUS_ASSERT(work.has_geometry());
  return bodies_.momenta(work);
}

void Dynamics::forces(const State& state, Workspace& work, LawForces& out) const {
  TALUS_ASSERT(work.has_geometry());
  out.instances.resize(contacts_.size());
  out.contacts.assign(model_.contacts.size(), 0.0);
  out.tensions.resize(cables_.size());
  contacts_.forces(state, work, out.instances);
  cables_.tensions(state, work, out.tensions);
  if (!work.any_near) return;
  for (std::size_t c = 0, instance = 0; c < out.contacts.size(); ++c) {
    double sum = 0.0;
    for (std::size_t i = 0; i < layout_.contact_instances[c]; ++i)
      sum += out.instances[instance++];
    out.contacts[c] = sum;
  }
}

double Dynamics::contact_depth(const Workspace& work, ContactId contact) const {
  TALUS_ASSERT(work.evaluated != Evaluated::nothing);
  const std::size_t first = layout_.contact_slots[index(contact)].mode;
  return largest_depth(work, first, first + layout_.contact_instances[index(contact)]);
}

double Dynamics::elongation(const Workspace& work, CableId cable) const {
  TALUS_ASSERT(work.has_geometry());
  return cables_.elongation(work, index(cable));
}

}  // namespace talus
