#include "solver/stability/run_monitor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/base/error.hpp"
#include "solver/dynamics/dynamics.hpp"
#include "solver/geometry/gap.hpp"
#include "solver/geometry/penetration.hpp"
#include "solver/integrate/integrator_list.hpp"
#include "solver/run/simulate.hpp"
#include "solver/run/snapshot.hpp"

namespace talus {
namespace {

/// Overlap over half the minimum width beyond which two bodies may slip through each other.
constexpr double deepest_ratio = 0.5;
/// Overlap over half the minimum width beyond which the shapes are no longer those of the scene.
constexpr double deep_ratio = 0.25;
/// A contact of fewer steps has a speed error of more than 5 % (0.45/N with a dashpot, the worst over all phases).
constexpr double fewest_steps = 10.0;

constexpr long regular_checks = 64, frequency_checks = 512;

/// Number of pairs without a contact whose overlap is reported.
constexpr long maximum_reported_pairs = 5;

std::vector<double> times_of_contacts(const Dynamics& dynamics, const StepAdvice& advice) {
  std::vector<double> times(dynamics.contacts().size());
  for (std::size_t i = 0; i < times.size(); ++i)
    times[i] = advice.springs[i].contact_time;
  return times;
}

/// The contact to which an instance belongs.
ContactId contact_of(const Dynamics& dynamics, std::size_t instance) {
  const std::vector<std::size_t>& counts = dynamics.layout().contact_instances;
  std::size_t contact = 0;
  for (; instance >= counts[contact]; ++contact)
    instance -= counts[contact];
  return static_cast<ContactId>(contact);
}

Rectangle box_around(const Bounds& bounds) { return {bounds.half_width, bounds.half_height}; }

}  // namespace

RunMonitor::RunMonitor(const Scene& scene, const Dynamics& dynamics, const State& start)
    : scene_{&scene}, dynamics_{&dynamics}, ledger_{dynamics, start}, modes_{start.mode} {
  fixed_step_ = !chooses_steps(scene.integrator);
  const std::vector<Contact>& contacts = scene.model.contacts;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    if (contacts[c].method == ContactMethod::nodes) by_nodes_.push_back(static_cast<ContactId>(c));
  }
  if (scene.plan.watch.missing_contacts != CheckAction::off) {
    missing_contacts_.emplace(dynamics);
    if (missing_contacts_->is_too_large()) warnings_.push_back(unchecked_pairs_warning());
    if (!missing_contacts_->is_checked()) missing_contacts_.reset();
  }
  if (missing_contacts_) {
    // Before the first step, so that a long run does not hide them until its end.
    Workspace work = dynamics.workspace();
    dynamics.update_all(start, work);
    check_missing_contacts(start.t, work);
    start_warnings_ = warnings_;
  }
  const long steps = step_count(scene.plan);
  every_ = std::max(1L, steps / regular_checks);
  apart_ = std::max(1L, steps / frequency_checks);
  if (start.q.size() > maximum_watched_coordinates) return;
  const StepAdvice closed = advise_step(dynamics, start);
  contact_times_ = times_of_contacts(dynamics, closed);
  if (const auto verdict = step_verdict(scene, closed))
    step_is_beyond_ = verdict->is_beyond, step_ratio_ = verdict->text;
}

template <class Message>
void RunMonitor::take(Watched which, double value, double limit, CheckAction violation, const State& seen,
                      ContactId contact, const Message& message) {
  const auto index = static_cast<std::size_t>(which);
  Extreme& extreme = extremes_[index];
  // For steps in a contact the extreme is the minimum; NaN counts as the worst value.
  const bool fewest = which == Watched::contact;
  const bool beyond = !(fewest ? value >= limit : value <= limit);
  if (!extreme.seen || !(fewest ? value >= extreme.value : value <= extreme.value))
    extreme = {value, seen.t, contact, true};
  if (!beyond || reported_[index] >= limit) return;
  reported_[index] = limit;
  const std::string said = fmt::format("at t = {:.6g} {}", seen.t, message());
  if (violation == CheckAction::error) {
    violation_ = said;
  } else {
    warnings_.push_back(said);
  }
}

