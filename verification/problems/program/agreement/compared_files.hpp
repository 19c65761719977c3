#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "verification/check/findings.hpp"
#include "verification/record/csv.hpp"
#include "verification/record/json_node.hpp"

/// Comparison of whole files with what is expected in them, reduced to few checks that name the worst item.
namespace talus::verification::problems {

/// The largest of many differences, with the name of its item. A NaN persists. Without a comparison its check fails.
class WorstDifference {
 public:
  void compare(const std::string& item, double found, double exact, double scale);
  void compare(const std::string& item, double found, double exact) {
    compare(item, found, exact, exact == 0.0 ? 1.0 : exact);
  }
  /// Checks it against zero; the argument of the bound is followed by the name of the item.
  void expect(Findings& findings, std::string name, double bound, const std::string& why) const;
  [[nodiscard]] double worst() const { return worst_; }
  [[nodiscard]] const std::string& item() const { return item_; }

 private:
  double worst_{std::numeric_limits<double>::quiet_NaN()};  ///< NaN before the first comparison, too
  bool compared_{};
  std::string item_{"none"};
};

/// The number of items that do not agree, with the name of the first. Without a comparison its check fails.
class Disagreements {
 public:
  void check(const std::string& item, bool agrees);
  void expect(Findings& findings, std::string name, const std::string& why) const;

 private:
  int compared_{}, count_{};
  std::string first_{"none"};
};

/// An expected number whose error is relative to `scale`, the size of its summands, instead of to itself.
[[nodiscard]] records::Json scaled(double number, double scale);

/// Compares a JSON document with an expected one, member by member: keys, their order, lengths of lists, texts, flags
/// and integers exactly, other numbers relative to themselves (absolutely if zero is expected) or as scaled().
class ComparedDocument {
 public:
  ComparedDocument(std::string name, const records::Json& found, const records::Json& expected);
  /// Two checks: "NAME: members" and "NAME: numbers, largest error".
  void expect(Findings& findings, double bound, const std::string& why) const;
  /// The first of them alone: for a document whose numbers are all integers, which are members.
  void expect_members(Findings& findings) const;

 private:
  void compare(const std::string& path, const records::Json& found, const records::Json& expected);

  std::string name_;
  WorstDifference numbers_;
  Disagreements members_;
};

/// The columns of a CSV file whose heads are "NAME [UNIT]".
struct Columns {
  explicit Columns(const records::Csv& csv);

  [[nodiscard]] std::size_t rows() const { return values.front().size(); }
  [[nodiscard]] bool has(std::string_view name) const;
  /// Throws std::runtime_error with the name if there is no such column.
  [[nodiscard]] const std::vector<double>& at(std::string_view name) const;

  std::vector<std::string> heads, names, units;
  std::vector<std::vector<double>> values;  ///< for each column, its rows
};

}  // namespace talus::verification::problems
