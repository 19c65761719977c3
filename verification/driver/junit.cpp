#include "verification/driver/junit.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "verification/driver/terminal.hpp"

namespace talus::verification {

namespace {

/// A `property` element of a test case.
std::string property(const char* name, const std::string& value) {
  return fmt::format("        <property name=\"{}\" value=\"{}\"/>\n", name, escaped(value));
}

/// The shortest text that reads back as the same double; NaN and infinity as "nan" and "inf".
std::string shortest(double value) { return fmt::format("{}", value); }

/// Properties with the numbers behind a verdict, for checks and controls. `unit` is that of measured and reference, and
/// also of error and bound unless these are relative.
template <class Compared>
std::string comparison(const Compared& compared, const std::string& unit, bool relative) {
  return property("measured", shortest(compared.measured)) + property("reference", shortest(compared.reference)) +
         property("error", shortest(compared.error)) + property("bound", shortest(compared.bound)) +
         property("unit", unit.empty() ? "1" : unit) + property("relative", relative ? "true" : "false");
}

std::string properties(const Check& check) {
  return comparison(check, check.unit, check.relative) + property("kind", name_of(check.kind));
}

/// Properties of the check that the control names, evaluated with the injected fault.
std::string properties(const Control& control, const std::vector<Check>& checks) {
  std::string made = property("observed", name_of(control.observed)) + property("check", control.turns_red);
  if (control.observed == Colour::missing) return made;
  const auto named = [&](const Check& check) { return check.name == control.turns_red; };
  const auto check = std::find_if(checks.begin(), checks.end(), named);
  return check == checks.end() ? made + comparison(control, "", false)
                               : made + comparison(control, check->unit, check->relative);
}

/// One test case. `how` is the element for a failure: "failure" or "error".
std::string test(const std::string& id, const std::string& name, double seconds, const std::string& properties,
                 const std::string& failure, const char* how) {
  std::string text =
      fmt::format("    <testcase classname=\"{}\" name=\"{}\" time=\"{:.3f}\"", escaped(id), escaped(name), seconds);
  if (properties.empty() && failure.empty()) return text + "/>\n";
  text += ">\n";
  if (!properties.empty()) text += "      <properties>\n" + properties + "      </properties>\n";
  if (!failure.empty()) text += fmt::format("      <{} message=\"{}\"/>\n", how, escaped(failure));
  return text + "    </testcase>\n";
}

/// Whether the case fails as a whole: it did not finish, or it had nothing to check.
bool failed_as_a_whole(const Record& record) {
  return record.status != Status::pass && (record.status != Status::fail || record.checks.empty());
}

/// Sums over the tests of one suite or of all suites.
struct Sums {
  std::size_t tests = 0;
  std::size_t failures = 0;
  std::size_t errors = 0;
  double seconds = 0.0;

  void add(const Sums& other) {
    tests += other.tests;
    failures += other.failures;
    errors += other.errors;
    seconds += other.seconds;
  }
  [[nodiscard]] std::string attributes() const {
    return fmt::format("tests=\"{}\" failures=\"{}\" errors=\"{}\" time=\"{:.3f}\"", tests, failures, errors, seconds);
  }
};

std::string suite(const Record& record, Sums& sums) {
  std::string tests;
  Sums own{.tests = record.checks.size() + record.controls.size() + 1, .seconds = record.seconds};
  // The checks of a case share its runs: their time is in the test case `run`, so that the sums are correct.
  for (const auto& check : record.checks) {
    tests +=
        test(record.id, check.name, 0.0, properties(check), check.pass ? "" : sentence(record.id, check), "failure");
    if (!check.pass) ++own.failures;
  }
  for (const auto& control : record.controls) {
    const bool pass = control.pass();
    tests += test(record.id, "control: " + control.name, 0.0, properties(control, record.checks),
                  pass ? "" : sentence(record.id, control), "failure");
    if (!pass) ++own.failures;
  }
  const bool error = failed_as_a_whole(record);
  if (error) own.errors = 1;
  tests += test(record.id, "run", record.seconds, "",
                error ? fmt::format("{}: {}", name_of(record.status), record.message) : "", "error");
  sums.add(own);
  return fmt::format("  <testsuite name=\"{}\" {}>\n{}  </testsuite>\n", escaped(record.id), own.attributes(), tests);
}

}  // namespace

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\n':
        out += "&#10;";
        break;
      case '\t':
        out += "&#9;";
        break;
      default:
        out += static_cast<unsigned char>(c) < 0x20 ? '?' : c;
    }
  }
  return out;
}

std::string junit_of(const std::vector<Record>& records) {
  std::string suites;
  Sums sums;
  for (const auto& record : records)
    suites += suite(record, sums);
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"talus_verify\" {}>\n{}</testsuites>\n",
      sums.attributes(), suites);
}

}  // namespace talus::verification
