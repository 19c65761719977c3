#include "reports/pages.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "reports/markdown.hpp"
#include "reports/page_cells.hpp"

namespace talus::reports {
namespace {

namespace mustache = kainjow::mustache;
using markdown::cell;
using Rows = std::vector<std::vector<std::string>>;

std::string link_of(const Results& results, const std::string& id) {
  for (const CaseRecord& record : results.cases) {
    if (record.id == id) return case_link(record);
  }
  return cell(id);
}

std::string status_word(const std::string& status) { return status == "pass" ? "pass" : "**" + status + "**"; }

/// The checks that stand for a case on the first pages: those the case marks, else the failed ones and the first few.
std::vector<Check> main_checks(const CaseRecord& record) {
  std::vector<Check> chosen;
  const auto marked = [](const Check& check) { return check.main; };
  const bool any = std::any_of(record.checks.begin(), record.checks.end(), marked);
  for (std::size_t i = 0; i < record.checks.size(); ++i) {
    const Check& check = record.checks[i];
    if (!check.pass || (any ? check.main : i < 5)) chosen.push_back(check);
  }
  return chosen;
}

std::string failures(const Results& results) {
  Rows checks;
  Rows controls;
  std::string others;
  for (const CaseRecord& record : results.cases) {
    for (const Check& check : record.checks) {
      if (check.pass) continue;
      checks.push_back({case_link(record), name_with_unit(check), measured_text(check), reference_text(check),
                        margin_text(check), reason(check)});
    }
    for (const Control& control : record.controls) {
      if (control.pass) continue;
      controls.push_back({case_link(record), cell(control.name), cell(control.turns_red), cell(control.expected),
                          "**" + cell(control.observed) + "**", cell(control.what)});
    }
    if (record.status != "pass" && !record.message.empty()) {
      others += fmt::format("- {}: **{}**. {}\n", case_link(record), record.status, markdown::words(record.message));
    } else if (record.status != "pass" && record.status != "fail") {
      others += fmt::format("- {}: **{}**, without a message.\n", case_link(record), record.status);
    }
  }
  std::string text = others.empty() ? "" : others + "\n";
  if (!checks.empty()) {
    text +=
        markdown::table(
            {{"case"}, {"check"}, {"measured", true}, {"reference", true}, {"error/bound", true}, {"why the bound"}},
            checks, "Checks that failed.") +
        "\n";
  }
  if (!controls.empty()) {
    text += markdown::table({{"case"}, {"control"}, {"turns red"}, {"expected"}, {"observed"}, {"the planted fault"}},
                            controls, "Controls that did not turn their check red.") +
            "\n";
  }
  return text;
}

std::string provenance(const Results& results) {
  const Provenance& p = results.provenance;
  std::string libraries;
  for (const auto& [name, version] : p.libraries)
    libraries += (libraries.empty() ? "" : ", ") + name + " " + version;
  const Rows rows{{"date, tier", cell(p.date + (results.tier.empty() ? "" : ", tier " + results.tier))},
                  {"revision", cell(p.revision) + (p.dirty ? " (**with uncommitted changes**)" : "")},
                  {"compiler", cell(p.compiler + (p.build_type.empty() ? "" : ", " + p.build_type))},
                  {"flags", p.flags.empty() ? "" : markdown::code(p.flags)},
                  {"machine", cell(p.cpu + (p.cores > 0 ? fmt::format(", {} cores", p.cores) : "") +
                                   (p.os.empty() ? "" : ", " + p.os))},
                  {"libraries", cell(libraries)}};
  return markdown::table({{"what"}, {"value"}}, rows, "");
}

std::string case_summary(const Results& results) {
  Rows rows;
  for (const CaseRecord& record : results.cases) {
    double worst = 0.0;
    for (const Check& check : record.checks) {
      if (!(check.margin <= worst)) worst = check.margin;
    }
    const auto green = std::count_if(record.checks.begin(), record.checks.end(), [](const Check& c) { return c.pass; });
    const auto red =
        std::count_if(record.controls.begin(), record.controls.end(), [](const Control& c) { return c.pass; });
    rows.push_back({case_link(record), cell(record.title), status_word(record.status),
                    fmt::format("{} of {}", green, record.checks.size()),
                    fmt::format("{} of {}", red, record.controls.size()),
                    record.checks.empty() ? "" : markdown::number(worst, 2), fmt::format("{:.2f}", record.seconds)});
  }
  return markdown::table({{"case"},
                          {"title"},
                          {"status"},
                          {"checks passed", true},
                          {"controls red", true},
                          {"worst error/bound", true},
                          {"seconds", true}},
                         rows, "");
}

std::string main_check_table(const Results& results) {
  Rows rows;
  for (const CaseRecord& record : results.cases) {
    std::string name = case_link(record);
    for (const Check& check : main_checks(record)) {
      rows.push_back({name, name_with_unit(check), measured_text(check, 7), reference_text(check, 7),
                      margin_text(check), check.pass ? "pass" : "**fail**"});
      name = std::string(" ");
    }
    if (record.checks.empty()) rows.push_back({name, "none ran", "", "", "", status_word(record.status)});
  }
  return markdown::table(
      {{"case"}, {"check"}, {"measured", true}, {"reference", true}, {"error/bound", true}, {"result"}}, rows, "");
}

/// `end_rule` reads "end rule".
std::string group_title(std::string group) {
  std::replace(group.begin(), group.end(), '_', ' ');
  return markdown::words(group);
}

std::string joined_links(const Results& results, const std::vector<std::string>& ids) {
  std::string text;
  for (const std::string& id : ids)
    text += (text.empty() ? "" : ", ") + link_of(results, id);
  return text;
}

/// The checks that touch a requirement: of each case the first few by name, and how many more.
std::string shown_by(const Results& results, const Requirement& requirement) {
  if (requirement.shown_by.empty()) return joined_links(results, requirement.cases);
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
      if (requirement.cases.empty()) {
        bare += (bare.empty() ? "" : "; ") + markdown::words(requirement.id);
      } else {
        rows.push_back({cell(requirement.id), cell(requirement.text), shown_by(results, requirement),
                        fmt::format("{}", requirement.checks)});
      }
    }
    text += fmt::format("## Requirements: {}\n\n{} of {} have a case.\n\n", group_title(group), rows.size(), all);
    if (!rows.empty())
      text += markdown::table({{"requirement"}, {"what"}, {"shown by"}, {"checks", true}}, rows, "") + "\n";
    if (!bare.empty()) text += "**Without a case:** " + bare + ".\n\n";
  }
  return text;
}

