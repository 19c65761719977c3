#pragma once

#include <string>
#include <vector>

namespace talus::verification {

/// A table of data in tidy form, a row for each measurement: kept as NAME.csv beside the record.
struct DataFile {
  std::string name;  ///< File stem, letters, digits and '_'; unlike the names of the case's figures.
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;  ///< Each as long as `columns`; no cell holds a comma.
};

/// std::invalid_argument, naming the file, if a name is missing, a row has another length than `columns` or a cell
/// holds a comma or the end of a line.
void demand_well_formed(const DataFile& file);

/// Its text: the columns' names, then a line for each row.
[[nodiscard]] std::string csv_of(const DataFile& file);

/// The data file of that text. std::invalid_argument as above.
[[nodiscard]] DataFile data_file(const std::string& name, const std::string& csv);

}  // namespace talus::verification
