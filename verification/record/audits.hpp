#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "verification/record/interface.hpp"
#include "verification/record/mutants.hpp"
#include "verification/record/results.hpp"

/// Results of audits of the verification: programs that change the solver, its input, its rounding or its surroundings.
namespace talus::records {

/// A check under another rounding mode.
struct RoundedResult {
  bool made{};      ///< false if its case did not make the check
  double margin{};  ///< error/bound
  bool holds{};
};

/// A check that fails under another rounding mode.
struct RoundedCheck {
  std::string case_id{};
  std::string check{};
  Kind kind{};
  RoundedResult nearest{};
  std::vector<RoundedResult> rounded;  ///< under each mode of the audit
};

/// Number of checks with a kind of bound, and of those that fail under each mode of the audit.
struct RoundedKind {
  Kind kind{};
  std::size_t checks{};
  std::vector<std::size_t> failed;
};

/// rounding.json: cases with every sum, product and root rounded in another direction.
struct RoundingAudit {
  std::vector<std::string> modes;    ///< "upward", "downward", "toward_zero"
  std::vector<RoundedKind> kinds;    ///< in the order in which they first occur
  std::vector<RoundedCheck> checks;  ///< those that fail under a mode, in the order of the results
};

/// Compares results of the same cases. `rounded`: rounding mode and its results.
[[nodiscard]] RoundingAudit rounding_audit(const Results& nearest,
                                           const std::vector<std::pair<std::string, Results>>& rounded);

/// Mutated files that one reader was given.
struct FuzzedReader {
  std::string reader{};
  std::size_t inputs{};
  std::size_t accepted{};
  std::size_t refused{};    ///< by an error that names file and location
  std::size_t cut_short{};  ///< accepted and run; the run ended at the limit of its work
  double seconds{};
  std::size_t findings{};  ///< crashes, hangs, excessive memory, errors without a location
};

/// fuzz.json.
struct FuzzAudit {
  std::uint64_t seed{};
  std::vector<FuzzedReader> readers;
};

/// faults.json: runs and cells that were killed at random times, and resumed.
struct FaultAudit {
  std::size_t kills{};
  std::size_t before_checkpoint{};  ///< kills before the first checkpoint; the run was started again
  std::size_t resumed{};            ///< kills after it; the run was resumed
  std::size_t temporary_files{};    ///< that kills left, and later runs removed
  std::size_t runs{};               ///< that were completed in the end
  std::size_t identical{};          ///< of these, with the files of an undisturbed run
};

/// A file that a case compares with, and the changes of it that turn the case red.
struct ChangedInput {
  std::string file{};  ///< in the folder `cases`
  std::string case_id{};
  std::size_t changes{};
  std::size_t detected{};
};

/// inputs.json: measurements, published numbers and recorded fingerprints, emptied, cut or made NaN.
struct InputAudit {
  std::vector<ChangedInput> files;
};

/// Lines and branches of a source file that are executed.
struct ExecutedSource {
  std::string file{};
  std::size_t lines{};
  std::size_t executed_lines{};
  std::size_t branches{};
  std::size_t executed_branches{};
};

/// lines.json: what unit tests and cases of the quick tier execute.
struct ExecutedLines {
  std::vector<ExecutedSource> files;
};

/// A defect of the program that was found and mended.
struct Defect {
  std::string what{};      ///< one sentence
  std::string area{};      ///< "physics", "integration", "files", ...
  std::string found_by{};  ///< "case", "unit test", "planted bug", "fuzzing", ...
  std::string commit{};    ///< that mended it
  std::string case_id{};   ///< case that would be red now; empty: a unit test is
  std::string test{};      ///< unit test that would be red now, "suite/test"; empty: a case is
};

/// Revision and date of the results of an audit that were recorded.
struct AuditOrigin {
  std::string audit{};  ///< "mutants", "interface", "rounding", "fuzz", "faults", "inputs", "lines"
  std::string revision{};
  std::string date{};  ///< YYYY-MM-DD
};

/// Results of audits; absent if there are none.
struct Audits {
  std::optional<Mutants> mutants;
  std::optional<Mutants> gate;  ///< a small sample, of the full tier
  std::optional<std::vector<InterfaceItem>> interface;
  std::optional<RoundingAudit> rounding;
  std::optional<FuzzAudit> fuzz;
  std::optional<FaultAudit> faults;
  std::optional<InputAudit> inputs;
  std::optional<ExecutedLines> lines;
  std::vector<Defect> defects;       ///< found by audits, tests and use; kept with the recorded audits
  std::vector<AuditOrigin> origins;  ///< of those that were recorded; the others belong to the reported run

  /// Null if the audit belongs to the reported run.
  [[nodiscard]] const AuditOrigin* origin(const std::string& audit) const;
};

/// The names of the audits that a report shows.
inline constexpr std::array audit_names{"mutants", "gate",   "interface", "rounding",
                                        "fuzz",    "faults", "inputs",    "lines"};

/// File of an audit: in the folder of the reported run, else the recorded one, else nowhere (empty).
[[nodiscard]] std::filesystem::path audit_file(const std::string& audit, const std::filesystem::path& run,
                                               const std::filesystem::path& recorded);

/// Reads defects.json from the folder of recorded audits, and mutants.json, gate.json, interface.json, rounding.json,
/// fuzz.json, faults.json, inputs.json and lines.json: each from the folder of the run if it is there, else from that
/// of recorded audits, whose origins.json must name its origin. Throws FileError, and RecordError for invalid content.
[[nodiscard]] Audits read_audits(const std::filesystem::path& run, const std::filesystem::path& recorded);

/// Throw FileError if the file cannot be written.
void write_rounding(const RoundingAudit& audit, const std::filesystem::path& file);
void write_fuzz(const FuzzAudit& audit, const std::filesystem::path& file);
void write_faults(const FaultAudit& audit, const std::filesystem::path& file);
void write_inputs(const InputAudit& audit, const std::filesystem::path& file);

}  // namespace talus::records
