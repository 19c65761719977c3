#include "verification/driver/baseline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "solver/base/error.hpp"

namespace talus::verification {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

bool contains(const std::vector<std::string>& list, const std::string& word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (std::isnan(a) && std::isnan(b));
}

ResultsSource source_of(const ResultsFile& given) {
  const Results& results = given.results;
  return {given.file, results.provenance, results.tier, holds(results), results.only};
}

/// The compared cases.
struct Scope {
  const std::vector<std::string>& run;       ///< Results::only of the new results.
  const std::vector<std::string>& compared;  ///< Allowance::only.

  [[nodiscard]] bool has(const std::string& id) const {
    return (run.empty() || contains(run, id)) && (compared.empty() || contains(compared, id));
  }
};

// --- Names ----------------------------------------------------------------------------------------------------------

/// The new name of an item of the baseline.
struct Target {
  std::optional<ItemName> name;  ///< No value: removed.
  int rank = 0;                  ///< 2: by a rename of the item, 1: by a rename of its case, 0: unchanged name.
};

class Targets {
 public:
  explicit Targets(const std::vector<Renaming>& renames) {
    for (const Renaming& renaming : renames)
      after_.emplace(renaming.before, renaming.after);
  }

  [[nodiscard]] Target of(const ItemName& before) const {
    if (const auto found = after_.find(before); found != after_.end()) return {found->second, 2};
    const auto in_case = after_.find({before.id, ""});
    if (in_case == after_.end()) return {before, 0};
    if (!in_case->second) return {std::nullopt, 1};
    return {ItemName{in_case->second->id, before.item}, 1};
  }

