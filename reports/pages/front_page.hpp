/// The parts of the report's first two pages: what was verified, the main pictures, the findings. All results are
/// Markdown.
#pragma once

#include <string>

#include "reports/base/record.hpp"

namespace talus::reports {

/// How many requirements of each group have checks in this run, all of which pass, in a sentence.
[[nodiscard]] std::string verified(const Results& results);

/// Requirements without a check in this run or with one that failed, and what the report is not about.
[[nodiscard]] std::string not_verified(const Results& results);

/// The highlights in rows of two, as the pictures figures/<highlight_stem()>.svg; highlights of cases that did not run
/// are omitted.
[[nodiscard]] std::string highlights(const Results& results);

/// The figure of a highlight; null if its case was not selected or broke off. Throws RecordError when the case has no
/// such figure.
[[nodiscard]] const Figure* figure_of(const Results& results, const records::Highlight& highlight);

[[nodiscard]] std::string highlight_stem(const records::Highlight& highlight);

/// The findings as a numbered list, with measured values in the place of names of checks; those whose cases were not
/// selected or broke off are left out. Throws RecordError when a case has no check of a name.
[[nodiscard]] std::string findings(const Results& results);

}  // namespace talus::reports
