/// The fields of a case's record in JSON, schema 1; see json_fields.hpp.
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "verification/record/case_record.hpp"
#include "verification/record/figure_fields.hpp"
#include "verification/record/json_fields.hpp"

namespace talus::records {

/// The version of record.json and results.json. Results of earlier programs are baselines, so that a new field must be
/// optional (value_if) within a version.
inline constexpr int schema = 1;

void fields(auto& f, Like<Check> auto& check) {
  f.nonempty_text("name", check.name);
  f.value("unit", check.unit);
  f.number("measured", check.measured);
  f.number("reference", check.reference);
  f.number("error", check.error);
  f.value("bound", check.bound);
  f.number("margin", check.margin);
  f.value("relative", check.relative);
  f.value("kind", check.kind);
  f.nonempty_text("why", check.why);
  f.value("pass", check.pass);
  f.value("slack", check.slack);
  f.value_if(check.order, "order", check.order);
  f.value_if(!check.text_measured.empty(), "text_measured", check.text_measured);
  f.value_if(!check.message.empty(), "message", check.message);
  f.value_if(check.main, "main", check.main);
}

inline void demand_sound(const Node& node, const Check& check) {
  if (const std::string fault = contradiction(check); !fault.empty())
    node.fail(fmt::format("check '{}': {}", check.name, fault));
}

void fields(auto& f, Like<Control> auto& control) {
  f.value("name", control.name);
  f.value("what", control.what);
  f.value("turns_red", control.turns_red);
  f.derived("expected", std::string(name_of(Colour::red)));
  f.value("observed", control.observed);
  f.value("unplanted", control.unplanted);
  const bool made = control.observed != Colour::missing;
  f.number_or_null(made, "measured", control.measured);
  f.number_or_null(made, "reference", control.reference);
  f.number_or_null(made, "error", control.error);
  f.number_or_null(made, "bound", control.bound);
  f.derived("pass", control.pass(), ", which follows from observed and unplanted");
  f.value("message", control.message);
}

void fields(auto& f, Like<Trace> auto& trace) {
  f.value("id", trace.requirement);
  f.value("checks", trace.checks);
  f.value("unmatched", trace.unmatched);
  f.value_if(!trace.used_instead.empty(), "used_instead", trace.used_instead);
}

void fields(auto& f, Like<Table> auto& table) {
  f.nonempty_text("name", table.name);
  f.nonempty_text("caption", table.caption);
  f.value("columns", table.columns);
  f.value("rows", table.rows);
}

inline void demand_sound(const Node& node, const Table& table) {
  if (table.columns.empty()) node.at("columns").fail("must hold at least one column");
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    if (table.rows[i].size() == table.columns.size()) continue;
    node.fail_at(fmt::format("rows[{}]", i),
                 fmt::format("has {} cells, the table {} columns", table.rows[i].size(), table.columns.size()));
  }
}

/// For a data file the record contains only the name.
inline Json json_of(const DataFile& file) { return file.name; }
inline void read_into(const Node& node, DataFile& file, Completeness /*completeness*/) {
  file.name = node.file_name(Node::longest_part);
}

void fields(auto& f, Like<Record> auto& record) {
  f.derived("schema", schema);
  f.nonempty_text("id", record.id);
  f.value("title", record.title);
  f.value("family", record.family);
  f.reserve("requirements");
  f.value("traces", record.requirements);
  std::vector<std::string> ids;
  for (const Trace& trace : record.requirements)
    ids.push_back(trace.requirement);
  f.derived("requirements", ids, ", the ids of the traces");
  f.value("main_checks", record.main_checks);
  f.value("source", record.source);
  f.value("page", record.page);
  f.value_if(!record.evidence.empty(), "evidence", record.evidence);
  f.value_if(!record.not_shown.empty(), "not_shown", record.not_shown);
  f.value("tier", record.tier);
  f.value("status", record.status);
  f.value("message", record.message);
  f.value("seconds", record.seconds);
  f.value("evaluations", record.evaluations);
  f.value("checks", record.checks);
  f.value("controls", record.controls);
  f.value("figures", record.figures);
  f.value("tables", record.tables);
  f.value("data", record.data);
  f.value("notes", record.notes);
}

/// Checks that names are unique, that the status follows from checks and controls, and that the main checks are those
/// named by the case.
void demand_sound(const Node& node, const Record& record);

}  // namespace talus::records
