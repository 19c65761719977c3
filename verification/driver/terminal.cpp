#include "verification/driver/terminal.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <utility>

#include "verification/record/failed_cases.hpp"

namespace talus::verification {

namespace {

/// Number of failed checks of a case that are printed, the most urgent first.
constexpr std::size_t maximum_lines = 8;
constexpr const char* green = "\x1b[32m";
constexpr const char* red = "\x1b[31m";
constexpr const char* plain = "\x1b[0m";

bool is_set(const char* variable) {
  const char* const value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

std::string with_unit(double value, const std::string& unit) {
  return unit == "1" || unit.empty() ? fmt::format("{:.6g}", value) : fmt::format("{:.6g} {}", value, unit);
}

/// Measure of how bad a check is: a failed one is worse than a passed one with the same ratio, where rounding makes
/// both 1. NaN counts as the largest.
std::pair<bool, double> badness(const Check& check) {
  return {!check.pass, std::isnan(check.margin) ? HUGE_VAL : check.margin};
}

/// The check with the largest error/bound.
const Check* worst(const std::vector<Check>& checks) {
  const auto found = std::max_element(checks.begin(), checks.end(),
                                      [&](const Check& a, const Check& b) { return badness(a) < badness(b); });
  return found == checks.end() ? nullptr : &*found;
}

/// Names of the controls of a failed case that are not judged.
std::string unjudged_controls(const Record& record) {
  std::string names;
  for (const Control& control : record.controls)
    if (!control.is_judged()) names += (names.empty() ? "" : ", ") + control.name;
  return names;
}

}  // namespace

std::string sentence(const std::string& id, const Check& check) {
  const std::string bound =
      check.relative ? fmt::format("{:.6g} of the reference", check.bound) : with_unit(check.bound, check.unit);
  std::string message =
      fmt::format("{}.{}: measured {}, reference {}, bound {}, error/bound {}", id, check.name,
                  check.text_measured.empty() ? with_unit(check.measured, check.unit) : check.text_measured,
                  with_unit(check.reference, check.unit), bound, records::margin_text(check.margin, check.pass, 3));
  if (!check.message.empty()) message += "; " + check.message;
  return message + " (" + check.why + ")";
}

std::string sentence(const std::string& id, const Control& control) {
  return fmt::format("{}: control '{}' ({}) must turn '{}' red: {}", id, control.name, control.what, control.turns_red,
                     control.message.empty() ? "it was not run" : control.message);
}

Terminal::Terminal(std::size_t total, std::string rounding)
    : total_(total),
      rounding_(std::move(rounding)),
      colour_(::isatty(STDOUT_FILENO) != 0 && !is_set("NO_COLOR")),
      progress_(::isatty(STDERR_FILENO) != 0) {}

std::string Terminal::rounding_text() const { return rounding_ == "nearest" ? "" : "; rounding " + rounding_; }

std::string Terminal::painted(const std::string& text, const char* colour) const {
  return colour_ ? colour + text + plain : text;
}

void Terminal::report(const Record& record, const std::vector<std::string>& running, bool reused) {
  ++ended_;
  clear_progress();
  const bool pass = record.status == Status::pass;
  const Check* const farthest = worst(record.checks);
  const std::string margin =
      farthest == nullptr ? "-"
                          : fmt::format("worst error/bound {} ({})",
                                        records::margin_text(farthest->margin, farthest->pass, 2), farthest->name);
  fmt::print("{}  {:<18} {:>3} checks  {:>2} controls  {:>8}  {}\n",
             painted(fmt::format("{:<7}", name_of(record.status)), pass ? green : red), record.id, record.checks.size(),
             record.controls.size(), reused ? "as before" : fmt::format("{:.2f} s", record.seconds), margin);
  if (!pass) fmt::print("         {}: {}\n", record.id, record.message);
  for (const auto& [of, checks] : records::failed_cases({&record, 1})) {
    for (const Check* check : std::span{checks}.first(std::min(checks.size(), maximum_lines)))
      fmt::print("         {}{}\n", sentence(of->id, *check), rounding_text());
    if (checks.size() > maximum_lines)
      fmt::print("         and {} more, in its record\n", checks.size() - maximum_lines);
  }
  for (const auto& control : record.controls) {
    if (!control.pass() && control.is_judged() && record.status == Status::fail)
      fmt::print("         {}\n", sentence(record.id, control));
  }
  if (const std::string names = unjudged_controls(record); !names.empty())
    fmt::print("         {}: controls whose checks fail without the fault, too: {}\n", record.id, names);
  std::fflush(stdout);
  show_progress(running);
}

void Terminal::show_progress(const std::vector<std::string>& running) const {
  if (!progress_ || running.empty()) return;
  std::string ids;
  for (const auto& id : running)
    ids += " " + id;
  fmt::print(stderr, "[{}/{}]{} ...", ended_, total_, ids);
  std::fflush(stderr);
}

void Terminal::clear_progress() const {
  if (!progress_) return;
  fmt::print(stderr, "\r\x1b[K");
  std::fflush(stderr);
}

void Terminal::summarise(const Results& results, const std::string& results_file) const {
  const records::Counts counts = counts_of(results);
  const bool pass = holds(results);
  const std::size_t unselected = results.registered.size() - results.selected.size();
  fmt::print(
      "{}: {} of {} cases passed; {} checks, {} failed, {} slack ({} exact or round-off, exempt from it); {} controls, "
      "{} not red or not judged{}{}\n",
      painted(pass ? "PASS" : "FAIL", pass ? green : red), counts.passed, counts.cases, counts.checks,
      counts.checks_failed, counts.slack, counts.exempt, counts.controls, counts.controls_failed,
      unselected == 0 ? "" : fmt::format("; {} registered but not selected", unselected), pass ? "" : rounding_text());
  if (const auto failed = records::failed_cases(results.records); counts.checks_failed > 1) {
    fmt::print("read first: {}\n", sentence(failed.front().record->id, *failed.front().checks.front()));
    for (const auto& [record, checks] : std::span{failed}.subspan(1)) {
      const Check& first = *checks.front();
      fmt::print("then: {}.{}: error/bound {}\n", record->id, first.name,
                 records::margin_text(first.margin, first.pass, 3));
    }
  }
  std::vector<std::string> broken_off;
  for (const auto& record : results.records) {
    if (!records::finished(record.status)) broken_off.push_back(record.id);
  }
  if (!broken_off.empty())
    fmt::print("without a verdict, ended by an error or a limit: {}\n", fmt::join(broken_off, ", "));
  if (results.selected.empty()) fmt::print("nothing was run: that is a failure\n");
  fmt::print("results: {}\n", results_file);
  std::fflush(stdout);
}

}  // namespace talus::verification
