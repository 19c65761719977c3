#include "verification/problems/fence/fence_snapshots.hpp"

#include "solver/scenes/fence_scene.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems {
namespace {

void add(Series& series, Vec2 p) { series.add(p.x, p.y); }

void add_column(Series& series, const Pose& pose, const scenes::FenceElement& column) {
  for (const auto& [x, y] : {std::pair{1, 1}, {-1, 1}, {-1, -1}, {1, -1}, {1, 1}})
    add(series, world_point(pose, {x * column.a, y * column.b}));
}

/// Adds a circle, drawn from its centre and back along the radius that lies along x at angle 0: this radius shows the
/// rotation of the rock.
void add_rock(Series& series, const Pose& pose, double radius) {
  constexpr int parts = 48;
  add(series, pose.p_WB);
  for (int i = 0; i <= parts; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / parts;
    add(series, world_point(pose, {radius * std::cos(angle), radius * std::sin(angle)}));
  }
  add(series, pose.p_WB);
}

}  // namespace

Figure snapshots(std::string name, std::string title, std::string caption, const scenes::Fence& fence,
                 const std::vector<double>& times) {
  Figure figure{.name = std::move(name),
                .title = std::move(title),
                .caption = std::move(caption),
                .x = {.label = "x", .unit = "ft", .min = -16.0, .max = 12.0},
                .y = {.label = "y", .unit = "ft", .min = -5.0, .max = 7.0},
                .series = {},
                .lines = {{'y', -4.5, "ground"}}};
  const scenes::FenceScene made = scenes::fence_scene(fence);
  const Model& model = made.scene.model;
  RunPlan plan = made.scene.plan;
  plan.end = times.back();
  const std::size_t rocks = fence.rocks.size();
  const auto layer = static_cast<std::size_t>(columns_of_half(fence)) + 1;
  const Watcher draw = [&](const State& seen, const StepInfo&) {
    if (figure.series.size() == times.size() || seen.t < times[figure.series.size()] - 0.5 * plan.step) return;
    Series series{.label = fmt::format("{:.2f} s", seen.t), .style = Style::outlines};
    for (std::size_t i = 0; i < rocks; ++i)
      add_rock(series, pose(model, seen, *made.members[1 + i].body), fence.rocks[i].a);
    for (std::size_t i = 0; i < static_cast<std::size_t>(fence.layers); ++i)
      add_column(series, pose(model, seen, *made.members[1 + rocks + i * layer].body), fence.column);
    figure.series.push_back(std::move(series));
  };
  run_scene(made.scene, made.scene.integrator, plan, nullptr, draw);
  return figure;
}

}  // namespace talus::verification::problems
