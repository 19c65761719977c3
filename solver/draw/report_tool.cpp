#include "solver/draw/report_tool.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "solver/base/error.hpp"

extern char** environ;

namespace talus::app {

namespace fs = std::filesystem;

fs::path report_tool() {
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

int run_report_tool(std::vector<std::string> arguments, bool quiet) {
  const std::string tool = report_tool().string();
  arguments.insert(arguments.begin(), tool);
  std::vector<char*> words;
  for (std::string& argument : arguments)
    words.push_back(argument.data());
  words.push_back(nullptr);
  // What was printed before must stand before what the tool prints, in whole lines.
  std::fflush(stdout);
  pid_t child = 0;
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  if (quiet) ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  const int reason = ::posix_spawn(&child, tool.c_str(), &actions, nullptr, words.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  if (reason != 0) {
    throw IoError{fmt::format("{}: {}", tool, std::strerror(reason))};
  }
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status)) return WEXITSTATUS(status);
  throw IoError{fmt::format("{}: ended by signal {}", tool, WTERMSIG(status))};
}

}  // namespace talus::app
