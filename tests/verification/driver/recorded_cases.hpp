#pragma once

#include <string>
#include <utility>
#include <vector>

#include "verification/check/check.hpp"
#include "verification/driver/recorded_results.hpp"

namespace talus::verification {

/// A check as recorded in results.json, with its verdict.
inline RecordedCheck recorded(const Check& check) {
  return {check.name,  check.unit,  check.kind,   check.relative, check.measured,     check.reference,
          check.error, check.bound, check.margin, check.pass,     check.text_measured};
}

/// A check against 1 m within `bound`: error/bound is |measured - 1| / bound.
inline RecordedCheck measured(const std::string& name, double value, double bound = 0.5) {
  return recorded(compare(name, value, 1.0, Tolerance::model(bound, "chosen"), "m"));
}

/// A control that turned its check red, or did not.
inline RecordedControl control(const std::string& name, bool pass = true) {
  return {name, "value", pass ? Colour::red : Colour::green, Colour::green, pass ? "" : "the check stayed green", pass};
}

/// A case that took 1 s and 100 evaluations; it fails if a check or control does.
inline RecordedCase recorded_case(const std::string& id, std::vector<RecordedCheck> checks,
                                  std::vector<RecordedControl> controls = {}) {
  RecordedCase c{id, "B: normal contact", {Status::pass, "", 1.0, 100}, std::move(checks), std::move(controls)};
  for (const RecordedCheck& check : c.checks)
    if (!check.pass) c.outcome.status = Status::fail;
  for (const RecordedControl& each : c.controls)
    if (!each.pass) c.outcome.status = Status::fail;
  return c;
}

/// Results of the quick tier with these cases, which are all registered ones.
inline RecordedResults recorded_results(std::vector<RecordedCase> cases, const std::string& file = "old.json") {
  RecordedResults results;
  results.source.file = file;
  results.source.holds = true;
  for (const RecordedCase& c : cases) {
    results.registered.push_back(c.id);
    results.source.holds = results.source.holds && c.outcome.status == Status::pass;
  }
  results.cases = std::move(cases);
  return results;
}

}  // namespace talus::verification
