#include "verification/problems/fence/fence_choice_findings.hpp"

#include <fmt/format.h>

#include <array>
#include <cstddef>

namespace talus::verification::problems {
namespace {

using scenes::Fence;

struct Choice {
  const char* name;
  void (*make)(Fence&);
};

constexpr std::array choices{
    Choice{"omega0 = 0 instead of 34 rad/s", [](Fence& f) { f.rocks.front().spin = 0.0; }},
    Choice{"omega0 = -34 rad/s", [](Fence& f) { f.rocks.front().spin *= -1.0; }},
    Choice{"overlap .05 ft instead of .06", [](Fence& f) { f.rock_overlap = 0.05; }},
    Choice{"overlap .08 ft", [](Fence& f) { f.rock_overlap = 0.08; }},
    Choice{"overlap .12 ft", [](Fence& f) { f.rock_overlap = 0.12; }},
    Choice{"8 nodes instead of 12", [](Fence& f) { f.rocks.front().points = 3; }},
    Choice{"16 nodes", [](Fence& f) { f.rocks.front().points = 5; }},
    Choice{"one resultant per pair", [](Fence& f) { f.options.contact = scenes::FenceContact::resultant; }},
    Choice{"clamped contacts", [](Fence& f) { f.options.end_rule = EndRule::clamped; }},
    Choice{"no half kick at the start", [](Fence& f) { f.options.start = scenes::FenceStart::plain; }},
    Choice{"attachment 2.67 ft (sample2) instead of 2.5", [](Fence& f) { f.y_top = 6.67; }},
    Choice{"column mass 16.4 slug instead of 14.9", [](Fence& f) { f.column.density *= 1.1; }},
    Choice{"column mass 29.8 slug (sample2)", [](Fence& f) { f.column.density *= 2.0; }},
    Choice{"bottom cable wrapped once", [](Fence& f) { f.area_bottom *= 0.5; }}};

/// Seven mean distances of rows that need no twins.
std::vector<std::string> cells_of(const char* name, const std::vector<RowRun>& rows) {
  std::vector<std::string> cells{name};
  for (const bool bottom_cable : {false, true}) {
    for (const FenceQuantity& quantity : fence_quantities()) {
      const FenceDistance d = distance_of(rows, quantity, bottom_cable);
      if (d.count > 0) cells.push_back(fmt::format("{:.1f}", d.mean));
    }
  }
  return cells;
}

std::vector<RowRun> run_with(const Choice& choice) {
  std::vector<RowRun> rows;
  for (const PrintedRow& printed : printed_rows()) {
    Fence fence = fence_of(printed);
    choice.make(fence);
    rows.push_back({printed, run_fence(fence), {}});
  }
  return rows;
}

void check_bottom_end(Findings& findings, const RowRun& row) {
  Fence fence = fence_of(row.printed);
  fence.options.bottom_end = scenes::BottomEnd::anchored;
  const FenceRun anchored = run_fence(fence);
  findings.expect(fmt::format("bottom cable anchored instead of free, joint force, {}", name_of(row.printed)),
                  anchored.peaks.joint, row.run.peaks.joint,
                  Tolerance::exact("the outermost column would have to move 3.6 ft before a last segment of 12.5 ft "
                                   "with .5 ft slack were taut: it stays slack, and the bits the same"),
                  "lb");
}

}  // namespace

void check_choices(Findings& findings, const std::vector<RowRun>& rows, const Setup& setup) {
  for (const RowRun& row : rows) {
    const bool quick = row.printed.table == 3 && row.printed.height == 0.0 && !row.printed.plastic;
    if (row.printed.bottom_cable && (quick || setup.tier == Tier::full)) check_bottom_end(findings, row);
  }
  if (setup.tier != Tier::full) return;
  Table table{.name = "choices",
              .caption =
                  "What each choice moves: mean distance to the print, forces in %, velocity in ft/s. n: the 14 "
                  "rows without bottom cable; b: the 20 rows with it.",
              .columns = {"choice", "n: joint", "top", "velocity", "b: joint", "top", "bottom", "velocity"},
              .rows = {cells_of("as taken", rows)}};
  for (const Choice& choice : choices)
    table.rows.push_back(cells_of(choice.name, run_with(choice)));
  findings.table(table);
}

}  // namespace talus::verification::problems
