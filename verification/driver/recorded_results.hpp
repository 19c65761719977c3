#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "verification/check/record.hpp"
#include "verification/driver/provenance.hpp"

namespace talus::verification {

/// A check as recorded in results.json, with the fields needed to compare two runs.
struct RecordedCheck {
  std::string name;           ///< Unique in its case: a repeated name is numbered, "name #2".
  std::string unit;           ///< Unit of measured and reference; "1" for a pure number.
  Kind kind = Kind::exact;    ///< The kind of justification of the bound.
  bool relative = false;      ///< Error and bound are divided by |reference|.
  double measured = 0.0;      ///< [unit]
  double reference = 0.0;     ///< [unit]
  double error = 0.0;         ///< As Check::error.
  double bound = 0.0;         ///< As Check::bound; finite.
  double margin = 0.0;        ///< error / bound.
  bool pass = false;          ///< The verdict; must follow from the numbers.
  std::string text_measured;  ///< Measured as text ("true", "false"); empty: print the number.
};

/// A negative control as recorded in results.json.
struct RecordedControl {
  std::string name;                    ///< Unique in its case, as RecordedCheck::name.
  std::string turns_red;               ///< The check that must fail with the fault.
  Colour observed = Colour::missing;   ///< With the fault; red is required.
  Colour unplanted = Colour::missing;  ///< Without the fault; green is required.
  std::string message;                 ///< Why the check did not turn red; empty if it did.
  bool pass = false;                   ///< The verdict; must follow from the colours.
};

/// Status and cost of a case.
struct CaseOutcome {
  Status status = Status::missing;
  std::string message;            ///< Why the case did not pass; empty if it did.
  double seconds = 0.0;           ///< Wall-clock time [s].
  std::uint64_t evaluations = 0;  ///< Counted force evaluations; 0: the case counts none.
};

/// A case as recorded in results.json.
struct RecordedCase {
  std::string id;  ///< Unique: a repeated id is numbered, "id #2".
  std::string family;
  CaseOutcome outcome;
  std::vector<RecordedCheck> checks;
  std::vector<RecordedControl> controls;
};

/// Origin of a results.json.
struct ResultsSource {
  std::filesystem::path file;
  Provenance provenance;
  Tier tier = Tier::quick;
  bool holds = false;               ///< Whether its verdict is "pass".
  std::vector<std::string> only{};  ///< The cases given with --only; empty: the whole tier was run.
};

/// The content of one results.json. Comparisons read that file only through this type.
struct RecordedResults {
  ResultsSource source;
  std::vector<std::string> registered;  ///< Ids of all cases of that program.
  std::vector<RecordedCase> cases;      ///< In the order of the file.
};

/// The case with this id, or nullptr.
[[nodiscard]] const RecordedCase* find_case(const RecordedResults& results, const std::string& id);

/// Reads a results.json strictly. IoError if the file cannot be read. InputError, with the file, the JSON path, what
/// was found and what is allowed, if it is not JSON, has another schema, lacks a field or has one of another type, or
/// if a verdict does not follow from its numbers.
[[nodiscard]] RecordedResults read_results(const std::filesystem::path& file);

}  // namespace talus::verification