void RunMonitor::check(const Snapshot& snapshot, long step, const std::optional<Balance>& balance) {
  const State& seen = snapshot.state();
  const MonitorRules& rules = scene_->plan.watch;
  const bool turn = step % every_ == 0;
  const bool changed = seen.mode != modes_;
  if (fixed_step_ && rules.instability != CheckAction::off && seen.q.size() <= maximum_watched_coordinates &&
      (turn || (changed && step - checked_step_ >= apart_))) {
    checked_step_ = step;
    check_frequency(snapshot);
  }
  if (changed && fixed_step_ && rules.accuracy != CheckAction::off) check_contact_steps(seen);
  if (step == 0 || changed) follow_contacts(seen);
  if (last_.touching) last_.time = seen.t;
  if (changed) modes_ = seen.mode;
  if ((rules.tunnelling != CheckAction::off || rules.accuracy != CheckAction::off) &&
      (step % 8 == 0 || touches(seen))) {
    check_pairs(snapshot);
    if (step % 8 == 0) check_unseen_overlaps(snapshot);
  }
  if (missing_contacts_ && reported_pairs_ < maximum_reported_pairs)
    check_missing_contacts(snapshot.state().t, snapshot.geometry());
  if ((turn || balance) && scene_->plan.ledger && rules.accuracy != CheckAction::off) check_balance(snapshot, balance);
}

/// True if some contact acts.
bool RunMonitor::touches(const State& seen) const { return any_set(seen.mode.data(), dynamics_->contacts().size()); }

/// Must be called before modes_ is set to the modes of the state.
void RunMonitor::follow_contacts(const State& seen) {
  const std::size_t count = dynamics_->contacts().size();
  std::optional<std::size_t> acts, ended;
  for (std::size_t i = 0; i < count; ++i) {
    if (seen.mode[i] != 0) {
      acts = i;
    } else if (modes_[i] != 0) {
      ended = i;
    }
  }
  if (!acts && !ended) return;
  touched_ = true;
  last_ = {contact_of(*dynamics_, acts ? *acts : *ended), seen.t, acts.has_value()};
}

std::optional<RunMonitor::LastContact> RunMonitor::last_contact() const {
  if (!touched_) return std::nullopt;
  return last_;
}

void RunMonitor::check_frequency(const Snapshot& snapshot) {
  const State& seen = snapshot.state();
  const std::vector<Spring> acting = acting_springs(*dynamics_, seen, snapshot.geometry());
  const auto limit = step_limit(natural_modes(*dynamics_, acting), name(scene_->integrator));
  if (!limit) return;
  const double step = scene_->plan.step;
  take(Watched::frequency, step / limit->step, 1.0, scene_->plan.watch.instability, seen, {}, [&] {
    return fmt::format(
        "h omega = {:.4g} > {:.4g}, the linear limit of {} for the mode of {:.4g} rad a unit of time, xi "
        "{:.3g}, of the springs that act: the motion grows without bound; the limit of the step is {:.4g}",
        step * limit->mode.frequency, limit->product, name(scene_->integrator), limit->mode.frequency,
        limit->mode.damping_ratio, limit->step);
  });
}

void RunMonitor::check_pairs(const Snapshot& snapshot) {
  if (dynamics_->contacts().candidates() == 0) return;
  const MonitorRules& rules = scene_->plan.watch;
  const auto contact_name = [this](ContactId contact) { return dynamics_->model().contacts[index(contact)].name; };
  const State& seen = snapshot.state();
  const Workspace& work = snapshot.geometry();
  if (fixed_step_ && rules.tunnelling != CheckAction::off) {
    const auto limit = dynamics_->contacts().tunnelling_limit(work, norm(dynamics_->model().gravity));
    if (std::isfinite(limit.longest_step)) {
      take(Watched::passing, scene_->plan.step / limit.longest_step, 1.0, rules.tunnelling, seen, limit.contact, [&] {
        return fmt::format(
            "the bodies of contact '{}' may pass each other unseen: a step is {:.3g} times the longest in "
            "which they cannot; it must be below {:.4g}",
            contact_name(limit.contact), scene_->plan.step / limit.longest_step, limit.longest_step);
      });
    }
  }
  const auto overlap = dynamics_->contacts().deepest_overlap(work);
  take_overlap(Watched::overlap, overlap.ratio, seen, overlap.contact, [](bool through) {
    return fmt::format(
        "{}; it needs a stiffer contact (overlaps are proportional to 1/sqrt(k)), a slower impact, or bodies farther "
        "apart at the start",
        through ? "the bodies may slip through each other" : "its shapes are no longer the scene's");
  });
}

