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

/// One subcommand: its options are bound to `app`; `work` executes it and returns the exit status.
struct Command {
  CLI::App* app{nullptr};
  std::function<int()> work;
};

/// Add a subcommand with options and help to `talus`.
[[nodiscard]] Command add_run(CLI::App& talus);
[[nodiscard]] Command add_check(CLI::App& talus);
[[nodiscard]] Command add_advise(CLI::App& talus);
[[nodiscard]] Command add_cell(CLI::App& talus);
[[nodiscard]] Command add_completion(CLI::App& talus);
[[nodiscard]] Command add_convert(CLI::App& talus);
[[nodiscard]] Command add_export(CLI::App& talus);
[[nodiscard]] Command add_study(CLI::App& talus);
[[nodiscard]] Command add_sweep(CLI::App& talus);
[[nodiscard]] Command add_list(CLI::App& talus);
[[nodiscard]] Command add_new(CLI::App& talus);
/// Add a subcommand that draws, and sends its DrawingRequest to the sink.
[[nodiscard]] Command add_calibrate(CLI::App& talus, const DrawingSink& sink);
[[nodiscard]] Command add_capacity(CLI::App& talus, const DrawingSink& sink);
[[nodiscard]] Command add_fit(CLI::App& talus, const DrawingSink& sink);
[[nodiscard]] Command add_plot(CLI::App& talus, const DrawingSink& sink);
[[nodiscard]] Command add_snapshot(CLI::App& talus, const DrawingSink& sink);
[[nodiscard]] Command add_animate(CLI::App& talus, const DrawingSink& sink);

/// Validator of an option: a number in [least, most]. It also rejects NaN, which CLI::Range accepts.
[[nodiscard]] CLI::Validator number_between(double minimum, double maximum);

/// Prints an error or a warning to stderr, in red on a terminal unless NO_COLOR is set; control characters are escaped.
void print_failure(std::string_view text);

/// The whole program: parses the command line, executes the command, converts errors to messages and exit statuses.
/// `version` is what --version prints.
[[nodiscard]] int run_command_line(const std::string& version, int count, const char* const* arguments);

}  // namespace talus::app
