#pragma once

#include <cstdint>

#include "solver/granular/disc_system.hpp"
#include "solver/laws/latching_spring.hpp"

namespace talus {

/// The shear cell of SNOFLO (Lacy 1989, chapter 3): discs between a base and a block, both rows of touching discs, the
/// block with a mass and a weight and driven along x, the field periodic along x. The names of CNTRL.DAT stand beside.
/// Gravity acts on the block alone.
struct ShearCell {
  LatchingSpring law;    ///< K1, K2
  double diameter{};     ///< D [L] > 0
  double mass{};         ///< M of a disc [M] > 0
  double gravity{};      ///< G [L/T^2] >= 0
  double block_mass{};   ///< MTOP [M] > 0
  int rows{};            ///< NHT of the array that the free discs start in > 0
  int columns{};         ///< NWID of it, in [1, TWID]
  int wall_discs{};      ///< TWID in the base and in the block >= 3
  double block_speed{};  ///< VXT along x [L/T]
  std::uint64_t seed{};  ///< of the first velocities along y

  double width() const { return wall_discs * diameter; }
  std::size_t free_discs() const { return static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns); }
  /// Overburden by the thesis's definition, MTOP G/(TWID D^2) [F/L^2] (Lacy 1989, "Data Input and Parameters").
  double overburden() const { return block_mass * gravity / (wall_discs * diameter * diameter); }
  /// How long two of its discs touch [T]: (pi/2) (sqrt(m/(2 K1)) + sqrt(m/(2 K2))) (Walton & Braun 1986).
  double contact_time() const;
};

/// Its walls among DiscShapes::walls, as wall_force() takes them.
inline constexpr std::size_t base_wall = 1, block_wall = 2;

/// Discs, walls and first velocities: base at y = 0, free discs in a rectangular array above it with velocities along x
/// that grow linearly with height to the block's, small random ones along y; block on top. What the thesis leaves open
/// is ours: the array is spread over the width, rows are as far apart as columns but at least 1.05 D, random
/// velocities are within a hundredth of the block's speed.
/// Errors: InputError for what lies outside the ranges above.
struct FilledCell {
  DiscShapes shapes;
  Discs discs;
  PeriodicBox box;
};
[[nodiscard]] FilledCell fill(const ShearCell& cell);

/// Depth of the field: between the centre lines of base and block, less one diameter [L].
[[nodiscard]] double depth(const ShearCell& cell, const Discs& discs);
/// Area of the free discs over that of the field.
[[nodiscard]] double solid_fraction(const ShearCell& cell, const Discs& discs);

/// Stresses on the walls, means over time weighed by the length of the steps [F/L^2], as overburden(): on the area
/// TWID D^2. S along the motion of the block, with the sign of what the block drags; N pressing outwards.
struct WallStress {
  double shear{};
  double normal{};
};
/// Of the forces at the last evaluation.
[[nodiscard]] WallStress block_stress(const ShearCell& cell, const DiscSystem<LatchingSpring>& system);
[[nodiscard]] WallStress base_stress(const ShearCell& cell, const DiscSystem<LatchingSpring>& system);

}  // namespace talus
