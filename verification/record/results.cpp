#include "verification/record/results.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>

#include "verification/record/error.hpp"

namespace talus::records {

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

const Check* check_of(const Results& results, const std::string& case_id, const std::string& name) {
  for (const Record& record : results.records) {
    if (record.id != case_id) continue;
    for (const Check& check : record.checks) {
      if (check.name == name) return &check;
    }
  }
  return nullptr;
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

}  // namespace talus::records
