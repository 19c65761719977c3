#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace talus::app {

/// A run or cell that came to its end: its folder holds a summary and no checkpoint.
struct EndedRun {
  std::string summary;  ///< text of summary.json
  std::string failure;  ///< why it diverged; empty if it is finished
};

/// The run that ended in a folder; nothing if there is none, or one that can be resumed.
[[nodiscard]] std::optional<EndedRun> ended_run(const std::filesystem::path& folder);

/// What `--resume` does with a run that ended: prints that there is nothing to resume, or with `json` its summary, and
/// returns the exit code that the run itself had (`ok` or `diverged`).
[[nodiscard]] int report_ended_run(const std::filesystem::path& folder, const EndedRun& run, bool json);

}  // namespace talus::app
