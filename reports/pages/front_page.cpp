#include "reports/pages/front_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "reports/base/error.hpp"
#include "reports/pages/page_cells.hpp"
#include "reports/text/markdown.hpp"

namespace talus::reports {
namespace {

/// The record of a case that ran to its end; null if there is none.
const Record* finished_record(const Results& results, const std::string& id) {
  const auto found =
      std::find_if(results.records.begin(), results.records.end(), [&](const Record& r) { return r.id == id; });
  return found == results.records.end() || !finished(found->status) ? nullptr : &*found;
}

/// The requirements that have a check in this run and none that failed.
std::set<std::string> verified_ids(const Results& results) {
  std::set<std::pair<std::string, std::string>> failed;
  for (const Record& record : results.records) {
    for (const Check& check : record.checks)
      if (!check.pass) failed.emplace(record.id, check.name);
  }
  std::set<std::string> ids;
  for (const Requirement& requirement : results.requirements) {
    std::size_t checks = 0, wrong = 0;
    for (const ShownBy& shown : requirement.shown_by) {
      checks += shown.checks.size();
      for (const std::string& name : shown.checks)
        wrong += failed.count({shown.case_id, name});
    }
    if (checks > 0 && wrong == 0) ids.insert(requirement.id);
  }
  return ids;
}

/// The members of an id: "pair.rectangle.terrain" -> {"pair", "rectangle", "terrain"}.
std::vector<std::string> members_of(const std::string& id) {
  std::vector<std::string> members{""};
  for (const char letter : id) {
    if (letter == '.') {
      members.emplace_back();
    } else {
      members.back() += letter == '_' ? ' ' : letter;
    }
  }
  return members;
}

/// A shape in a sentence: "a half plane"; terrain is no single thing.
std::string with_article(const std::string& shape) { return (shape == "terrain" ? "" : "a ") + shape; }

/// What is required, as a phrase: "a rectangle in contact with terrain", "rotation of an attenuator (Eq. 4)".
std::string phrase_of(const Requirement& requirement) {
  const std::vector<std::string> members = members_of(requirement.id);
  if (requirement.group == "pair" && members.size() == 3)
    return fmt::format("{} in contact with {}", with_article(members[1]), with_article(members[2]));
  if (requirement.group == "regime" && members.size() == 3)
    return fmt::format("mode {} of the law {}", members[2], members[1]);
  if (members.size() == 2 && requirement.id.find(". ") == std::string::npos) {
    std::string kind = members[0] == "law" || members[0] == "shear_law" ? requirement.text : members[0];
    if (kind == "method") kind = "contact method";
    if (kind == "mechanism") kind = "energy loss by";
    return kind + " " + members[1];
  }
  return fmt::format("{} ({})", requirement.text, requirement.id);
}

/// "<<NAME>>" replaced by what the check of that name measured.
std::string with_values(const std::string& text, const Record& record) {
  std::string result;
  std::size_t at = 0;
  for (std::size_t open = text.find("<<"); open != std::string::npos; open = text.find("<<", at)) {
    const std::size_t close = text.find(">>", open);
    if (close == std::string::npos)
      throw RecordError(fmt::format("findings: case '{}': '<<' without '>>' in: {}", record.id, text));
    const std::string name = text.substr(open + 2, close - open - 2);
    const auto check =
        std::find_if(record.checks.begin(), record.checks.end(), [&](const Check& each) { return each.name == name; });
    if (check == record.checks.end())
      throw RecordError(fmt::format("findings: case '{}' has no check '{}'", record.id, name));
    result += text.substr(at, open - at) + markdown::number(check->measured, 3);
    at = close + 2;
  }
  return result + text.substr(at);
}

}  // namespace

std::string verified(const Results& results) {
  const std::set<std::string> ids = verified_ids(results);
  std::string text;
  const auto add = [&](const std::vector<std::string>& groups, const char* what) {
    std::size_t all = 0, count = 0;
    for (const Requirement& requirement : results.requirements) {
      if (std::find(groups.begin(), groups.end(), requirement.group) == groups.end()) continue;
      ++all;
      count += ids.count(requirement.id);
    }
    if (all == 0) return;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ",
                        count == all ? fmt::format("{}", all) : fmt::format("{} of {}", count, all), what);
  };
  add({"equation"}, "equations of the 1993 report");
  add({"law"}, "force laws");
  add({"regime"}, "of their regimes");
  add({"shear_law"}, "friction laws");
  add({"integrator"}, "integrators");
  add({"shape"}, "shapes");
  add({"pair"}, "pairs of shapes in contact");
  add({"mechanism"}, "mechanisms of energy loss");
  add(results.families, "problems of the catalogue");
  return text.empty() ? "nothing: no requirement is listed." : text + " have checks in this run, all of which pass.";
}

std::string not_verified(const Results& results) {
  const std::set<std::string> ids = verified_ids(results);
  std::string open;
  std::size_t count = 0;
  constexpr std::size_t named = 12;
  for (const Requirement& requirement : results.requirements) {
    if (ids.count(requirement.id) > 0) continue;
    if (++count <= named) open += (open.empty() ? "" : "; ") + markdown::text(phrase_of(requirement));
  }
  if (count > named) open += fmt::format("; {} more", count - named);
  return (open.empty()
              ? std::string("Every listed requirement has checks, all of which pass. ")
              : fmt::format("Without checks that all pass in this run: {} ([traceability](page:traceability)). ",
                            open)) +
         "Verification compares the solver with solutions of the same equations. Whether these equations describe a "
         "given fence or material (validation) is outside this report, but for the measured rebounds of spheres "
         "in family V; so is motion in three dimensions.";
}

std::string highlight_stem(const records::Highlight& highlight) {
  return "front-" + highlight.case_id + "-" + highlight.figure;
}

const Figure* figure_of(const Results& results, const records::Highlight& highlight) {
  const Record* const record = finished_record(results, highlight.case_id);
  if (record == nullptr) return nullptr;
  const auto found = std::find_if(record->figures.begin(), record->figures.end(),
                                  [&](const Figure& figure) { return figure.name == highlight.figure; });
  if (found == record->figures.end())
    throw RecordError(fmt::format("highlights: case '{}' has no figure '{}'", highlight.case_id, highlight.figure));
  return &*found;
}

std::string highlights(const Results& results) {
  std::vector<std::vector<std::string>> rows;
  for (const records::Highlight& highlight : results.highlights) {
    if (figure_of(results, highlight) == nullptr) continue;
    if (rows.empty() || rows.back().size() == 2) rows.resize(rows.size() + 2);
    rows[rows.size() - 2].push_back(
        fmt::format("![](figures/{}.svg){{alt=\"{}\" width=48%}}", highlight_stem(highlight), highlight.case_id));
    rows.back().push_back(fmt::format("{} {}", markdown::cell(highlight.caption), link_of(results, highlight.case_id)));
  }
  for (std::vector<std::string>& row : rows)
    row.resize(2);
  return rows.empty() ? "" : markdown::table({{" "}, {" "}}, rows, "");
}

std::string findings(const Results& results) {
  std::string text;
  for (const records::Finding& finding : results.findings) {
    const Record* const record = finished_record(results, finding.case_id);
    if (record == nullptr) continue;
    text += fmt::format("1. {} ({})\n", markdown::text(with_values(finding.text, *record)), case_link(*record));
  }
  return text.empty() ? "The cases of the findings did not run.\n" : text;
}

}  // namespace talus::reports
