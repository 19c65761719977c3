#include "verification/problems/fence/fence_table_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace talus::verification::problems {
namespace {

constexpr long history_every = 100;  // steps: 2e-4 s

Figure printed_against_ours(const std::vector<RowRun>& rows, const FenceQuantity& quantity, const std::string& name) {
  Series line{.label = "equal", .style = Style::lines};
  std::array<Series, 2> groups{Series{.label = "no bottom cable", .style = Style::errorbars},
                               Series{.label = "with bottom cable", .style = Style::errorbars}};
  for (const RowRun& row : rows) {
    const auto print = quantity.printed(row.printed);
    if (!print) continue;
    Series& group = groups[row.printed.bottom_cable ? 1 : 0];
    group.add(print->value, row.run.peaks.*quantity.ours);
    group.y_low.push_back(row.low(quantity));
    group.y_high.push_back(row.high(quantity));
    line.x.push_back(print->value);
  }
  std::sort(line.x.begin(), line.x.end());
  line.y = line.x;
  Figure figure{.name = name,
                .title = fmt::format("Printed and computed {}", quantity.name),
                .caption = fmt::format("The {} of Tables 2 and 3: printed (across) and computed (up). Whiskers: least "
                                       "and largest of the run and its twins, where these were run.",
                                       quantity.name),
                .x = {.label = "printed", .unit = quantity.unit},
                .y = {.label = "computed", .unit = quantity.unit},
                .series = {line}};
  for (Series& group : groups) {
    if (!group.x.empty()) figure.series.push_back(std::move(group));
  }
  return figure;
}

struct HistoryPlot {
  const char* name;
  const char* label;
  const char* unit;
  double FenceSample::*value;
};

}  // namespace

void draw_tables(Findings& findings, const std::vector<RowRun>& rows) {
  static constexpr std::array names{"joint_force", "top_cable_force", "bottom_cable_force", "exit_velocity"};
  for (std::size_t q = 0; q < names.size(); ++q)
    findings.figure(printed_against_ours(rows, fence_quantities()[q], names[q]));
}

void draw_histories(Findings& findings) {
  static constexpr std::array plots{
      HistoryPlot{"joint", "force in the top joint", "lb", &FenceSample::joint},
      HistoryPlot{"top", "top cable force", "lb", &FenceSample::top},
      HistoryPlot{"bottom", "bottom cable force", "lb", &FenceSample::bottom},
      HistoryPlot{"velocity", "x velocity of the rock", "ft/s", &FenceSample::speed},
      HistoryPlot{"plastic_stretch", "plastic stretch of the top cable's segment", "ft", &FenceSample::stretch}};
  for (const int table : {2, 3}) {
    std::array<FenceRun, 2> runs;
    for (const PrintedRow& row : printed_rows()) {
      if (row.table == table && row.height == 0.0 && row.bottom_cable)
        runs[row.plastic ? 1 : 0] = run_fence(fence_of(row), history_every);
    }
    for (const HistoryPlot& plot : plots) {
      Figure figure{.name = fmt::format("fig_{}_{}", 12 + table, plot.name),
                    .title = fmt::format("Fig. {}: {}", 12 + table, plot.label),
                    .caption = fmt::format("{} lb rock, yc = 0, bottom cable with .5 ft slack, beside the central "
                                           "column: the {}, for Fig. {} of the report.",
                                           600 * (table - 1), plot.label, 12 + table),
                    .x = {.label = "time", .unit = "s"},
                    .y = {.label = plot.label, .unit = plot.unit},
                    .series = {{"elastic", {}, {}, Style::lines}, {"elastic-plastic", {}, {}, Style::lines}}};
      for (std::size_t r = 0; r < runs.size(); ++r) {
        for (const FenceSample& sample : runs[r].history)
          figure.series[r].add(sample.time, sample.*plot.value);
      }
      findings.figure(std::move(figure));
    }
  }
}

}  // namespace talus::verification::problems
