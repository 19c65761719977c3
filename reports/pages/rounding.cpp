#include "reports/pages/rounding.hpp"

#include <fmt/format.h>

#include <vector>

#include "reports/pages/page_cells.hpp"
#include "reports/text/markdown.hpp"

namespace talus::reports {

namespace {

using markdown::cell;
using Rows = std::vector<std::vector<std::string>>;

const Check* find(const Results& results, const std::string& case_id, const std::string& name) {
  for (const Record& record : results.records) {
    if (record.id != case_id) continue;
    for (const Check& check : record.checks) {
      if (check.name == name) return &check;
    }
  }
  return nullptr;
}

std::string ratio_text(const Check* check) {
  if (check == nullptr) return "not made";
  const std::string text = records::margin_text(check->margin, check->pass, 2);
  return check->pass ? text : "**" + text + "**";
}

bool holds(const Check* check) { return check != nullptr && check->pass; }

}  // namespace

std::string rounding_text(const Results& nearest, const RoundedResults& rounded) {
  std::map<std::string, std::map<std::string, std::size_t>> failed;  // by kind and rounding mode
  std::map<std::string, std::size_t> all;
  std::vector<markdown::Column> columns{{"case"}, {"check"}, {"kind"}, {"nearest", true}};
  for (const auto& [rounding, results] : rounded)
    columns.push_back({cell(rounding), true});
  Rows rows;
  for (const Record& record : nearest.records) {
    for (const Check& check : record.checks) {
      const std::string kind = name_of(check.kind);
      ++all[kind];
      std::vector<std::string> row{case_link(record), cell(check.name), cell(kind), ratio_text(&check)};
      bool any = false;
      for (const auto& [rounding, results] : rounded) {
        const Check* const other = find(results, record.id, check.name);
        row.push_back(ratio_text(other));
        if (holds(other)) continue;
        any = true;
        ++failed[kind][rounding];
      }
      if (any) rows.push_back(std::move(row));
    }
  }
  std::vector<markdown::Column> heads{{"kind of bound"}, {"checks", true}};
  for (const auto& [rounding, results] : rounded)
    heads.push_back({"fail " + cell(rounding), true});
  Rows sums;
  for (const auto& [kind, count] : all) {
    sums.push_back({cell(kind), fmt::format("{}", count)});
    for (const auto& [rounding, results] : rounded)
      sums.back().push_back(fmt::format("{}", failed[kind][rounding]));
  }
  std::string text = markdown::table(heads, sums, "") + "\n";
  if (rows.empty()) return text + "No check fails under another rounding.\n";
  return text + "Error/bound of the checks that fail under another rounding (bold):\n\n" +
         markdown::table(columns, rows, "");
}

}  // namespace talus::reports
