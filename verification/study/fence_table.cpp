#include "verification/study/fence_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "solver/io/fence1993/read_deck.hpp"

namespace talus::verification::problems {
namespace {

constexpr double yield_top = 2e5;     // [lb]
constexpr double yield_bottom = 1e5;  // [lb]

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream in{line + ","};
  for (std::string cell; std::getline(in, cell, ',');)
    cells.push_back(cell);
  return cells;
}

/// Value and last digit of a text such as "3.87", in units of `unit`.
PrintedNumber number(const std::string& text, double unit) {
  const std::size_t point = text.find('.');
  const auto decimals = point == std::string::npos ? 0.0 : static_cast<double>(text.size() - point - 1);
  return {std::stod(text) * unit, 0.5 * std::pow(10.0, -decimals) * unit};
}

PrintedRow row_of(const std::vector<std::string>& cells) {
  if (cells.size() != 9) throw std::invalid_argument{fmt::format("{} cells, 9 belong there", cells.size())};
  PrintedRow row{.table = std::stoi(cells[0]),
                 .height = std::stod(cells[3]),
                 .bottom_cable = cells[2] != "none",
                 .plastic = cells[4] == "elastic_plastic",
                 .joint = number(cells[5], 1e4),
                 .top = number(cells[6], 1e5),
                 .bottom = {},
                 .speed = number(cells[8], 1.0)};
  if (!cells[7].empty()) row.bottom = number(cells[7], 1e5);
  return row;
}

}  // namespace

std::vector<PrintedRow> printed_rows() {
  const std::filesystem::path file = std::filesystem::path{TALUS_CASES} / "published" / "fence_tables_2_3.csv";
  std::ifstream in{file};
  if (!in) throw std::runtime_error{file.string() + ": cannot be read"};
  std::vector<PrintedRow> rows;
  bool heading = true;
  int line_number = 0;
  for (std::string line; std::getline(in, line);) {
    ++line_number;
    if (line.empty() || line.front() == '#') continue;
    if (std::exchange(heading, false)) continue;
    try {
      rows.push_back(row_of(cells_of(line)));
    } catch (const std::logic_error& fault) {
      throw std::runtime_error{fmt::format("{}:{}: {}", file.string(), line_number, fault.what())};
    }
  }
  return rows;
}

std::string name_of(const PrintedRow& row) {
  return fmt::format("T{} {} {:+.1f} {}", row.table, row.bottom_cable ? "slack .5" : "no bottom", row.height,
                     row.plastic ? "plastic" : "elastic");
}

scenes::Fence published_fence(const std::string& name) {
  return read_deck(std::filesystem::path{TALUS_CASES} / "fence" / name);
}

scenes::Fence fence_of(const PrintedRow& row) {
  scenes::Fence fence = published_fence(row.table == 2 ? "table_2.DAT" : "table_3.DAT");
  fence.rocks.front().position.y = fence.column.position.y + row.height;
  if (!row.bottom_cable) fence.connections = 1;
  if (row.plastic) fence.limit_top = yield_top, fence.limit_bottom = yield_bottom;
  return fence;
}

}  // namespace talus::verification::problems
