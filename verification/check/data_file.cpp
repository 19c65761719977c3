#include "verification/check/data_file.hpp"

#include <fmt/format.h>

#include <sstream>
#include <stdexcept>

namespace talus::verification {
namespace {

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream in{line + ","};
  for (std::string cell; std::getline(in, cell, ',');)
    cells.push_back(cell);
  return cells;
}

void demand_row(const DataFile& file, const std::vector<std::string>& row) {
  if (row.size() != file.columns.size()) {
    throw std::invalid_argument(
        fmt::format("data file '{}': a row of {}, {} columns", file.name, row.size(), file.columns.size()));
  }
  for (const std::string& cell : row) {
    if (cell.find_first_of(",\n\r") != std::string::npos)
      throw std::invalid_argument(fmt::format("data file '{}': the cell '{}' cannot stand in it", file.name, cell));
  }
}

}  // namespace

void demand_well_formed(const DataFile& file) {
  if (file.name.empty() || file.columns.empty()) {
    throw std::invalid_argument(
        fmt::format("data file '{}': it has no {}", file.name, file.name.empty() ? "name" : "columns"));
  }
  demand_row(file, file.columns);
  for (const auto& row : file.rows)
    demand_row(file, row);
}

std::string csv_of(const DataFile& file) {
  std::string text = fmt::format("{}\n", fmt::join(file.columns, ","));
  for (const auto& row : file.rows)
    text += fmt::format("{}\n", fmt::join(row, ","));
  return text;
}

DataFile data_file(const std::string& name, const std::string& csv) {
  DataFile file{name, {}, {}};
  std::istringstream in{csv};
  for (std::string line; std::getline(in, line);) {
    if (file.columns.empty()) {
      file.columns = cells_of(line);
    } else {
      file.rows.push_back(cells_of(line));
    }
  }
  demand_well_formed(file);
  return file;
}

}  // namespace talus::verification
