/// Columns, cables and hangers of a fence.

#include <cmath>

#include "solver/scenes/fence_maker.hpp"

namespace talus::scenes {

CableId FenceMaker::add_cable(const std::string& name, CableEnd a, CableEnd b, double stiffness, double rest_length,
                              bool top) {
  const FenceOptions& options = fence_.options;
  ElasticPlastic law{.stiffness = stiffness, .yield = top ? fence_.limit_top : fence_.limit_bottom};
  // The hardening modulus H is such that the tangent stiffness k H/(k + H) is the given fraction of k.
  law.hardening = options.hardening / (1.0 - options.hardening) * stiffness;
  for (const YieldMultiple& point : options.table)
    law.table.push_back({point.strain * rest_length, point.multiple * law.yield});
  if (const double strength = top ? options.strength_top : options.strength_bottom; strength > 0.0)
    law.strength = strength;
  if (options.rupture > 0.0) law.rupture = options.rupture * rest_length;
  for (const StretchedCable& stretched : fence_.stretched_cables) {
    if (stretched.cable != name) continue;
    // The cable's memory starts at zero: earlier plastic elongation is part of its rest length and law.
    rest_length += stretched.stretch;
    law = law.drawn_before(stretched.stretch);
    if (!(law.rupture > 0.0))
      throw FenceError{{0, "stretched_cable",
                        fmt::format("found cable '{}' stretched by {:.6g}; it must be less, since it breaks at that",
                                    name, stretched.stretch)}};
  }
  Cable cable{.name = name, .a = a, .b = b, .rest_length = rest_length, .law = law};
  cable.multiplicity = full() ? 1 : 2;
  return builder_.add(cable);
}

/// The column at a position, with its changed values if it has any.
ChangedColumn FenceMaker::column(int position) const {
  for (const ChangedColumn& changed : fence_.changed_columns) {
    if (changed.number == position + 1) return changed;
  }
  const FenceElement& e = fence_.column;
  return {position + 1, e.a, e.b, e.density, fence_.y_top, fence_.y_bottom};
}

/// A rock can hit the columns within half their spacing along the fence: one, or two when it is midway between them. In
/// the half model these are the central ones.
bool FenceMaker::meets(const FenceElement& rock, const Column& column) const {
  if (!full()) return column.position == 0;
  return std::abs(rock.along - column.along) <= 0.5 * fence_.spacing * (1.0 + 1e-9);
}

void FenceMaker::add_member(int layer, const Column& column, const ChangedColumn& changed, Vec2 position,
                            double angle) {
  FenceElement own = fence_.column;
  own.a = changed.a, own.b = changed.b, own.density = changed.density;
  const MassProperties solid = mass_properties(own);
  made_.members.push_back({.body = column.body,
                           .layer = layer,
                           .position = position,
                           .angle = angle,
                           .mass = solid.mass,
                           .inertia = solid.inertia});
}

void FenceMaker::add_layer(int layer) {
  const FenceElement& e = fence_.column;
  const double x = e.position.x - (layer - 1) * fence_.layer_spacing;
  const StaticShape shape = static_shape(fence_);
  if (layer == 1) made_.horizontal_tension = shape.horizontal_tension;
  const int count = columns_of_half(fence_);
  const double inner = even() ? 0.5 * fence_.spacing : 0.0;  // z of the first column
  layers_.emplace_back();
  std::vector<std::array<std::size_t, 2>> hung;  // indices in layers_.back(): for each position, the column on either
                                                 // side
  for (int i = 0; i < count; ++i) {
    const ChangedColumn changed = column(i);
    FenceElement own = e;
    own.a = changed.a, own.b = changed.b, own.density = changed.density;
    Body made = body(own, "", fence_.options.contact);
    made.sleeps = made.mobility == Mobility::free;
    const bool centre = i == 0;
    // Equal columns add an exact zero, so that their heights suffer no round-off.
    const double lower = changed.y_top == column(0).y_top ? 0.0 : column(0).y_top - changed.y_top;
    made.p_WB = {x, e.position.y + shape.heights[static_cast<std::size_t>(i)] + lower};
    if (!full() && !(centre && (!even() || doubled()))) made.multiplicity = 2;
    if (centre && doubled()) made.mass *= 2.0, made.inertia *= 2.0;
    hung.emplace_back();
    const int sides = full() && !(centre && !even()) ? 2 : 1;
    for (int side = 0; side < 2; ++side) {
      if (side < sides) {
        Column column{.number = fmt::format("{}{}", side == 1 ? "-" : "", i + 1)};
        column.along = (side == 1 ? -1 : 1) * (inner + i * fence_.spacing);
        column.height = made.p_WB.y;
        column.mass = made.mass, column.inertia = made.inertia, column.multiplicity = made.multiplicity;
        column.position = i;
        column.struck = std::ranges::any_of(fence_.rocks, [&](const FenceElement& r) { return meets(r, column); });
        made.name = fmt::format("{}column{}", prefix(layer), column.number);
        column.body = builder_.add(made);
        layers_.back().push_back(column);
      }
      hung.back()[static_cast<std::size_t>(side)] = layers_.back().size() - 1;
    }
    add_member(layer, layers_.back()[hung.back()[0]], changed, made.p_WB, made.angle);
  }
  const MassProperties solid = mass_properties(e);
  const Vec2 end{x, e.position.y + shape.heights.back()};
  made_.members.push_back({.layer = layer, .position = end, .mass = solid.mass, .inertia = solid.inertia});
  add_segments(layer, true, shape, hung);
  if (fence_.connections == 2) add_segments(layer, false, shape, hung);
  if (fence_.options.hanger_strength > 0.0) add_hangers(layer);
}

void FenceMaker::add_segments(int layer, bool top, const StaticShape& shape,
                              const std::vector<std::array<std::size_t, 2>>& hung) {
  const std::vector<Column>& columns = layers_.back();
  const auto joint = [&](std::size_t position, std::size_t hand) {
    const ChangedColumn own = column(static_cast<int>(position));
    const Column& at = columns[hung[position][hand]];
    return CableEnd{at.body, {0.0, top ? own.y_top : own.y_bottom, at.along}};
  };
  // Top joints lie on the cable; bottom joints of equal columns follow the rise of the top joints.
  const auto drop = [&](std::size_t position) {
    const ChangedColumn own = column(static_cast<int>(position));
    return top ? 0.0 : (own.y_bottom - own.y_top) - (fence_.y_bottom - fence_.y_top);
  };
  const std::string stem = prefix(layer) + (top ? "top" : "bottom");
  // The bottom cable is doubled (two strands).
  const double stiffness = top ? fence_.young * fence_.area_top : 2.0 * fence_.young * fence_.area_bottom;
  const std::size_t count = hung.size();
  if (full() && even()) {
    // The horizontal segment between the central columns.
    const double d = fence_.spacing, k = stiffness / d;
    add_cable(stem + "0", joint(0, 1), joint(0, 0), k, top ? d - shape.horizontal_tension / k : d + fence_.slack, top);
  }
  const std::size_t first_member = made_.members.size() - count - 1;
  const Vec2 end = made_.members.back().position;
  const std::size_t segments = top || fence_.options.bottom_end == BottomEnd::anchored ? count : count - 1;
  for (std::size_t s = 0; s < segments; ++s) {
    const double last_drop = s + 1 < count ? drop(s + 1) : drop(0);
    const double rise = shape.heights[s + 1] - shape.heights[s] + (last_drop - drop(s));
    const double length = std::sqrt(shape.distances[s] * shape.distances[s] + rise * rise);
    const double k = stiffness / length;
    if (top && s == 0 && layer == 1) first_stiffness_ = k;
    const double rest = top ? length - shape.tensions[s] / k : length + fence_.slack;
    for (const int side : full() ? std::vector{1, -1} : std::vector{1}) {
      const std::size_t hand = side > 0 ? 0 : 1;
      const CableEnd a = joint(s, hand);
      const double local_y = top ? column(0).y_top : column(0).y_bottom;
      const CableEnd b = s + 1 < count ? joint(s + 1, hand)
                                       : CableEnd{{}, {end.x, end.y + local_y, a.p.z + side * shape.distances[s]}};
      const CableId id = add_cable(fmt::format("{}{}{}", stem, side < 0 ? "-" : "", s + 1), a, b, k, rest, top);
      FenceMember& member = made_.members[first_member + s];
      if (side > 0) (top ? member.top : member.bottom) = id;
    }
  }
}

void FenceMaker::add_hangers(int layer) {
  const std::size_t first_member = made_.members.size() - static_cast<std::size_t>(columns_of_half(fence_)) - 1;
  for (const Column& hung : layers_.back()) {
    const HangerId id = builder_.add(Hanger{.name = fmt::format("{}hanger{}", prefix(layer), hung.number),
                                            .body = hung.body,
                                            .p = {0.0, column(hung.position).y_top, hung.along},
                                            .strength = fence_.options.hanger_strength});
    if (hung.along >= 0.0) made_.members[first_member + static_cast<std::size_t>(hung.position)].hanger = id;
  }
}

}  // namespace talus::scenes
