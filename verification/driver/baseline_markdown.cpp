#include "verification/driver/baseline_markdown.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "verification/driver/baseline_lines.hpp"

namespace talus::verification {

namespace {

constexpr std::size_t maximum_worse = 100;
constexpr std::size_t maximum_admitted = 20;
constexpr std::size_t maximum_names = 50;
constexpr std::size_t maximum_times = 5;

/// Escapes text so that Markdown shows it literally, in one line.
std::string unmarked(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '\n' || c == '\r') {
      escaped += ' ';
      continue;
    }
    if (std::string_view("\\`*_[]<|$#~").find(c) != std::string_view::npos) escaped += '\\';
    escaped += c;
  }
  return escaped;
}

std::string row(const std::vector<std::string>& cells) {
  std::string text = "|";
  for (const std::string& cell : cells)
    text += " " + unmarked(cell) + " |";
  return text + "\n";
}

std::string changes(const std::vector<ChangeLine>& lines, std::size_t maximum) {
  std::string text =
      "| why | case/check | baseline | now | change/bound | error/bound | bound |\n"
      "|:--|:--|:--|:--|:--|:--|:--|\n";
  for (std::size_t i = 0; i < std::min(maximum, lines.size()); ++i) {
    const ChangeLine& line = lines[i];
    text += row({line.why, line.item, line.before, line.after, line.moved, line.margin, line.bound});
  }
  if (lines.size() > maximum)
    text += fmt::format("\nand {} more in `baseline.json`\n", grouped(lines.size() - maximum));
  return text;
}

std::string names_list(const char* title, const std::vector<std::string>& names) {
  if (names.empty()) return "";
  std::string text = fmt::format("\n### {}\n\n", title);
  for (std::size_t i = 0; i < std::min(maximum_names, names.size()); ++i)
    text += "- " + unmarked(names[i]) + "\n";
  if (names.size() > maximum_names) text += fmt::format("- and {} more\n", names.size() - maximum_names);
  return text;
}

std::string items_row(const char* what, const Totals::Items& items) {
  return row({what, grouped(items.compared), grouped(items.worse), grouped(items.worsened), grouped(items.improved),
              grouped(items.gone), grouped(items.removed), grouped(items.added)});
}

std::string sources(const Comparison& comparison, const Totals& totals) {
  const ResultsSource &before = comparison.before, &after = comparison.after;
  std::string text = "| | baseline | now |\n|:--|:--|:--|\n";
  text += row({"results", before.file.string(), after.file.string()});
  text += row({"revision", revision_text(before.provenance), revision_text(after.provenance)});
  text += row({"verdict", before.holds ? "pass" : "fail", after.holds ? "pass" : "fail"});
  if (before.only != after.only)
    text += row({"cases named by --only", before.only.empty() ? "none" : grouped(before.only.size()),
                 after.only.empty() ? "none" : grouped(after.only.size())});
  text += row({"date", before.provenance.date, after.provenance.date});
  for (const Difference& difference : build_differences(comparison))
    text += row({difference.what, difference.before, difference.after});
  text += row({"evaluations", grouped(totals.evaluations_before), grouped(totals.evaluations_after)});
  text += row({"time of the cases compared", fmt::format("{:.1f} s", totals.seconds_before),
               fmt::format("{:.1f} s", totals.seconds_after)});
  return text;
}

std::string times(const Comparison& comparison) {
  const auto cases = by_seconds(comparison);
  if (cases.empty()) return "";
  std::string text =
      "\n### Times with the largest difference (not compared)\n\n| case | baseline | now |\n|:--|--:|--:|\n";
  for (std::size_t i = 0; i < std::min(maximum_times, cases.size()); ++i) {
    text += row({cases[i]->name.id, fmt::format("{:.2f} s", cases[i]->before->seconds),
                 fmt::format("{:.2f} s", cases[i]->after->seconds)});
  }
  return text;
}

std::string title(const Comparison& comparison, const Totals& totals) {
  if (totals.worse() > 0) {
    return fmt::format("## Verification: worse than the baseline ({}, {}, {})\n", counted(totals.cases.worse, "case"),
                       counted(totals.checks.worse, "check"), counted(totals.controls.worse, "control"));
  }
  if (!comparison.renaming_errors.empty()) return "## Verification: wrong renames for the baseline\n";
  if (totals.cases.compared == 0) return "## Verification: nothing to compare with the baseline\n";
  return "## Verification: nothing is worse than the baseline\n";
}

}  // namespace

std::string markdown_of(const Comparison& comparison) {
  const Totals totals = totals_of(comparison);
  const auto worse = lines_of_worse(comparison);
  const auto admitted = lines_of_admitted(comparison);
  std::string text = title(comparison, totals);
  if (!comparison.after.holds) text += "\n**The run itself fails:** see its output and `junit.xml`.\n";
  for (const std::string& error : comparison.renaming_errors)
    text += "\n- " + unmarked(error);
  if (!comparison.renaming_errors.empty()) text += "\n";
  if (!worse.empty()) text += "\n### Worse\n\n" + changes(worse, maximum_worse);
  text +=
      "\n### Totals\n\n| | compared | worse | pass -> fail | fail -> pass | gone | removed | new |\n"
      "|:--|--:|--:|--:|--:|--:|--:|--:|\n";
  text +=
      items_row("cases", totals.cases) + items_row("checks", totals.checks) + items_row("controls", totals.controls);
  text += fmt::format(
      "\nMeasured values: {} identical, {} within round-off, {} changed. error/bound: {} grew, {} shrank. Bounds: {} "
      "widened, {} tightened; {} changed. Evaluations: {} with more, {} with fewer.{}\n\n",
      grouped(totals.identical), grouped(totals.round_off), grouped(totals.changed), grouped(totals.margins_grown),
      grouped(totals.margins_shrunk), grouped(totals.bounds_widened), grouped(totals.bounds_tightened),
      counted(totals.references_changed, "reference"), counted(totals.evaluations_grown, "case"),
      counted(totals.evaluations_shrunk, "case"),
      comparison.unselected.empty()
          ? ""
          : fmt::format(" Not selected: {} of the baseline.", counted(comparison.unselected.size(), "case")));
  text += sources(comparison, totals);
  if (!admitted.empty()) text += "\n### Largest changes that are not worse\n\n" + changes(admitted, maximum_admitted);
  text += names_list("New", new_items(comparison));
  text += names_list("Gone or removed", lost_items(comparison));
  return text + times(comparison);
}

}  // namespace talus::verification
