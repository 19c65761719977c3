#pragma once

#include <cstddef>
#include <cstdint>

#include "solver/base/vec.hpp"
#include "solver/granular/neighbour_list.hpp"
#include "solver/laws/latching_spring.hpp"
#include "solver/laws/linear_spring_dashpot.hpp"

namespace talus {

/// What a contact remembers: of two arrays each touch would fetch a line of the cache.
struct DiscContactPast {
  double largest{};       ///< overlap [L], as of
  std::uint64_t sweep{};  ///< the last sweep that found the pair touching
};

/// What a sweep over discs works on, as FastDiscSystem lays it out: numbers of pairs come in whole packs. A place
/// begins at places[first[k]] with its x.
struct DiscSweep {
  double kick{}, drift{};  ///< how long velocities change, and places [T]; 0: not at all
  NeighbourList::Flow flow{};
  double* places{};        ///< x, y of discs, ghosts, and of one that is nowhere [L]
  double* velocities{};    ///< of discs [L/T]
  const double* before{};  ///< of all places before the kick [L/T]; null if the law needs no rates
  std::size_t discs{};
  const std::uint32_t* ghost_disc{};  ///< whose image each ghost is

  std::size_t pairs{};                      ///< with those that fill the last pack, which are nowhere
  const std::uint32_t *first{}, *second{};  ///< where their places begin
  const std::uint32_t* listed{};            ///< number in `pasts`; null: their own
  const double* radii{};                    ///< sum of two [L]; null if all are
  double equal_radii{};                     ///< [L]

  const double* inverse_mass{};  ///< of discs [1/M]
  std::size_t unlike{};          ///< all bits; 0 if the first mass is that of all
  const std::size_t* wall{};     ///< of discs; null if there are none
  Vec2* wall_forces{};           ///< are added to [F]

  DiscContactPast* pasts{};  ///< of the listed pairs
  std::uint64_t now{};       ///< number of this sweep
};

/// Pairs that are worked on together: to where lists of them are filled.
inline constexpr std::size_t sweep_block = 256;

/// Numbers of the pairs from <= k < to whose surfaces are nearer than so much; how many. At most sweep_block are asked
/// for at once; beyond those found, `found` is written to up to a pack further.
std::size_t find_near(const DiscSweep& sweep, double nearer, std::size_t from, std::size_t to, std::uint32_t* found);

/// Kicks and drifts all discs, whichever has a length other than 0; the largest square of their own speeds.
double sweep_discs(const LinearSpringDashpot& law, const DiscSweep& sweep);
double sweep_discs(const LatchingSpring& law, const DiscSweep& sweep);

}  // namespace talus
