#pragma once

#include <string>
#include <utility>
#include <vector>

#include "verification/check/check.hpp"
#include "verification/driver/baseline.hpp"

namespace talus::verification {

/// A check against 1 m within `bound`: error/bound is |measured - 1| / bound.
inline Check measured(const std::string& name, double value, double bound = 0.5) {
  return compare(name, value, 1.0, Tolerance::model(bound, "chosen"), "m");
}

/// A control that turned its check red, or did not.
inline Control control(const std::string& name, bool pass = true) {
  return {.name = name,
          .what = "a fault",
          .turns_red = "value",
          .observed = pass ? Colour::red : Colour::green,
          .unplanted = Colour::green,
          .message = pass ? "" : "the check stayed green"};
}

/// A case that took 1 s and 100 evaluations; it fails if a check or control does.
inline Record recorded_case(const std::string& id, std::vector<Check> checks, std::vector<Control> controls = {}) {
  Record record;
  record.id = id;
  record.family = "B: normal contact";
  record.status = Status::pass;
  record.seconds = 1.0;
  record.evaluations = 100;
  for (const Check& check : checks)
    if (!check.pass) record.status = Status::fail;
  for (const Control& each : controls)
    if (!each.pass()) record.status = Status::fail;
  record.checks = std::move(checks);
  record.controls = std::move(controls);
  return record;
}

/// Results of the quick tier with these cases, which are all registered ones.
inline ResultsFile recorded_results(std::vector<Record> cases, const std::string& file = "old.json") {
  ResultsFile recorded{file, {}};
  for (const Record& record : cases) {
    recorded.results.registered.push_back(record.id);
    recorded.results.selected.push_back(record.id);
  }
  recorded.results.records = std::move(cases);
  return recorded;
}

}  // namespace talus::verification
