#pragma once

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "verification/check/case.hpp"
#include "verification/check/findings.hpp"

namespace talus::verification {

/// How a case ended.
enum class Status {
  pass,     ///< Every check holds and every control turned red.
  fail,     ///< A check does not hold, a control stayed green, or there was nothing to check.
  error,    ///< The case threw, crashed, or left a record that cannot be read.
  timeout,  ///< The case was stopped at its time limit.
  missing,  ///< The case left no record.
};

/// The word for `status` in the records.
[[nodiscard]] const char* name_of(Status status);

/// The status called `name`; std::invalid_argument for any other word.
[[nodiscard]] Status status_named(const std::string& name);

/// What a check did in a setup: held (green), failed (red), or was not made.
enum class Colour { green, red, missing };

/// The word for `colour` in the records.
[[nodiscard]] const char* name_of(Colour colour);

/// The colour called `name`; std::invalid_argument for any other word.
[[nodiscard]] Colour colour_named(const std::string& name);

/// What came of one planted fault. Red is demanded with the fault, and green without it at the same resolution, so that
/// it is the fault that turned the check red.
struct Control {
  std::string name;                    ///< Fault::name.
  std::string what;                    ///< Fault::what.
  std::string turns_red;               ///< The check it must turn red.
  Colour observed = Colour::missing;   ///< With the fault; red is demanded.
  Colour unplanted = Colour::missing;  ///< Without the fault, equally coarse; green is demanded.
  double measured = 0.0;               ///< With the fault; with `reference`, `error`, `bound` only if not missing.
  double reference = 0.0;
  double error = 0.0;
  double bound = 0.0;
  std::string message{};  ///< Why it did not turn red, or what was thrown after it did.

  [[nodiscard]] bool pass() const { return observed == Colour::red && unplanted == Colour::green; }
};

/// A requirement and the checks that touch it.
struct Trace {
  std::string requirement;          ///< Claim::requirement.
  std::vector<std::string> checks;  ///< Names of the checks made whose names hold one of Claim::parts.
  std::string unmatched{};          ///< A part that is in no name; empty if there is none.

  /// There is a check for it, and each part that the case names has one.
  [[nodiscard]] bool shown() const { return !checks.empty() && unmatched.empty(); }
};

/// All that one case leaves behind; `record.json` and the CSV files it names.
struct Record {
  std::string id;
  std::string title;
  std::string family{};                  ///< Case::family.
  std::vector<Trace> requirements;       ///< With the checks made so far.
  std::vector<std::string> main_checks;  ///< Case::main_checks.
  std::string source;
  std::string page;
  Tier tier = Tier::quick;
  Status status = Status::missing;
  std::string message;   ///< Why the case did not pass; empty if it did.
  double seconds = 0.0;  ///< Wall-clock time of the case.
  std::uint64_t evaluations = 0;
  std::vector<Check> checks;
  std::vector<Control> controls;
  std::vector<Figure> figures;
  std::vector<Table> tables;
  std::vector<DataFile> data;
  std::vector<std::string> notes;
};

/// A record that is missing, empty, truncated, of another schema or inconsistent; the message names file and fault.
struct RecordError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The head of a record: what the case says of itself, nothing found yet.
[[nodiscard]] Record record_of(const Case& verification_case);

/// The checks of `checks` that show what `claims` say, a trace for each claim.
[[nodiscard]] std::vector<Trace> traced(const std::vector<Claim>& claims, const std::vector<Check>& checks);

/// The JSON text of a record (schema 1).
[[nodiscard]] std::string text_of(const Record& record);

/// Writes `folder/record.json` and one CSV file per figure and data file, data first, each under a temporary name and
/// then renamed, so that a record that exists is whole. std::runtime_error if a file cannot be written.
void write_record(const Record& record, const std::filesystem::path& folder);

/// Reads `folder/record.json` and its CSV files strictly: RecordError if a file is missing, empty or truncated, if the
/// schema is another, a field is absent, or a check's verdict does not follow from its numbers.
[[nodiscard]] Record read_record(const std::filesystem::path& folder);

/// Writes `text` to `file` under a temporary name, then renames it; std::runtime_error if that fails.
void write_whole(const std::filesystem::path& file, const std::string& text);

}  // namespace talus::verification
