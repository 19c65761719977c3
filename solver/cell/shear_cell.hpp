#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "solver/base/fields.hpp"
#include "solver/granular/discs.hpp"
#include "solver/granular/periodic_box.hpp"
#include "solver/laws/law_list.hpp"

namespace talus {

/// The shear cell of SNOFLO (Lacy 1989, chapter 3): discs between a base and a block, both of them rows of touching
/// discs; the block has a mass and a weight and is driven along x; the field is periodic along x. The names of
/// CNTRL.DAT are given with the members. Gravity acts on the block alone.
struct ShearCell {
  DiscLaw law;           ///< in 1989 a latching spring with K1 and K2
  double diameter{};     ///< D [L] > 0
  double mass{};         ///< M of a disc [M] > 0
  double gravity{};      ///< G [L/T^2] >= 0
  double block_mass{};   ///< MTOP [M] > 0
  int rows{};            ///< NHT > 0, rows of the array in which the free discs start
  int columns{};         ///< NWID of that array, in [1, TWID]
  int wall_discs{};      ///< TWID >= 3, discs in the base and in the block
  double block_speed{};  ///< VXT along x [L/T]
  std::uint64_t seed{};  ///< of the initial velocities along y
  /// Friction between discs, if any; free discs then turn, each with the inertia of a solid disc, but wall discs do
  /// not.
  std::optional<DiscFriction> friction{};
  double impact_speed{};  ///< see nominal_speed() [L/T] >= 0; 0: the shear velocity of the start

  double width() const { return wall_discs * diameter; }
  static constexpr std::size_t maximum_discs = 10'000'000;  ///< maximum number of free discs

  std::size_t free_discs() const { return static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns); }
  /// Overburden by the thesis's definition, MTOP G/(TWID D^2) [F/L^2] (Lacy 1989, "Data Input and Parameters").
  double overburden() const { return block_mass * gravity / (wall_discs * diameter * diameter); }
  /// Whether the law is linear in every mode: its slow impacts have a duration.
  bool is_linear() const;
  /// Speed of approach for which the impacts of the cell are stated [L/T]: 0, the limit of slow impacts, for linear
  /// laws. Contacts by other laws are the longer the slower they are, without a limit, and need a speed:
  /// `impact_speed`, or the difference of speed between neighbouring rows at the start, |VXT|/(NHT + 1). This is the
  /// shear rate times the distance of the rows, the scale of the speeds at which a shear flow drives discs against each
  /// other. A contact time hardly depends on the choice: by Hertz's law it decreases as v^(-1/5), by a factor of 1.6
  /// for 10 times the speed, while a contact must have 10 steps, of which a leapfrog needs 2 to be stable. A
  /// restitution that depends on the speed is that of this one.
  double nominal_speed() const;
  /// The overlap at which stiffnesses of laws that are not linear are stated [L]: the largest of an impact of two discs
  /// at the nominal speed, or if it is larger, that under the weight of the block on one of its discs; at most a
  /// diameter.
  double nominal_overlap() const;
  /// Stiffness of a contact while it loads: K1, or k_n [F/L]; of other laws F/d at the nominal overlap.
  double stiffness() const;
  /// Stiffness of the contact's stiffest branch: K2 of a slow impact, or k_n [F/L]; of other laws dF/dd at the nominal
  /// overlap.
  double largest_stiffness() const;
  /// Tangential stiffness of a contact that sticks [F/L]: k_s; of friction whose stiffness varies, at the nominal
  /// overlap. Only of a cell with friction.
  double shear_stiffness() const;
  /// Frequency of two discs in contact while they load [rad/T]: w1 = sqrt(2 K1/m).
  double loading_frequency() const;
  /// Duration of an impact of two of its discs at the nominal speed [T], by the law.
  double contact_time() const;
  /// Ratio of speeds after and before a head-on impact of two of its discs at the nominal speed, by the law.
  double restitution() const;
  /// The law, if it is that of 1989: a latching spring with zero growth, without friction; else null.
  const LatchingSpring* law_of_1989() const;
  /// Density of the material, for discs as thick as they are wide: M/(pi D^3/4) [M/L^3].
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

/// Validation error of a field. The message continues after the field's name: "found 3; it must be ...".
struct CellError {
  std::string field;  ///< name in fields() or counts(), or of a parameter of the law
  std::string message;
};
/// All errors that prevent a cell from being filled; empty if there are none.
[[nodiscard]] std::vector<CellError> validation_errors(const ShearCell& cell);

/// Talus's choice of a cell in SI units, because the thesis's values are not known: 80 discs of ice of 1 mm, e = 0.7, 8
/// rows of 10 between walls of 11, the block driven at `speed` diameters per second under `overburden` [Pa].
[[nodiscard]] ShearCell ice_cell(double overburden, double speed, std::uint64_t seed = 1);

/// Wall numbers of base and block, as in DiscShapes::wall and for wall_force().
inline constexpr std::size_t base_wall = 1, block_wall = 2;

/// Discs, walls and initial velocities: the base at y = 0; above it the free discs in a rectangular array, with
/// velocities along x that grow linearly with height to the block's, and small random ones along y; the block on top.
/// Details that the thesis leaves open are chosen here: the array is spread over the width, rows are as far apart as
/// columns but at least 1.05 D, random velocities are within 1 % of the block's speed.
/// Errors: InputError for parameters outside the ranges above.
struct FilledCell {
  DiscShapes shapes;
  Discs discs;
  PeriodicBox box;
};
[[nodiscard]] FilledCell fill(const ShearCell& cell);

/// Index of the block's first disc: after the free discs and the base's.
[[nodiscard]] std::size_t first_block_disc(const ShearCell& cell);
/// Depth of the field: between the centre lines of base and block, less one diameter [L].
[[nodiscard]] double depth(const ShearCell& cell, const Discs& discs);
/// Area of the free discs over that of the field.
[[nodiscard]] double solid_fraction(const ShearCell& cell, const Discs& discs);

/// How far a list of the cell's pairs reaches beyond contact [L]: from the table of list_skin.hpp, limited in a narrow
/// field so that no disc meets two images of another.
[[nodiscard]] double cell_skin(const ShearCell& cell);

/// Six-fold order of the free discs: the mean over them of |sum exp(6 i angle)|/n over the n discs of any kind within
/// 1.3 D of their centre; 1 in a perfect triangular array, 0 for a disc with fewer than three neighbours (Nelson &
/// Halperin 1979).
[[nodiscard]] double sixfold_order(const ShearCell& cell, const FilledCell& filled, const Discs& discs);

}  // namespace talus
