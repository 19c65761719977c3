#include "verification/study/scenes/fence_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <string_view>

#include "solver/io/fence1993/read_deck.hpp"
#include "verification/check/case_file.hpp"
#include "verification/record/csv.hpp"
#include "verification/record/error.hpp"

namespace talus::verification::problems {
namespace {

constexpr double yield_top = 2e5;     // [lb]
constexpr double yield_bottom = 1e5;  // [lb]

/// A printed number such as "3.87", in units of `unit`, and half a unit of its last digit.
PrintedNumber printed(const records::Csv& csv, std::size_t row, const char* name, double unit) {
  const std::size_t column = csv.column(name);
  const std::string_view text = csv.cell(row, column);
  const std::size_t point = text.find('.');
  const auto decimals = point == std::string_view::npos ? 0.0 : static_cast<double>(text.size() - point - 1);
  return {csv.number(row, column) * unit, 0.5 * std::pow(10.0, -decimals) * unit};
}

PrintedRow row_of(const records::Csv& csv, std::size_t row) {
  const auto cell = [&](const char* column) { return csv.cell(row, column); };
  const auto demand = [&](bool holds, const char* column, const char* allowed) {
    if (!holds)
      throw records::RecordError{fmt::format("{}: line {}: {}: found '{}', allowed: {}", csv.file().string(),
                                             csv.line(row), column, cell(column), allowed)};
  };
  const bool bottom_cable = cell("slack_ft") != "none";
  demand(cell("cable") == "elastic" || cell("cable") == "elastic_plastic", "cable", "elastic or elastic_plastic");
  demand(bottom_cable || cell("bottom_1e5_lb").empty(), "bottom_1e5_lb", "nothing, as there is no bottom cable");
  PrintedRow made{.table = static_cast<int>(csv.number(row, "table")),
                  .rock = csv.number(row, "rock_lb"),
                  .slack = bottom_cable ? csv.number(row, "slack_ft") : 0.0,
                  .height = csv.number(row, "yc_ft"),
                  .bottom_cable = bottom_cable,
                  .plastic = cell("cable") == "elastic_plastic",
                  .joint = printed(csv, row, "joint_1e4_lb", 1e4),
                  .top = printed(csv, row, "top_1e5_lb", 1e5),
                  .bottom = {},
                  .speed = printed(csv, row, "vx_ft_s", 1.0)};
  if (bottom_cable) made.bottom = printed(csv, row, "bottom_1e5_lb", 1e5);
  return made;
}

}  // namespace

std::vector<PrintedRow> printed_rows() {
  const std::filesystem::path file = case_file("published/fence_tables_2_3.csv");
  const records::Csv csv = records::read_csv(file);
  std::vector<PrintedRow> rows;
  for (std::size_t row = 0; row < csv.rows(); ++row)
    rows.push_back(row_of(csv, row));
  return rows;
}

std::string name_of(const PrintedRow& row) {
  return fmt::format("T{} {} {:+.1f} {}", row.table, row.bottom_cable ? "slack 0.5" : "no bottom", row.height,
                     row.plastic ? "plastic" : "elastic");
}

scenes::Fence published_fence(const std::string& name) { return read_deck(case_file("fence") / name); }

scenes::Fence fence_of(const PrintedRow& row) {
  scenes::Fence fence = published_fence(row.table == 2 ? "table_2.DAT" : "table_3.DAT");
  fence.rocks.front().position.y = fence.column.position.y + row.height;
  if (!row.bottom_cable) fence.connections = 1;
  if (row.plastic) fence.limit_top = yield_top, fence.limit_bottom = yield_bottom;
  return fence;
}

}  // namespace talus::verification::problems
