/// Runs another program without a shell and waits for it; callable from any thread.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace talus::reports {

/// A program with its arguments and environment. Standard input is empty.
struct Command {
  std::string program;                             ///< looked up in PATH
  std::vector<std::string> arguments;              ///< passed literally, without a shell
  std::filesystem::path folder{};                  ///< working folder; empty: that of this process
  std::map<std::string, std::string> environment;  ///< added to the environment of this process, or replacing its
                                                   ///< entries
};

/// Result of a program.
struct Finished {
  int status{};            ///< exit status, or 128 + signal
  std::string output{};    ///< standard output
  std::string messages{};  ///< standard error
};

/// Runs the program until it ends. `watch` is called about five times a second, and after output; a signal that it
/// returns is sent to the program, 0: none. Throws OutputError if it cannot be started (not found, no permission, no
/// such folder).
[[nodiscard]] Finished run(const Command& command, const std::function<int()>& watch = {});

/// Throws OutputError, as run() would, unless a program with that name is in PATH.
void demand_program(const std::string& name);

/// As run(), but throws OutputError with the tool's name and messages if its exit status is not 0. `purpose` completes
/// "gnuplot failed on ...".
Finished run_or_throw(const Command& command, const std::string& purpose);

}  // namespace talus::reports
