#include "verification/problems/speed_accuracy/work_charts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <utility>

#include "verification/study/findings/rows.hpp"

namespace talus::verification::problems {
namespace {

std::string exact_text(double number) { return fmt::format("{:.17g}", number); }

/// Columns of the data, in their order.
enum Column : std::size_t { scene, quantity, method, setting, runs, rms, max, evaluations, failed, limit, floor };
const std::vector<std::string> columns{"scene",     "quantity",    "method", "setting",           "runs", "error_rms",
                                       "error_max", "evaluations", "failed", "limit_evaluations", "floor"};

std::string plain(std::string text) {
  text.erase(std::remove(text.begin(), text.end(), ','), text.end());
  return text;
}

/// Name of a figure: letters and digits of its title, all other characters as '_'.
std::string stem_of(const std::string& text) {
  std::string stem = "work";
  for (const char letter : " " + text) {
    const bool kept = std::isalnum(static_cast<unsigned char>(letter)) != 0;
    if (kept) {
      stem += letter;
    } else if (stem.back() != '_') {
      stem += '_';
    }
  }
  return stem;
}

std::string capitalised(std::string title) {
  title.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(title.front())));
  return title;
}

constexpr double top = 1.0;  ///< upper end of the charts: larger errors are failures

/// All curves of one chart, in the order of the data.
struct Chart {
  std::vector<Series> series;
  std::vector<int> failed;  ///< number of points of each that are drawn as crosses
  Series crosses{.label = "failed", .style = Style::crosses};
  double limit{}, floor{};
};

void add_row(const std::vector<std::string>& row, Chart& chart) {
  if (chart.series.empty() || chart.series.back().label != row[method]) {
    chart.series.push_back({.label = row[method]});
    chart.failed.push_back(0);
  }
  const double x = std::stod(row[evaluations]);
  if (row[failed] != "0" || !(std::stod(row[rms]) <= top)) {
    ++chart.failed.back();
    chart.crosses.add(x, top);
  } else {
    chart.series.back().x.push_back(x);
    chart.series.back().y.push_back(std::stod(row[rms]));
  }
  chart.limit = std::stod(row[limit]);
  chart.floor = std::stod(row[floor]);
}

/// The number at the `fraction` of the distance from `low` to `high` on a logarithmic scale.
double between(double low, double high, double fraction) { return low * std::pow(high / low, fraction); }

/// Reference lines of orders 1, 2 and 4, in the empty corner of small cost and small error.
std::vector<records::Slope> slopes_in(const Chart& chart) {
  double first = std::numeric_limits<double>::infinity(), last = 0.0, minimum = top;
  for (const Series& series : chart.series) {
    for (std::size_t i = 0; i < series.x.size(); ++i) {
      first = std::min(first, series.x[i]);
      last = std::max(last, series.x[i]);
      minimum = std::min(minimum, series.y[i]);
    }
  }
  std::vector<records::Slope> slopes;
  for (const auto& [order, fraction] : {std::pair{1.0, 0.55}, {2.0, 0.4}, {4.0, 0.25}})
    slopes.push_back(
        {-order, between(first, last, 0.05), between(minimum, top, fraction), fmt::format("order {:g}", order)});
  return slopes;
}

Figure figure_of(const std::string& title, const Chart& chart) {
  Figure figure{.name = stem_of(title),
                .title = capitalised(title),
                .caption =
                    "Relative error against force evaluations. Vertical line: $\\omega h = 2$, the limit of the "
                    "leapfrog methods; crosses at the top: points at which a run failed or had an error above 100 %, "
                    "their number in brackets. Dashed: orders 1, 2 and 4.",
                .x = {.label = "force evaluations", .unit = "1", .log = true},
                .y = {.label = "error", .unit = "1", .log = true, .min = {}, .max = top},
                .series = {},
                .slopes = slopes_in(chart),
                .lines = {{'x', chart.limit, "limit"}}};
  double minimum = top;
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    Series series = chart.series[i];
    if (chart.failed[i] > 0) series.label += fmt::format(" ({})", chart.failed[i]);
    if (series.x.empty()) {  // keeps the method in the legend, with its colour in all charts
      series.add(chart.crosses.x.front(), top);
    }
    minimum = std::min(minimum, *std::min_element(series.y.begin(), series.y.end()));
    figure.series.push_back(series);
  }
  if (!chart.crosses.x.empty()) figure.series.push_back(chart.crosses);
  if (minimum < 1e3 * chart.floor) figure.lines.push_back({'y', chart.floor, "resolution of the reference"});
  return figure;
}

