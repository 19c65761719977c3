#include "reports/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>

#include "reports/error.hpp"

namespace talus::reports {
namespace {

/// Cells of one line; a cell in double quotes may hold commas.
std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (const char letter : line) {
    if (letter == '"') {
      quoted = !quoted;
    } else if (letter == ',' && !quoted) {
      cells.emplace_back();
    } else if (letter != '\r') {
      cells.back() += letter;
    }
  }
  return cells;
}

}  // namespace

std::size_t Csv::column(const std::string& name) const {
  const auto place = std::find(header.begin(), header.end(), name);
  if (place == header.end()) {
    throw RecordError(
        fmt::format("{}: has no column '{}'; its columns: {}", file.string(), name, fmt::join(header, ", ")));
  }
  return static_cast<std::size_t>(place - header.begin());
}

double Csv::number(std::size_t row, std::size_t column) const {
  const std::string& text = rows[row][column];
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !std::isfinite(value)) {
    throw RecordError(fmt::format("{}:{}: column '{}' holds '{}', not a finite number", file.string(), row + 2,
                                  header[column], text));
  }
  return value;
}

Csv read_csv(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) throw RecordError(file.string() + ": the file is missing");
  Csv csv{file, {}, {}};
  std::string line;
  if (!std::getline(stream, line) || line.empty()) throw RecordError(file.string() + ": the file is empty");
  csv.header = cells_of(line);
  while (std::getline(stream, line)) {
    if (line.empty()) continue;
    csv.rows.push_back(cells_of(line));
    if (csv.rows.back().size() != csv.header.size()) {
      throw RecordError(fmt::format("{}:{}: has {} cells, the header {}", file.string(), csv.rows.size() + 1,
                                    csv.rows.back().size(), csv.header.size()));
    }
  }
  return csv;
}

}  // namespace talus::reports