/// Outlines may overlap without a node of either inside the other: two crossed bars, or a peak of the ground.
void RunMonitor::check_unseen_overlaps(const Snapshot& snapshot) {
  const Workspace& work = snapshot.geometry();
  for (const ContactId contact : by_nodes_) {
    const std::size_t c = index(contact);
    const Candidate& pair = dynamics_->contacts().pair(contact);
    const auto none_in = [&] {
      const auto gaps = work.gaps.begin();
      return std::none_of(gaps + static_cast<std::ptrdiff_t>(pair.first), gaps + static_cast<std::ptrdiff_t>(pair.last),
                          [](const Gap& gap) { return gap.depth > 0.0; });
    };
    if (!work.near[c] || !none_in()) continue;
    const Pose A = work.poses[index(pair.a)], B = work.poses[index(pair.b)];
    const double size = smaller_size(pair);
    // Boxes around the outlines are cheap to check, and overlap at least as far.
    if (!is_unbounded(pair.bounds_a) && !is_unbounded(pair.bounds_b) &&
        !(gap(box_around(pair.bounds_a), A, box_around(pair.bounds_b), B).depth > deep_ratio * size))
      continue;
    const std::vector<Body>& bodies = dynamics_->model().bodies;
    const double ratio = penetration(bodies[index(pair.a)].shape, A, bodies[index(pair.b)].shape, B) / size;
    // A curved outline always overlaps a little between two nodes.
    if (ratio <= deep_ratio) continue;
    take_overlap(Watched::unseen, ratio, snapshot.state(), contact, [](bool) {
      return "no node of either is in the other, so that no force acts; it needs more nodes, or the method resultant";
    });
  }
}

template <class Message>
void RunMonitor::take_overlap(Watched which, double ratio, const State& seen, ContactId contact,
                              const Message& message) {
  if (!(ratio > 0.0)) return;
  const MonitorRules& rules = scene_->plan.watch;
  const bool through = ratio > deepest_ratio && rules.tunnelling != CheckAction::off;
  if (!through && rules.accuracy == CheckAction::off) return;
  const double limit = through ? deepest_ratio : deep_ratio;
  take(which, ratio, limit, through ? rules.tunnelling : rules.accuracy, seen, contact, [&] {
    return fmt::format(
        "contact '{}' overlaps by {:.3g} of half the least width of its smaller body, more than {:g}: {}",
        dynamics_->model().contacts[index(contact)].name, ratio, limit, message(through));
  });
}

void RunMonitor::check_missing_contacts(double time, const Workspace& geometry) {
  for (const UndeclaredOverlap& overlap : missing_contacts_->new_overlaps(geometry)) {
    if (reported_pairs_++ == maximum_reported_pairs) return;
    const std::string said =
        fmt::format("at t = {:.6g} {}{}", time, overlap_text(overlap, dynamics_->model()),
                    reported_pairs_ == maximum_reported_pairs ? "; further pairs are not reported" : "");
    if (scene_->plan.watch.missing_contacts == CheckAction::error) {
      violation_ = said;
      return;
    }
    warnings_.push_back(said);
  }
}

std::vector<std::pair<BodyId, BodyId>> RunMonitor::undeclared_overlaps() const {
  return missing_contacts_ ? missing_contacts_->returned() : std::vector<std::pair<BodyId, BodyId>>{};
}

void RunMonitor::check_contact_steps(const State& seen) {
  for (std::size_t i = 0; i < contact_times_.size(); ++i) {
    if (modes_[i] != 0 || seen.mode[i] == 0 || !std::isfinite(contact_times_[i])) continue;
    const double steps = contact_times_[i] / scene_->plan.step;
    const ContactId contact = contact_of(*dynamics_, i);
    take(Watched::contact, steps, fewest_steps, scene_->plan.watch.accuracy, seen, contact, [&] {
      return fmt::format(
          "contact '{}' touches, which lasts {:.3g} steps: its speeds may be off by {:.2g} %; a step of "
          "{:.3g} gives it 50",
          dynamics_->model().contacts[index(contact)].name, steps, 45.0 / steps, contact_times_[i] / 50.0);
    });
  }
}

void RunMonitor::check_balance(const Snapshot& snapshot, const std::optional<Balance>& balance) {
  Balance now;
  if (balance) {
    now = *balance;
  } else {
    now.error = ledger_.accounts(snapshot).energy_balance_error;
    now.scale = ledger_.energy_scale();
  }
  if (keep_larger(balance_.error, std::abs(now.error))) drift_time_ = snapshot.state().t;
  balance_.scale = std::max(balance_.scale, now.scale);
  if (scene_->plan.watch.accuracy == CheckAction::error && !(drift() <= largest_balance_error))
    violation_ = drift_text();
}