std::string scene_and_quantity(const SceneCurves& all, std::size_t q) {
  return all.scene->quantities.size() == 1 ? all.scene->name : all.scene->name + ": " + all.scene->quantities[q];
}

}  // namespace

DataFile work_data(const std::vector<SceneCurves>& all) {
  DataFile data{"work_and_precision", columns, {}};
  for (const SceneCurves& each : all) {
    for (std::size_t q = 0; q < each.scene->quantities.size(); ++q) {
      for (const WorkCurve& curve : each.curves) {
        for (const CurvePoint& point : curve.points) {
          data.rows.push_back(cells("{} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {}", plain(each.scene->name),
                                    plain(each.scene->quantities[q]), curve.method, exact_text(point.setting),
                                    each.scene->runs, exact_text(point.rms[q]), exact_text(point.max[q]),
                                    exact_text(point.evaluations), point.failed,
                                    exact_text(each.scene->evaluations_at_limit()), exact_text(each.scene->floor)));
        }
      }
    }
  }
  return data;
}

std::vector<Figure> work_figures(const DataFile& data) {
  std::vector<Figure> figures;
  std::string title;
  Chart chart;
  const auto close = [&] {
    if (!title.empty()) figures.push_back(figure_of(title, chart));
    chart = {};
  };
  for (const auto& row : data.rows) {
    const std::string own = row[scene] + ": " + row[quantity];
    if (own != title) {
      close();
      title = own;
    }
    add_row(row, chart);
  }
  close();
  return figures;
}

std::string evaluations_text(double evaluations) {
  return std::isfinite(evaluations) ? fmt::format("{:.0f}", evaluations) : "-";
}

std::vector<Table> cost_tables(const std::vector<SceneCurves>& all) {
  std::vector<Table> tables;
  for (const double error : read_off_errors) {
    Table table{.name = fmt::format("cost_{:.0e}", error),
                .caption = fmt::format("Force evaluations for an error of {:.0e}; -: not reached.", error),
                .columns = {"method"}};
    for (const char* const name : work_methods)
      table.rows.push_back({name});
    for (const SceneCurves& each : all) {
      for (std::size_t q = 0; q < each.scene->quantities.size(); ++q) {
        table.columns.push_back(scene_and_quantity(each, q));
        for (std::size_t m = 0; m < each.curves.size(); ++m)
          table.rows[m].push_back(evaluations_text(cost_of(each.curves[m], q, error)));
      }
    }
    tables.push_back(table);
  }
  return tables;
}

Cheapest cheapest(const SceneCurves& curves, std::size_t q, double error) {
  Cheapest found{"", std::numeric_limits<double>::infinity()};
  for (const WorkCurve& curve : curves.curves) {
    const double cost = cost_of(curve, q, error);
    if (cost < found.evaluations) found = {curve.method, cost};
  }
  return found;
}

Table cheapest_table(const std::vector<SceneCurves>& all) {
  Table table{.name = "cheapest",
              .caption = "The method that reaches an error with the fewest force evaluations, and their number.",
              .columns = {"scene", "1e-2", "1e-4", "1e-6", "1e-9"}};
  for (const SceneCurves& each : all) {
    for (std::size_t q = 0; q < each.scene->quantities.size(); ++q) {
      std::vector<std::string> row{scene_and_quantity(each, q)};
      for (const double error : read_off_errors) {
        const Cheapest best = cheapest(each, q, error);
        row.push_back(best.method.empty() ? "-" : fmt::format("{} {:.0f}", best.method, best.evaluations));
      }
      table.rows.push_back(row);
    }
  }
  return table;
}

}  // namespace talus::verification::problems
