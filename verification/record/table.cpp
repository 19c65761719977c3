#include "verification/record/table.hpp"

#include <utility>

namespace talus::records {

std::string csv_of(const DataFile& file) {
  CsvText text{file.columns};
  for (const auto& row : file.rows) {
    for (const std::string& cell : row)
      text.cell(cell);
    text.end_row();
  }
  return std::move(text).text();
}

DataFile data_file(const std::string& name, const Csv& csv) {
  DataFile file{name, csv.header(), {}};
  for (std::size_t row = 0; row < csv.rows(); ++row) {
    std::vector<std::string>& cells = file.rows.emplace_back();
    for (std::size_t column = 0; column < csv.header().size(); ++column)
      cells.emplace_back(csv.cell(row, column));
  }
  return file;
}

}  // namespace talus::records
