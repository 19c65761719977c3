#include "reports/pages/comparisons.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "reports/pages/page_cells.hpp"
#include "reports/text/markdown.hpp"

namespace talus::reports {
namespace {

using markdown::cell;
using Rows = std::vector<std::vector<std::string>>;

std::string comparison(const Table& table) {
  std::vector<markdown::Column> columns;
  for (const std::string& heading : table.columns)
    columns.push_back({cell(heading), !columns.empty()});
  Rows rows = table.rows;
  for (auto& row : rows) {
    for (std::string& entry : row)
      entry = cell(entry);
  }
  return markdown::table(columns, rows, "");
}

}  // namespace

std::string common_formulas(const Results& results) {
  std::string text;
  for (const Record& record : results.records) {
    for (const Table& table : record.tables) {
      if (table.name.rfind("common_formula", 0) != 0) continue;
      text += fmt::format("{} Case {}.\n\n{}\n", table.caption, case_link(record), comparison(table));
    }
  }
  return text.empty() ? "None so far.\n" : text;
}

std::string checks_of_peers(const Results& results) {
  Rows rows;
  std::string suite;
  for (const Peer& peer : results.peers) {
    std::string remark = peer.cases.empty() ? "**none**" : joined_links(results, peer.cases);
    if (!peer.problems.empty()) remark += " (" + cell(fmt::format("{}", fmt::join(peer.problems, ", "))) + ")";
    if (!peer.remark.empty()) remark += ": " + cell(peer.remark);
    rows.push_back(
        {peer.suite == suite ? " " : cell(peer.suite), cell(peer.id), cell(peer.what), cell(peer.form), remark});
    suite = peer.suite;
  }
  if (rows.empty()) return "None so far.\n";
  return markdown::table({{"source"}, {"check"}, {"set-up"}, {"compared with"}, {"here"}}, rows, "");
}

std::string errata(const Results& results) {
  std::string text;
  for (const Erratum& e : results.errata) {
    text += fmt::format("**{}. {}.** {}\n\n- Printed: {}; corrected: {}\n- Evidence: {}\n\n", markdown::text(e.id),
                        markdown::text(e.where),
                        e.case_id.empty() ? "" : fmt::format("Case {}.", link_of(results, e.case_id)),
                        markdown::text(e.printed), markdown::text(e.corrected), markdown::text(e.evidence));
  }
  return text.empty() ? "None so far.\n" : text;
}

}  // namespace talus::reports
