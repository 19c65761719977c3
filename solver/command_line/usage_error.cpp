#include "solver/command_line/usage_error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdio>
#include <iostream>
#include <vector>

#include "solver/base/error.hpp"
#include "solver/base/exit_code.hpp"

namespace talus {
namespace {

/// "talus sweep run", of active_command().
std::string full_name(const CLI::App& program) {
  const auto parsed = program.get_subcommands();
  return program.get_name() + (parsed.empty() ? "" : " " + full_name(*parsed.front()));
}

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames())
      names.push_back("--" + name);
  }
  return names;
}

std::vector<std::string> subcommand_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  return names;
}

std::string message(const CLI::App& program, const CLI::ParseError& error) {
  const CLI::App& app = active_command(program);
  const std::vector<std::string> commands = subcommand_names(app), unexpected = program.remaining(true);
  if (unexpected.empty() && !commands.empty() && dynamic_cast<const CLI::RequiredError*>(&error) != nullptr)
    return fmt::format("a command is missing; known: {}", fmt::join(commands, ", "));
  if (unexpected.empty()) return error.what();
  const std::string& first = unexpected.front();
  if (first.front() == '-') {
    // A long list hides the nearest name; --help, which the next line names, prints it.
    const std::vector<std::string> names = option_names(app);
    constexpr std::size_t maximum_listed = 20;
    if (names.size() <= maximum_listed) return unknown_name("option", first, names).what();
    return fmt::format("option '{}' is not known; nearest: {}", first, nearest_name(first, names));
  }
  if (!commands.empty()) return unknown_name("command", first, commands).what();
  return fmt::format("'{}' is one argument too many", first);
}

}  // namespace

void refuse_empty_values(CLI::App& app) {
  for (CLI::Option* option : app.get_options())
    if (option->get_items_expected_max() > 0)
      option->check([](const std::string& value) {
        return value.empty() ? std::string{"found \"\"; a value must follow"} : std::string{};
      });
}

CLI::Validator whole_between(std::int64_t minimum, std::int64_t maximum) {
  return {[=](const std::string& value) {
            std::int64_t number = 0;
            const auto [end, failure] = std::from_chars(value.data(), value.data() + value.size(), number);
            const bool is_whole = failure == std::errc{} && end == value.data() + value.size();
            if (is_whole && number >= minimum && number <= maximum) return std::string{};
            return fmt::format("found {}; it must be a whole number between {} and {}", value, minimum, maximum);
          },
          fmt::format("in [{}, {}]", minimum, maximum)};
}

const CLI::App& active_command(const CLI::App& program) {
  const auto parsed = program.get_subcommands();
  return parsed.empty() ? program : active_command(*parsed.front());
}

std::string usage_error(const CLI::App& program, const CLI::ParseError& error) {
  return fmt::format("{}\nhelp: {} --help", message(program, error), full_name(program));
}

int exit_of_parse(const CLI::App& program, const CLI::ParseError& error) {
  const auto fail = [&](app::ExitCode code, const std::string& message) {
    std::fputs(fmt::format("{}: {}\n", program.get_name(), message).c_str(), stderr);
    return code;
  };
  if (dynamic_cast<const CLI::Success*>(&error) == nullptr) {
    std::fflush(stdout);
    return fail(app::bad_input, usage_error(program, error));
  }
  static_cast<void>(program.exit(error));
  const bool is_written = static_cast<bool>(std::cout.flush()) && std::fflush(stdout) == 0;
  return is_written ? app::ok : fail(app::io_failed, "standard output: cannot be written");
}

}  // namespace talus