std::string RunMonitor::drift_text() const {
  const std::string text = fmt::format("at t = {:.6g} {}", drift_time_, balance_text(drift()));
  return std::isfinite(drift()) ? fmt::format("{}, more than {:g} %", text, 100.0 * largest_balance_error) : text;
}

std::vector<std::string> RunMonitor::warnings() const {
  std::vector<std::string> all = warnings_;
  const bool judged = scene_->plan.ledger && scene_->plan.watch.accuracy == CheckAction::warning;
  if (judged && !(drift() <= largest_balance_error)) all.push_back(drift_text());
  return all;
}

void RunMonitor::serialize(Archive& archive) {
  archive.numbers("modes", modes_);
  archive.count("checked", checked_step_);
  archive.scope("ledger", [&] { ledger_.serialize(archive); });
  if (missing_contacts_) {
    archive.count("reported_pairs", reported_pairs_);
    archive.scope("missing_contacts", [&] { missing_contacts_->serialize(archive); });
  }
  archive.number("balance_error", balance_.error);
  archive.number("balance_scale", balance_.scale);
  archive.number("drift_time", drift_time_);
  archive.flag("touched", touched_);
  archive.flag("touching", last_.touching);
  archive.number("last_contact_time", last_.time);
  long contact = static_cast<long>(index(last_.contact));
  archive.count("last_contact", contact);
  if (contact != 0 && contact >= static_cast<long>(dynamics_->model().contacts.size()))
    throw InputError{fmt::format("last_contact: found {}; there are {}", contact, dynamics_->model().contacts.size())};
  last_.contact = static_cast<ContactId>(contact);
  std::vector<double> numbers;
  for (std::size_t i = 0; i < watched_count; ++i) {
    const Extreme& e = extremes_[i];
    numbers.insert(numbers.end(),
                   {e.value, e.time, static_cast<double>(index(e.contact)), e.seen ? 1.0 : 0.0, reported_[i]});
  }
  archive.numbers("extremes", numbers);
  std::string said = fmt::format("{}", fmt::join(warnings_, "\n"));
  archive.text("warnings", said);
  if (!archive.is_loading()) return;
  for (std::size_t i = 0; i < watched_count; ++i) {
    const double* at = &numbers[5 * i];
    const std::size_t contacts = dynamics_->model().contacts.size();
    const bool at_contact = at[3] != 0.0 && i != static_cast<std::size_t>(Watched::frequency);
    if (!(at[2] >= 0.0 && at[2] < (at_contact ? static_cast<double>(contacts) : 1.0) && at[2] == std::floor(at[2])))
      throw InputError{fmt::format("extremes: found contact {}; there are {}", at[2], contacts)};
    extremes_[i] = {at[0], at[1], static_cast<ContactId>(at[2]), at[3] != 0.0};
    reported_[i] = at[4];
  }
  warnings_.clear();
  for (std::size_t from = 0; from < said.size();) {
    const std::size_t end = std::min(said.find('\n', from), said.size());
    warnings_.push_back(said.substr(from, end - from));
    from = end + 1;
  }
}

std::vector<std::string> watch_lines(const RunMonitor& watch, const Scene& scene) {
  std::vector<std::string> lines;
  const auto line = [&](Watched which, std::string_view what, double scale, std::string_view unit, bool at_contact) {
    const RunMonitor::Extreme& extreme = watch.extreme(which);
    if (!extreme.seen) return;
    lines.push_back(
        fmt::format("{:<34}{:>10.4g}{} at t = {:.6g}{}", what, scale * extreme.value, unit, extreme.time,
                    at_contact ? fmt::format(", '{}'", scene.model.contacts[index(extreme.contact)].name) : ""));
  };
  line(Watched::frequency, "step over its linear limit", 1.0, "  ", false);
  line(Watched::passing, "step over the longest unseen pass", 1.0, "  ", true);
  line(Watched::overlap, "largest overlap over half width", 100.0, " %", true);
  line(Watched::unseen, "largest overlap unseen by nodes", 100.0, " %", true);
  line(Watched::contact, "steps in the shortest contact", 1.0, "  ", true);
  return lines;
}

}  // namespace talus
