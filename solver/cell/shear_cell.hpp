#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "solver/base/fields.hpp"
#include "solver/granular/discs.hpp"
#include "solver/granular/periodic_box.hpp"
#include "solver/laws/coulomb_friction.hpp"
#include "solver/laws/law_list.hpp"

namespace talus {

/// The shear cell of SNOFLO (Lacy 1989, chapter 3): discs between a base and a block, both rows of touching discs, the
/// block with a mass and a weight and driven along x, the field periodic along x. The names of CNTRL.DAT stand beside.
/// Gravity acts on the block alone.
struct ShearCell {
  DiscLaw law;           ///< of 1989: a latching spring, K1 and K2
  double diameter{};     ///< D [L] > 0
  double mass{};         ///< M of a disc [M] > 0
  double gravity{};      ///< G [L/T^2] >= 0
  double block_mass{};   ///< MTOP [M] > 0
  int rows{};            ///< NHT of the array that the free discs start in > 0
  int columns{};         ///< NWID of it, in [1, TWID]
  int wall_discs{};      ///< TWID in the base and in the block >= 3
  double block_speed{};  ///< VXT along x [L/T]
  std::uint64_t seed{};  ///< of the first velocities along y
  /// Where discs rub each other, and then turn, each as a solid disc does; those of the walls do not turn.
  std::optional<CoulombFriction> friction{};

  double width() const { return wall_discs * diameter; }
  static constexpr std::size_t most_discs = 10'000'000;  ///< free ones

  std::size_t free_discs() const { return static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns); }
  /// Overburden by the thesis's definition, MTOP G/(TWID D^2) [F/L^2] (Lacy 1989, "Data Input and Parameters").
  double overburden() const { return block_mass * gravity / (wall_discs * diameter * diameter); }
  /// Stiffness of a contact that is pressed: K1, or k_n [F/L].
  double stiffness() const;
  /// Stiffness of its stiffest branch: K2 of a slow impact, or k_n [F/L].
  double largest_stiffness() const;
  /// Of two discs that touch, while they load [rad/T]: w1 = sqrt(2 K1/m).
  double loading_frequency() const;
  /// How long a slow impact of two of its discs lasts [T], by the law.
  double contact_time() const;
  /// Ratio of speeds after and before a slow head-on impact of two of its discs, by the law.
  double restitution() const;
  /// Its law, if it is that of 1989: a latching spring that does not grow stiffer, without friction; else null.
  const LatchingSpring* law_of_1989() const;
  /// Of the material, discs as thick as they are wide: M/(pi D^3/4) [M/L^3].
  double density() const;

  static constexpr std::array<Field<ShearCell>, 5> fields() {
    return {{{"diameter", dimension::length, &ShearCell::diameter, Range::positive, "diameter D of a disc"},
             {"mass", dimension::mass, &ShearCell::mass, Range::positive, "mass M of a disc"},
             {"gravity", dimension::acceleration, &ShearCell::gravity, Range::non_negative,
              "acceleration of free fall G, which acts on the block alone"},
             {"block_mass", dimension::mass, &ShearCell::block_mass, Range::positive, "mass MTOP of the block"},
             {"block_speed", dimension::velocity, &ShearCell::block_speed, Range::any,
              "speed VXT at which the block is driven along x"}}};
  }
  static constexpr std::array<CountField<ShearCell>, 3> counts() {
    return {{{"rows", &ShearCell::rows, 1, 100'000, "rows NHT of the array that the free discs start in"},
             {"columns", &ShearCell::columns, 1, 100'000, "columns NWID of it, at most as many as wall_discs"},
             {"wall_discs", &ShearCell::wall_discs, 3, 100'000, "discs TWID in the base and in the block"}}};
  }
};

/// What is wrong with a field, as a message goes on after its name: "found 3; it must be ...".
struct CellError {
  std::string field;  ///< name among fields() and counts(), or of the law's
  std::string words;
};
/// All that keeps a cell from being filled.
[[nodiscard]] std::vector<CellError> validation_errors(const ShearCell& cell);

/// Talus's own choice of a cell in SI units, for the thesis's numbers are not known: 80 discs of ice of a millimetre,
/// e = .7, 8 rows of 10 between walls of 11, the block driven at `speed` diameters a second under `overburden` [Pa].
[[nodiscard]] ShearCell ice_cell(double overburden, double speed, std::uint64_t seed = 1);

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

/// Where the block's discs begin among the discs: after the free ones and the base's.
[[nodiscard]] std::size_t first_block_disc(const ShearCell& cell);
/// Depth of the field: between the centre lines of base and block, less one diameter [L].
[[nodiscard]] double depth(const ShearCell& cell, const Discs& discs);
/// Area of the free discs over that of the field.
[[nodiscard]] double solid_fraction(const ShearCell& cell, const Discs& discs);

/// How far beyond contact a list of the cell's pairs is to reach [L]: as the table says (list_skin.hpp), in a narrow
/// field as far as a disc meets no two images of another.
[[nodiscard]] double cell_skin(const ShearCell& cell);

/// How well the free discs stand in six-fold order: the mean over them of |sum exp(6 i angle)|/n over the n discs of
/// any kind within 1.3 D of their centre; 1 in a perfect triangular array, 0 for one with fewer than three (Nelson &
/// Halperin 1979).
[[nodiscard]] double sixfold_order(const ShearCell& cell, const FilledCell& filled, const Discs& discs);

}  // namespace talus
