#include "verification/check/figure_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

namespace talus::verification {

namespace {

std::string key_of(const std::string& label) {
  std::string key;
  for (const char letter : label) {
    const auto c = static_cast<unsigned char>(letter);
    if (std::isalnum(c) != 0) {
      key += static_cast<char>(std::tolower(c));
    } else if (!key.empty() && key.back() != '_') {
      key += '_';
    }
  }
  while (!key.empty() && key.back() == '_')
    key.pop_back();
  return key.empty() ? "series" : key;
}

bool has_bars(const Figure& figure) {
  return std::any_of(figure.series.begin(), figure.series.end(), [](const Series& s) { return !s.y_low.empty(); });
}

bool has_values(const Figure& figure) {
  return std::any_of(figure.series.begin(), figure.series.end(), [](const Series& s) { return !s.values.empty(); });
}

std::vector<std::string> cells_of(const std::string& row) {
  std::vector<std::string> cells;
  std::stringstream stream(row);
  for (std::string cell; std::getline(stream, cell, ',');)
    cells.push_back(cell);
  return cells;
}

double number(const std::string& cell, std::size_t line) {
  char* end = nullptr;
  const double value = std::strtod(cell.c_str(), &end);
  if (cell.empty() || *end != '\0' || !std::isfinite(value)) {
    throw std::invalid_argument(fmt::format("line {}: '{}' is not a finite number", line, cell));
  }
  return value;
}

void add_row(const std::vector<std::string>& cells, std::size_t line, bool bars, bool values, Series& series) {
  series.x.push_back(number(cells[1], line));
  series.y.push_back(number(cells[2], line));
  if (bars) {
    series.y_low.push_back(number(cells[3], line));
    series.y_high.push_back(number(cells[4], line));
  }
  if (values) series.values.push_back(number(cells.back(), line));
}

}  // namespace

std::vector<std::string> series_keys(const Figure& figure) {
  std::vector<std::string> keys;
  for (const auto& series : figure.series) {
    const std::string stem = key_of(series.label);
    std::string key = stem;
    for (int i = 2; std::find(keys.begin(), keys.end(), key) != keys.end(); ++i)
      key = fmt::format("{}_{}", stem, i);
    keys.push_back(key);
  }
  return keys;
}

std::string csv_of(const Figure& figure) {
  const bool bars = has_bars(figure);
  const bool values = has_values(figure);
  const auto keys = series_keys(figure);
  std::string text = fmt::format("series,x,y{}{}\n", bars ? ",y_low,y_high" : "", values ? ",value" : "");
  for (std::size_t s = 0; s < keys.size(); ++s) {
    const Series& series = figure.series[s];
    for (std::size_t i = 0; i < series.x.size(); ++i) {
      text += fmt::format("{},{:.17g},{:.17g}", keys[s], series.x[i], series.y[i]);
      if (bars) {
        const bool own = !series.y_low.empty();
        text +=
            fmt::format(",{:.17g},{:.17g}", own ? series.y_low[i] : series.y[i], own ? series.y_high[i] : series.y[i]);
      }
      if (values) text += fmt::format(",{:.17g}", series.values.empty() ? 0.0 : series.values[i]);
      text += '\n';
    }
  }
  return text;
}

void read_points(const std::string& csv, const std::vector<std::string>& keys, Figure& figure) {
  if (csv.empty() || csv.back() != '\n') throw std::invalid_argument("empty, or truncated in the last line");
  std::stringstream stream(csv);
  std::string row;
  std::getline(stream, row);
  const bool values = row.ends_with(",value");
  const std::string others = values ? row.substr(0, row.size() - 6) : row;
  const bool bars = others == "series,x,y,y_low,y_high";
  if (!bars && others != "series,x,y") throw std::invalid_argument("line 1: unknown columns '" + row + "'");
  for (std::size_t line = 2; std::getline(stream, row); ++line) {
    const auto cells = cells_of(row);
    if (cells.size() != (bars ? 5u : 3u) + (values ? 1u : 0u))
      throw std::invalid_argument(fmt::format("line {}: not all columns", line));
    const auto key = std::find(keys.begin(), keys.end(), cells[0]);
    if (key == keys.end()) throw std::invalid_argument(fmt::format("line {}: unknown series '{}'", line, cells[0]));
    add_row(cells, line, bars, values, figure.series.at(static_cast<std::size_t>(key - keys.begin())));
  }
  for (const auto& series : figure.series) {
    if (series.x.empty()) throw std::invalid_argument("series '" + series.label + "' has no row");
  }
}

}  // namespace talus::verification