 private:
  std::map<ItemName, std::optional<ItemName>> after_;
};

template <class T>
using Items = std::vector<std::pair<ItemName, const T*>>;

std::vector<CaseOutcome> outcomes_of(const Results& results) {
  std::vector<CaseOutcome> outcomes;
  for (const Record& record : results.records)
    outcomes.push_back({record.status, record.message, record.seconds, record.evaluations});
  return outcomes;
}

/// `outcomes`: those of the results.
Items<CaseOutcome> cases_of(const Results& results, const std::vector<CaseOutcome>& outcomes) {
  Items<CaseOutcome> items;
  for (std::size_t i = 0; i < outcomes.size(); ++i)
    items.emplace_back(ItemName{results.records[i].id, ""}, &outcomes[i]);
  return items;
}

Items<Check> checks_of(const Results& results) {
  Items<Check> items;
  for (const Record& record : results.records) {
    for (const Check& check : record.checks)
      items.emplace_back(ItemName{record.id, check.name}, &check);
  }
  return items;
}

Items<Control> controls_of(const Results& results) {
  Items<Control> items;
  for (const Record& record : results.records) {
    for (const Control& control : record.controls)
      items.emplace_back(ItemName{record.id, control_item(control.name)}, &control);
  }
  return items;
}

/// Pairs the items of both results by name. Renamed items are paired first, so that no other item takes their new name.
/// Items out of scope are excluded.
template <class Changed, class T>
std::vector<Changed> paired(const Items<T>& before, const Items<T>& after, const Targets& targets, const Scope& scope) {
  std::map<ItemName, std::size_t> index;
  std::vector<Changed> now(after.size()), lost;
  for (std::size_t i = 0; i < after.size(); ++i) {
    index.emplace(after[i].first, i);
    now[i].name = after[i].first;
    now[i].presence = Presence::added;
    now[i].after = *after[i].second;
  }
  for (const int rank : {2, 1, 0}) {
    for (const auto& [name, value] : before) {
      const Target target = targets.of(name);
      if (target.rank != rank || !scope.has(target.name ? target.name->id : name.id)) continue;
      const auto found = target.name ? index.find(*target.name) : index.end();
      const bool is_free = found != index.end() && now[found->second].presence == Presence::added;
      Changed& change = is_free ? now[found->second] : lost.emplace_back();
      change.before = *value;
      change.presence = is_free ? Presence::both : target.name ? Presence::gone : Presence::removed;
      if (!is_free) change.name = name;
      if (is_free && name != *target.name) change.renamed_from = name;
    }
  }
  std::erase_if(now, [&](const Changed& change) { return !scope.has(change.name.id); });
  now.insert(now.end(), std::make_move_iterator(lost.begin()), std::make_move_iterator(lost.end()));
  for (Changed& change : now) {
    if (change.presence == Presence::gone) change.worse.push_back(Reason::gone);
  }
  return now;
}

bool has_item(const Results& results, const ItemName& name) {
  const Record* const found = find_case(results, name.id);
  if (found == nullptr) return false;
  const auto is_check = [&](const Check& check) { return check.name == name.item; };
  const auto is_control = [&](const Control& control) { return control_item(control.name) == name.item; };
  return name.item.empty() || std::any_of(found->checks.begin(), found->checks.end(), is_check) ||
         std::any_of(found->controls.begin(), found->controls.end(), is_control);
}

bool is_given(const std::vector<Renaming>& renames, const ItemName& name) {
  return std::any_of(renames.begin(), renames.end(), [&](const Renaming& r) { return r.after == name; });
}

std::string still_there(const Renaming& renaming, const std::string& where) {
  return fmt::format("{}: found '{}'; {} still has it: it must be a name that is no longer used", renaming.location,
                     text_of(renaming.before), where);
}

/// Renames whose new name does not exist, or whose old name still does. For a case that did not finish, the new name is
/// not required to exist.
std::vector<std::string> renaming_errors_of(const std::vector<Renaming>& renames, const ResultsFile& after,
                                            const Scope& scope) {
  std::vector<std::string> errors;
  const std::string file = after.file.string();
  for (const Renaming& renaming : renames) {
    const std::string& id = renaming.after ? renaming.after->id : renaming.before.id;
    if (!scope.has(id)) continue;
    const Record* const target = find_case(after.results, id);
    const bool ended = target == nullptr || finished(target->status);
    if (renaming.after && ended && !has_item(after.results, *renaming.after)) {
      errors.push_back(fmt::format("{}: found '{}' on the right; it must be a name of {}", renaming.location,
                                   text_of(*renaming.after), file));
    }
    if (has_item(after.results, renaming.before) && !is_given(renames, renaming.before))
      errors.push_back(still_there(renaming, file));
  }
  return errors;
}

// --- Changes ---------------------------------------------------------------------------------------------------------

bool is_letter_of(const std::string& name, const std::string& family) {
  return name.size() == 1 && family.starts_with(name + ":");
}

/// The largest change/bound that is allowed for a check of that case.
double tolerance_of(const Allowance& allowance, const ItemName& name, const std::string& family) {
  double value = 0.0;
  for (const ChangeTolerance& tolerance : allowance.tolerances) {
    if (tolerance.name.empty() || tolerance.name == family || is_letter_of(tolerance.name, family) ||
        tolerance.name == name.id)
      value = tolerance.value;
  }
  return value;
}

/// Growth of error/bound (after - before); NaN counts as infinite.
double growth_of(double before, double after) {
  const double from = std::isnan(before) ? infinity : before, to = std::isnan(after) ? infinity : after;
  return from == to ? 0.0 : to - from;
}

Movement movement_of(const Check& before, const Check& after, double moved) {
  if (before.unit != after.unit) return Movement::changed;
  if (same_bits(before.measured, after.measured)) return Movement::identical;
  const double limit = std::min(round_off_limit(before.kind), round_off_limit(after.kind));
  return moved <= limit ? Movement::round_off : Movement::changed;
}

/// |difference| in units of `scale`; infinite if the difference is not finite or if the scale is zero.
double moved_by(double difference, double scale) {
  if (difference == 0.0) return 0.0;
  return std::isfinite(difference) && scale > 0.0 ? std::abs(difference) / scale : infinity;
}

void weigh(CheckChange& change, const Allowance& allowance, double tolerance) {
  const Check& before = *change.before;
  const Check& after = *change.after;
  const bool is_same = same_bits(before.measured, after.measured);
  change.difference = is_same ? 0.0 : after.measured - before.measured;
  change.moved = moved_by(change.difference, change_scale(before));
  change.movement = movement_of(before, after, change.moved);
  change.growth = growth_of(before.margin, after.margin);
  change.tolerance = tolerance;
  if (allowance.round_off && change.movement == Movement::round_off)
    change.tolerance = std::max(tolerance, round_off_limit(before.kind));
  const bool improved = !before.pass && after.pass;
  const double growth = allowance.margin.value_or(change.tolerance);
  constexpr double rounding = 1.0 + 1e-9;  // The difference of two ratios has a rounding error; zero does not.
  if (before.pass && !after.pass) change.worse.push_back(Reason::verdict);
  if (before.unit != after.unit) change.worse.push_back(Reason::unit);
  const bool is_beyond = !improved && before.unit == after.unit && !(change.moved <= change.tolerance);
  const bool is_large = change.movement == Movement::changed;
  if (is_beyond && is_large) change.worse.push_back(Reason::value);
  if (change.growth > growth * rounding) change.worse.push_back(Reason::margin);
  if (is_beyond && !is_large) change.worse.push_back(Reason::round_off);
}

void weigh(ControlChange& change) {
  if (change.before->pass() && !change.after->pass()) change.worse.push_back(Reason::verdict);
}

void weigh(CaseChange& change, const Allowance& allowance) {
  if (change.before->status == Status::pass && change.after->status != Status::pass)
    change.worse.push_back(Reason::status);
  const auto before = static_cast<double>(change.before->evaluations);
  const auto after = static_cast<double>(change.after->evaluations);
  // A case without counted evaluations in the baseline cannot be compared.
  if (before > 0.0 && after > before * (1.0 + allowance.evaluation_growth)) change.worse.push_back(Reason::evaluations);
}

template <class Changes>
std::map<std::string, std::size_t> gone_by_case(const Changes& changes) {
  std::map<std::string, std::size_t> count;
  for (const auto& change : changes)
    count[change.name.id] += change.presence == Presence::gone ? 1 : 0;
  return count;
}

template <class Changes>
Totals::Items items_of(const Changes& changes) {
  Totals::Items items;
  for (const auto& change : changes) {
    if (change.presence == Presence::both) ++items.compared;
    if (change.presence == Presence::added) ++items.added;
    if (change.presence == Presence::gone) ++items.gone;
    if (change.presence == Presence::removed) ++items.removed;
    if (!change.worse.empty()) ++items.worse;
  }
  return items;
}

void add_verdict(Totals::Items& items, bool before, bool after) {
  if (before && !after) ++items.worsened;
  if (!before && after) ++items.improved;
}

}  // namespace

