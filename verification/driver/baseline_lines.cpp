#include "verification/driver/baseline_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "verification/record/check.hpp"

namespace talus::verification {

namespace {

/// A line with its sort keys.
struct SortedLine {
  int rank = 0;       ///< Severity rank of the reason.
  double size = 0.0;  ///< Size of the change.
  ChangeLine line;
};

std::vector<ChangeLine> in_order(std::vector<SortedLine> lines) {
  std::stable_sort(lines.begin(), lines.end(), [](const SortedLine& a, const SortedLine& b) {
    return a.rank != b.rank ? a.rank < b.rank : a.size > b.size;
  });
  std::vector<ChangeLine> sorted;
  for (SortedLine& line : lines)
    sorted.push_back(std::move(line.line));
  return sorted;
}

std::string with_unit(const std::string& number, const std::string& unit) {
  return unit == "1" || unit.empty() ? number : number + " " + unit;
}

template <class T>
std::string item_text(const Change<T>& change) {
  return text_of(change.name) + (change.renamed_from ? " (was " + text_of(*change.renamed_from) + ")" : "");
}

/// The measured value as text or number, followed by the reference in brackets if that changed.
std::string measured_text(const Check& check, const std::string& number, const std::string& reference) {
  const std::string measured = check.text_measured.empty() ? with_unit(number, check.unit) : check.text_measured;
  const std::string verdict = check.pass ? "" : "FAIL ";
  return verdict + measured + (reference.empty() ? "" : " (reference " + reference + ")");
}

std::string bound_text(const Check& check, double bound) {
  if (bound == 0.0) return "exact";
  const std::string number = fmt::format("{:.4g}", bound);
  return check.relative ? number + " of the reference" : with_unit(number, check.unit);
}

/// change/bound; for an exact check, which has no bound, the change relative to the reference.
std::string moved_text(const CheckChange& change) {
  const std::string number = fmt::format("{:.3g}", change.moved);
  return change.before->bound == 0.0 && change.moved > 0.0 && std::isfinite(change.moved) ? number + " of the reference"
                                                                                          : number;
}

/// error/bound before and after, each on the correct side of 1, with as many digits as show that they differ.
std::string margin_change(const Check& before, const Check& after) {
  std::string from, to;
  for (int digits = 3; digits <= 17 && from == to; ++digits) {
    from = records::margin_text(before.margin, before.pass, digits);
    to = records::margin_text(after.margin, after.pass, digits);
    if (before.margin == after.margin) break;
  }
  return from == to ? from : from + " -> " + to;
}

ChangeLine line_of(const CheckChange& change, const std::string& why) {
  const Check &before = *change.before, &after = *change.after;
  const auto [old_value, new_value] = number_pair(before.measured, after.measured);
  auto [old_reference, new_reference] = number_pair(before.reference, after.reference);
  if (old_reference == new_reference) old_reference = new_reference = "";
  ChangeLine line;
  line.why = why;
  line.item = item_text(change);
  line.before = measured_text(before, old_value, old_reference);
  line.after = measured_text(after, new_value, new_reference);
  line.bound = bound_text(before, before.bound);
  if (const std::string now = bound_text(after, after.bound); now != line.bound) line.bound += " -> " + now;
  line.moved = moved_text(change);
  line.margin = margin_change(before, after);
  return line;
}

ChangeLine line_of_gone(const CheckChange& change, const std::string& why) {
  const Check& before = *change.before;
  ChangeLine line;
  line.why = why;
  line.item = item_text(change);
  line.before = measured_text(before, fmt::format("{:.6g}", before.measured), "");
  line.after = "not made";
  line.bound = bound_text(before, before.bound);
  return line;
}

std::string colours(const Control& control) {
  if (control.pass()) return "red with the fault";
  return fmt::format("FAIL '{}' is {} with the fault, {} without it", control.turns_red, name_of(control.observed),
                     name_of(control.unplanted));
}

std::string status_text(const CaseOutcome& outcome) {
  return name_of(outcome.status) + (outcome.message.empty() ? "" : ": " + outcome.message);
}

std::string with_its_items(const CaseChange& change) {
  if (change.checks_gone + change.controls_gone == 0) return "";
  return fmt::format(" ({} and {} gone)", counted(change.checks_gone, "check"),
                     counted(change.controls_gone, "control"));
}

void add_lines(const CaseChange& change, std::vector<SortedLine>& lines) {
  for (const Reason reason : change.worse) {
    ChangeLine line;
    line.why = name_of(reason);
    line.item = item_text(change);
    double size = 0.0;
    if (reason == Reason::evaluations) {
      const auto before = static_cast<double>(change.before->evaluations);
      size = (static_cast<double>(change.after->evaluations) - before) / before;
      line.before = grouped(change.before->evaluations) + " evaluations";
      line.after = fmt::format("{} (+{:.3g} %)", grouped(change.after->evaluations), 100.0 * size);
    } else {
      line.before = status_text(*change.before);
      line.after = (reason == Reason::gone ? "not run" : status_text(*change.after)) + with_its_items(change);
    }
    lines.push_back({static_cast<int>(reason), size, std::move(line)});
  }
}

/// Cases whose checks and controls need no separate lines when they are gone.
std::set<std::string> unfinished_cases(const Comparison& comparison) {
  std::set<std::string> ids;
  for (const CaseChange& change : comparison.cases) {
    const bool ended = change.presence == Presence::both && finished(change.after->status);
    if (!ended) ids.insert(change.renamed_from ? change.renamed_from->id : change.name.id);
  }
  return ids;
}

/// Kind of change of a check that is not worse; empty if unchanged.
std::string admitted_change(const CheckChange& change) {
  const Check &before = *change.before, &after = *change.after;
  if (!before.pass && after.pass) return "improved";
  if (after.bound > before.bound) return "bound widened";
  if (change.movement == Movement::changed) return "value";
  if (after.bound < before.bound) return "bound tightened";
  if (change.movement == Movement::round_off) return "round-off";
  return before.reference == after.reference ? "" : "reference";
}

}  // namespace

std::vector<ChangeLine> lines_of_worse(const Comparison& comparison) {
  std::vector<SortedLine> lines;
  const auto unfinished = unfinished_cases(comparison);
  const auto is_in_case_line = [&](const auto& change) {
    return change.presence == Presence::gone && unfinished.contains(change.name.id);
  };
  for (const CaseChange& change : comparison.cases)
    add_lines(change, lines);
  for (const CheckChange& change : comparison.checks) {
    if (change.worse.empty() || is_in_case_line(change)) continue;
    const Reason reason = change.worse.front();
    const bool is_gone = reason == Reason::gone;
    lines.push_back({static_cast<int>(reason),
                     is_gone                    ? 0.0
                     : reason == Reason::margin ? change.growth
                                                : change.moved,
                     is_gone ? line_of_gone(change, name_of(reason)) : line_of(change, name_of(reason))});
  }
  for (const ControlChange& change : comparison.controls) {
    if (change.worse.empty() || is_in_case_line(change)) continue;
    ChangeLine line;
    line.why = name_of(change.worse.front());
    line.item = item_text(change);
    line.before = colours(*change.before);
    line.after = change.after ? colours(*change.after) : "not planted";
    lines.push_back({static_cast<int>(change.worse.front()), 0.0, std::move(line)});
  }
  return in_order(std::move(lines));
}

std::vector<ChangeLine> lines_of_admitted(const Comparison& comparison) {
  std::vector<SortedLine> lines;
  for (const CheckChange& change : comparison.checks) {
    if (change.presence != Presence::both || !change.worse.empty()) continue;
    const std::string why = admitted_change(change);
    if (!why.empty()) lines.push_back({0, change.moved, line_of(change, why)});
  }
  return in_order(std::move(lines));
}

namespace {

/// The names of cases, checks and controls for which `listed` is true, without the checks and controls of listed cases.
template <class Listed>
std::vector<std::string> names_where(const Comparison& comparison, Listed&& listed) {
  std::vector<std::string> names;
  std::set<std::string> whole;
  for (const CaseChange& change : comparison.cases) {
    if (!listed(change.presence)) continue;
    names.push_back(item_text(change));
    whole.insert(change.name.id);
  }
  const auto add = [&](const auto& changes) {
    for (const auto& change : changes) {
      if (listed(change.presence) && !whole.contains(change.name.id)) names.push_back(item_text(change));
    }
  };
  add(comparison.checks);
  add(comparison.controls);
  return names;
}

}  // namespace

std::vector<std::string> new_items(const Comparison& comparison) {
  return names_where(comparison, [](Presence presence) { return presence == Presence::added; });
}

std::vector<std::string> lost_items(const Comparison& comparison) {
  return names_where(comparison,
                     [](Presence presence) { return presence == Presence::gone || presence == Presence::removed; });
}

std::vector<Difference> build_differences(const Comparison& comparison) {
  const Provenance &before = comparison.before.provenance, &after = comparison.after.provenance;
  std::vector<Difference> all{{"compiler", before.compiler, after.compiler},
                              {"flags", before.flags, after.flags},
                              {"build type", before.build_type, after.build_type},
                              {"processor", before.cpu, after.cpu},
                              {"system", before.os, after.os}};
  std::map<std::string, std::pair<std::string, std::string>> libraries;
  for (const auto& [library, version] : before.libraries)
    libraries[library].first = version;
  for (const auto& [library, version] : after.libraries)
    libraries[library].second = version;
  for (const auto& [library, versions] : libraries)
    all.push_back({library, versions.first, versions.second});
  std::erase_if(all, [](const Difference& difference) { return difference.before == difference.after; });
  for (Difference& difference : all) {
    if (difference.before.empty()) difference.before = "none";
    if (difference.after.empty()) difference.after = "none";
  }
  return all;
}

std::vector<const CaseChange*> by_seconds(const Comparison& comparison) {
  std::vector<const CaseChange*> cases;
  for (const CaseChange& change : comparison.cases) {
    if (change.presence == Presence::both) cases.push_back(&change);
  }
  const auto size = [](const CaseChange* change) { return std::abs(change->after->seconds - change->before->seconds); };
  std::stable_sort(cases.begin(), cases.end(),
                   [&](const CaseChange* a, const CaseChange* b) { return size(a) > size(b); });
  return cases;
}

std::string revision_text(const Provenance& from) {
  return from.revision.substr(0, 12) + (from.dirty ? " (modified)" : "");
}

std::pair<std::string, std::string> number_pair(double before, double after) {
  std::pair<std::string, std::string> pair;
  for (int digits = 6; digits <= std::numeric_limits<double>::max_digits10; ++digits) {
    pair = {fmt::format("{:.{}g}", before, digits), fmt::format("{:.{}g}", after, digits)};
    if (before == after || pair.first != pair.second) break;
  }
  return pair;
}

std::string grouped(std::uint64_t number) {
  std::string text = std::to_string(number);
  for (auto at = static_cast<std::ptrdiff_t>(text.size()) - 3; at > 0; at -= 3)
    text.insert(static_cast<std::size_t>(at), 1, ',');
  return text;
}

std::string counted(std::size_t count, const std::string& noun) {
  return grouped(count) + " " + noun + (count == 1 ? "" : "s");
}

}  // namespace talus::verification
