#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "reports/base/process.hpp"
#include "solver/base/fields.hpp"

namespace talus::app {

/// What starts the parts of a sweep.
enum class Engine {
  local,     ///< threads of this process
  parallel,  ///< GNU parallel, here or on hosts that ssh reaches
  slurm,     ///< a job array
};

/// Request to run a sweep in parts, each by a process with one thread.
struct EngineRequest {
  std::filesystem::path folder;   ///< of the sweep; absolute
  std::filesystem::path program;  ///< talus; absolute
  std::size_t parts{};
  unsigned threads{1};               ///< of this machine
  std::string hosts;                 ///< of parallel: file with ssh hosts; empty: this machine
  std::vector<std::string> options;  ///< for the engine's command
  bool waits{};                      ///< of slurm: wait until all parts have ended
};

/// Text of the shell script that runs one part: its first argument, or that of the Slurm task.
[[nodiscard]] std::string part_script(const EngineRequest& request);

/// The command that starts all parts by the script. Errors: InputError for an option that the engine does not use.
[[nodiscard]] reports::Command engine_command(Engine engine, const EngineRequest& request,
                                              const std::filesystem::path& script);

}  // namespace talus::app

namespace talus {
template <>
struct Names<app::Engine> {
  static constexpr std::array<std::string_view, 3> list{"local", "parallel", "slurm"};
};
}  // namespace talus
