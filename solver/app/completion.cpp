#include "solver/command_line/completion.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "solver/app/command.hpp"

namespace talus::app {
namespace {

int print_completion(const CLI::App& talus, const std::string& wanted) {
  fmt::print("{}", completion(talus, value_named<Shell>("shell", wanted)));
  return ok;
}

}  // namespace

Command add_completion(CLI::App& talus) {
  CLI::App* app = talus.add_subcommand("completion", "Print a script that makes a shell complete commands and options");
  const auto shell = std::make_shared<std::string>();
  offer(app->add_option("shell", *shell, "bash, zsh or fish")->required(), names_of<Shell>());
  app->footer(
      "Example:\n"
      "  source <(talus completion bash)     in ~/.bashrc, for each shell from then on; or for all users:\n"
      "  talus completion fish > /usr/share/fish/vendor_completions.d/talus.fish");
  return {app, [&talus, shell] { return print_completion(talus, *shell); }};
}

}  // namespace talus::app
