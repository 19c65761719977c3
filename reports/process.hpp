/// Starting another program without a shell, and waiting for it; from any thread.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace talus::reports {

/// A program and all that it is given. Standard input is empty.
struct Command {
  std::string program;                             ///< looked up in PATH
  std::vector<std::string> arguments;              ///< passed as they are, no shell reads them
  std::filesystem::path folder{};                  ///< working folder; empty: ours
  std::map<std::string, std::string> environment;  ///< added to ours, or replacing entries of it
};

/// How a program ended.
struct Finished {
  int status{};            ///< exit code, or 128 + signal
  std::string output{};    ///< standard output
  std::string messages{};  ///< standard error
};

/// Runs the program to its end. Throws OutputError when it cannot be started (not found, no permission, no
/// such folder).
[[nodiscard]] Finished run(const Command& command);

/// Throws OutputError, as run() would, unless a program of that name is in PATH.
void demand_program(const std::string& name);

/// As run(), and throws OutputError naming the tool and showing its messages when it ends with other than 0.
/// `purpose` completes "gnuplot failed on ...".
Finished run_or_throw(const Command& command, const std::string& purpose);

}  // namespace talus::reports
