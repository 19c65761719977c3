#include "solver/io/fence1993/fence_rules.hpp"

#include <fmt/format.h>

#include <cmath>

#include "solver/scenes/fence_scene.hpp"

namespace talus {
namespace {

using scenes::ElementSolid;
using scenes::ElementType;
using scenes::Fence;
using scenes::FenceElement;
using Faults = std::vector<FenceFault>;

std::string amount(double value, const Fence& fence, Dimension dimension) {
  return fmt::format("{} {}", value, symbol(fence.units, dimension));
}

void add_element_faults(Faults& found, const FenceElement& element, std::size_t number) {
  const auto code = static_cast<std::size_t>(element.solid);
  const bool cylinder = element.solid == ElementSolid::cylinder;
  if (cylinder != (element.type == ElementType::column)) {
    found.push_back(
        {number, "solid",
         fmt::format("found {} ({}); it must be {}", code, name_of(element.solid),
                     cylinder ? "0 (ellipsoid) or 1 (block) for the ground and rocks" : "2 (cylinder) for a column")});
  }
  const double motions[] = {element.velocity.x, element.velocity.y, element.spin};
  constexpr std::string_view names[] = {"along x", "along y", "as spin"};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!element.held[axis] || motions[axis] == 0.0) continue;
    found.push_back({number, axis == 2 ? "spin" : "velocity",
                     fmt::format("found {} {}; it must be 0, since this motion is held", motions[axis], names[axis])});
  }
}

/// Checks the position along the fence: only a rock of the full model may have one, in front of the columns.
void add_along_fault(Faults& found, const FenceElement& element, std::size_t number, const Fence& fence, bool rock) {
  if (element.along == 0.0) return;
  const std::string along = fmt::format("found {}", amount(element.along, fence, dimension::length));
  const double reach = 0.5 * fence.columns * fence.spacing;
  if (!rock) {
    found.push_back({number, "along", along + "; only a rock has a place along the fence"});
  } else if (fence.options.symmetry == scenes::FenceSymmetry::half) {
    found.push_back({number, "along", along + "; it must be 0 in the half model, which is symmetric"});
  } else if (std::abs(element.along) > reach) {
    found.push_back({number, "along",
                     fmt::format("{}; it must be in front of the columns, within {} of mid-span", along,
                                 amount(reach, fence, dimension::length))});
  }
}

/// Checks the options for the yielding of the cables.
void add_yield_faults(Faults& found, const scenes::FenceOptions& options) {
  if (options.hardening >= 1.0) found.push_back({0, "options", "hardening: found 1; it must be < 1"});
  if (options.hardening != 0.0 && !options.table.empty()) {
    found.push_back({0, "options",
                     fmt::format("found hardening = {} and table; a cable yields by one of the two, hardening or table",
                                 options.hardening)});
  }
  scenes::YieldMultiple before{0.0, 1.0};
  for (const scenes::YieldMultiple& point : options.table) {
    if (!(point.strain > before.strain && point.multiple >= before.multiple)) {
      found.push_back({0, "options",
                       fmt::format("table: found ({:.6g}, {:.6g}) after ({:.6g}, {:.6g}); plastic strains must grow "
                                   "and multiples of the yield force not fall, from (0, 1) on",
                                   point.strain, point.multiple, before.strain, before.multiple)});
      return;
    }
    before = point;
  }
}

void add_layer_faults(Faults& found, const Fence& fence) {
  if (fence.gravity_sign == 0) found.push_back({0, "gravity_sign", "found 0; it must be 1 or -1"});
  const double width = (fence.columns - 1) * fence.spacing;
  if (!(width < fence.span)) {
    found.push_back(
        {0, "columns",
         fmt::format("found {}: {} apart they take {}; it must be less than the span, {}", fence.columns,
                     amount(fence.spacing, fence, dimension::length), amount(width, fence, dimension::length),
                     amount(fence.span, fence, dimension::length))});
  }
  if (!(fence.y_top > fence.y_bottom)) {
    found.push_back(
        {0, "y_top",
         fmt::format("found {}; it must be above the bottom joint, {}", amount(fence.y_top, fence, dimension::length),
                     amount(fence.y_bottom, fence, dimension::length))});
  }
  if (fence.layers == 2 && fence.layer_spacing == 0.0)
    found.push_back({0, "layer_spacing", "found 0; it must be > 0 for two layers"});
}

/// Checks that no rock starts behind the exit if the run ends there.
void add_end_faults(Faults& found, const Fence& fence) {
  if (fence.options.end != scenes::FenceEnd::exit) return;
  for (std::size_t i = 0; i < fence.rocks.size(); ++i) {
    if (fence.rocks[i].position.x > fence.options.exit_x) continue;
    found.push_back({i + 2, "position",
                     fmt::format("found x = {}; it must be > exit_x, {}, where the run ends",
                                 amount(fence.rocks[i].position.x, fence, dimension::length),
                                 amount(fence.options.exit_x, fence, dimension::length))});
  }
}

void add_history_faults(Faults& found, const Fence& fence) {
  if (fence.history_codes.size() > maximum_history_codes) {
    found.push_back(
        {0, "history_codes",
         fmt::format("found {} codes; there can be at most {}", fence.history_codes.size(), maximum_history_codes)});
  }
  for (const int code : fence.history_codes) {
    if (code >= 1 && code <= last_history_code) continue;
    found.push_back({0, "history_codes", fmt::format("found {}; it must be in 1 .. {}", code, last_history_code)});
  }
  for (const int element : fence.history_elements) {
    if (element >= 1 && element <= element_count(fence)) continue;
    found.push_back({0, "history_elements",
                     fmt::format("found {}; it must be in 1 .. {}: the ground, the rocks ({}), then for each layer "
                                 "half its columns and a fixed end",
                                 element, element_count(fence), fence.rocks.size())});
  }
}

}  // namespace

std::vector<FenceFault> faults(const Fence& fence) {
  const std::size_t column = fence.rocks.size() + 2;
  Faults found;
  add_element_faults(found, fence.ground, 1);
  for (std::size_t i = 0; i < fence.rocks.size(); ++i)
    add_element_faults(found, fence.rocks[i], i + 2);
  add_element_faults(found, fence.column, column);
  for (std::size_t i = 0; i < fence.rocks.size(); ++i)
    add_along_fault(found, fence.rocks[i], i + 2, fence, true);
  add_along_fault(found, fence.ground, 1, fence, false);
  add_along_fault(found, fence.column, column, fence, false);
  add_yield_faults(found, fence.options);
  add_layer_faults(found, fence);
  add_end_faults(found, fence);
  add_history_faults(found, fence);
  return found;
}

std::string title_error(std::string_view title) {
  for (std::size_t i = 0; i < title.size(); ++i) {
    const auto byte = static_cast<unsigned char>(title[i]);
    // U+0080 .. U+009F are control characters; in the code pages of DOS these bytes are letters.
    const bool upper = byte == 0xc2 && static_cast<unsigned char>(title[i + 1]) < 0xa0;
    if (!upper && (byte >= 0x20 || byte == '\t') && byte != 0x7f) continue;
    return fmt::format("found the control character 0x{:02x}; a title is one line of UTF-8 or Latin-1 text",
                       static_cast<unsigned char>(title[upper ? i + 1 : i]));
  }
  return "";
}

}  // namespace talus
