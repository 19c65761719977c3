#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "solver/base/vec.hpp"
#include "solver/granular/neighbour_list.hpp"
#include "solver/granular/swept_pairs.hpp"

namespace talus {

/// Forces of the first discs of pairs on the second.
struct PairForces {
  std::vector<std::uint32_t> first, second;    ///< index of the disc's x in StepBlock::positions
  std::vector<double> force;                   ///< on the second disc: x, y of each pair [F]
  std::vector<double> friction, arm_a, arm_b;  ///< friction, which turns both discs [F], and its lever arms [L]
  std::size_t count{};
};

/// Consecutive discs of one wall: [begin, end).
struct WallDiscs {
  std::size_t wall{}, begin{}, end{};
};

/// Input of a sweep, laid out by FastDiscEngine: a block of discs, which no other thread moves meanwhile, and pairs of
/// them.
struct StepBlock {
  bool kicks{};    ///< whether velocities change, by impulse_per_force
  double drift{};  ///< duration of the drift [T]; 0: none
  double reach{};  ///< largest gap of surfaces at which the law acts [L]
  NeighbourList::Flow flow{};
  double* positions{};                      ///< x, y of discs, of ghosts and of one padding entry (NaN) [L]
  double *velocities{}, *spins{};           ///< of discs [L/T, 1/T]; spins is null if they do not turn
  const double *before{}, *spins_before{};  ///< before the kick: of discs and ghosts, and spins; null if not needed
  std::size_t discs{};                      ///< number of all discs
  std::size_t begin{}, end{};               ///< discs of this block
  std::span<const WallDiscs> later;         ///< wall discs that move after the sweep, in order
  const std::uint32_t* ghost_disc{};        ///< disc of which each ghost is an image
  const std::uint8_t* ghost_image{};        ///< its image code
  const NeighbourList::Shift* shifts{};     ///< by image code

  const double* impulse_per_force{};    ///< of discs, each twice: duration of the kick over mass [T/M]
  const double *radius{}, *per_mass{};  ///< of discs: [L], 1/(inertia) over 1/mass [1/L^2]
  std::size_t per_disc_mass{},
      per_disc_radius{};        ///< index masks: all bits set, or 0 if all discs have the first value
  double equal_radii{};         ///< sum of two radii, if all are equal [L]
  const std::uint32_t* wall{};  ///< wall number of each disc
  std::size_t first_wall{};     ///< index in `positions` before which no disc belongs to a wall

  const SweptPairs* pairs{};
  SweptContacts* contacts{};           ///< contacts of these pairs
  std::vector<EndedContact>* ended{};  ///< contacts that have ended are appended
  std::vector<Vec2>* wall_forces{};    ///< by wall: forces of its contacts are appended [F]
  const PairForces* outgoing{};        ///< forces of pairs with only the first disc in this block
};

}  // namespace talus
