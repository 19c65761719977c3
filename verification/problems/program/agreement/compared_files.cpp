#include "verification/problems/program/agreement/compared_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace talus::verification::problems {

using records::Json;

void WorstDifference::compare(const std::string& item, double found, double exact, double scale) {
  const double error = found == exact ? 0.0 : (found - exact) / scale;
  if (compared_ && (std::isnan(worst_) || std::abs(error) <= std::abs(worst_))) return;
  compared_ = true, worst_ = error, item_ = item;
}

void WorstDifference::expect(Findings& findings, std::string name, double bound, const std::string& why) const {
  const std::string reason = fmt::format("{}. The largest is of {}", why, item_);
  findings.expect(std::move(name), worst_, 0.0,
                  bound > 0.0 ? Tolerance::round_off(bound, reason) : Tolerance::exact(reason));
}

void Disagreements::check(const std::string& item, bool agrees) {
  ++compared_;
  if (agrees) return;
  if (count_++ == 0) first_ = item;
}

void Disagreements::expect(Findings& findings, std::string name, const std::string& why) const {
  findings.expect(std::move(name), compared_ > 0 ? count_ : std::numeric_limits<double>::quiet_NaN(), 0.0,
                  Tolerance::exact(count_ == 0 ? why : fmt::format("{}. The first is {}", why, first_)));
}

Json scaled(double number, double scale) { return {{"number", number}, {"scale", scale}}; }

ComparedDocument::ComparedDocument(std::string name, const Json& found, const Json& expected) : name_{std::move(name)} {
  compare("", found, expected);
}

void ComparedDocument::compare(const std::string& path, const Json& found, const Json& expected) {
  if (expected.is_object() && expected.size() == 2 && expected.contains("scale") && expected.contains("number")) {
    members_.check(path, found.is_number());
    if (found.is_number())
      numbers_.compare(path, found.get<double>(), expected["number"].get<double>(), expected["scale"].get<double>());
  } else if (expected.is_number_float() && found.is_number()) {
    numbers_.compare(path, found.get<double>(), expected.get<double>());
  } else if (expected.is_object() && found.is_object()) {
    for (const auto& [key, value] : found.items())
      members_.check(fmt::format("{}.{}, which is not expected", path, key), expected.contains(key));
    auto at = found.begin();
    for (const auto& [key, value] : expected.items()) {
      members_.check(fmt::format("{}.{}, which is not at its position", path, key),
                     at != found.end() && (at++).key() == key);
      if (found.contains(key)) compare(path.empty() ? key : path + "." + key, found.at(key), value);
    }
  } else if (expected.is_array() && found.is_array()) {
    members_.check(fmt::format("{}, a list of {} instead of {}", path, found.size(), expected.size()),
                   found.size() == expected.size());
    for (std::size_t i = 0; i < std::min(found.size(), expected.size()); ++i)
      compare(fmt::format("{}[{}]", path, i), found[i], expected[i]);
  } else {
    members_.check(fmt::format("{}: {} instead of {}", path, found.dump().substr(0, 80), expected.dump().substr(0, 80)),
                   found == expected);
  }
}

void ComparedDocument::expect_members(Findings& findings) const {
  members_.expect(findings, name_ + ": members that are missing, unknown or differ",
                  "each member has an expected value, so that a new one fails this check");
}

void ComparedDocument::expect(Findings& findings, double bound, const std::string& why) const {
  expect_members(findings);
  numbers_.expect(findings, name_ + ": numbers, largest error", bound, why);
}

Columns::Columns(const records::Csv& csv) : heads{csv.header()}, values(csv.header().size()) {
  for (std::size_t i = 0; i < heads.size(); ++i) {
    const std::size_t bracket = heads[i].find(" [");
    names.push_back(heads[i].substr(0, bracket));
    units.push_back(bracket == std::string::npos ? "1" : heads[i].substr(bracket + 2, heads[i].size() - bracket - 3));
    for (std::size_t row = 0; row < csv.rows(); ++row)
      values[i].push_back(csv.number(row, i));
  }
}

bool Columns::has(std::string_view name) const { return std::ranges::find(names, name) != names.end(); }

const std::vector<double>& Columns::at(std::string_view name) const {
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) throw std::runtime_error(fmt::format("no column {}", name));
  return values[static_cast<std::size_t>(found - names.begin())];
}

}  // namespace talus::verification::problems
