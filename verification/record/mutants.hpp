#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "verification/record/names.hpp"

/// mutants.json: small changes of the solver and which cases noticed them.
namespace talus::records {

enum class MutantStatus {
  pending,     ///< not tried
  killed,      ///< a case turned red
  survived,    ///< cases evaluated it, and all stayed green
  unreached,   ///< no case evaluates it
  equivalent,  ///< changes no result, for a reason that is written down
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

/// How a case ended with a mutant.
enum class TrialEnd { pass, fail, error, crash, timeout };

template <>
struct Names<TrialEnd> {
  static constexpr std::array<std::pair<TrialEnd, const char*>, 5> values{{{TrialEnd::pass, "pass"},
                                                                           {TrialEnd::fail, "fail"},
                                                                           {TrialEnd::error, "error"},
                                                                           {TrialEnd::crash, "crash"},
                                                                           {TrialEnd::timeout, "timeout"}}};
};

/// One case run with one mutant.
struct Trial {
  std::string case_id{};
  TrialEnd end{};
  double ratio{};       ///< largest error/bound of its checks; infinite if one failed that has no size, or the case did
                        ///< not end
  std::string check{};  ///< the check with that ratio
  std::vector<std::string> failed{};  ///< the checks that failed
};

/// Line and column, from 1, columns in bytes; the end is behind the last byte.
struct SourceRange {
  std::size_t line{};
  std::size_t column{};
  std::size_t end_line{};
  std::size_t end_column{};
};

struct MutantRecord {
  int number{};                      ///< that switches it on
  std::string id{};                  ///< unique
  std::string operation{};           ///< mutation operator, or "bug" for one written by hand
  std::string words{};               ///< what is wrong
  std::string file{};                ///< path in the source tree
  SourceRange range{};               ///< of what it replaces
  std::string original{};            ///< what it replaces
  std::string replacement{};         ///< by what; empty: left out
  std::vector<std::string> cases{};  ///< of which one must turn red (bugs); "*": all that evaluate it must
  MutantStatus status{};
  std::string reason{};                   ///< why it is equivalent
  std::vector<std::string> covered_by{};  ///< cases that evaluate it
  std::vector<Trial> trials{};            ///< those run; without the whole matrix none after the first kill
};

/// A case without a mutant, in this build.
struct UnchangedCase {
  std::string id{};
  std::string family{};
  double seconds{};  ///< processor time
  bool recorded{};   ///< it compares with earlier results of the program itself
};

struct Mutants {
  std::size_t candidates{};      ///< generated mutants that there are, those that do not compile among them
  std::size_t uncompiled{};      ///< of those drawn, left out because they do not compile
  std::uint64_t seed{};          ///< of the sample
  bool whole_matrix{};           ///< every case that evaluates a mutant was run with it
  std::size_t operator_count{};  ///< mutation operators in use
  double build_seconds{};
  double run_seconds{};
  std::vector<UnchangedCase> cases{};
  std::vector<MutantRecord> mutants{};
};

/// Whether a case turned red.
[[nodiscard]] bool kills(const Trial& trial);

/// How many of a set of mutants were killed.
struct Score {
  std::size_t killed{};
  std::size_t survived{};
  std::size_t unreached{};
  std::size_t equivalent{};

  /// Those that count: not the equivalent ones.
  [[nodiscard]] std::size_t counted() const { return killed + survived + unreached; }
  /// Killed of those that count; 1 if none does.
  [[nodiscard]] double share() const {
    return counted() == 0 ? 1.0 : static_cast<double>(killed) / static_cast<double>(counted());
  }
};
void count(Score& score, const MutantRecord& mutant);

/// FileError if a file cannot be written or read, RecordError for another content.
void write_mutants(const Mutants& mutants, const std::filesystem::path& file);
[[nodiscard]] Mutants read_mutants(const std::filesystem::path& file);

}  // namespace talus::records
