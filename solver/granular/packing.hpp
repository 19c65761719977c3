#pragma once

#include <cstddef>
#include <cstdint>

#include "solver/granular/discs.hpp"
#include "solver/granular/periodic_box.hpp"

namespace talus {

/// Discs to be packed into a rectangle that is periodic along x, and along y unless it is between two walls.
struct PackingPlan {
  std::size_t discs{};      ///< number of free discs > 0
  double diameter{};        ///< of the middle size [L] > 0
  double spread{};          ///< diameters are uniformly distributed over diameter (1 -+ spread); in [0, 0.9]
  double mass{};            ///< of a disc of the middle size [M] > 0; of others in proportion to their areas
  double solid_fraction{};  ///< area of the free discs over the rectangle's, in (0, 0.9]
  double aspect{1.0};       ///< height over width of the rectangle > 0; between walls, approximate
  bool walls{};             ///< held rows of touching discs of the middle size, below and above
  std::uint64_t seed{};     ///< of random sizes and positions
};

/// Discs at rest, none of which overlap. The rectangle is centred at the origin. The surfaces of walls touch it from
/// outside; wall discs come last, those below first.
struct Packing {
  DiscShapes shapes;
  Discs discs;
  PeriodicBox box;
  double width{}, height{};  ///< of the rectangle [L]
};

/// Random sequential packing: places discs one after the other at random where there is room. Equal discs reach solid
/// fractions of about 0.5 (their random sequential adsorption ends at 0.547; Feder 1980).
/// Errors: InputError for parameters outside the ranges above, if a disc is so large that it would touch its own image,
/// and if a disc has not found room at 20000 positions.
[[nodiscard]] Packing scatter(const PackingPlan& plan);

/// Packing by growth: discs are scattered at a solid fraction of 0.2 and grow while they move and collide, as those of
/// Lubachevsky & Stillinger 1990, but with soft contacts. Remaining overlaps are then pushed apart by damped contacts
/// between discs that are 0.1 % larger. Equal discs order themselves and reach 0.84; those of a spread of 0.2 reach
/// 0.82 without order.
/// Errors: as scatter(), and InputError if the discs cannot be pushed apart.
[[nodiscard]] Packing grow(const PackingPlan& plan);

/// Minimum over pairs of the distance of the centres over the sum of the radii: below 1 discs overlap. At most 1.1:
/// pairs that are further apart are not considered.
[[nodiscard]] double closest(const Packing& packing);

/// Gives the free discs random velocities. Each component is distributed as the sum of twelve uniform random numbers,
/// which is nearly Gaussian. The momentum is zero, and the granular temperature m <v^2>/2 is exactly `temperature`
/// [F L] >= 0.
/// Errors: InputError for a temperature above 0 with fewer than two free discs.
void agitate(Packing& packing, double temperature, std::uint64_t seed);

}  // namespace talus
