#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "verification/record/csv.hpp"

namespace talus::verification {

/// The unit in the brackets at the end of a heading; "1" without them.
[[nodiscard]] std::string unit_of_heading(std::string_view heading);

/// A number of a run and its unit.
struct RunResult {
  double value{};
  std::string unit{};  ///< "1" for a pure number; of a quotient "m/s / m" unless both units are the same
};

/// Files that `talus run --out --impacts` has written, and the results in them, by name:
/// - initial.NAME, final.NAME: the first and the last row of history.csv, e.g. final.disc.vx
/// - minimum.NAME, maximum.NAME, minimum_time.NAME, maximum_time.NAME: the extremes of summary.json
/// - impact.N.CONTACT.COLUMN: the N-th impact of a contact, counted from 1, in impacts.csv, e.g.
///   impact.1.wall.restitution
/// - A / B: a quotient of two of these
class RunResults {
 public:
  /// Errors: records::FileError and records::RecordError for files that cannot be read.
  explicit RunResults(const std::filesystem::path& folder);

  /// Errors: InputError for a name that does not exist, with the known ones.
  [[nodiscard]] RunResult at(const std::string& name) const;
  /// The step given to the method [unit of time].
  [[nodiscard]] double step() const { return step_; }
  [[nodiscard]] const std::string& unit_of_time() const { return unit_of_time_; }

 private:
  struct Extreme {
    std::string name, unit;
    double minimum{}, maximum{}, minimum_time{}, maximum_time{};
  };

  RunResult single(const std::string& name) const;
  RunResult of_history(std::size_t row, const std::string& name) const;
  RunResult of_extremes(const std::string& which, const std::string& name) const;
  RunResult of_impacts(const std::string& name) const;

  records::Csv history_, impacts_;
  std::vector<Extreme> extremes_;
  std::string unit_of_time_;
  double step_{};
};

}  // namespace talus::verification
