#include "reports/pages/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "reports/pages/page_cells.hpp"
#include "reports/text/markdown.hpp"
#include "verification/record/failed_cases.hpp"

namespace talus::reports {
namespace {

using markdown::cell;
using Rows = std::vector<std::vector<std::string>>;

bool passes(const Check& check) { return check.pass; }
bool passes(const Control& control) { return control.pass(); }

/// Number of passing items in a list.
struct Tally {
  std::size_t passed{}, all{};

  template <class Items>
  void add(const Items& items) {
    all += items.size();
    for (const auto& item : items)
      passed += passes(item) ? 1 : 0;
  }
  /// "12", or "**11 of 12**".
  [[nodiscard]] std::string text() const {
    return passed == all ? fmt::format("{}", all) : fmt::format("**{} of {}**", passed, all);
  }
};

/// Largest error/bound of a case's checks. A failed check counts as larger than all that passed, NaN as infinite.
std::string worst_margin(const Record& record) {
  const auto badness = [](const Check& check) {
    return std::pair{!check.pass, std::isnan(check.margin) ? HUGE_VAL : check.margin};
  };
  const auto worst = std::max_element(record.checks.begin(), record.checks.end(),
                                      [&](const Check& a, const Check& b) { return badness(a) < badness(b); });
  return worst == record.checks.end() ? "" : records::margin_text(worst->margin, worst->pass, 2);
}

std::vector<std::string> row_of(const Record& record) {
  Tally checks, controls;
  checks.add(record.checks);
  controls.add(record.controls);
  return {case_link(record),
          cell(record.title),
          status_word(record),
          checks.text(),
          controls.text(),
          worst_margin(record),
          fmt::format("{:.2f}", record.seconds)};
}

/// Rows of one family, with the family's totals above them; nothing if no case belongs to it.
void append_family(Rows& rows, const std::string& family, const Results& results) {
  const std::size_t head = rows.size();
  Tally checks, controls;
  double seconds = 0.0;
  std::size_t cases = 0, passed = 0;
  for (const Record& record : results.records) {
    if (record.family != family) continue;
    if (cases == 0) rows.emplace_back();
    ++cases;
    passed += record.status == Status::pass ? 1 : 0;
    checks.add(record.checks);
    controls.add(record.controls);
    seconds += record.seconds;
    rows.push_back(row_of(record));
  }
  if (cases == 0) return;
  const std::string count = passed == cases ? fmt::format("{}", cases) : fmt::format("{} of {}", passed, cases);
  rows[head] = {family.empty() ? "**others**" : "**" + cell(family) + "**",
                fmt::format("*{} {}*", count, cases == 1 ? "case" : "cases"),
                " ",
                checks.text(),
                controls.text(),
                " ",
                fmt::format("{:.2f}", seconds)};
}

}  // namespace

std::string failures(const Results& results) {
  Rows checks;
  Rows controls;
  std::string others;
  for (const auto& [record, failed] : records::failed_cases(results.records))
    for (const Check* check : failed)
      checks.push_back({case_link(*record), name_with_unit(*check), measured_text(*check), reference_text(*check),
                        margin_text(*check), reason(*check)});
  for (const Record& record : results.records) {
    for (const Control& control : record.controls) {
      if (control.pass()) continue;
      controls.push_back({case_link(record), cell(control.name), cell(control.turns_red),
                          fmt::format("**{}**", name_of(control.unplanted)),
                          fmt::format("**{}**", name_of(control.observed)), cell(control.what)});
    }
    if (record.status != Status::pass && !record.message.empty()) {
      others +=
          fmt::format("- {}: **{}**. {}\n", case_link(record), name_of(record.status), markdown::text(record.message));
    } else if (!finished(record.status)) {
      others += fmt::format("- {}: **{}**, without a message.\n", case_link(record), name_of(record.status));
    }
  }
  std::string text = others.empty() ? "" : others + "\n";
  if (!checks.empty()) {
    text +=
        markdown::table(
            {{"case"}, {"check"}, {"measured", true}, {"reference", true}, {"error/bound", true}, {"why the bound"}},
            checks,
            "Checks that failed. First the case with the largest finite error/bound: what fails below may follow from "
            "it.") +
        "\n";
  }
  if (!controls.empty()) {
    text +=
        markdown::table(
            {{"case"}, {"control"}, {"turns red"}, {"without the fault"}, {"with it"}, {"the planted fault"}}, controls,
            "Controls that did not turn their check from green to red. If it is red without the fault, "
            "too, the control is not judged: repair the check first.") +
        "\n";
  }
  return text;
}

std::string summary_by_family(const Results& results) {
  Rows rows;
  for (const std::string& family : results.families)
    append_family(rows, family, results);
  append_family(rows, "", results);
  return markdown::table({{"case"},
                          {"what"},
                          {"result"},
                          {"checks", true},
                          {"controls", true},
                          {"worst error/bound", true},
                          {"seconds", true}},
                         rows, "");
}

}  // namespace talus::reports
