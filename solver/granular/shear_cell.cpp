#include "solver/granular/shear_cell.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "solver/base/error.hpp"

namespace talus {
namespace {

void demand(bool holds, const char* field, double found, const char* allowed) {
  if (!holds) throw InputError{fmt::format("{}: found {}; it must be {}", field, found, allowed)};
}

void check(const ShearCell& cell) {
  demand(cell.law.stiffness > 0.0, "stiffness (K1)", cell.law.stiffness, "> 0");
  demand(cell.law.unloading_stiffness >= cell.law.stiffness, "unloading_stiffness (K2)", cell.law.unloading_stiffness,
         "at least the stiffness (K1)");
  demand(cell.diameter > 0.0, "diameter (D)", cell.diameter, "> 0");
  demand(cell.mass > 0.0, "mass (M)", cell.mass, "> 0");
  demand(cell.gravity >= 0.0, "gravity (G)", cell.gravity, ">= 0");
  demand(cell.block_mass > 0.0, "block_mass (MTOP)", cell.block_mass, "> 0");
  demand(cell.rows > 0, "rows (NHT)", cell.rows, "> 0");
  demand(cell.wall_discs >= 3, "wall_discs (TWID)", cell.wall_discs, "at least 3");
  demand(cell.columns > 0 && cell.columns <= cell.wall_discs, "columns (NWID)", cell.columns,
         "> 0 and at most the discs of a wall (TWID)");
}

/// Uniform in [-1, 1) from the generator's own bits: the library's distributions differ between libraries.
double symmetric(std::mt19937_64& random) { return std::ldexp(static_cast<double>(random() >> 11), -52) - 1.0; }

WallStress stress(const ShearCell& cell, Vec2 force) {
  const double area = cell.wall_discs * cell.diameter * cell.diameter;
  return {force.x / area, force.y / area};
}

}  // namespace

double ShearCell::contact_time() const {
  return 0.5 * std::numbers::pi *
         (std::sqrt(0.5 * mass / law.stiffness) + std::sqrt(0.5 * mass / law.unloading_stiffness));
}

FilledCell fill(const ShearCell& cell) {
  check(cell);
  FilledCell filled{.shapes = {}, .discs = {}, .box = {.width = cell.width()}};
  const double radius = 0.5 * cell.diameter, left = -0.5 * cell.width();
  const double column = cell.width() / cell.columns, row = std::max(column, 1.05 * cell.diameter);
  const double top = row * (cell.rows + 1);
  std::mt19937_64 random{cell.seed};
  for (int r = 0; r < cell.rows; ++r) {
    for (int c = 0; c < cell.columns; ++c) {
      const double y = row * (r + 1);
      filled.shapes.add(radius, 1.0 / cell.mass);
      filled.discs.add(left + column * (c + 0.5), y, cell.block_speed * y / top,
                       0.01 * std::abs(cell.block_speed) * symmetric(random));
    }
  }
  const std::size_t base = filled.shapes.add(DiscWall{});
  const std::size_t block = filled.shapes.add(DiscWall{.mass = cell.block_mass, .gravity = cell.gravity});
  for (const std::size_t wall : {base, block}) {
    for (int c = 0; c < cell.wall_discs; ++c) {
      filled.shapes.add(radius, 0.0, wall);
      filled.discs.add(left + cell.diameter * (c + 0.5), wall == base ? 0.0 : top,
                       wall == base ? 0.0 : cell.block_speed, 0.0);
    }
  }
  return filled;
}

double depth(const ShearCell& cell, const Discs& discs) {
  const std::size_t base = cell.free_discs(), block = base + static_cast<std::size_t>(cell.wall_discs);
  return discs.y[block] - discs.y[base] - cell.diameter;
}

double solid_fraction(const ShearCell& cell, const Discs& discs) {
  const double disc = 0.25 * std::numbers::pi * cell.diameter * cell.diameter;
  return static_cast<double>(cell.free_discs()) * disc / (cell.width() * depth(cell, discs));
}

WallStress block_stress(const ShearCell& cell, const DiscSystem<LatchingSpring>& system) {
  const WallStress on_block = stress(cell, system.wall_force(block_wall));
  return {-on_block.shear, on_block.normal};
}

WallStress base_stress(const ShearCell& cell, const DiscSystem<LatchingSpring>& system) {
  const WallStress on_base = stress(cell, system.wall_force(base_wall));
  return {on_base.shear, -on_base.normal};
}

}  // namespace talus
