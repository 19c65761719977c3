#include "reports/pages/rounding.hpp"

#include <fmt/format.h>

#include <vector>

#include "reports/pages/page_cells.hpp"
#include "reports/text/markdown.hpp"

namespace talus::reports {

namespace {

using markdown::cell;
using Rows = std::vector<std::vector<std::string>>;

std::string ratio_text(const records::RoundedResult& result) {
  if (!result.made) return "not made";
  const std::string text = records::margin_text(result.margin, result.holds, 2);
  return result.holds ? text : "**" + text + "**";
}

}  // namespace

std::string rounding_text(const records::RoundingAudit& audit, const Results& results) {
  std::vector<markdown::Column> heads{{"kind of bound"}, {"checks", true}};
  std::vector<markdown::Column> columns{{"case"}, {"check"}, {"kind"}, {"nearest", true}};
  for (const std::string& mode : audit.modes) {
    heads.push_back({"fail " + cell(mode), true});
    columns.push_back({cell(mode), true});
  }
  Rows sums, rows;
  for (const records::RoundedKind& kind : audit.kinds) {
    sums.push_back({cell(name_of(kind.kind)), fmt::format("{}", kind.checks)});
    for (const std::size_t failed : kind.failed)
      sums.back().push_back(fmt::format("{}", failed));
  }
  for (const records::RoundedCheck& check : audit.checks) {
    rows.push_back(
        {link_of(results, check.case_id), cell(check.check), cell(name_of(check.kind)), ratio_text(check.nearest)});
    for (const records::RoundedResult& rounded : check.rounded)
      rows.back().push_back(ratio_text(rounded));
  }
  const std::string text = markdown::table(heads, sums, "") + "\n";
  if (rows.empty()) return text + "No check fails under another rounding.\n";
  return text + "Error/bound of the checks that fail under another rounding (bold):\n\n" +
         markdown::table(columns, rows, "");
}

}  // namespace talus::reports
