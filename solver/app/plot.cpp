#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>

#include "solver/app/command.hpp"
#include "solver/base/error.hpp"
#include "solver/io/toml_document.hpp"

extern char** environ;

namespace talus::app {
namespace {

namespace fs = std::filesystem;

struct PlotOptions {
  std::string folder;
  std::vector<std::string> formats{"svg", "pdf", "png"};
};

/// talus_report beside this executable, or else in the folders of PATH.
fs::path find_report_tool() {
  std::error_code error;
  const fs::path self = fs::read_symlink("/proc/self/exe", error);
  std::vector<fs::path> places;
  if (!error) places.push_back(self.parent_path());
  const char* path = std::getenv("PATH");
  for (std::string_view rest = path != nullptr ? path : ""; !rest.empty();) {
    const std::size_t colon = std::min(rest.find(':'), rest.size());
    if (colon > 0) places.emplace_back(rest.substr(0, colon));
    rest.remove_prefix(std::min(colon + 1, rest.size()));
  }
  for (const fs::path& place : places) {
    if (const fs::path tool = place / "talus_report"; ::access(tool.c_str(), X_OK) == 0) return tool;
  }
  throw IoError{"talus_report draws the plots; it is neither beside talus nor in PATH"};
}

int plot(const PlotOptions& options) {
  // Read here only so that a folder without a run is named before another program starts.
  static_cast<void>(read_text(fs::path{options.folder} / "plot.json"));
  const std::string tool = find_report_tool().string();
  const std::string formats = fmt::format("{}", fmt::join(options.formats, ","));
  std::string words[] = {tool, "--plot", options.folder, "--format", formats};
  std::vector<char*> arguments;
  for (std::string& word : words)
    arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t child = 0;
  if (const int reason = ::posix_spawn(&child, tool.c_str(), nullptr, nullptr, arguments.data(), environ)) {
    throw IoError{fmt::format("{}: {}", tool, std::strerror(reason))};
  }
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status)) return WEXITSTATUS(status);
  throw IoError{fmt::format("{}: ended by signal {}", tool, WTERMSIG(status))};
}

}  // namespace

Command add_plot(CLI::App& talus) {
  CLI::App* app = talus.add_subcommand("plot", "Draw the histories of a run into its folder plots/");
  const auto options = std::make_shared<PlotOptions>();
  app->add_option("DIR", options->folder, "folder that `talus run --out` wrote")->required();
  app->add_option("--format", options->formats, "formats, from svg, pdf, png; default all")
      ->delimiter(',')
      ->check(CLI::IsMember({"svg", "pdf", "png"}));
  app->footer("Example:\n  talus run cases/two_cable.toml --out out && talus plot out --format svg");
  return {app, [options] { return plot(*options); }};
}

}  // namespace talus::app
