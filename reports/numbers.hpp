/// Numbers of a report, compared with those of the records that it was made from.
#pragma once

#include <cstddef>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace talus::reports {

/// Number of numbers in a Markdown text as a reader sees it: without targets of links, attributes of pictures, numbers
/// of figures and tables, versions of tools; digits of names such as rk4, `fence_1993` or 2D are not numbers.
[[nodiscard]] std::size_t count_of_numbers(const std::string& markdown);

/// All numbers of results.json in a folder and of the audits (in that folder, else in that of recorded audits), of
/// their texts and of the templates of chapters; and the sums, fractions and sizes that the report derives from them.
/// Throws RecordError or FileError of the record library if a file cannot be read.
[[nodiscard]] std::set<double> numbers_of_records(const std::filesystem::path& verify,
                                                  const std::filesystem::path& templates,
                                                  const std::filesystem::path& audits = {});

/// Numbers of a Markdown text, as written, that are neither among `known`, rounded to their digits, nor ordinals
/// (integers up to 250).
[[nodiscard]] std::vector<std::string> unfounded_numbers(const std::string& markdown, const std::set<double>& known);

/// The same of both volumes of the report in a folder.
[[nodiscard]] std::vector<std::string> unfounded_numbers(const std::filesystem::path& verify,
                                                         const std::filesystem::path& report,
                                                         const std::filesystem::path& templates,
                                                         const std::filesystem::path& audits = {});

}  // namespace talus::reports
