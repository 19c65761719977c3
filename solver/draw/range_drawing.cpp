#include "solver/draw/range_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "solver/draw/frame_style.hpp"

namespace talus::app {
namespace {

/// Largest over smallest value from which an axis is logarithmic.
constexpr double wide = 10.0;

bool differs(const QuantityColumn& column) {
  const auto [smallest, largest] = std::ranges::minmax(column.values);
  return smallest < largest;
}

std::string label_of(const QuantityColumn& column) {
  std::string label = column.name;
  std::ranges::replace(label, '_', ' ');
  return label;
}

DrawingRequest request_of(reports::Page page, const PictureOptions& picture) {
  page.columns = page.panels.size() > 1 ? 2 : 1;
  DrawingRequest request{.pictures = {}, .target = picture.folder, .formats = picture.formats};
  request.pictures.pages.push_back(std::move(page));
  return request;
}

records::Figure panel(const DrawnRange& range, const QuantityColumn& abscissa, const UnitSystem& units) {
  const auto [smallest, largest] = std::ranges::minmax(abscissa.values);
  records::Figure figure{
      .name = abscissa.name,
      .title = "",
      .caption = "",
      .x = {.label = label_of(abscissa), .unit = symbol(units, abscissa.dimension), .log = largest > wide * smallest},
      .y = {.label = "restitution"}};
  records::Series& points = figure.series.emplace_back(frame_series("", records::Style::points, {}));
  for (std::size_t i = 0; i < range.restitutions.size(); ++i)
    points.add(abscissa.values[i] / si_size(units, abscissa.dimension), range.restitutions[i]);
  figure.lines.push_back({.at = range.wanted, .label = fmt::format("wanted: {:.4g}", range.wanted)});
  for (const double deviation : {-range.largest_deviation, range.largest_deviation})
    figure.lines.push_back({.at = range.wanted + deviation, .label = fmt::format("{:+.3g}", deviation)});
  return figure;
}

}  // namespace

DrawingRequest range_drawing(const DrawnRange& range, const std::string& title, const UnitSystem& units,
                             const PictureOptions& picture) {
  reports::Page page{.name = "calibration", .title = title, .columns = 1, .panels = {}};
  for (const QuantityColumn& abscissa : range.abscissae)
    if (differs(abscissa)) page.panels.push_back(panel(range, abscissa, units));
  // A single pair, or equal ones, are drawn against the last abscissa.
  if (page.panels.empty()) page.panels.push_back(panel(range, range.abscissae.back(), units));
  return request_of(std::move(page), picture);
}

DrawingRequest results_drawing(const QuantityColumn& abscissa, std::span<const QuantityColumn> results,
                               std::optional<double> wanted, const std::string& title, const UnitSystem& units,
                               const PictureOptions& picture) {
  reports::Page page{.name = "calibration", .title = title, .columns = 1, .panels = {}};
  const ColumnUnit x = column_unit(abscissa.dimension, units);
  for (const QuantityColumn& result : results) {
    const ColumnUnit y = column_unit(result.dimension, units);
    const bool is_number = result.dimension == dimension::number;
    records::Figure& figure =
        page.panels.emplace_back(records::Figure{.name = result.name,
                                                 .title = "",
                                                 .caption = "",
                                                 .x = {.label = label_of(abscissa), .unit = x.symbol},
                                                 .y = {.label = label_of(result), .unit = is_number ? "" : y.symbol}});
    records::Series& points = figure.series.emplace_back(frame_series("", records::Style::points, {}));
    for (std::size_t i = 0; i < result.values.size(); ++i)
      points.add(abscissa.values[i] / x.size, result.values[i] / y.size);
    if (wanted && page.panels.size() == 1)
      figure.lines.push_back({.at = *wanted, .label = fmt::format("wanted: {:.4g}", *wanted)});
  }
  return request_of(std::move(page), picture);
}

}  // namespace talus::app
