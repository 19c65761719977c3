#include "reports/pages/appendix.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "reports/pages/page_cells.hpp"
#include "reports/text/markdown.hpp"

namespace talus::reports {
namespace {

using markdown::cell;
using Rows = std::vector<std::vector<std::string>>;

/// Title of a group: "end_rule" becomes "end rule".
std::string group_title(std::string group) {
  std::replace(group.begin(), group.end(), '_', ' ');
  return markdown::text(group);
}

/// The checks that cover a requirement: for each case the names of the first few, and the number of the others.
std::string shown_by(const Results& results, const Requirement& requirement) {
  constexpr std::size_t named = 2;
  std::string text;
  for (const ShownBy& shown : requirement.shown_by) {
    const std::size_t count = std::min(named, shown.checks.size());
    std::string names;
    for (std::size_t i = 0; i < count; ++i)
      names += (i == 0 ? "" : "; ") + cell(shown.checks[i]);
    if (shown.checks.size() > count) names += fmt::format("; {} more", shown.checks.size() - count);
    text += fmt::format("{}{}: {}", text.empty() ? "" : ". ", link_of(results, shown.case_id),
                        names.empty() ? "none ran" : names);
  }
  return text;
}

/// Number of checks that cover a requirement.
std::size_t check_count(const Requirement& requirement) {
  std::size_t count = 0;
  for (const ShownBy& shown : requirement.shown_by)
    count += shown.checks.size();
  return count;
}

}  // namespace

std::string perturbed_references(const Results& results) {
  struct Count {
    std::size_t either{}, one{};
  };
  std::map<std::string, Count> counts;
  Count all;
  for (const Record& record : results.records) {
    for (const Check& check : record.checks) {
      if (!check.pass) continue;
      // error -+ 1.5 bounds| exceeds the bound in both directions if the error is less than half of it.
      const bool either = check.bound == 0.0 || check.margin < 0.5;
      Count& of_kind = counts[name_of(check.kind)];
      for (Count* const count : {&of_kind, &all})
        ++(either ? count->either : count->one);
    }
  }
  Rows rows;
  const auto row = [&](const std::string& name, const Count& count) {
    rows.push_back({name, fmt::format("{}", count.either + count.one), fmt::format("{}", count.either),
                    fmt::format("{}", count.one)});
  };
  for (const auto& [kind, count] : counts)
    row(cell(kind), count);
  row("**all**", all);
  return "A reference that is wrong by 1.5 bounds turns a check red in either direction where the error is less than "
         "half of the bound, else in the direction away from what was measured.\n\n" +
         markdown::table(
             {{"kind of bound"}, {"checks that hold", true}, {"red either way", true}, {"red one way", true}}, rows,
             "");
}

std::string machine(const Provenance& p) {
  return p.cores == 0 ? p.cpu : fmt::format("{}, {} core{}", p.cpu, p.cores, p.cores == 1 ? "" : "s");
}

std::string provenance(const Results& results) {
  const Provenance& p = results.provenance;
  std::string libraries;
  for (const auto& [name, version] : p.libraries)
    libraries += (libraries.empty() ? "" : ", ") + name + " " + version;
  const Rows rows{{"date, tier", cell(fmt::format("{}, tier {}", p.date, name_of(results.tier)))},
                  {"revision", cell(p.revision) + (p.dirty ? " (**with uncommitted changes**)" : "")},
                  {"compiler", cell(p.compiler + (p.build_type.empty() ? "" : ", " + p.build_type))},
                  {"flags", p.flags.empty() ? "" : markdown::code(p.flags)},
                  {"machine", cell(machine(p) + (p.os.empty() ? "" : ", " + p.os))},
                  {"libraries", cell(libraries)}};
  return markdown::table({{"what"}, {"value"}}, rows, "");
}

std::string traceability(const Results& results) {
  std::vector<std::string> groups;
  for (const Requirement& requirement : results.requirements) {
    if (std::find(groups.begin(), groups.end(), requirement.group) == groups.end()) groups.push_back(requirement.group);
  }
  std::string text;
  for (const std::string& group : groups) {
    Rows rows;
    std::string bare;
    std::size_t all = 0;
    for (const Requirement& requirement : results.requirements) {
      if (requirement.group != group) continue;
      ++all;
      if (requirement.shown_by.empty()) {
        bare += (bare.empty() ? "" : "; ") + markdown::text(requirement.id);
      } else {
        rows.push_back({cell(requirement.id), cell(requirement.text), shown_by(results, requirement),
                        fmt::format("{}", check_count(requirement))});
      }
    }
    text += fmt::format("## Requirements: {}\n\n{} of {} have a case.\n\n", group_title(group), rows.size(), all);
    if (!rows.empty())
      text += markdown::table({{"requirement"}, {"what"}, {"shown by"}, {"checks", true}}, rows, "") + "\n";
    if (!bare.empty()) text += "**Without a case:** " + bare + ".\n\n";
  }
  return text;
}

}  // namespace talus::reports
