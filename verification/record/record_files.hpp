/// The files record.json and results.json.
#pragma once

#include <filesystem>
#include <string>

#include "verification/record/case_record.hpp"
#include "verification/record/error.hpp"
#include "verification/record/results.hpp"

namespace talus::records {

/// The JSON text of a record (schema 1). The columns of its figures must be set; see name_columns().
[[nodiscard]] std::string text_of(const Record& record);

/// Writes `folder/record.json` and one CSV file per figure and data file. The data are written first, so that an
/// existing record is complete. FileError if a file cannot be written.
void write_record(const Record& record, const std::filesystem::path& folder);

/// Reads `folder/record.json` and its CSV files strictly. RecordError if a file is missing, empty or truncated, the
/// schema differs, a field is absent, or a check's verdict does not follow from its numbers.
[[nodiscard]] Record read_record(const std::filesystem::path& folder);

/// The JSON text of results.json (schema 1).
[[nodiscard]] std::string text_of(const Results& results);

/// Reads results.json strictly, but not the CSV files of its figures (see read_points()). FileError if the file cannot
/// be read; RecordError (file and path) if it violates the schema or contradicts itself: a selected case has no record
/// or two, counts and verdict do not follow from the cases, or a check's verdict does not follow from its numbers.
[[nodiscard]] Results read_results(const std::filesystem::path& file);

}  // namespace talus::records
