#include "solver/scenes/fence_plausibility.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "solver/dynamics/candidates.hpp"
#include "solver/scenes/fence_element.hpp"

namespace talus::scenes {
namespace {

std::string length(const Fence& fence, double value) {
  return fmt::format("{:.4g} {}", value, symbol(fence.units, dimension::length));
}

/// Half-widths of the columns of a layer.
struct HalfWidths {
  explicit HalfWidths(const Fence& fence) {
    const auto half = static_cast<std::size_t>(fence.columns + 1) / 2;
    std::vector<double> from_centre(half, fence.column.a);
    for (const ChangedColumn& changed : fence.changed_columns)
      from_centre.at(static_cast<std::size_t>(changed.number - 1)) = changed.a;
    widest = *std::ranges::max_element(from_centre);
    // Of an even number the two inner columns are neighbours.
    if (fence.columns % 2 == 0) of_neighbours = 2.0 * from_centre.front();
    for (std::size_t i = 1; i < half; ++i)
      of_neighbours = std::max(of_neighbours, from_centre[i - 1] + from_centre[i]);
  }

  double widest{};
  double of_neighbours{};  ///< largest sum of two; 0 for a single column
};

}  // namespace

std::vector<std::string> implausible_geometry(const Fence& fence, const FenceScene& made) {
  std::vector<std::string> found;
  if (fence.sag > fence.span) {
    found.push_back(fmt::format("sag: the top cable hangs {} down over a span of only {}", length(fence, fence.sag),
                                length(fence, fence.span)));
  }
  const HalfWidths widths{fence};
  if (fence.columns > 1 && fence.spacing < 2.0 * fence.column.a) {
    found.push_back(
        fmt::format("spacing: columns of a width of {} have a spacing of {}, so that neighbours overlap by {}",
                    length(fence, 2.0 * fence.column.a), length(fence, fence.spacing),
                    length(fence, 2.0 * fence.column.a - fence.spacing)));
  } else if (fence.spacing < widths.of_neighbours) {
    found.push_back(fmt::format("changed_column: a column of a width of {} overlaps its neighbours, {} apart",
                                length(fence, 2.0 * widths.widest), length(fence, fence.spacing)));
  }
  if (fence.layers == 2 && fence.layer_spacing < 2.0 * widths.widest) {
    found.push_back(fmt::format("layer_spacing: the layers are {} apart, columns {} thick: they overlap by {}",
                                length(fence, fence.layer_spacing), length(fence, 2.0 * widths.widest),
                                length(fence, 2.0 * widths.widest - fence.layer_spacing)));
  }
  const Model& model = made.scene.model;
  const Body& ground = model.bodies[index(*made.members.front().body)];
  const Pose ground_pose{ground.p_WB, rotation(ground.angle), {}, 0.0};
  double deepest = 0.0;
  std::string column;
  for (const FenceMember& member : made.members) {
    if (!member.body || member.layer == 0) continue;
    const Body& body = model.bodies[index(*member.body)];
    const Pose pose{body.p_WB, rotation(body.angle), {}, 0.0};
    const double below = -height_over(ground, ground_pose, world_point(pose, {0.0, -bounds(body.shape).half_height}));
    if (below > deepest) deepest = below, column = body.name;
  }
  if (deepest > 0.0) {
    found.push_back(
        fmt::format("ground: it reaches {} into the columns, furthest into '{}'", length(fence, deepest), column));
  }
  return found;
}

std::vector<std::string> implausible_motion(const Fence& fence, const FenceSummary& summary) {
  constexpr double heights = 5.0, spans = 5.0;
  std::vector<std::string> found;
  double top = 0.0;
  for (const LayerRecord& layer : summary.layers)
    top = std::max(top, layer.top.start);
  for (const RockPassage& rock : summary.rocks) {
    if (top > 0.0 && rock.highest > heights * top) {
      found.push_back(fmt::format("'{}' flies away: it rises to {} over the ground, {:.3g} times as high as the fence",
                                  rock.name, length(fence, rock.highest), rock.highest / top));
    } else if (rock.distance > spans * fence.span) {
      found.push_back(fmt::format("'{}' is {} from the fence at the end, {:.3g} times its span", rock.name,
                                  length(fence, rock.distance), rock.distance / fence.span));
    }
    if (!rock.touched) {
      found.push_back(fmt::format("'{}' never touches the fence; at the end it is {} from it", rock.name,
                                  length(fence, rock.distance)));
    }
  }
  return found;
}

}  // namespace talus::scenes
