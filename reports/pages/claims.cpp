#include "reports/pages/claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "reports/pages/page_cells.hpp"
#include "reports/text/markdown.hpp"

namespace talus::reports {
namespace {

using markdown::cell;
using Rows = std::vector<std::vector<std::string>>;

struct Rung {
  Evidence kind;
  const char* claim;
  const char* no_claim;
};

constexpr std::array rungs{
    Rung{Evidence::measurement,
         "The model, with these parameters, describes what was measured, within the distance stated.",
         "Other materials, sizes and speeds; that no other model does as well."},
    Rung{Evidence::closed_form, "The solver solves the equations of its model, with errors up to the bound.",
         "That these equations describe nature; parameters that are not run."},
    Rung{Evidence::independent_integration, "Programs without common code find the same solution.",
         "That the equations are right."},
    Rung{Evidence::historical_program, "Talus reproduces what FENCE or SNOFLO printed, to the digits given.",
         "That the printed numbers are right (chapter Errata), or agree with nature."},
    Rung{Evidence::other_code, "Talus and a program in use today agree, or read each other's files.",
         "That either of them is right."},
    Rung{Evidence::property, "What every solution must satisfy, is satisfied; two ways through Talus agree.",
         "That the solution is right: wrong ones may have the same property."},
    Rung{Evidence::earlier_result, "Nothing has changed since it was recorded.", "That the result was right then."}};
static_assert(rungs.size() == records::Names<Evidence>::values.size());

bool rests_on(const Record& record, Evidence kind) {
  return std::find(record.evidence.begin(), record.evidence.end(), kind) != record.evidence.end();
}

/// Number of cases of a family (all of them if it is empty) whose strongest evidence this is.
std::size_t strongest(const Results& results, Evidence kind, const std::string& family = "") {
  return static_cast<std::size_t>(
      std::count_if(results.records.begin(), results.records.end(), [&](const Record& record) {
        return (family.empty() || record.family == family) && !record.evidence.empty() &&
               record.evidence.front() == kind;
      }));
}

std::string count_text(std::size_t count) { return count == 0 ? "-" : fmt::format("{}", count); }

/// The paragraph "Conclusion" at the beginning of a page as Markdown on one line, for a cell of a table; empty if there
/// is none.
std::string conclusion_of(const std::string& page) {
  std::string paragraph = page.substr(0, page.find("\n\n"));
  const std::string label = "**Conclusion.** ";
  if (!paragraph.starts_with(label)) return "";
  paragraph.erase(0, label.size());
  std::string cell;
  for (const char c : paragraph)
    cell += c == '\n' ? " " : c == '|' ? "\\|" : std::string(1, c);
  return cell;
}

}  // namespace

std::string ladder_of_claims(const Results& results) {
  Rows rows;
  for (const Rung& rung : rungs) {
    const auto all = std::count_if(results.records.begin(), results.records.end(),
                                   [&](const Record& record) { return rests_on(record, rung.kind); });
    rows.push_back({cell(name_of(rung.kind)), cell(rung.claim), cell(rung.no_claim),
                    count_text(static_cast<std::size_t>(all)), count_text(strongest(results, rung.kind))});
  }
  std::string text = markdown::table(
      {{"evidence"}, {"what may be claimed"}, {"what may not"}, {"cases", true}, {"strongest in", true}}, rows, "");
  std::vector<markdown::Column> columns{{"strongest evidence"}};
  for (const Rung& rung : rungs)
    columns.push_back({cell(name_of(rung.kind)), true});
  Rows families;
  for (const std::string& family : results.families) {
    std::vector<std::string> row{cell(family)};
    for (const Rung& rung : rungs)
      row.push_back(count_text(strongest(results, rung.kind, family)));
    families.push_back(row);
  }
  return text + "\n" + markdown::table(columns, families, "");
}

std::string claims_of_cases(const Results& results) {
  Rows rows;
  for (const Record& record : results.records) {
    std::string kinds;
    for (const Evidence kind : record.evidence)
      kinds += (kinds.empty() ? "" : ", ") + cell(name_of(kind));
    rows.push_back(
        {case_link(record), kinds.empty() ? "**none**" : kinds, conclusion_of(record.page), cell(record.not_shown)});
  }
  return markdown::table({{"case"}, {"evidence"}, {"conclusion"}, {"not shown"}}, rows, "");
}

}  // namespace talus::reports
