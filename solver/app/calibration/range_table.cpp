#include "solver/app/calibration/range_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <utility>

#include "solver/base/error.hpp"
#include "solver/calibrate/impact_range.hpp"
#include "solver/io/file/atomic_file.hpp"
#include "solver/io/file/folder_lock.hpp"
#include "solver/io/file/quantity_text.hpp"

namespace talus::app {
namespace {

namespace fs = std::filesystem;

constexpr int maximum_on_axis = 100;

}  // namespace

std::vector<double> axis_of(const std::string& option, const std::vector<std::string>& texts, Dimension dimension,
                            Spacing spacing) {
  const double first = option_quantity(option, texts[0], dimension, si);
  const double last = option_quantity(option, texts[1], dimension, si);
  if (!(first < last)) {
    throw InputError{
        fmt::format("{}: found \"{}\" and \"{}\"; the first must be less than the second", option, texts[0], texts[1])};
  }
  int count = 0;
  const std::string& text = texts[2];
  const auto read = std::from_chars(text.data(), text.data() + text.size(), count);
  if (read.ec != std::errc{} || read.ptr != text.data() + text.size() || count < 2 || count > maximum_on_axis) {
    throw InputError{
        fmt::format("{}: found \"{}\"; the count must be a whole number from 2 to {}", option, text, maximum_on_axis)};
  }
  if (spacing == Spacing::logarithmic) return log_spaced(first, last, count);
  std::vector<double> numbers;
  for (int i = 0; i < count; ++i)
    numbers.push_back(std::lerp(first, last, static_cast<double>(i) / (count - 1)));
  return numbers;
}

void print_table(const std::vector<QuantityColumn>& table, const UnitSystem& units) {
  std::vector<std::size_t> widths;
  const auto print_row = [&](const auto& text) {
    for (std::size_t i = 0; i < table.size(); ++i)
      fmt::print("{:>{}}", text(table[i]), widths[i]);
    fmt::print("\n");
  };
  for (const QuantityColumn& column : table)
    widths.push_back(std::max<std::size_t>(column.name.size(), 12) + 2);
  print_row([](const QuantityColumn& column) { return column.name; });
  print_row([&](const QuantityColumn& column) { return column_unit(column.dimension, units).symbol; });
  for (std::size_t row = 0; row < table.front().values.size(); ++row) {
    print_row([&](const QuantityColumn& column) {
      return fmt::format("{:.6g}", column.values[row] / column_unit(column.dimension, units).size);
    });
  }
}

nlohmann::ordered_json rows_of(const std::vector<QuantityColumn>& table) {
  auto rows = nlohmann::ordered_json::array();
  for (std::size_t row = 0; row < table.front().values.size(); ++row) {
    nlohmann::ordered_json object;
    for (const QuantityColumn& column : table)
      object[column.name] = column.values[row];
    rows.push_back(std::move(object));
  }
  return rows;
}

void write_table(const std::vector<QuantityColumn>& table, const CalibrateOptions& options, const UnitSystem& units,
                 DrawingRequest drawing, const DrawingSink& sink) {
  const fs::path folder{options.picture.folder};
  make_folder(folder);
  const FolderLock lock{folder};
  write_whole(folder / "calibration.csv", quantity_csv(table, units));
  if (!options.json) fmt::print("{}\n", (folder / "calibration.csv").string());
  drawing.lists_files = !options.json;
  sink(std::move(drawing));
}

}  // namespace talus::app
