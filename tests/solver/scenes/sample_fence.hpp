#pragma once

#include "solver/scenes/fence.hpp"

namespace talus::scenes {

/// sample2 of the manual (Mustoe & Huttelmaier 1993, Appendix II.5.1), layers and columns as given.
inline Fence sample2(int layers = 2, int columns = 13) {
  Fence fence;
  fence.title = "sample2";
  fence.steps = 200, fence.print_every = 60, fence.history_every = 30;
  fence.penetration = 0.05, fence.gravity = 32.18;
  fence.ground = {.solid = ElementSolid::block, .a = 10.0, .b = 0.5, .density = 0.1, .position = {0.0, -5.0}};
  fence.ground.held = {true, true, true};
  FenceElement rock{.points = 4, .a = 1.201, .b = 1.201, .density = 5.13, .position = {2.451, 0.0}};
  rock.velocity = {-65.0, 0.0};
  rock.spin = 34.0;
  fence.rocks = {rock};
  fence.column = {.type = ElementType::column, .solid = ElementSolid::cylinder, .a = 1.25, .b = 4.0, .density = 0.76};
  fence.span = 55.0, fence.sag = 5.5, fence.spacing = 2.5;
  fence.young = 2e7 * 144.0, fence.area_top = 1.076 / 144.0, fence.area_bottom = 0.25 / 144.0;
  fence.y_top = 6.67, fence.y_bottom = -4.0;
  fence.columns = columns, fence.restitution = 0.4, fence.slack = 0.5;
  fence.limit_top = fence.limit_bottom = 1e8;
  fence.layers = layers, fence.layer_spacing = 2.6, fence.rock_overlap = 0.6, fence.layer_overlap = 0.5;
  return fence;
}

}  // namespace talus::scenes
