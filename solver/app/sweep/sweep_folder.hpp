#pragma once

#include <sys/types.h>

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "solver/app/sweep/sweep_base.hpp"
#include "solver/app/sweep/sweep_file.hpp"
#include "solver/app/sweep/sweep_result.hpp"
#include "solver/app/sweep/sweep_runs.hpp"

namespace talus::app {

/// The folder of a sweep, which is all that its runs need, on any machine:
///
///   sweep.json      base, outputs, limits and number of runs
///   base.toml       the scene
///   manifest.jsonl  a line for each run: its id and its parameters
///   results/*.jsonl results, a line for each run; a file for each process that runs parts of the sweep
struct SweepFolder {
  std::filesystem::path folder;
  std::string title;
  std::string base_text;
  std::vector<std::string> outputs;
  SweepLimits limits;
  std::vector<SweptRun> runs;

  [[nodiscard]] SweepBase base() const;
  /// 16 hexadecimal digits that follow from base, outputs and limits: results of equal ones are of the same sweep.
  [[nodiscard]] std::string key() const;
  /// Part `number` >= 1 of `of` equal parts: every run of that number, and each of-th after it.
  [[nodiscard]] SweepFolder part(std::size_t number, std::size_t of) &&;
};

/// Writes the folder of a planned sweep. An earlier plan in it is replaced; its results remain and count for runs that
/// both have. Errors: InputError if there are results, and base, outputs or limits differ from those of these results;
/// IoError.
void write_sweep_folder(const SweepFolder& sweep);

/// Reads a folder. Errors: IoError; InputError for a folder that is not of a sweep, with file and line.
[[nodiscard]] SweepFolder read_sweep_folder(const std::filesystem::path& folder);

/// All results in a folder, also of runs that the manifest does not have. The last line of a file without its end, of a
/// process that was killed, is ignored. Errors: IoError; InputError with file and line.
[[nodiscard]] std::vector<SweepResult> all_results(const SweepFolder& sweep);

/// Results of a sweep by the ids of the runs.
struct KnownResults {
  std::map<std::string, SweepResult> by_id;
  std::vector<std::pair<std::string, std::filesystem::path>> duplicates;  ///< ids of runs that had results, with the
                                                                          ///< files of the further ones
  std::size_t of_others{};  ///< number of results of runs that are not in the manifest
};
/// The results of the manifest's runs. Errors: as all_results().
[[nodiscard]] KnownResults read_results(const SweepFolder& sweep);

/// File for the results of this process. A line is written at once, so that the results of a killed process are whole.
class ResultFile {
 public:
  /// Errors: IoError.
  explicit ResultFile(const SweepFolder& sweep);
  ResultFile(const ResultFile&) = delete;
  ResultFile& operator=(const ResultFile&) = delete;
  ~ResultFile();

  /// Adds a result; one thread at a time. Errors: IoError.
  void add(const SweepResult& result);
  /// Flushes all results to the disk. Errors: IoError.
  void flush();

 private:
  std::filesystem::path file_;
  std::string key_;
  int descriptor_{-1};
  off_t size_{};
};

}  // namespace talus::app
