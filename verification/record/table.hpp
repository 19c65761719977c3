#pragma once

#include <string>
#include <vector>

#include "verification/record/csv.hpp"

namespace talus::records {

/// A table of the report; cells are the text to print.
struct Table {
  std::string name;     ///< Unique in its case.
  std::string caption;  ///< What the rows show; Markdown.
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows{};  ///< Each as long as `columns`.
};

/// A table of data in tidy form, one row per measurement, stored as NAME.csv beside the record.
struct DataFile {
  std::string name;  ///< File stem, letters, digits and '_'; different from the names of the case's figures.
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;  ///< Each as long as `columns`.
};

/// The CSV text of a data file.
[[nodiscard]] std::string csv_of(const DataFile& file);

/// The data file with that name and content.
[[nodiscard]] DataFile data_file(const std::string& name, const Csv& csv);

}  // namespace talus::records
