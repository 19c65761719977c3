#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "verification/check/record.hpp"
#include "verification/driver/provenance.hpp"

namespace talus::verification {

/// A check as results.json records it, as far as two runs are compared.
struct RecordedCheck {
  std::string name;           ///< Unique in its case: a name that repeats is numbered, "name #2".
  std::string unit;           ///< Unit of measured and reference; "1" for a pure number.
  Kind kind = Kind::exact;    ///< The kind of argument behind the bound.
  bool relative = false;      ///< Error and bound are divided by |reference|.
  double measured = 0.0;      ///< [unit]
  double reference = 0.0;     ///< [unit]
  double error = 0.0;         ///< As Check::error.
  double bound = 0.0;         ///< As Check::bound; finite.
  double margin = 0.0;        ///< error / bound.
  bool pass = false;          ///< The verdict, which follows from the numbers.
  std::string text_measured;  ///< Measured in words ("true", "false"); empty: print the number.
};

/// A negative control as results.json records it.
struct RecordedControl {
  std::string name;                    ///< Unique in its case, as RecordedCheck::name.
  std::string turns_red;               ///< The check that the fault must turn red.
  Colour observed = Colour::missing;   ///< With the fault; red is required.
  Colour unplanted = Colour::missing;  ///< Without the fault; green is required.
  std::string message;                 ///< Why it did not turn red; empty if it did.
  bool pass = false;                   ///< The verdict, which follows from the colours.
};

/// How a case ended and what it cost.
struct CaseOutcome {
  Status status = Status::missing;
  std::string message;            ///< Why the case did not pass; empty if it did.
  double seconds = 0.0;           ///< Wall-clock time [s].
  std::uint64_t evaluations = 0;  ///< Force evaluations that the case counted; 0: it counts none.
};

/// A case as results.json records it.
struct RecordedCase {
  std::string id;  ///< Unique: an id that repeats is numbered, "id #2".
  std::string family;
  CaseOutcome outcome;
  std::vector<RecordedCheck> checks;
  std::vector<RecordedControl> controls;
};

/// Which run a results.json is of.
struct ResultsSource {
  std::filesystem::path file;
  Provenance provenance;
  Tier tier = Tier::quick;
  bool holds = false;               ///< Its verdict.
  std::vector<std::string> only{};  ///< The cases that --only named; empty: the whole tier was run.
};

/// One results.json. This is the only reader of that file for comparisons.
struct RecordedResults {
  ResultsSource source;
  std::vector<std::string> registered;  ///< Ids of all cases of that program.
  std::vector<RecordedCase> cases;      ///< In the order of the file.
};

/// The case called `id`, or nullptr.
[[nodiscard]] const RecordedCase* find_case(const RecordedResults& results, const std::string& id);

/// Reads a results.json strictly. IoError if the file cannot be read. InputError, with the file, the JSON path, what
/// was found and what is allowed, if it is not JSON, has another schema, lacks a field or has one of another type, or
/// if a verdict does not follow from its numbers.
[[nodiscard]] RecordedResults read_results(const std::filesystem::path& file);

}  // namespace talus::verification
