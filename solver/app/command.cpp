#include "solver/app/command.hpp"

#include <fmt/format.h>
#include <unistd.h>
#include <cstdlib>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cstdio>
#include <vector>

#include "solver/base/error.hpp"
#include "solver/command_line/usage_error.hpp"
#include "verification/record/utf8.hpp"

namespace talus::app {
namespace {

void describe(CLI::App& talus, const std::string& version) {
  talus.description(
      "Talus: a 2-D discrete element code for rockfall fences and sheared granular cells.\n"
      "Bodies, tension-only cables and contacts, described in a scene file (TOML, quantities with units).");
  talus.footer(
      "Examples:\n"
      "  talus new fence > my.toml                    a commented scene file that runs as it is\n"
      "  talus check cases/two_cable.toml             its bodies and contacts; is the step small enough?\n"
      "  talus advise cases/two_cable.toml --accuracy 1e-3 --of particle.x.max --out advised.toml\n"
      "                                               the cheapest integrator and step that reach this accuracy\n"
      "  talus run cases/two_cable.toml --out out     run it; summary here, histories and state in out/\n"
      "  talus plot out                               draw the histories into out/plots/\n"
      "  talus snapshot out                           draw bodies and cables at several times\n"
      "  talus animate out                            a page that plays the run in a browser\n"
      "  talus cell cases/cell/CNTRL.DAT --units SI   a sheared cell of discs, as the program SNOFLO of 1989\n"
      "  talus convert fence.DAT fence.toml           a deck of the 1993 program FENCE as a scene, or back\n"
      "  talus list fields                            every field that a scene can hold, with its dimension\n"
      "Exit statuses: 0 done, 2 wrong input or usage, 3 the run failed numerically, 4 a file cannot be read or "
      "written, 5 "
      "no method gives the required accuracy, 6 some runs of a sweep failed, 7 the results are NOT USABLE or, of "
      "check, the step is beyond its limit "
      "or the run would end at its start, 128 + n stopped by signal n and saved to be resumed.");
  talus.set_version_flag("--version", version, "Print the version, the revision and the build, and exit");
  talus.require_subcommand(1);
}

int report(ExitCode code, std::string_view message) {
  print_failure(message);
  return code;
}

int work(const std::vector<Command>& commands) {
  try {
    const auto given =
        std::find_if(commands.begin(), commands.end(), [](const Command& command) { return command.app->parsed(); });
    TALUS_DEMAND(given != commands.end());
    const int code = given->work();
    // Output to a full disk or a closed pipe is lost: report it.
    if (std::fflush(stdout) != 0) return report(io_failed, "standard output: cannot be written");
    return code;
  } catch (const InputError& error) {
    return report(bad_input, error.what());
  } catch (const IoError& error) {
    return report(io_failed, error.what());
  } catch (const std::system_error& error) {
    // Thrown by a write to stdout, by the file system, or when a thread cannot be started.
    return report(io_failed, fmt::format("{}{}", std::ferror(stdout) != 0 ? "standard output: " : "", error.what()));
  }
}

int parse_and_work(const std::string& version, int count, const char* const* arguments) {
  for (int i = 1; i < count; ++i) {
    if (records::is_utf8(arguments[i])) continue;
    return report(bad_input, fmt::format("found \"{}\", which is not UTF-8; what names files and titles must be, since "
                                         "it is written to JSON and XML",
                                         records::as_utf8(arguments[i])));
  }
  CLI::App talus{"", "talus"};
  describe(talus, version);
  const std::vector<Command> commands{add_run(talus),
                                      add_check(talus),
                                      add_advise(talus),
                                      add_calibrate(talus, draw),
                                      add_capacity(talus, draw),
                                      add_cell(talus),
                                      add_completion(talus),
                                      add_convert(talus),
                                      add_export(talus),
                                      add_fit(talus, draw),
                                      add_plot(talus, draw),
                                      add_snapshot(talus, draw),
                                      add_animate(talus, draw),
                                      add_study(talus),
                                      add_sweep(talus),
                                      add_list(talus),
                                      add_new(talus)};
  for (const Command& command : commands)
    refuse_empty_values(*command.app);
  try {
    talus.parse(count, arguments);
  } catch (const CLI::ParseError& error) {
    return exit_of_parse(talus, error);
  }
  return work(commands);
}

}  // namespace

CLI::Validator number_between(double minimum, double maximum) {
  return {[=](std::string& value) {
            double number = 0.0;
            const auto [end, failure] = std::from_chars(value.data(), value.data() + value.size(), number);
            const bool read = failure == std::errc{} && end == value.data() + value.size();
            if (read && number >= minimum && number <= maximum) return std::string{};
            return fmt::format("found {}; it must be a number between {} and {}", value, minimum, maximum);
          },
          fmt::format("in [{}, {}]", minimum, maximum)};
}

void print_failure(std::string_view text) {
  // Messages quote files, names of files and other programs.
  const std::string message = records::shown_lines(text);
  const char* no_color = std::getenv("NO_COLOR");
  const bool red = ::isatty(STDERR_FILENO) == 1 && (no_color == nullptr || *no_color == '\0');
  std::string lines;
  for (std::size_t from = 0; from <= message.size();) {
    const std::size_t end = std::min(message.find('\n', from), message.size());
    const std::string_view line = std::string_view{message}.substr(from, end - from);
    const bool help = line.starts_with("help: ");
    lines += fmt::format("{}{}{}{}\n", red ? "\033[31m" : "", help ? "" : "talus: ", line, red ? "\033[0m" : "");
    from = end + 1;
  }
  // Keeps the order and whole lines if stdout and stderr go to the same file.
  std::fflush(stdout);
  // Write errors of stderr are ignored: they lose the message, not the run.
  std::fputs(lines.c_str(), stderr);
  std::fflush(stderr);
}

int run_command_line(const std::string& version, int count, const char* const* arguments) {
  try {
    return parse_and_work(version, count, arguments);
  } catch (const std::bad_alloc&) {
    std::fputs("talus: out of memory\n", stderr);  // no fmt::format: it allocates memory
    return io_failed;
  }
}

}  // namespace talus::app
