#pragma once

#include <map>
#include <string>

#include "verification/check/case.hpp"
#include "verification/problems/program/scenes/toml_values.hpp"
#include "verification/record/json_node.hpp"
#include "verification/study/program/program_run.hpp"

/// Summaries of cells beside their scenes and printed tables; part of the case `cell_files`.
namespace talus::verification::problems::cell_files {

/// Expected members of a JSON object by their names.
using Members = std::map<std::string, TomlValue>;
[[nodiscard]] TomlValue number_of(double value);
[[nodiscard]] TomlValue text_of(const std::string& text);

/// Number of units and meanings of results that differ from `units` (by result; none: no unit) and the printed table.
[[nodiscard]] double wrong_texts(const records::Node& numbers, const std::map<std::string, std::string>& units,
                                 const std::string& printed);

/// Number of warnings of a summary that the program has not printed, and of those that it has printed alone.
[[nodiscard]] double wrong_warnings(const records::Node& summary, const ProgramEnd& ended);

/// Number of numbers, texts and switches of a summary that differ from `expected`, or are missing in one of them.
[[nodiscard]] double wrong_members(const records::Node& found, const Members& expected);

/// Runs cells whose scenes set every field, before anything touches, and compares the summary, the figures and the
/// files that are written.
void check_written_cells(const TemporaryFolder& folder, Findings& findings, const Setup& setup);

}  // namespace talus::verification::problems::cell_files
