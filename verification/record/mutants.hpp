#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "verification/record/names.hpp"

/// mutants.json: small changes of the solver and the cases that detected them.
namespace talus::records {

enum class MutantStatus {
  pending,     ///< not tested
  killed,      ///< a case failed
  survived,    ///< cases evaluated it, and all passed
  unreached,   ///< no case evaluates it
  equivalent,  ///< changes no result, for a recorded reason
};

template <>
struct Names<MutantStatus> {
  static constexpr std::array<std::pair<MutantStatus, const char*>, 5> values{
      {{MutantStatus::pending, "pending"},
       {MutantStatus::killed, "killed"},
       {MutantStatus::survived, "survived"},
       {MutantStatus::unreached, "unreached"},
       {MutantStatus::equivalent, "equivalent"}}};
};

/// Result of a case with a mutant.
enum class TrialEnd { pass, fail, error, crash, timeout };

template <>
struct Names<TrialEnd> {
  static constexpr std::array<std::pair<TrialEnd, const char*>, 5> values{{{TrialEnd::pass, "pass"},
                                                                           {TrialEnd::fail, "fail"},
                                                                           {TrialEnd::error, "error"},
                                                                           {TrialEnd::crash, "crash"},
                                                                           {TrialEnd::timeout, "timeout"}}};
};

/// One run of a case with one mutant.
struct Trial {
  std::string case_id{};
  TrialEnd end{};
  double ratio{};       ///< largest error/bound of its checks; infinite if a check without a size failed or the case
                        ///< did not finish
  std::string check{};  ///< the check with that ratio
  std::vector<std::string> failed{};  ///< the checks that failed
};

/// Line and column, counted from 1, columns in bytes; the end is after the last byte.
struct SourceRange {
  std::size_t line{};
  std::size_t column{};
  std::size_t end_line{};
  std::size_t end_column{};
};

struct MutantRecord {
  int number{};                      ///< number that activates it; 0: equivalent, not compiled
  std::string id{};                  ///< unique
  std::string operation{};           ///< mutation operator, or "bug" for a hand-written one
  std::string description{};         ///< description of the error
  std::string file{};                ///< path in the source tree
  SourceRange range{};               ///< source range that it replaces
  std::string original{};            ///< replaced text
  std::string replacement{};         ///< new text; empty: the original is deleted
  std::vector<std::string> cases{};  ///< cases of which one must fail (bugs); "*": all that evaluate it must fail
  MutantStatus status{};
  std::string reason{};                   ///< why it is equivalent
  std::vector<std::string> covered_by{};  ///< cases that evaluate it
  std::vector<Trial> trials{};            ///< the runs made; without the whole matrix none after the first kill
};

/// A case without mutants, in this build.
struct UnchangedCase {
  std::string id{};
  std::string family{};
  double seconds{};  ///< processor time
  bool recorded{};   ///< it compares with earlier results of the program itself
  bool in_matrix{};  ///< run with every mutant that it evaluates, not only until a case is red
};

struct Mutants {
  std::size_t candidates{};      ///< number of mutants generated, including those that do not compile
  std::size_t uncompiled{};      ///< number of drawn mutants that were dropped because they do not compile
  std::uint64_t seed{};          ///< seed of the sample
  bool whole_matrix{};           ///< whether every mutant was run with each case of the matrix that evaluates it
  std::size_t operator_count{};  ///< number of mutation operators in use
  double build_seconds{};
  double run_seconds{};
  std::vector<UnchangedCase> cases{};
  std::vector<MutantRecord> mutants{};
};

/// Whether the case detected the mutant.
[[nodiscard]] bool kills(const Trial& trial);

/// Numbers of mutants by status.
struct Score {
  std::size_t killed{};
  std::size_t survived{};
  std::size_t unreached{};
  std::size_t equivalent{};
  std::size_t pending{};

  /// Number of mutants in the score: all except the equivalent and the pending ones.
  [[nodiscard]] std::size_t counted() const { return killed + survived + unreached; }
  /// Killed fraction of the counted mutants; 1 if there are none.
  [[nodiscard]] double fraction() const {
    return counted() == 0 ? 1.0 : static_cast<double>(killed) / static_cast<double>(counted());
  }
};
void count(Score& score, const MutantRecord& mutant);

/// Errors: FileError if a file cannot be written or read, RecordError for invalid content.
void write_mutants(const Mutants& mutants, const std::filesystem::path& file);
[[nodiscard]] Mutants read_mutants(const std::filesystem::path& file);

}  // namespace talus::records
