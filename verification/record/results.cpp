#include "verification/record/results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <set>

#include "verification/record/results_fields.hpp"

namespace talus::records {
namespace {

void demand_once(const Node& node, const char* key, const std::vector<std::string>& ids) {
  const std::set<std::string> distinct(ids.begin(), ids.end());
  if (distinct.size() != ids.size()) node.at(key).complain("names a case twice");
}

}  // namespace

void demand_sound(const Node& node, const Provenance& provenance) {
  try {
    static_cast<void>(epoch_seconds(provenance.date));
  } catch (const RecordError& wrong) {
    node.at("date").complain(wrong.what());
  }
}

void demand_sound(const Node& node, const Results& results) {
  demand_once(node, "registered", results.registered);
  demand_once(node, "selected", results.selected);
  const auto among = [](const std::vector<std::string>& ids, const std::string& id) {
    return std::find(ids.begin(), ids.end(), id) != ids.end();
  };
  for (const std::string& id : results.selected) {
    if (!among(results.registered, id)) node.at("selected").complain(fmt::format("'{}' is not registered", id));
    const auto named = [&](const Record& record) { return record.id == id; };
    const auto count = std::count_if(results.records.begin(), results.records.end(), named);
    if (count != 1) node.at("cases").complain(fmt::format("selected case '{}' has {} records", id, count));
  }
  for (const Record& record : results.records) {
    if (!among(results.selected, record.id))
      node.at("cases").complain(fmt::format("'{}' was not registered and selected", record.id));
    if (!record.family.empty() && !among(results.families, record.family)) {
      node.at("cases").complain(fmt::format("case '{}' is of family '{}', which is not listed; listed: {}", record.id,
                                            record.family, fmt::join(results.families, ", ")));
    }
  }
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

Counts counts_of(const Results& results) {
  Counts counts;
  for (const Record& record : results.records) {
    ++counts.cases;
    ++(record.status == Status::pass ? counts.passed : counts.failed);
    for (const Check& check : record.checks) {
      ++counts.checks;
      if (!check.pass) ++counts.checks_failed;
      if (check.slack) ++counts.slack;
      if (exempt_from_slack(check.kind)) ++counts.exempt;
    }
    for (const Control& control : record.controls) {
      ++counts.controls;
      if (!control.pass()) ++counts.controls_failed;
    }
  }
  return counts;
}

bool holds(const Results& results) {
  if (results.selected.empty() || results.records.size() != results.selected.size()) return false;
  for (std::size_t i = 0; i < results.records.size(); ++i) {
    if (results.records[i].id != results.selected[i] || results.records[i].status != Status::pass) return false;
  }
  return true;
}

std::string text_of(const Results& results) {
  return json_of(results).dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Results read_results(const std::filesystem::path& file) {
  const Json document = read_json(file);
  Results results;
  read_into(Node{document, file.string() + ": results"}, results, Completeness::complete);
  return results;
}

}  // namespace talus::records
