#pragma once

#include <cstddef>
#include <cstdint>

#include "solver/granular/discs.hpp"
#include "solver/granular/periodic_box.hpp"

namespace talus {

/// Discs to be packed into a rectangle that repeats itself along x, and along y or between two walls.
struct PackingPlan {
  std::size_t discs{};      ///< free ones > 0
  double diameter{};        ///< of the middle size [L] > 0
  double spread{};          ///< diameters are evenly spread over diameter (1 -+ spread); in [0, .9]
  double mass{};            ///< of a disc of the middle size [M] > 0; of others as their areas
  double solid_fraction{};  ///< area of the free discs over the rectangle's, in (0, .9]
  double aspect{1.0};       ///< height over width of the rectangle > 0; between walls, nearly
  bool walls{};             ///< below and above, rows of touching discs of the middle size, which are held
  std::uint64_t seed{};     ///< of sizes and places
};

/// Discs at rest, none of which overlap. The rectangle has its middle at the origin. Walls touch it from outside with
/// their surfaces; their discs come last, those below first.
struct Packing {
  DiscShapes shapes;
  Discs discs;
  PeriodicBox box;
  double width{}, height{};  ///< of the rectangle [L]
};

/// Discs put one after the other at random where there is room. Equal discs reach solid fractions of about .5 (their
/// random sequential adsorption ends at .547; Feder 1980).
/// Errors: InputError for what lies outside the ranges above, if a disc is so large that it would touch its own image,
/// and if one has found no room in 20000 places.
[[nodiscard]] Packing scatter(const PackingPlan& plan);

/// Discs that grow from a scattered fifth-filled rectangle on while they fly about and collide, as those of Lubachevsky
/// & Stillinger 1990, but with soft contacts. What overlap is left is then pushed apart by damped contacts, which
/// reach a thousandth farther than the discs. Equal discs order themselves and reach .84; those of a spread of .2 reach
/// .82 without order.
/// Errors: as scatter(), and InputError if the discs cannot be pushed apart.
[[nodiscard]] Packing grow(const PackingPlan& plan);

/// The least distance of two centres over the sum of the radii: below 1 discs overlap. At most 1.1: what is further
/// apart is not looked at.
[[nodiscard]] double closest(const Packing& packing);

/// Gives the free discs random velocities, those of each direction distributed as sums of twelve even ones, which is
/// nearly a Gaussian distribution; without momentum, and exactly of that granular temperature, m <v^2>/2 [F L] >= 0.
/// Errors: InputError for a temperature above 0 of fewer than two free discs.
void agitate(Packing& packing, double temperature, std::uint64_t seed);

}  // namespace talus
