#include "solver/command_line/completion.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <memory>
#include <utility>

#include "solver/app/command.hpp"
#include "solver/base/error.hpp"

namespace talus::app {
namespace {

constexpr std::array<std::pair<const char*, Shell>, 3> shells{
    {{"bash", Shell::bash}, {"zsh", Shell::zsh}, {"fish", Shell::fish}}};

std::vector<std::string> shell_names() {
  std::vector<std::string> names;
  for (const auto& each : shells)
    names.emplace_back(each.first);
  return names;
}

int print_completion(const CLI::App& talus, const std::string& wanted) {
  for (const auto& [name, shell] : shells) {
    if (wanted != name) continue;
    fmt::print("{}", completion(talus, shell));
    return ok;
  }
  throw unknown_name("shell", wanted, shell_names());
}

}  // namespace

Command add_completion(CLI::App& talus) {
  CLI::App* app = talus.add_subcommand("completion", "Print a script that makes a shell complete commands and options");
  const auto shell = std::make_shared<std::string>();
  offer(app->add_option("shell", *shell, "bash, zsh or fish")->required(), shell_names());
  app->footer(
      "Example:\n"
      "  source <(talus completion bash)     in ~/.bashrc, for each shell from then on; or for all users:\n"
      "  talus completion fish > /usr/share/fish/vendor_completions.d/talus.fish");
  return {app, [&talus, shell] { return print_completion(talus, *shell); }};
}

}  // namespace talus::app
