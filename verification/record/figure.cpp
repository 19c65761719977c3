#include "verification/record/figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace talus::records {
namespace {

constexpr int maximum_columns = 12;
constexpr int maximum_divisions = 100;

void demand_sound(const Axis& axis, const std::string& part, const Fail& fail) {
  if (axis.log && ((axis.min && *axis.min <= 0.0) || (axis.max && *axis.max <= 0.0)))
    fail(part, "limits of a log axis must be > 0");
  if (axis.divisions < 0 || axis.divisions > maximum_divisions) {
    fail(part + ".divisions", fmt::format("must be from 0 to {}, found {}", maximum_divisions, axis.divisions));
  }
}

void demand_colour(const std::string& colour, const std::string& part, const Fail& fail) {
  const bool fine = colour.size() == 7 && colour[0] == '#' &&
                    colour.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
  if (!colour.empty() && !fine) fail(part, fmt::format("must be a colour such as #0072b2, found '{}'", colour));
}

void demand_sound(const Figure& figure, const Series& series, const std::string& part, const Fail& fail) {
  const bool by_value = coloured_by_value(series);
  demand_colour(series.look.colour, part + ".colour", fail);
  demand_colour(series.look.fill, part + ".fill", fail);
  if (has_look(series.style) && series.look.colour.empty() && series.look.fill.empty() && !by_value)
    fail(part, "shapes need a colour, a fill or a value");
  if (series.style == Style::circles && series.look.fill.empty() && !by_value)
    fail(part, "circles need a fill or a value");
  if (series.style == Style::circles && series.radius.empty() && series.columns.radius.empty())
    fail(part + ".radius", "is missing: circles need it");
  const bool bars = (!series.y_low.empty() && !series.y_high.empty()) ||
                    (!series.columns.y_low.empty() && !series.columns.y_high.empty());
  if (series.style == Style::errorbars && !bars) fail(part, "error bars need y_low and y_high");
  if (series.style == Style::heat && !by_value) fail(part, "a heat map needs a value for each point");
  if (series.style == Style::heat && (!figure.scale || figure.panels.empty()))
    fail(part, "a heat map needs panels and a scale");
  const int panels = std::max(1, static_cast<int>(figure.panels.size()));
  if (series.panel < 0 || series.panel >= panels) {
    fail(part + ".panel", fmt::format("must be from 0 to {}, found {}", panels - 1, series.panel));
  }
}

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

}  // namespace

void demand_sound(const Scale& scale, const Fail& fail) {
  if (!(scale.min < scale.max))
    fail("scale", fmt::format("min must be less than max, found {} and {}", scale.min, scale.max));
}

void demand_sound(const Figure& figure, const Fail& fail) {
  demand_sound(figure.x, "x", fail);
  demand_sound(figure.y, "y", fail);
  if (figure.series.empty()) fail("series", "must hold at least one series");
  if (figure.columns < 1 || figure.columns > maximum_columns)
    fail("columns", fmt::format("must be from 1 to {}, found {}", maximum_columns, figure.columns));
  if (figure.scale) demand_sound(*figure.scale, fail);
  for (std::size_t i = 0; i < figure.series.size(); ++i)
    demand_sound(figure, figure.series[i], fmt::format("series[{}]", i), fail);
  for (std::size_t i = 0; i < figure.slopes.size(); ++i) {
    const std::string part = fmt::format("slopes[{}]", i);
    if (!figure.x.log || !figure.y.log) fail(part, "a slope needs both axes to be log");
    if (!(figure.slopes[i].x > 0.0 && figure.slopes[i].y > 0.0)) fail(part, "x and y must be > 0");
  }
  for (std::size_t i = 0; i < figure.lines.size(); ++i) {
    const Line& line = figure.lines[i];
    const std::string part = fmt::format("lines[{}]", i);
    if (line.axis != 'x' && line.axis != 'y') fail(part + ".axis", fmt::format("must be x or y, found {}", line.axis));
    if ((line.axis == 'x' ? figure.x : figure.y).log && line.at <= 0.0)
      fail(part + ".at", fmt::format("must be > 0 on a log axis, found {}", line.at));
  }
  if (figure.equal && (!figure.x.min || !figure.x.max || !figure.y.min || !figure.y.max))
    fail("", "a figure with equal units needs min and max of both axes");
}

void name_columns(Figure& figure) {
  figure.csv = figure.name + ".csv";
  const auto keys = series_keys(figure);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    Series& series = figure.series[i];
    series.columns = {.x = "x", .y = "y", .where = keys[i]};
    if (!series.y_low.empty()) series.columns.y_low = "y_low", series.columns.y_high = "y_high";
    if (!series.values.empty()) series.columns.value = "value";
    if (!series.radius.empty()) series.columns.radius = "radius";
  }
}

}  // namespace talus::records
