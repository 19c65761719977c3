#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace talus::app {

/// talus_report beside this executable, or else in the folders of PATH. Errors: IoError if it is in none.
[[nodiscard]] std::filesystem::path report_tool();

/// Runs talus_report with these arguments and returns its exit code. Errors: IoError if it cannot be started or ends by
/// a signal. `quiet`: it prints no list of its files.
[[nodiscard]] int run_report_tool(std::vector<std::string> arguments, bool quiet = false);

}  // namespace talus::app
