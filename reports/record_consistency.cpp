#include "reports/record_consistency.hpp"

#include <fmt/format.h>

#include <set>
#include <string>

#include "reports/json_node.hpp"

namespace talus::reports {

Counts counted(const std::vector<CaseRecord>& cases) {
  Counts counts;
  for (const CaseRecord& record : cases) {
    ++counts.cases;
    ++(record.status == "pass" ? counts.passed : counts.failed);
    for (const Check& check : record.checks) {
      ++counts.checks;
      counts.checks_failed += check.pass ? 0 : 1;
      counts.slack += check.slack ? 1 : 0;
      counts.exempt += check.kind == "exact" || check.kind == "round_off" ? 1 : 0;
    }
    for (const Control& control : record.controls) {
      ++counts.controls;
      counts.controls_failed += control.pass ? 0 : 1;
    }
  }
  return counts;
}

void demand_consistency(const Node& root, const Results& results) {
  const std::set<std::string> registered(results.registered.begin(), results.registered.end());
  if (registered.size() != results.registered.size()) root.at("registered").complain("names a case twice");
  const std::set<std::string> selected(results.selected.begin(), results.selected.end());
  if (selected.size() != results.selected.size()) root.at("selected").complain("names a case twice");
  std::multiset<std::string> present;
  for (const CaseRecord& record : results.cases)
    present.insert(record.id);
  for (const std::string& id : selected) {
    if (registered.count(id) == 0) root.at("selected").complain(fmt::format("'{}' is not registered", id));
    if (present.count(id) != 1) {
      root.at("cases").complain(fmt::format("selected case '{}' has {} records", id, present.count(id)));
    }
  }
  for (const std::string& id : present) {
    if (selected.count(id) == 0) root.at("cases").complain(fmt::format("'{}' was not registered and selected", id));
  }
  const std::set<std::string> families(results.families.begin(), results.families.end());
  for (const CaseRecord& record : results.cases) {
    if (record.family.empty() || families.count(record.family) > 0) continue;
    root.at("cases").complain(
        fmt::format("case '{}' is of family '{}', which is not listed", record.id, record.family));
  }
  const Counts mine = counted(results.cases);
  const auto agree = [&](const char* name, int told, int found) {
    if (told != found) root.at("counts").at(name).complain(fmt::format("says {}, the records hold {}", told, found));
  };
  agree("cases", results.counts.cases, mine.cases);
  agree("passed", results.counts.passed, mine.passed);
  agree("failed", results.counts.failed, mine.failed);
  agree("checks", results.counts.checks, mine.checks);
  agree("checks_failed", results.counts.checks_failed, mine.checks_failed);
  agree("slack", results.counts.slack, mine.slack);
  if (root.at("counts").has("exempt")) agree("exempt", results.counts.exempt, mine.exempt);
  agree("controls", results.counts.controls, mine.controls);
  agree("controls_failed", results.counts.controls_failed, mine.controls_failed);
  const bool failed = mine.failed > 0 || mine.cases == 0;
  if (failed && results.verdict == "pass") root.at("verdict").complain("is pass, but a case did not (or none ran)");
}

}  // namespace talus::reports
