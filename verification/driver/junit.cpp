#include "verification/driver/junit.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "verification/driver/terminal.hpp"

namespace talus::verification {

namespace {

std::string test(const std::string& id, const std::string& name, const std::string& failure, const char* how) {
  const std::string head = fmt::format("    <testcase classname=\"{}\" name=\"{}\"", escaped(id), escaped(name));
  if (failure.empty()) return head + "/>\n";
  return fmt::format("{}>\n      <{} message=\"{}\"/>\n    </testcase>\n", head, how, escaped(failure));
}

/// A case that did not end by itself, or had nothing to check, fails as a whole.
bool failed_as_a_whole(const Record& record) {
  return record.status != Status::pass && (record.status != Status::fail || record.checks.empty());
}

std::string suite(const Record& record) {
  std::string tests;
  std::size_t failures = 0;
  for (const auto& check : record.checks) {
    tests += test(record.id, check.name, check.pass ? "" : sentence(record.id, check), "failure");
    if (!check.pass) ++failures;
  }
  for (const auto& control : record.controls) {
    const bool pass = control.pass();
    tests += test(record.id, "control: " + control.name, pass ? "" : sentence(record.id, control), "failure");
    if (!pass) ++failures;
  }
  const bool error = failed_as_a_whole(record);
  tests += test(record.id, "run", error ? fmt::format("{}: {}", name_of(record.status), record.message) : "", "error");
  return fmt::format(
      "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" time=\"{:.3f}\">\n{}  </testsuite>\n",
      escaped(record.id), record.checks.size() + record.controls.size() + 1, failures, error ? 1 : 0, record.seconds,
      tests);
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
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"talus_verify\">\n";
  for (const auto& record : records)
    text += suite(record);
  return text + "</testsuites>\n";
}

}  // namespace talus::verification
