#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "verification/driver/baseline.hpp"

namespace talus::verification {

/// Command-line options of a comparison with a baseline, as given; `read_gate` parses the numbers.
struct BaselineOptions {
  std::string baseline;                 ///< An earlier results.json; empty: no comparison.
  std::string compare;                  ///< The results.json to compare; empty: that of this run.
  std::string renamed;                  ///< File of renames; empty: none.
  std::vector<std::string> tolerances;  ///< "X" or "NAME=X".
  std::string margin;                   ///< Empty: none.
  std::string evaluation_growth = "0";
  bool allow_round_off = false;
};

/// The baseline and the rules of the comparison, read before anything runs.
struct BaselineGate {
  ResultsFile before;
  Allowance allowance;
  std::vector<Renaming> renames;
};

/// Result of a comparison.
enum class GateVerdict { not_worse, worse, wrong_renames };

/// Reads a results.json. IoError if the file cannot be read; InputError if it is invalid or contradicts itself.
[[nodiscard]] ResultsFile read_results_file(const std::filesystem::path& file);

/// Reads the baseline, the renames and the numbers of the options; writes nothing. IoError if a file cannot be read;
/// InputError if a file is invalid, a number is not at least 0, or an input is one of the files that `finish` writes
/// into `out`.
[[nodiscard]] BaselineGate read_gate(const BaselineOptions& options, const std::vector<std::string>& only,
                                     const std::filesystem::path& out);

/// Removes the baseline.json and baseline.md of an earlier comparison from `out`.
void remove_comparison(const std::filesystem::path& out);

/// Compares `after` with the baseline, writes baseline.json and baseline.md into `out` and prints the table. IoError if
/// a file cannot be written.
[[nodiscard]] GateVerdict finish(const BaselineGate& gate, const ResultsFile& after, const std::filesystem::path& out);

}  // namespace talus::verification
