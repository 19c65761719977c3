#include "verification/record/figure_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "verification/record/error.hpp"

namespace talus::records {
namespace {

/// A column that a series names, and the destination of its numbers.
struct Source {
  std::size_t column = 0;
  std::vector<double>* into = nullptr;
};

/// Digits needed to read the same double back.
constexpr int digits = 17;

std::vector<Source> sources_of(Series& series, const Csv& csv) {
  std::vector<Source> sources;
  const auto add = [&](const std::string& name, std::vector<double>& into) {
    into.clear();
    if (!name.empty()) sources.push_back({csv.column(name), &into});
  };
  add(series.columns.x, series.x);
  add(series.columns.y, series.y);
  add(series.columns.y_low, series.y_low);
  add(series.columns.y_high, series.y_high);
  add(series.columns.value, series.values);
  add(series.columns.radius, series.radius);
  add(series.style == Style::shapes ? "line" : "", series.line);
  return sources;
}

/// The CSV file that a figure names. If it cannot be read, the record is invalid.
Csv csv_beside(const Figure& figure, const std::filesystem::path& folder) {
  try {
    return read_csv(folder / figure.csv);
  } catch (const FileError& fault) {
    throw RecordError(fault.what());
  }
}

}  // namespace

std::string csv_of(const Figure& figure) {
  const auto any = [&](const std::vector<double> Series::*numbers) {
    return std::any_of(figure.series.begin(), figure.series.end(),
                       [&](const Series& series) { return !(series.*numbers).empty(); });
  };
  const bool bars = any(&Series::y_low), values = any(&Series::values);
  std::vector<std::string> columns{"series", "x", "y"};
  if (bars) columns.insert(columns.end(), {"y_low", "y_high"});
  if (values) columns.emplace_back("value");
  CsvText text{columns};
  for (const Series& series : figure.series) {
    const bool own_bars = !series.y_low.empty();
    for (std::size_t i = 0; i < series.x.size(); ++i) {
      text.cell(series.columns.where);
      text.number(series.x[i], digits);
      text.number(series.y[i], digits);
      if (bars) {
        text.number(own_bars ? series.y_low[i] : series.y[i], digits);
        text.number(own_bars ? series.y_high[i] : series.y[i], digits);
      }
      if (values) text.number(series.values.empty() ? 0.0 : series.values[i], digits);
      text.end_row();
    }
  }
  return std::move(text).text();
}

void read_points(Figure& figure, const Csv& csv, Rows rows) {
  std::vector<bool> used(csv.rows(), false);
  for (Series& series : figure.series) {
    const std::vector<Source> sources = sources_of(series, csv);
    const std::string& where = series.columns.where;
    const std::size_t kind = where.empty() ? 0 : csv.column("series");
    for (std::size_t row = 0; row < csv.rows(); ++row) {
      if (!where.empty() && csv.cell(row, kind) != where) continue;
      used[row] = true;
      for (const Source& source : sources)
        source.into->push_back(csv.number(row, source.column));
    }
    if (series.x.empty()) {
      throw RecordError(fmt::format("{}: figure '{}': series '{}' (columns '{}', '{}'{}) has no row",
                                    csv.file().string(), figure.name, series.label, series.columns.x, series.columns.y,
                                    where.empty() ? "" : ", series = '" + where + "'"));
    }
  }
  const auto stray = std::find(used.begin(), used.end(), false);
  if (rows == Rows::all && stray != used.end()) {
    const auto row = static_cast<std::size_t>(stray - used.begin());
    throw RecordError(fmt::format("{}:{}: found a row of '{}', which is no series of figure '{}'", csv.file().string(),
                                  csv.line(row), csv.cell(row, 0), figure.name));
  }
}

void read_points(Figure& figure, const std::filesystem::path& folder, Rows rows) {
  read_points(figure, csv_beside(figure, folder), rows);
}

void read_points(std::vector<Figure>& figures, const std::filesystem::path& folder) {
  std::map<std::string, Csv> files;
  for (Figure& figure : figures) {
    auto file = files.find(figure.csv);
    if (file == files.end()) file = files.emplace(figure.csv, csv_beside(figure, folder)).first;
    read_points(figure, file->second, Rows::some);
  }
}

}  // namespace talus::records
