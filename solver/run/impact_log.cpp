#include "solver/run/impact_log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/base/error.hpp"

namespace talus {
namespace {

/// Calls visit(number) for all numbers of an impact; flags are numbers, too. The list of a checkpoint.
template <class Impact, class Visit>
void for_each_number(Impact& impact, Visit&& visit) {
  visit(impact.touch_time), visit(impact.separation_time);
  visit(impact.approach_speed), visit(impact.separation_speed);
  visit(impact.slip_before), visit(impact.slip_after);
  visit(impact.peak_force), visit(impact.peak_force_time), visit(impact.largest_overlap);
  visit(impact.normal_impulse), visit(impact.tangential_impulse);
  visit(impact.impulse.x), visit(impact.impulse.y);
}
constexpr std::size_t numbers_of_impact = 13, items_of_impact = numbers_of_impact + 3;
constexpr std::size_t items_of_acting = 12;

/// A whole number from a checkpoint below `limit`. Errors: InputError.
std::size_t index_below(std::string_view name, double found, std::size_t limit) {
  if (found >= 0.0 && found < static_cast<double>(limit) && found == std::floor(found))
    return static_cast<std::size_t>(found);
  throw InputError{fmt::format("{}: found {}; it must be a whole number from 0 to below {}", name, found, limit)};
}

/// Errors: InputError if the list does not consist of whole records.
void demand_records(std::string_view name, const std::vector<double>& list, std::size_t items) {
  if (list.size() % items != 0)
    throw InputError{fmt::format("{}: found {} numbers; it must be whole rows of {}", name, list.size(), items)};
}

}  // namespace

ImpactLog::ImpactLog(const Dynamics& dynamics)
    : dynamics_{&dynamics},
      acting_(dynamics.contacts().candidates()),
      motions_(dynamics.model().bodies.size()),
      depths_(dynamics.contacts().candidates()),
      motions_now_(dynamics.model().bodies.size()),
      friction_(dynamics.contacts().size()) {}

void ImpactLog::operator()(const Snapshot& snapshot, const StepInfo&) {
  const State& state = snapshot.state();
  const Poses& poses = snapshot.geometry().poses;
  for (std::size_t i = 0; i < motions_now_.size(); ++i)
    motions_now_[i] = {{poses.vx[i], poses.vy[i]}, poses.w[i]};
  const bool any_acts = any_set(state.mode.data(), dynamics_->contacts().size());
  if (any_acts) {
    static_cast<void>(snapshot.forces());
    dynamics_->contacts().friction_forces(state, snapshot.geometry(), friction_);
  }
  // With nothing in contact now and before, no impact begins or ends.
  if (any_acts || any_acting_) {
    for (std::size_t c = 0; c < acting_.size(); ++c)
      follow(c, snapshot);
  }
  any_acting_ = any_acts;
  observed_ = true;
  time_ = state.t;
  motions_ = motions_now_;
  depths_ = snapshot.depths();
}

bool ImpactLog::acts(const State& state, std::size_t contact) const {
  const Candidate& pair = dynamics_->contacts().pair(static_cast<ContactId>(contact));
  return any_set(&state.mode[pair.first], pair.last - pair.first);
}

/// Begins, continues or ends the impact of a contact.
void ImpactLog::follow(std::size_t contact, const Snapshot& snapshot) {
  const bool acts_now = acts(snapshot.state(), contact);
  std::optional<Acting>& acting = acting_[contact];
  if (!acts_now && !acting) return;
  const double time = snapshot.state().t, depth = snapshot.depths()[contact];
  const Forces now = acts_now ? forces(snapshot, contact) : Forces{};
  if (!acting) {
    acting.emplace();
    acting->impact = impacts_.size();
    locate(snapshot, contact, *acting);
    const Approach before = approach(*acting, observed_ ? motions_ : motions_now_);
    RecordedImpact impact;
    impact.contact = static_cast<ContactId>(contact);
    impact.from_start = !observed_;
    impact.touch_time = observed_ ? crossing(contact, depth, time) : time;
    impact.approach_speed = before.closing, impact.slip_before = before.slip;
    impact.peak_force = now.normal, impact.peak_force_time = time;
    impact.largest_overlap = depth;
    impacts_.push_back(impact);
  }
  RecordedImpact& impact = impacts_[acting->impact];
  if (observed_) add(impact, acting->forces, now, time);
  if (!acts_now) {
    const Approach after = approach(*acting, motions_now_);
    impact.ended = true;
    impact.separation_time = crossing(contact, depth, time);
    impact.separation_speed = -after.closing, impact.slip_after = after.slip;
    acting.reset();
    return;
  }
  if (now.normal > impact.peak_force) impact.peak_force = now.normal, impact.peak_force_time = time;
  impact.largest_overlap = std::max(impact.largest_overlap, depth);
  acting->forces = now;
  locate(snapshot, contact, *acting);
}

/// Stores the geometry of the acting instance that overlaps most.
void ImpactLog::locate(const Snapshot& snapshot, std::size_t contact, Acting& acting) const {
  const Candidate& pair = dynamics_->contacts().pair(static_cast<ContactId>(contact));
  const Workspace& work = snapshot.geometry();
  const State& state = snapshot.state();
  std::optional<std::size_t> deepest;
  for (std::size_t i = pair.first; i < pair.last; ++i) {
    if (state.mode[i] != 0 && (!deepest || work.gaps[i].depth > work.gaps[*deepest].depth)) deepest = i;
  }
  TALUS_DEMAND(deepest.has_value());
  acting.instance = *deepest;
  const Gap& gap = work.gaps[*deepest];
  const InstancePair& bodies = dynamics_->contacts().pairs()[*deepest];
  acting.n_AB = gap.n_AB;
  acting.arm_A = gap.p_WC - work.poses[index(bodies.a)].p_WB;
  acting.arm_B = gap.p_WC - work.poses[index(bodies.b)].p_WB;
}

/// Sums over the instances. The bodies of an instance may be those of the contact in reverse; the friction force along
/// the tangent is then the same, because normal and bodies change their signs together.
ImpactLog::Forces ImpactLog::forces(const Snapshot& snapshot, std::size_t contact) const {
  const ContactForces& contacts = dynamics_->contacts();
  const Candidate& pair = contacts.pair(static_cast<ContactId>(contact));
  const std::vector<double>& normal = snapshot.forces().instances;
  const Workspace& work = snapshot.geometry();
  const BodyId b = dynamics_->model().contacts[contact].b;
  Forces sum;
  for (std::size_t i = pair.first; i < pair.last; ++i) {
    if (normal[i] == 0.0 && friction_[i] == 0.0) continue;
    const Vec2 n = work.gaps[i].n_AB, tangent{-n.y, n.x};
    const Vec2 on_B = normal[i] * n - friction_[i] * tangent;
    sum.normal += normal[i];
    sum.tangential -= friction_[i];
    sum.on_b += contacts.pairs()[i].b == b ? on_B : -on_B;
  }
  return sum;
}

/// Adds the impulse of the step that ends at `time`, by the trapezoidal rule.
void ImpactLog::add(RecordedImpact& impact, const Forces& before, const Forces& after, double time) const {
  const double half = 0.5 * (time - time_);
  impact.normal_impulse += half * (before.normal + after.normal);
  impact.tangential_impulse += half * (before.tangential + after.tangential);
  impact.impulse += half * (before.on_b + after.on_b);
}

/// Time at which the overlap of the contact passes the beginning of the reach of its law, between the last state and
/// one with this overlap and time, by linear interpolation.
double ImpactLog::crossing(std::size_t contact, double depth, double time) const {
  const double reach = dynamics_->contacts().pair(static_cast<ContactId>(contact)).reach;
  const double before = depths_[contact] + reach, after = depth + reach;
  const double part = before / (before - after);
  // If the overlap does not change its sign, as of a law that reopens early, the change is that of the mode.
  return part >= 0.0 && part <= 1.0 ? time_ + part * (time - time_) : time;
}

ImpactLog::Approach ImpactLog::approach(const Acting& acting, const std::vector<Motion>& motions) const {
  const InstancePair& pair = dynamics_->contacts().pairs()[acting.instance];
  const auto velocity = [&](BodyId body, Vec2 arm) {
    const Motion& motion = motions[index(body)];
    return motion.v + cross(motion.w, arm);
  };
  const Vec2 B_past_A = velocity(pair.b, acting.arm_B) - velocity(pair.a, acting.arm_A);
  return {-dot(B_past_A, acting.n_AB), dot(B_past_A, {-acting.n_AB.y, acting.n_AB.x})};
}

void ImpactLog::serialize(Archive& archive) {
  archive.flag("observed", observed_);
  archive.number("time", time_);
  std::vector<double> motions;
  for (const Motion& body : motions_)
    motions.insert(motions.end(), {body.v.x, body.v.y, body.w});
  archive.numbers("motions", motions);
  for (std::size_t i = 0; i < motions_.size(); ++i) {
    const double* const of = &motions[3 * i];
    motions_[i] = {{of[0], of[1]}, of[2]};
  }
  archive.numbers("overlaps", depths_);
  serialize_impacts(archive);
  serialize_acting(archive);
}

void ImpactLog::serialize_impacts(Archive& archive) {
  std::vector<double> list;
  for (const RecordedImpact& impact : impacts_) {
    list.insert(list.end(),
                {static_cast<double>(index(impact.contact)), impact.from_start ? 1.0 : 0.0, impact.ended ? 1.0 : 0.0});
    for_each_number(impact, [&](double number) { list.push_back(number); });
  }
  archive.list("impacts", list);
  if (!archive.is_loading()) return;
  demand_records("impacts", list, items_of_impact);
  impacts_.clear();
  for (auto next = list.begin(); next != list.end();) {
    RecordedImpact impact;
    impact.contact = static_cast<ContactId>(index_below("impacts", *next++, acting_.size()));
    impact.from_start = index_below("impacts", *next++, 2) == 1;
    impact.ended = index_below("impacts", *next++, 2) == 1;
    for_each_number(impact, [&](double& number) { number = *next++; });
    impacts_.push_back(impact);
  }
}

void ImpactLog::serialize_acting(Archive& archive) {
  std::vector<double> list;
  for (const std::optional<Acting>& acting : acting_) {
    if (!acting) continue;
    const Forces& forces = acting->forces;
    list.insert(list.end(), {static_cast<double>(acting->impact), static_cast<double>(acting->instance), acting->n_AB.x,
                             acting->n_AB.y, acting->arm_A.x, acting->arm_A.y, acting->arm_B.x, acting->arm_B.y,
                             forces.normal, forces.tangential, forces.on_b.x, forces.on_b.y});
  }
  archive.list("acting", list);
  if (!archive.is_loading()) return;
  demand_records("acting", list, items_of_acting);
  std::fill(acting_.begin(), acting_.end(), std::nullopt);
  for (auto next = list.begin(); next != list.end();) {
    const auto take = [&next] { return *next++; };
    Acting acting;
    acting.impact = index_below("acting", take(), impacts_.size());
    acting.instance = index_below("acting", take(), friction_.size());
    acting.n_AB.x = take(), acting.n_AB.y = take();
    acting.arm_A.x = take(), acting.arm_A.y = take();
    acting.arm_B.x = take(), acting.arm_B.y = take();
    acting.forces.normal = take(), acting.forces.tangential = take();
    acting.forces.on_b.x = take(), acting.forces.on_b.y = take();
    acting_[index(impacts_[acting.impact].contact)] = acting;
  }
  any_acting_ = !list.empty();
}

}  // namespace talus
