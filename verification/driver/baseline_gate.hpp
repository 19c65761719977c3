#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "verification/driver/baseline.hpp"

namespace talus::verification {

/// The options of a comparison with a baseline as they are given; numbers are read by `read_gate`.
struct BaselineOptions {
  std::string baseline;                 ///< An earlier results.json; empty: no comparison.
  std::string compare;                  ///< The results.json to compare; empty: that of this run.
  std::string renamed;                  ///< File of renames; empty: none.
  std::vector<std::string> tolerances;  ///< "X" or "NAME=X".
  std::string margin;                   ///< Empty: none.
  std::string evaluation_growth = "0";
  bool allow_round_off = false;
};

/// What the results of a run are compared with, read before anything is run.
struct BaselineGate {
  RecordedResults before;
  Allowance allowance;
  std::vector<Renaming> renames;
};

/// How a comparison ends.
enum class GateVerdict { not_worse, worse, wrong_renames };

/// Reads baseline and renames and the numbers of the options; nothing is written. IoError if a file cannot be read;
/// InputError if one is not what it must be, if a number is not one of at least 0, or if an input is one of the files
/// that `finish` writes into `out`.
[[nodiscard]] BaselineGate read_gate(const BaselineOptions& options, const std::vector<std::string>& only,
                                     const std::filesystem::path& out);

/// Removes baseline.json and baseline.md that an earlier comparison left in `out`.
void remove_comparison(const std::filesystem::path& out);

/// Compares `after` with the baseline, writes baseline.json and baseline.md into `out` and prints the table. IoError if
/// a file cannot be written.
[[nodiscard]] GateVerdict finish(const BaselineGate& gate, const RecordedResults& after,
                                 const std::filesystem::path& out);

}  // namespace talus::verification
