#pragma once

#include <cstddef>
#include <vector>

/// A shear cell as the thesis of 1989 describes its program (Lacy 1989, "Virtual Elements and Periodic Boundaries"):
/// each disc has a virtual image in the field to the left of the real one, which represents it across the border, and
/// every disc is tested against every other. Semi-implicit Euler steps; latching springs (Walton & Braun 1986) whose
/// largest overlaps are stored in a table of all pairs.
namespace talus::verification::reference {

struct VirtualDiscs {
  double k1{}, k2{};           ///< [F/L]
  double diameter{}, mass{};   ///< of all discs [L], [M]
  double left{}, width{};      ///< of the field, [left, left + width) [L]
  double gravity{};            ///< on the block [L/T^2]
  double block_mass{};         ///< [M]
  std::size_t free{}, wall{};  ///< free discs come first, then the `wall` discs of the base, then those of the block
  std::vector<double> x, y, vx, vy;
  std::vector<double> largest{};  ///< largest overlap of each pair since it touched; filled by the first step

  /// One step: forces at the present positions, then velocities, then positions.
  void step(double h);

  double force_on_block_x{}, force_on_block_y{};  ///< at the start of the last step [F]
  double force_on_base_x{}, force_on_base_y{};
  double lost{};  ///< energy dissipated by the contacts so far [F L]

  /// A pair with a force: at the start of the last step, disc a pushes disc b with `force` > 0 [F] along (dx, dy), from
  /// the centre of a to the image of b that it touches [L].
  struct Contact {
    std::size_t a{}, b{};
    double force{}, overlap{};
    double dx{}, dy{};
  };
  std::vector<Contact> contacts{};
};

}  // namespace talus::verification::reference
