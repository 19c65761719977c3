/// Messages about wrong command lines (solver/command_line/usage_error.hpp).
#include "solver/command_line/usage_error.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(usage_error_tests)

using namespace talus;

namespace {

/// The message about these arguments of a program with options, and with commands if `commands`.
std::string message(std::vector<std::string> arguments, bool commands) {
  CLI::App program{"", "tool"};
  std::string out;
  int jobs = 0;
  program.add_option("--out", out);
  program.add_option("--jobs", jobs)->check(whole_between(1, 8));
  refuse_empty_values(program);
  if (commands) {
    program.require_subcommand(1);
    program.add_subcommand("draw")->add_option("--depth", jobs);
    program.add_subcommand("list");
    CLI::App* const many = program.add_subcommand("many");
    many->require_subcommand(1);
    many->add_subcommand("run")->add_option("FOLDER", out)->required();
  }
  std::reverse(arguments.begin(), arguments.end());  // CLI11 takes them from the end
  try {
    program.parse(std::move(arguments));
  } catch (const CLI::ParseError& error) {
    return usage_error(program, error);
  }
  return "no error";
}

}  // namespace

BOOST_AUTO_TEST_CASE(options_and_arguments_that_are_not_known) {
  const std::string help = "\nhelp: tool --help";
  BOOST_TEST(message({"--out", "a", "--jobs", "2"}, false) == "no error");
  BOOST_TEST(message({"--job", "2"}, false) ==
             "option '--job' is not known; nearest: --jobs; known: --help, --out, --jobs" + help);
  BOOST_TEST(message({"case"}, false) == "'case' is one argument too many" + help);
  for (const std::string value : {"9", "two", "2x", "1.5"})
    BOOST_TEST(message({"--jobs", value}, false) ==
               "--jobs: found " + value + "; it must be a whole number between 1 and 8" + help);
  BOOST_TEST(message({"--out", ""}, false) == "--out: found \"\"; a value must follow" + help);
}

BOOST_AUTO_TEST_CASE(commands_that_are_missing_or_not_known) {
  const std::string help = "\nhelp: tool --help";
  BOOST_TEST(message({}, true) == "a command is missing; known: draw, list, many" + help);
  BOOST_TEST(message({"drw"}, true) == "command 'drw' is not known; nearest: draw; known: draw, list, many" + help);
  BOOST_TEST(message({"draw", "--dept", "1"}, true) ==
             "option '--dept' is not known; nearest: --depth; known: --help, --depth\nhelp: tool draw --help");
  BOOST_TEST(message({"many"}, true) == "a command is missing; known: run\nhelp: tool many --help");
  BOOST_TEST(message({"many", "run"}, true) == "FOLDER is required\nhelp: tool many run --help");
  BOOST_TEST(message({"many", "run", "a", "b"}, true) == "'b' is one argument too many\nhelp: tool many run --help");
  BOOST_TEST(message({"many", "run", "--folder"}, true) ==
             "option '--folder' is not known; nearest: --help; known: --help\nhelp: tool many run --help");
  BOOST_TEST(message({"list", "more"}, true) == "'more' is one argument too many\nhelp: tool list --help");
}

BOOST_AUTO_TEST_SUITE_END()
