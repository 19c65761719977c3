#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "solver/base/vec.hpp"
#include "solver/granular/neighbour_list.hpp"
#include "solver/granular/swept_pairs.hpp"

namespace talus {

/// What the first discs of pairs do to the second.
struct PairForces {
  std::vector<std::uint32_t> first, second;    ///< where the places begin
  std::vector<double> force;                   ///< on the second: x, y of each [F]
  std::vector<double> friction, arm_a, arm_b;  ///< turns both [F], at [L]
  std::size_t count{};
};

/// Discs of a wall that follow each other.
struct WallDiscs {
  std::size_t wall{}, begin{}, end{};
};

/// What a sweep works on, as FastDiscSystem lays it out: some of the discs, which nobody else moves meanwhile, and
/// pairs of them.
struct StepBlock {
  bool kicks{};    ///< whether velocities change, by impulse_per_force
  double drift{};  ///< how long places change [T]; 0: not at all
  double reach{};  ///< how far apart surfaces may be where they touch, as the law understands it [L]
  NeighbourList::Flow flow{};
  double* places{};                         ///< x, y of discs, ghosts, and of one that is nowhere [L]
  double *velocities{}, *spins{};           ///< of discs [L/T, 1/T]; no spins if they do not turn
  const double *before{}, *spins_before{};  ///< of all places, and of discs, before the kick; null if not needed
  std::size_t discs{};                      ///< of all
  std::size_t begin{}, end{};               ///< those of this sweep
  std::span<const WallDiscs> later;         ///< in order: of them those that do not move with the sweep
  const std::uint32_t* ghost_disc{};        ///< whose image each ghost is
  const std::uint8_t* ghost_image{};        ///< which image
  const NeighbourList::Shift* shifts{};     ///< by image

  const double* impulse_per_force{};           ///< of discs, twice each: the kick over the mass [T/M]
  const double *radius{}, *per_mass{};         ///< of discs: [L], 1/(inertia) over 1/mass [1/L^2]
  std::size_t unlike_mass{}, unlike_radius{};  ///< all bits; 0 if the first number is that of all
  double equal_radii{};                        ///< sum of two, if all are equal [L]
  const std::uint32_t* wall{};                 ///< of discs
  std::size_t first_wall{};                    ///< no disc of a wall has its place before this

  const SweptPairs* pairs{};
  SweptContacts* contacts{};          ///< of these pairs
  std::vector<PartedPair>* parted{};  ///< is added to
  std::vector<Vec2>* wall_pushes{};   ///< of each wall are added to: forces of its contacts [F]
  const PairForces* outgoing{};       ///< of pairs whose first disc is of this sweep and whose second is not
};

}  // namespace talus
