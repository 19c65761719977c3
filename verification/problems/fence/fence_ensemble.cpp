#include "verification/problems/fence/fence_ensemble.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace talus::verification::problems {
namespace {

/// The fence with a shift and a step that is `coarsening` times as long, over the same duration.
scenes::Fence shifted(scenes::Fence fence, const FenceShift& shift, double coarsening) {
  scenes::FenceElement& rock = fence.rocks.front();
  rock.spin += shift.spin;
  rock.position.y += shift.height;
  rock.angle += shift.angle;
  const double factor = shift.step * coarsening;
  fence.step_factor *= factor;
  fence.steps = std::lround(static_cast<double>(fence.steps) / factor);
  return fence;
}

bool with_twins(const PrintedRow& row, const Setup& setup) {
  if (setup.coarse) return false;
  return setup.tier == Tier::full || (row.bottom_cable && !row.plastic && row.height == 0.0);
}

}  // namespace

std::vector<FenceShift> declared_shifts() {
  constexpr double quarter = std::numbers::pi / 24.0;  // of 30 degrees
  return {{.name = "omega0 + 2 rad/s", .spin = 2.0},
          {.name = "omega0 - 2 rad/s", .spin = -2.0},
          {.name = "yc + 0.02 ft", .height = 0.02},
          {.name = "yc - 0.02 ft", .height = -0.02},
          {.name = "nodes + 7.5 deg", .angle = quarter},
          {.name = "nodes + 15 deg", .angle = 2.0 * quarter},
          {.name = "nodes + 22.5 deg", .angle = 3.0 * quarter},
          {.name = "step / 2", .step = 0.5},
          {.name = "step x 2", .step = 2.0}};
}

const std::vector<FenceQuantity>& fence_quantities() {
  using Printed = std::optional<PrintedNumber>;
  static const std::vector<FenceQuantity> all{
      {"joint force", "lb", &FenceSample::joint, [](const PrintedRow& r) -> Printed { return r.joint; }, true},
      {"top cable force", "lb", &FenceSample::top, [](const PrintedRow& r) -> Printed { return r.top; }, true},
      {"bottom cable force", "lb", &FenceSample::bottom, [](const PrintedRow& r) { return r.bottom; }, true},
      {"exit velocity", "ft/s", &FenceSample::speed, [](const PrintedRow& r) -> Printed { return r.speed; }, false}};
  return all;
}

double RowRun::low(const FenceQuantity& quantity) const {
  double minimum = run.peaks.*quantity.ours;
  for (const FenceSample& twin : twins)
    minimum = std::min(minimum, twin.*quantity.ours);
  return minimum;
}

double RowRun::high(const FenceQuantity& quantity) const {
  double largest = run.peaks.*quantity.ours;
  for (const FenceSample& twin : twins)
    largest = std::max(largest, twin.*quantity.ours);
  return largest;
}

bool RowRun::inside(const FenceQuantity& quantity) const {
  const PrintedNumber print = quantity.printed(printed).value();
  return print.value + print.half >= low(quantity) && print.value - print.half <= high(quantity);
}

scenes::Fence fence_of(const PrintedRow& row, const Setup& setup) {
  scenes::Fence fence = fence_of(row);
  if (setup.has("mass_doubled")) fence.column.density *= 2.0;
  if (setup.has("limits_ignored")) fence.limit_top = fence.limit_bottom = 1e8;
  if (setup.has("height_downwards")) fence.rocks.front().position.y *= -1.0;
  if (setup.has("bottom_wrapped_once")) fence.area_bottom *= 0.5;
  return fence;
}

std::vector<RowRun> run_rows(const Setup& setup, double coarsening) {
  std::vector<RowRun> rows;
  for (const PrintedRow& printed : printed_rows()) {
    const scenes::Fence fence = fence_of(printed, setup);
    rows.push_back({printed, run_fence(shifted(fence, {}, coarsening)), {}});
    if (!with_twins(printed, setup)) continue;
    for (const FenceShift& shift : declared_shifts())
      rows.back().twins.push_back(run_fence(shifted(fence, shift, coarsening)).peaks);
  }
  return rows;
}

FenceDistance distance_of(const std::vector<RowRun>& rows, const FenceQuantity& quantity, bool bottom_cable) {
  FenceDistance all;
  double twins = 0.0;
  int twin_count = 0;
  for (const RowRun& row : rows) {
    const auto print = quantity.printed(row.printed);
    if (!print || row.printed.bottom_cable != bottom_cable) continue;
    ++all.count;
    const double ours = row.run.peaks.*quantity.ours;
    all.mean += std::abs(quantity.distance(ours, print->value));
    for (const FenceSample& twin : row.twins)
      twins += std::abs(quantity.distance(twin.*quantity.ours, ours)), ++twin_count;
    if (row.twins.empty()) continue;
    ++all.spread;
    all.inside += row.inside(quantity) ? 1 : 0;
  }
  all.mean /= all.count;
  all.twins = twin_count > 0 ? twins / twin_count : std::numeric_limits<double>::quiet_NaN();
  return all;
}

}  // namespace talus::verification::problems
