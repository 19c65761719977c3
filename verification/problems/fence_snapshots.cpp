#include "verification/problems/fence_snapshots.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "solver/run/simulate.hpp"
#include "solver/scenes/fence_scene.hpp"
#include "verification/problems/fence_table.hpp"

namespace talus::verification::problems {
namespace {

constexpr std::array<double, 5> times{0.0, 0.03, 0.06, 0.1, 0.16};  // [s]

/// The two bodies at one time.
struct Snapshot {
  double time{};
  Pose rock;
  Pose column;
};

std::vector<Snapshot> snapshots(const scenes::FenceScene& made) {
  std::vector<Snapshot> taken;
  const Model& model = made.scene.model;
  const Dynamics dynamics{model};
  RigidBodySystem system{dynamics, false};
  Integrator integrator = made.scene.integrator;
  State state = made.scene.initial;
  RunPlan plan = made.scene.plan;
  plan.end = times.back();
  const Observer observers[] = {[&](const State& seen, const StepInfo&) {
    if (taken.size() == times.size() || seen.t < times[taken.size()] - 0.5 * plan.step) return;
    taken.push_back({seen.t, pose(model, seen, *made.members[1].body), pose(model, seen, *made.members[2].body)});
  }};
  static_cast<void>(simulate(system, integrator, state, plan, observers));
  return taken;
}

Series column_outline(const Snapshot& taken, const scenes::FenceElement& column) {
  Series series{.label = fmt::format("column, {:.2f} s", taken.time), .x = {}, .y = {}, .style = Style::lines};
  for (const auto& [x, y] : {std::pair{1, 1}, {-1, 1}, {-1, -1}, {1, -1}, {1, 1}}) {
    const Vec2 p = world_point(taken.column, {x * column.a, y * column.b});
    series.x.push_back(p.x);
    series.y.push_back(p.y);
  }
  return series;
}

/// A circle, its first and last point at its centre: the radius drawn shows how it has turned.
Series rock_outline(const Snapshot& taken, double radius) {
  Series series{.label = fmt::format("rock, {:.2f} s", taken.time), .x = {}, .y = {}, .style = Style::lines};
  constexpr int parts = 48;
  for (int i = -1; i <= parts; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / parts;
    const Vec2 p =
        i < 0 ? taken.rock.p_WB : world_point(taken.rock, {radius * std::cos(angle), radius * std::sin(angle)});
    series.x.push_back(p.x);
    series.y.push_back(p.y);
  }
  return series;
}

}  // namespace

void draw_snapshots(Findings& findings) {
  for (const PrintedRow& row : printed_rows()) {
    if (row.table != 2 || row.height != 0.0 || row.plastic) continue;
    const int number = row.bottom_cable ? 12 : 13;
    const scenes::Fence fence = fence_of(row);
    Figure figure{
        .name = fmt::format("fig_{}_snapshots", number),
        .title = fmt::format("Fig. {}: rock of 600 lb, {} bottom cable", number, row.bottom_cable ? "with" : "without"),
        .caption = fmt::format("Central column and rock seen along the fence, for Fig. {} of the report; the "
                               "rock comes from the right.",
                               number),
        .x = {.label = "x", .unit = "ft", .min = -14.0, .max = 10.0},
        .y = {.label = "y", .unit = "ft", .min = -5.0, .max = 5.0},
        .series = {},
        .lines = {{'y', -4.5, "ground"}}};
    const std::vector<Snapshot> taken = snapshots(scenes::fence_scene(fence));
    for (const Snapshot& snapshot : taken)
      figure.series.push_back(column_outline(snapshot, fence.column));
    for (const Snapshot& snapshot : taken)
      figure.series.push_back(rock_outline(snapshot, fence.rocks[0].a));
    findings.figure(std::move(figure));
  }
}

}  // namespace talus::verification::problems
