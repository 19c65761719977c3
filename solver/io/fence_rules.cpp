#include "solver/io/fence_rules.hpp"

#include <fmt/format.h>

#include <cmath>

#include "solver/scenes/fence_scene.hpp"

namespace talus {
namespace {

using scenes::ElementSolid;
using scenes::ElementType;
using scenes::Fence;
using scenes::FenceElement;
using Fault = std::optional<FenceFault>;

std::string amount(double value, const Fence& fence, Dimension dimension) {
  return fmt::format("{} {}", value, symbol(fence.units, dimension));
}

Fault element_fault(const FenceElement& element, std::size_t number) {
  const auto code = static_cast<std::size_t>(element.solid);
  const bool cylinder = element.solid == ElementSolid::cylinder;
  if (cylinder != (element.type == ElementType::column)) {
    return FenceFault{
        number, "solid",
        fmt::format("found {} ({}); it must be {}", code, Names<ElementSolid>::list[code],
                    cylinder ? "0 (ellipsoid) or 1 (block) for the ground and rocks" : "2 (cylinder) for a column")};
  }
  const bool moves_where_held[] = {element.held[0] && element.velocity.x != 0.0,
                                   element.held[1] && element.velocity.y != 0.0,
                                   element.held[2] && element.spin != 0.0};
  for (int axis = 0; axis < 3; ++axis) {
    if (!moves_where_held[axis]) continue;
    const double found = axis == 0 ? element.velocity.x : axis == 1 ? element.velocity.y : element.spin;
    return FenceFault{number, axis == 2 ? "spin" : "velocity",
                      fmt::format("found {} {}; it must be 0, since this motion is held", found,
                                  axis == 0   ? "along x"
                                  : axis == 1 ? "along y"
                                              : "as spin")};
  }
  return {};
}

/// Where rocks may be along the fence.
Fault along_fault(const FenceElement& element, std::size_t number, const Fence& fence, bool rock) {
  if (element.along == 0.0) return {};
  const std::string found = fmt::format("found {}", amount(element.along, fence, dimension::length));
  if (!rock) return FenceFault{number, "along", found + "; only a rock has a place along the fence"};
  if (fence.options.symmetry == scenes::FenceSymmetry::half)
    return FenceFault{number, "along", found + "; it must be 0 in the half model, which is symmetric"};
  const double reach = 0.5 * fence.columns * fence.spacing;
  if (std::abs(element.along) <= reach) return {};
  return FenceFault{number, "along",
                    fmt::format("{}; it must be in front of the columns, within {} of mid-span", found,
                                amount(reach, fence, dimension::length))};
}

/// How the cables yield.
Fault yield_fault(const scenes::FenceOptions& options) {
  if (options.hardening >= 1.0) return FenceFault{0, "options", "hardening: found 1; it must be < 1"};
  if (options.hardening != 0.0 && !options.table.empty()) {
    return FenceFault{
        0, "options",
        fmt::format("found hardening = {} and table; a cable yields by one of the two, hardening or table",
                    options.hardening)};
  }
  scenes::YieldMultiple before{0.0, 1.0};
  for (const scenes::YieldMultiple& point : options.table) {
    if (!(point.strain > before.strain && point.multiple >= before.multiple)) {
      return FenceFault{0, "options",
                        fmt::format("table: found ({:.6g}, {:.6g}) after ({:.6g}, {:.6g}); plastic strains must grow "
                                    "and multiples of the yield force not fall, from (0, 1) on",
                                    point.strain, point.multiple, before.strain, before.multiple)};
    }
    before = point;
  }
  return {};
}

Fault layer_fault(const Fence& fence) {
  if (fence.gravity_sign == 0) return FenceFault{0, "gravity_sign", "found 0; it must be 1 or -1"};
  const double width = (fence.columns - 1) * fence.spacing;
  if (!(width < fence.span)) {
    return FenceFault{
        0, "columns",
        fmt::format("found {}: {} apart they take {}; it must be less than the span, {}", fence.columns,
                    amount(fence.spacing, fence, dimension::length), amount(width, fence, dimension::length),
                    amount(fence.span, fence, dimension::length))};
  }
  if (!(fence.y_top > fence.y_bottom)) {
    return FenceFault{
        0, "y_top",
        fmt::format("found {}; it must be above the bottom joint, {}", amount(fence.y_top, fence, dimension::length),
                    amount(fence.y_bottom, fence, dimension::length))};
  }
  if (fence.layers == 2 && fence.layer_spacing == 0.0) {
    return FenceFault{0, "layer_spacing", "found 0; it must be > 0 for two layers"};
  }
  return {};
}

/// Where a run ends by exit.
Fault end_fault(const Fence& fence) {
  if (fence.options.end != scenes::FenceEnd::exit) return {};
  for (std::size_t i = 0; i < fence.rocks.size(); ++i) {
    if (fence.rocks[i].position.x > fence.options.exit_x) continue;
    return FenceFault{i + 2, "position",
                      fmt::format("found x = {}: the rock starts behind exit_x, {}, where the run ends",
                                  amount(fence.rocks[i].position.x, fence, dimension::length),
                                  amount(fence.options.exit_x, fence, dimension::length))};
  }
  return {};
}

Fault history_fault(const Fence& fence) {
  if (fence.history_codes.size() > most_history_codes) {
    return FenceFault{
        0, "history_codes",
        fmt::format("found {} codes; there can be at most {}", fence.history_codes.size(), most_history_codes)};
  }
  for (const int code : fence.history_codes) {
    if (code >= 1 && code <= last_history_code) continue;
    return FenceFault{0, "history_codes", fmt::format("found {}; it must be in 1 .. {}", code, last_history_code)};
  }
  for (const int element : fence.history_elements) {
    if (element >= 1 && element <= element_count(fence)) continue;
    return FenceFault{0, "history_elements",
                      fmt::format("found {}; it must be in 1 .. {}: the ground, the rocks ({}), then for each layer "
                                  "half its columns and a fixed end",
                                  element, element_count(fence), fence.rocks.size())};
  }
  return {};
}

}  // namespace

std::optional<FenceFault> fault(const Fence& fence) {
  if (Fault found = element_fault(fence.ground, 1)) return found;
  for (std::size_t i = 0; i < fence.rocks.size(); ++i) {
    if (Fault found = element_fault(fence.rocks[i], i + 2)) return found;
  }
  if (Fault found = element_fault(fence.column, fence.rocks.size() + 2)) return found;
  for (std::size_t i = 0; i < fence.rocks.size(); ++i) {
    if (Fault found = along_fault(fence.rocks[i], i + 2, fence, true)) return found;
  }
  if (Fault found = along_fault(fence.ground, 1, fence, false)) return found;
  if (Fault found = along_fault(fence.column, fence.rocks.size() + 2, fence, false)) return found;
  if (Fault found = yield_fault(fence.options)) return found;
  if (Fault found = layer_fault(fence)) return found;
  if (Fault found = end_fault(fence)) return found;
  return history_fault(fence);
}

std::string objection_to_title(std::string_view title) {
  for (std::size_t i = 0; i < title.size(); ++i) {
    const auto byte = static_cast<unsigned char>(title[i]);
    // U+0080 .. U+009F: letters in the code pages of DOS.
    const bool upper = byte == 0xc2 && static_cast<unsigned char>(title[i + 1]) < 0xa0;
    if (!upper && (byte >= 0x20 || byte == '\t') && byte != 0x7f) continue;
    return fmt::format("found the control character 0x{:02x}; a title is one line of UTF-8 or Latin-1 text",
                       static_cast<unsigned char>(title[upper ? i + 1 : i]));
  }
  return "";
}

}  // namespace talus