const Record* find_case(const Results& results, const std::string& id) {
  const auto found = std::ranges::find(results.records, id, &Record::id);
  return found == results.records.end() ? nullptr : &*found;
}

double round_off_limit(Kind kind) { return kind == Kind::round_off ? 1.0 : 1e-9; }

double change_scale(const Check& before) {
  if (before.bound == 0.0) return std::abs(before.reference);
  return before.relative ? before.bound * std::abs(before.reference) : before.bound;
}

Comparison compare(const ResultsFile& before_file, const ResultsFile& after_file, const Allowance& allowance,
                   const std::vector<Renaming>& renames) {
  const Results &before = before_file.results, &after = after_file.results;
  const Targets targets(renames);
  const Scope scope{after.only, allowance.only};
  Comparison comparison;
  comparison.before = source_of(before_file);
  comparison.after = source_of(after_file);
  comparison.allowance = allowance;
  const std::vector<CaseOutcome> outcomes_before = outcomes_of(before), outcomes_after = outcomes_of(after);
  comparison.cases =
      paired<CaseChange>(cases_of(before, outcomes_before), cases_of(after, outcomes_after), targets, scope);
  comparison.checks = paired<CheckChange>(checks_of(before), checks_of(after), targets, scope);
  comparison.controls = paired<ControlChange>(controls_of(before), controls_of(after), targets, scope);
  for (const Record& record : before.records) {
    const Target target = targets.of({record.id, ""});
    if (!scope.has(target.name ? target.name->id : record.id)) comparison.unselected.push_back(record.id);
  }
  for (CheckChange& change : comparison.checks) {
    if (change.presence == Presence::both) {
      weigh(change, allowance, tolerance_of(allowance, change.name, find_case(after, change.name.id)->family));
    }
  }
  for (ControlChange& change : comparison.controls) {
    if (change.presence == Presence::both) weigh(change);
  }
  // Items that are gone have their name in the baseline.
  const auto checks = gone_by_case(comparison.checks), controls = gone_by_case(comparison.controls);
  for (CaseChange& change : comparison.cases) {
    if (change.presence == Presence::both) weigh(change, allowance);
    const std::string& id = change.renamed_from ? change.renamed_from->id : change.name.id;
    if (const auto found = checks.find(id); found != checks.end()) change.checks_gone = found->second;
    if (const auto found = controls.find(id); found != controls.end()) change.controls_gone = found->second;
  }
  comparison.renaming_errors = renaming_errors_of(renames, after_file, scope);
  return comparison;
}

