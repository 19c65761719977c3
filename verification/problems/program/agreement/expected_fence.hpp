#pragma once

#include <string>

#include "verification/problems/program/agreement/expected_files.hpp"

/// What the files of a fence must contain beyond those of every run.
namespace talus::verification::problems::agreeing_files {

/// The verdict in summary.json, in the scene's units.
[[nodiscard]] Json expected_verdict(const Run& run);
/// sheet.json in SI, with `metre` of them in a unit of length. Its quality and events are those of summary.json.
/// `found` decides between rows whose forces or heights are equal to within rounding errors.
[[nodiscard]] Json expected_sheet(const Run& run, const Json& found, double metre);
/// NAME.history.json: numbers from the scene and history.csv, titles of the manual of 1993; `csv` is the text of the
/// CSV file, whose comments say what is skipped.
[[nodiscard]] Json expected_codes(const Run& run, const std::string& csv);

}  // namespace talus::verification::problems::agreeing_files
