#include "reports/case_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "reports/figure_record.hpp"
#include "reports/json_node.hpp"

namespace talus::reports {
namespace {

Check check_of(const Node& node) {
  Check check;
  check.name = node.at("name").words();
  check.unit = node.text_or_empty("unit");
  check.measured = node.at("measured").number();
  check.reference = node.has("reference") ? node.at("reference").number() : std::numeric_limits<double>::quiet_NaN();
  check.error = node.at("error").number();
  check.bound = node.at("bound").number();
  if (node.has("margin")) {
    check.margin = node.at("margin").number();
  } else {
    check.margin = check.error == 0.0 ? 0.0 : std::numeric_limits<double>::infinity();
  }
  check.relative = node.flag_or_false("relative");
  check.kind = node.at("kind").one_of({"exact", "round_off", "truncation", "model", "interval"});
  check.why = node.at("why").words();
  check.pass = node.at("pass").flag();
  check.slack = node.flag_or_false("slack");
  check.main = node.flag_or_false("main");
  check.order = node.flag_or_false("order");
  check.text_measured = node.text_or_empty("text_measured");
  if (check.pass && !(check.margin <= 1.0)) node.complain("passes although error/bound is above 1 or not a number");
  return check;
}

Control control_of(const Node& node) {
  const auto number = [&](const char* key) {
    return node.has(key) ? node.at(key).number() : std::numeric_limits<double>::quiet_NaN();
  };
  return {node.at("name").words(),
          node.at("what").words(),
          node.at("turns_red").words(),
          node.text_or_empty("expected"),
          node.at("observed").words(),
          node.at("pass").flag(),
          number("measured"),
          number("reference"),
          number("error"),
          number("bound")};
}

Table table_of(const Node& node) {
  Table table{node.text_or_empty("name"), node.text_or_empty("caption"), node.at("columns").texts(), {}};
  if (table.columns.empty()) node.at("columns").complain("must hold at least one column");
  for (const Node& row : node.at("rows").list()) {
    table.rows.push_back(row.texts());
    if (table.rows.back().size() != table.columns.size()) {
      row.complain(fmt::format("has {} cells, the table {} columns", table.rows.back().size(), table.columns.size()));
    }
  }
  return table;
}

}  // namespace

CaseRecord case_of(const Node& node) {
  CaseRecord record;
  record.id = file_name(node.at("id"));
  record.status = node.at("status").one_of({"pass", "fail", "error", "timeout", "missing"});
  const bool ran = record.status == "pass" || record.status == "fail";
  record.title = ran ? node.at("title").words() : node.text_or_empty("title");
  record.page = ran ? node.at("page").words() : node.text_or_empty("page");
  record.family = node.text_or_empty("family");
  record.source = node.text_or_empty("source");
  record.message = record.status == "pass" ? node.text_or_empty("message") : node.at("message").text();
  record.tier = node.text_or_empty("tier");
  record.seconds = node.has("seconds") ? node.at("seconds").number() : 0.0;
  if (node.has("requirements")) record.requirements = node.at("requirements").texts();
  if (node.has("notes")) record.notes = node.at("notes").texts();
  for (const Node& item : node.list_or_empty("checks"))
    record.checks.push_back(check_of(item));
  for (const Node& item : node.list_or_empty("controls"))
    record.controls.push_back(control_of(item));
  for (const Node& item : node.list_or_empty("figures"))
    record.figures.push_back(figure_of(item));
  for (const Node& item : node.list_or_empty("tables"))
    record.tables.push_back(table_of(item));
  demand_distinct_names(node, "checks", record.checks);
  demand_distinct_names(node, "figures", record.figures);
  if (record.status == "pass") {
    if (record.checks.empty()) node.complain("passes without a check");
    const auto red = [](const auto& item) { return !item.pass; };
    if (std::any_of(record.checks.begin(), record.checks.end(), red)) node.complain("passes with a failed check");
    if (std::any_of(record.controls.begin(), record.controls.end(), red)) node.complain("passes with a green control");
  }
  return record;
}

}  // namespace talus::reports
