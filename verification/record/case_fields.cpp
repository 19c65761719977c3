#include "verification/record/case_fields.hpp"

#include <algorithm>

namespace talus::records {

void demand_sound(const Node& node, const Record& record) {
  // A case that did not run because it is malformed may lack any of these.
  if (finished(record.status)) {
    static_cast<void>(node.at("id").file_name(Node::longest_part));
    static_cast<void>(node.at("title").nonempty_text());
    static_cast<void>(node.at("page").nonempty_text());
  }
  demand_distinct_names(node, "checks", record.checks);
  demand_distinct_names(node, "controls", record.controls);
  demand_distinct_names(node, "figures", record.figures);
  demand_distinct_names(node, "tables", record.tables);
  for (const Check& check : record.checks) {
    if (check.main != is_main(record, check)) {
      node.at("checks").fail(fmt::format("check '{}' must {}be marked as main: it is {}in main_checks", check.name,
                                         check.main ? "not " : "", check.main ? "not " : ""));
    }
  }
  if (record.status != Status::pass) return;
  if (record.checks.empty()) node.fail("passes without a check");
  if (std::any_of(record.checks.begin(), record.checks.end(), [](const Check& check) { return !check.pass; }))
    node.fail("passes with a failed check");
  if (std::any_of(record.controls.begin(), record.controls.end(), [](const Control& each) { return !each.pass(); }))
    node.fail("passes with a control that did not turn red");
}

}  // namespace talus::records