std::string front(const Results& results, const std::filesystem::path& templates) {
  const Counts& c = results.counts;
  mustache::data values;
  values.set("verdict", results.verdict == "pass" ? "PASS" : "FAIL");
  values.set("counts", fmt::format("{} cases: {} passed, {} failed. {} checks: {} failed, {} slack ({} exact or "
                                   "round-off ones are exempt from that rule). {} negative controls: "
                                   "{} failed.",
                                   c.cases, c.passed, c.failed, c.checks, c.checks_failed, c.slack, c.exempt,
                                   c.controls, c.controls_failed));
  std::string left_out;
  for (const std::string& id : results.registered) {
    if (std::find(results.selected.begin(), results.selected.end(), id) != results.selected.end()) continue;
    left_out += (left_out.empty() ? "" : ", ") + id;
  }
  values.set("is_partial", !left_out.empty());
  values.set("left_out", left_out);
  const std::string failed = failures(results);
  values.set("has_failures", !failed.empty());
  values.set("failures", failed);
  values.set("cases", case_summary(results));
  values.set("provenance", provenance(results));
  values.set("checks", main_check_table(results));
  values.set("traceability", traceability(results));
  return filled(templates / "front.mustache", values);
}

std::string back(const Results& results, const std::filesystem::path& templates, const std::string& tools) {
  std::string errata;
  for (const Erratum& e : results.errata) {
    errata += fmt::format("**{}. {}.** {}\n\n- Printed: {}\n- Corrected: {}\n- Evidence: {}\n\n", markdown::words(e.id),
                          markdown::words(e.where),
                          e.case_id.empty() ? "" : fmt::format("Case {}.", link_of(results, e.case_id)),
                          markdown::words(e.printed), markdown::words(e.corrected), markdown::words(e.evidence));
  }
  std::string references;
  for (const Reference& r : results.references) {
    references += fmt::format("- **{}**: {}\n", markdown::words(r.key), markdown::words(r.text));
  }
  mustache::data values;
  values.set("errata", errata.empty() ? "None so far.\n" : errata);
  values.set("references", references.empty() ? "None.\n" : references);
  values.set("tools", tools);
  values.set("date", results.provenance.date);
  return filled(templates / "back.mustache", values);
}

}  // namespace

std::string report_markdown(const Results& results, const Drawn& drawn, const std::filesystem::path& templates,
                            const std::string& tools) {
  std::string text = front(results, templates);
  for (std::size_t i = 0; i < results.cases.size(); ++i) {
    text += fmt::format("\n{}", case_page(results.cases[i], i + 1, drawn, templates));
  }
  return fmt::format("{}\n{}", text, back(results, templates, tools));
}

}  // namespace talus::reports
