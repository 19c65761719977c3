#include "reports/record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <set>

#include "reports/error.hpp"
#include "reports/json_node.hpp"

namespace talus::reports {
namespace {

/// A file stem that cannot lead out of its folder.
std::string file_name(const Node& node) {
  std::string name = node.words();
  if (name.find('/') != std::string::npos || name.front() == '.') node.complain("must be a plain file name");
  return name;
}

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

Axis axis_of(const Node& node) {
  Axis axis{node.at("label").words(), node.text_or_empty("unit"), node.flag_or_false("log"), {}, {}};
  if (node.has("min")) axis.min = node.at("min").finite();
  if (node.has("max")) axis.max = node.at("max").finite();
  if (axis.log && ((axis.min && *axis.min <= 0.0) || (axis.max && *axis.max <= 0.0))) {
    node.complain("limits of a log axis must be > 0");
  }
  return axis;
}

Series series_of(const Node& node) {
  Series series;
  series.label = node.text_or_empty("label");
  series.x = node.at("x").words();
  series.y = node.at("y").words();
  series.style = node.at("style").one_of({"points", "lines", "linespoints", "errorbars", "crosses"});
  series.where = node.text_or_empty("where");
  if (series.style == "errorbars") {
    series.y_low = node.at("y_low").words();
    series.y_high = node.at("y_high").words();
  }
  return series;
}

Figure figure_of(const Node& node) {
  Figure figure;
  figure.name = file_name(node.at("name"));
  figure.title = node.at("title").words();
  figure.caption = node.text_or_empty("caption");
  figure.x = axis_of(node.at("x"));
  figure.y = axis_of(node.at("y"));
  figure.csv = file_name(node.at("csv"));
  for (const Node& item : node.at("series").list())
    figure.series.push_back(series_of(item));
  if (figure.series.empty()) node.at("series").complain("must hold at least one series");
  for (const Node& item : node.list_or_empty("slopes")) {
    if (!figure.x.log || !figure.y.log) item.complain("a slope needs both axes to be log");
    const Slope slope{item.at("order").finite(), item.at("x").finite(), item.at("y").finite(),
                      item.text_or_empty("label")};
    if (slope.x <= 0.0 || slope.y <= 0.0) item.complain("x and y must be > 0");
    figure.slopes.push_back(slope);
  }
  for (const Node& item : node.list_or_empty("lines")) {
    const LimitLine line{item.at("axis").one_of({"x", "y"})[0], item.at("at").finite(), item.text_or_empty("label")};
    if ((line.axis == 'x' ? figure.x : figure.y).log && line.at <= 0.0) item.at("at").complain("a log axis needs > 0");
    figure.lines.push_back(line);
  }
  return figure;
}

Table table_of(const Node& node) {
  Table table{node.text_or_empty("caption"), node.at("columns").texts(), {}};
  if (table.columns.empty()) node.at("columns").complain("must hold at least one column");
  for (const Node& row : node.at("rows").list()) {
    table.rows.push_back(row.texts());
    if (table.rows.back().size() != table.columns.size()) {
      row.complain(fmt::format("has {} cells, the table {} columns", table.rows.back().size(), table.columns.size()));
    }
  }
  return table;
}

/// Names within a case are what failures, controls and files are told by: each may occur once.
template <class Things>
void demand_distinct_names(const Node& node, const char* key, const Things& things) {
  std::set<std::string> seen;
  for (const auto& thing : things) {
    if (!seen.insert(thing.name).second) node.at(key).complain(fmt::format("'{}' occurs twice", thing.name));
  }
}

CaseRecord case_of(const Node& node) {
  CaseRecord record;
  record.id = file_name(node.at("id"));
  record.status = node.at("status").one_of({"pass", "fail", "error", "timeout", "missing"});
  const bool ran = record.status == "pass" || record.status == "fail";
  record.title = ran ? node.at("title").words() : node.text_or_empty("title");
  record.page = ran ? node.at("page").words() : node.text_or_empty("page");
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

Provenance provenance_of(const Node& node) {
  Provenance p;
  p.revision = node.at("revision").text();
  p.dirty = node.flag_or_false("dirty");
  p.compiler = node.at("compiler").text();
  p.flags = node.at("flags").text();
  p.build_type = node.text_or_empty("build_type");
  p.cpu = node.at("cpu").text();
  p.cores = node.has("cores") ? node.at("cores").integer() : 0;
  p.os = node.text_or_empty("os");
  p.libraries = node.at("libraries").dictionary();
  p.date = node.at("date").words();
  try {
    static_cast<void>(epoch_seconds(p.date));
  } catch (const RecordError& wrong) {
    node.at("date").complain(wrong.what());
  }
  return p;
}

Counts counts_of(const Node& node) {
  return {node.at("cases").integer(),
          node.at("passed").integer(),
          node.at("failed").integer(),
          node.at("checks").integer(),
          node.at("checks_failed").integer(),
          node.at("slack").integer(),
          node.at("controls").integer(),
          node.at("controls_failed").integer(),
          node.has("exempt") ? node.at("exempt").integer() : 0};
}

/// The numbers as they follow from the records themselves.
Counts counted(const std::vector<CaseRecord>& cases) {
  Counts counts;
  for (const CaseRecord& record : cases) {
    ++counts.cases;
    ++(record.status == "pass" ? counts.passed : counts.failed);
    for (const Check& check : record.checks) {
      ++counts.checks;
      counts.checks_failed += check.pass ? 0 : 1;
      counts.slack += check.slack ? 1 : 0;
      counts.exempt += check.kind == "exact" || check.kind == "round_off" ? 1 : 0;
    }
    for (const Control& control : record.controls) {
      ++counts.controls;
      counts.controls_failed += control.pass ? 0 : 1;
    }
  }
  return counts;
}

/// Number registered (and asked for) = number run = number in the report, and the verdict follows from the records.
void demand_consistency(const Node& root, const Results& results) {
  const std::set<std::string> registered(results.registered.begin(), results.registered.end());
  if (registered.size() != results.registered.size()) root.at("registered").complain("names a case twice");
  const std::set<std::string> selected(results.selected.begin(), results.selected.end());
  if (selected.size() != results.selected.size()) root.at("selected").complain("names a case twice");
  std::multiset<std::string> present;
  for (const CaseRecord& record : results.cases)
    present.insert(record.id);
  for (const std::string& id : selected) {
    if (registered.count(id) == 0) root.at("selected").complain(fmt::format("'{}' is not registered", id));
    if (present.count(id) != 1) {
      root.at("cases").complain(fmt::format("selected case '{}' has {} records", id, present.count(id)));
    }
  }
  for (const std::string& id : present) {
    if (selected.count(id) == 0) root.at("cases").complain(fmt::format("'{}' was not registered and selected", id));
  }
  const Counts mine = counted(results.cases);
  const auto agree = [&](const char* name, int told, int found) {
    if (told != found) root.at("counts").at(name).complain(fmt::format("says {}, the records hold {}", told, found));
  };
  agree("cases", results.counts.cases, mine.cases);
  agree("passed", results.counts.passed, mine.passed);
  agree("failed", results.counts.failed, mine.failed);
  agree("checks", results.counts.checks, mine.checks);
  agree("checks_failed", results.counts.checks_failed, mine.checks_failed);
  agree("slack", results.counts.slack, mine.slack);
  if (root.at("counts").has("exempt")) agree("exempt", results.counts.exempt, mine.exempt);
  agree("controls", results.counts.controls, mine.controls);
  agree("controls_failed", results.counts.controls_failed, mine.controls_failed);
  const bool failed = mine.failed > 0 || mine.cases == 0;
  if (failed && results.verdict == "pass") root.at("verdict").complain("is pass, but a case did not (or none ran)");
}

json parsed(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) throw OutputError(file.string() + ": cannot be read");
  try {
    return json::parse(stream);
  } catch (const json::parse_error& wrong) {
    throw RecordError(fmt::format("{}: is not JSON: {}", file.string(), wrong.what()));
  }
}

void demand_schema(const Node& root) {
  if (root.at("schema").integer() != 1) root.at("schema").complain("this report reads schema 1 only");
}

}  // namespace

Results read_results(const std::filesystem::path& file) {
  const json document = parsed(file);
  const Node root(document, file.string() + ": results");
  demand_schema(root);
  Results results;
  results.provenance = provenance_of(root.at("provenance"));
  results.registered = root.at("registered").texts();
  results.selected = root.has("selected") ? root.at("selected").texts() : results.registered;
  results.counts = counts_of(root.at("counts"));
  results.tier = root.text_or_empty("tier");
  results.verdict = root.at("verdict").one_of({"pass", "fail"});
  for (const Node& item : root.at("requirements").list()) {
    Requirement requirement{item.at("id").words(),    item.at("group").words(),    item.text_or_empty("text"),
                            item.at("cases").texts(), item.at("checks").integer(), {}};
    for (const Node& shown : item.list_or_empty("shown_by"))
      requirement.shown_by.push_back({shown.at("case").words(), shown.at("checks").texts()});
    results.requirements.push_back(std::move(requirement));
  }
  for (const Node& item : root.at("cases").list())
    results.cases.push_back(case_of(item));
  if (!root.at("counts").has("exempt")) results.counts.exempt = counted(results.cases).exempt;
  for (const Node& item : root.list_or_empty("errata")) {
    results.errata.push_back({item.at("id").words(), item.text_or_empty("where"), item.at("printed").text(),
                              item.at("corrected").text(), item.text_or_empty("evidence"), item.text_or_empty("case")});
  }
  for (const Node& item : root.list_or_empty("references")) {
    results.references.push_back({item.at("key").words(), item.at("text").words()});
  }
  demand_consistency(root, results);
  return results;
}

Plots read_plots(const std::filesystem::path& file) {
  const json document = parsed(file);
  const Node root(document, file.string() + ": plot");
  Plots plots{root.text_or_empty("title"), {}};
  for (const Node& item : root.at("figures").list())
    plots.figures.push_back(figure_of(item));
  if (plots.figures.empty()) root.at("figures").complain("must hold at least one figure");
  demand_distinct_names(root, "figures", plots.figures);
  return plots;
}

long long epoch_seconds(const std::string& iso_date) {
  int year = 0;
  unsigned month = 0;
  unsigned day = 0;
  int hour = 0;
  int minute = 0;
  int second = 0;
  const int count =
      std::sscanf(iso_date.c_str(), "%4d-%2u-%2u%*[T ]%2d:%2d:%2d", &year, &month, &day, &hour, &minute, &second);
  const std::chrono::year_month_day date{std::chrono::year(year), std::chrono::month(month), std::chrono::day(day)};
  const bool time_is_fine = hour >= 0 && hour < 24 && minute >= 0 && minute < 60 && second >= 0 && second < 61;
  if ((count != 3 && count != 6) || !date.ok() || !time_is_fine) {
    throw RecordError(fmt::format("'{}' is not a date such as 2026-03-01T12:00:00Z", iso_date));
  }
  const long long days = std::chrono::sys_days(date).time_since_epoch().count();
  return days * 86400 + hour * 3600 + minute * 60 + second;
}

}  // namespace talus::reports
