#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "solver/base/exit_code.hpp"
#include "solver/draw/drawing.hpp"

namespace CLI {
class App;
class Validator;
}  // namespace CLI

namespace talus::app {

/// One subcommand: its options are bound to `app`; `work` does it and returns the exit code.
struct Command {
  CLI::App* app{nullptr};
  std::function<int()> work;
};

/// Each adds its subcommand with options and help to `talus`.
[[nodiscard]] Command add_run(CLI::App& talus);
[[nodiscard]] Command add_check(CLI::App& talus);
[[nodiscard]] Command add_advise(CLI::App& talus);
[[nodiscard]] Command add_calibrate(CLI::App& talus);
[[nodiscard]] Command add_cell(CLI::App& talus);
[[nodiscard]] Command add_convert(CLI::App& talus);
[[nodiscard]] Command add_export(CLI::App& talus);
[[nodiscard]] Command add_study(CLI::App& talus);
[[nodiscard]] Command add_list(CLI::App& talus);
[[nodiscard]] Command add_new(CLI::App& talus);
/// These send what they draw to the sink.
[[nodiscard]] Command add_plot(CLI::App& talus, const DrawingSink& sink);
[[nodiscard]] Command add_snapshot(CLI::App& talus, const DrawingSink& sink);
[[nodiscard]] Command add_animate(CLI::App& talus, const DrawingSink& sink);

/// Of an option: a number between these. What is not a number is refused, which CLI::Range lets pass.
[[nodiscard]] CLI::Validator number_between(double least, double most);

/// Says what went wrong, or what is to be known, on stderr: in red on a terminal unless NO_COLOR is set.
void print_failure(std::string_view words);

/// A word of a command that is printed, such that a shell reads it as it is: in quotes where it holds more than letters,
/// digits, bytes of UTF-8 and `/ . _ - + , : = @ %`.
[[nodiscard]] std::string shell_word(const std::string& word);

/// The whole program: parses the command line, does the command, turns errors into messages and exit codes.
[[nodiscard]] int run_command_line(int count, const char* const* arguments);

}  // namespace talus::app