Totals totals_of(const Comparison& comparison) {
  Totals totals;
  totals.cases = items_of(comparison.cases);
  totals.checks = items_of(comparison.checks);
  totals.controls = items_of(comparison.controls);
  for (const CaseChange& change : comparison.cases) {
    if (change.presence != Presence::both) continue;
    add_verdict(totals.cases, change.before->status == Status::pass, change.after->status == Status::pass);
    totals.evaluations_before += change.before->evaluations;
    totals.evaluations_after += change.after->evaluations;
    totals.seconds_before += change.before->seconds;
    totals.seconds_after += change.after->seconds;
    if (change.after->evaluations > change.before->evaluations) ++totals.evaluations_grown;
    if (change.after->evaluations < change.before->evaluations) ++totals.evaluations_shrunk;
  }
  for (const CheckChange& change : comparison.checks) {
    if (change.presence != Presence::both) continue;
    const Check &before = *change.before, &after = *change.after;
    add_verdict(totals.checks, before.pass, after.pass);
    if (change.movement == Movement::identical) ++totals.identical;
    if (change.movement == Movement::round_off) ++totals.round_off;
    if (change.movement == Movement::changed) ++totals.changed;
    if (change.growth > 0.0) ++totals.margins_grown;
    if (change.growth < 0.0) ++totals.margins_shrunk;
    if (after.bound > before.bound) ++totals.bounds_widened;
    if (after.bound < before.bound) ++totals.bounds_tightened;
    if (!same_bits(before.reference, after.reference)) ++totals.references_changed;
  }
  for (const ControlChange& change : comparison.controls) {
    if (change.presence == Presence::both) add_verdict(totals.controls, change.before->pass(), change.after->pass());
  }
  return totals;
}

void validate(const ResultsFile& before, Tier tier, const Allowance& allowance, const std::vector<Renaming>& renames,
              const std::vector<std::string>& families, const std::vector<std::string>& registered) {
  const std::string file = before.file.string();
  const Results& results = before.results;
  if (results.tier != tier) {
    throw InputError(fmt::format("{}: tier: found \"{}\"; it must be \"{}\", the tier that it is compared with", file,
                                 name_of(results.tier), name_of(tier)));
  }
  if (results.records.empty()) throw InputError(file + ": cases: found none; there must be at least one");
  std::vector<std::string> known = families;
  known.insert(known.end(), registered.begin(), registered.end());
  for (const Record& record : results.records) {
    for (const std::string& name : {record.family, record.id}) {
      if (!name.empty() && !contains(known, name)) known.push_back(name);
    }
  }
  for (const ChangeTolerance& tolerance : allowance.tolerances) {
    const auto is_letter = [&](const std::string& family) { return is_letter_of(tolerance.name, family); };
    if (!tolerance.name.empty() && !contains(known, tolerance.name) &&
        std::none_of(known.begin(), known.end(), is_letter))
      throw unknown_name("--tolerance: family or case", tolerance.name, known);
  }
  for (const Renaming& renaming : renames) {
    if (!has_item(results, renaming.before)) {
      throw InputError(
          fmt::format("{}: found '{}' on the left; it must be a name of the baseline {} (delete the line if "
                      "the baseline has the new name already)",
                      renaming.location, text_of(renaming.before), file));
    }
    if (renaming.after && !contains(registered, renaming.after->id))
      throw unknown_name(renaming.location + ": case", renaming.after->id, registered);
    if (renaming.before.item.empty() && contains(registered, renaming.before.id) && !is_given(renames, renaming.before))
      throw InputError(still_there(renaming, "this program"));
  }
}

}  // namespace talus::verification
