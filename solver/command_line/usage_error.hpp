#pragma once

#include <cstdint>
#include <string>

namespace CLI {
class App;
class ParseError;
class Validator;
}  // namespace CLI

namespace talus {

/// Rejects empty values of all options of a program or command, for example from an unset shell variable: no option has
/// a meaning for them.
void refuse_empty_values(CLI::App& app);

/// Validator of an option: a whole number in [minimum, maximum]. In place of CLI::Range, whose message does not say
/// what is wrong with a text.
[[nodiscard]] CLI::Validator whole_between(std::int64_t minimum, std::int64_t maximum);

/// The innermost subcommand that was given on the command line, or the program if none was recognised.
[[nodiscard]] const CLI::App& active_command(const CLI::App& program);

/// Message about a command line that CLI11 rejected, in the form of other messages: an unknown option or command with
/// the nearest and the known ones. Its last line is "help: PROGRAM --help". The program must have a name.
[[nodiscard]] std::string usage_error(const CLI::App& program, const CLI::ParseError& error);

/// Prints what parse() threw: the requested help or version on standard output, else "PROGRAM: " and usage_error() on
/// standard error. Returns the exit status: 0, or 4 if standard output cannot be written; 2 for a wrong command line.
[[nodiscard]] int exit_of_parse(const CLI::App& program, const CLI::ParseError& error);

}  // namespace talus
