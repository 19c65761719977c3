#include "verification/driver/baseline_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "verification/driver/baseline_lines.hpp"

namespace talus::verification {

namespace {

constexpr std::size_t worse_rows = 50;
constexpr std::size_t admitted_rows = 5;
constexpr std::size_t names_listed = 5;

std::string row(const std::string& name, const std::string& text) { return fmt::format("{:<12} {}\n", name, text); }

/// Non-zero counts as text: "2 new, 1 gone".
std::string joined(const std::vector<std::pair<std::size_t, std::string>>& counts) {
  std::string text;
  for (const auto& [count, message] : counts) {
    if (count > 0) text += (text.empty() ? "" : ", ") + grouped(count) + " " + message;
  }
  return text;
}

std::string presence_text(const Totals::Items& items) {
  return joined({{items.added, "new"},
                 {items.gone, "gone"},
                 {items.removed, "removed"},
                 {items.worsened, "pass -> fail"},
                 {items.improved, "fail -> pass"}});
}

std::string plus(const std::string& text, const std::string& more) { return more.empty() ? text : text + "; " + more; }

std::string totals_text(const Comparison& comparison, const Totals& totals) {
  const std::string values =
      joined({{totals.identical, "identical"}, {totals.round_off, "within round-off"}, {totals.changed, "changed"}});
  std::string text =
      row("compared",
          fmt::format("{}, {}, {}{}", counted(totals.cases.compared, "case"), counted(totals.checks.compared, "check"),
                      counted(totals.controls.compared, "control"),
                      comparison.unselected.empty() ? ""
                                                    : fmt::format("; {} of the baseline not selected",
                                                                  counted(comparison.unselected.size(), "case"))));
  if (const std::string cases = presence_text(totals.cases); !cases.empty()) text += row("cases", cases);
  text += row("checks", plus("measured values: " + (values.empty() ? "none" : values), presence_text(totals.checks)));
  if (const std::string controls = presence_text(totals.controls); !controls.empty()) text += row("controls", controls);
  const std::string margins = joined({{totals.margins_grown, "grew"}, {totals.margins_shrunk, "shrank"}});
  if (!margins.empty()) text += row("error/bound", margins);
  const std::string bounds = joined({{totals.bounds_widened, "widened"},
                                     {totals.bounds_tightened, "tightened"},
                                     {totals.references_changed, "with another reference"}});
  if (!bounds.empty()) text += row("bounds", bounds);
  const std::string evaluations =
      totals.evaluations_grown + totals.evaluations_shrunk == 0
          ? ""
          : fmt::format("more in {}, fewer in {}", counted(totals.evaluations_grown, "case"),
                        counted(totals.evaluations_shrunk, "case"));
  text += row("evaluations",
              plus(grouped(totals.evaluations_before) + (totals.evaluations_before == totals.evaluations_after
                                                             ? " (equal)"
                                                             : " -> " + grouped(totals.evaluations_after)),
                   evaluations));
  std::string seconds = fmt::format("{:.1f} s -> {:.1f} s, not compared", totals.seconds_before, totals.seconds_after);
  if (const auto cases = by_seconds(comparison); !cases.empty()) {
    seconds += fmt::format("; largest difference: {} {:.2f} s -> {:.2f} s", cases.front()->name.id,
                           cases.front()->before->seconds, cases.front()->after->seconds);
  }
  return text + row("time", seconds);
}

std::string source_text(const Comparison& comparison) {
  const ResultsSource& before = comparison.before;
  std::string remarks;
  if (!before.only.empty())
    remarks += fmt::format("; it has only the {} of its --only", counted(before.only.size(), "case"));
  if (!before.holds) remarks += "; its own verdict is fail";
  std::string text = "\n" + row("baseline", fmt::format("{}: revision {}, {}, {} tier{}", before.file.string(),
                                                        revision_text(before.provenance), before.provenance.date,
                                                        name_of(before.tier), remarks));
  for (const Difference& difference : build_differences(comparison))
    text += row("  other", fmt::format("{}: {} -> {}", difference.what, difference.before, difference.after));
  return text;
}

std::string text_of(const ChangeLine& line) {
  std::string text = fmt::format("  {:<15} {}: {} -> {}", line.why, line.item, line.before, line.after);
  if (!line.moved.empty()) text += "; change/bound " + line.moved;
  if (!line.margin.empty()) text += "; error/bound " + line.margin;
  if (!line.bound.empty()) text += "; bound " + line.bound;
  return text + "\n";
}

std::string list_of(const std::vector<ChangeLine>& lines, std::size_t maximum) {
  std::string text;
  for (std::size_t i = 0; i < std::min(maximum, lines.size()); ++i)
    text += text_of(lines[i]);
  if (lines.size() > maximum) text += fmt::format("  and {} more in baseline.json\n", grouped(lines.size() - maximum));
  return text;
}

std::string names_text(const char* what, const std::vector<std::string>& names) {
  if (names.empty()) return "";
  std::string text;
  for (std::size_t i = 0; i < std::min(names_listed, names.size()); ++i)
    text += (i == 0 ? "" : "; ") + names[i];
  if (names.size() > names_listed) text += fmt::format("; and {} more", names.size() - names_listed);
  return row(what, text);
}

}  // namespace

std::string table_of(const Comparison& comparison) {
  const Totals totals = totals_of(comparison);
  const auto worse = lines_of_worse(comparison);
  const auto admitted = lines_of_admitted(comparison);
  std::string text = source_text(comparison) + totals_text(comparison, totals);
  text += names_text("new", new_items(comparison));
  if (!worse.empty()) text += "worse than the baseline:\n" + list_of(worse, worse_rows);
  if (!admitted.empty()) text += "largest changes that are not worse:\n" + list_of(admitted, admitted_rows);
  if (totals.worse() > 0) {
    text += fmt::format(
        "WORSE: {}, {} and {} are worse than the baseline\n"
        "an intended change: make these results the baseline, or see --tolerance, --margin, --evaluation-growth and "
        "--renamed\n",
        counted(totals.cases.worse, "case"), counted(totals.checks.worse, "check"),
        counted(totals.controls.worse, "control"));
  } else if (!comparison.renaming_errors.empty()) {
    text += fmt::format("WRONG RENAMES: {}; nothing is worse than the baseline\n",
                        counted(comparison.renaming_errors.size(), "error"));
  } else if (totals.cases.compared == 0) {
    text += "NOT WORSE: nothing was compared, because the baseline has none of these cases\n";
  } else {
    text += "NOT WORSE: nothing is worse than the baseline\n";
  }
  return text;
}

}  // namespace talus::verification
