#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "solver/base/vec.hpp"
#include "solver/granular/neighbour_list.hpp"
#include "solver/laws/coulomb_friction.hpp"
#include "solver/laws/latching_spring.hpp"
#include "solver/laws/linear_spring_dashpot.hpp"

namespace talus {

/// Pairs in the order of the neighbour list, and behind them as many of places that are nowhere as fill the lanes.
struct SweptPairs {
  std::vector<std::uint32_t> first, second;  ///< where the places begin; of a second disc across a border, its ghost's
  std::vector<std::uint32_t> listed;         ///< numbers in the list; none if they are all of it
  std::vector<double> radii;                 ///< their sum, if discs are unlike [L]
  std::size_t count{};

  /// Makes room for a whole list of so many, of unlike discs or like ones.
  void list(std::size_t size, bool unlike);
  /// Takes those with these numbers from a whole list behind its own.
  void take(const SweptPairs& list, std::span<const std::uint32_t> numbers);
  /// Fills the lanes behind the last pair, wherever packs begin. nowhere: where that place begins.
  void fill_up(std::uint32_t nowhere);

 private:
  void resize(std::size_t size, bool near, bool unlike);
};

/// Pairs that a sweep found touching, in their order, with what their contacts remember; behind them one whose number
/// no pair has.
struct TouchingPairs {
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  std::vector<std::uint32_t> pair{none};  ///< numbers in the list that is swept
  std::vector<double> largest;            ///< overlap since the touch, of laws that remember it [L]
  std::vector<double> stretch;            ///< of the spring of friction [L]
  std::vector<double> normal;             ///< force of the law, where it pushes [F]; < 0: the contact is new
  std::vector<double> power, released;    ///< what the law keeps, of laws without memory (settled.hpp) [F L/T, F L]
  std::vector<double> slid;               ///< what friction dissipates [F L]
  std::size_t count{};

  /// Of a law that remembers or not, with friction or without; what they keep only where it is asked for.
  void resize(std::size_t size, bool remembers, bool turns, bool keeps) {
    pair.resize(size, none);
    if (remembers) largest.resize(size);
    if (turns) stretch.resize(size);
    if (turns || keeps) normal.resize(size);
    if (keeps && !remembers) power.resize(size), released.resize(size);
    if (keeps && turns) slid.resize(size);
  }
};

/// A contact that has ended, of a law that remembers or with friction.
struct PartedPair {
  std::uint32_t pair{};         ///< number in the whole list
  double largest{}, stretch{};  ///< [L]
};

/// A force on a wall, from one of its contacts.
struct WallPush {
  std::size_t wall{};
  Vec2 force;  ///< [F]
};

/// What the first discs of pairs do to the second.
struct DiscPushes {
  std::vector<std::uint32_t> first, second;    ///< where the places begin
  std::vector<double> x, y;                    ///< force on the second [F]
  std::vector<double> friction, arm_a, arm_b;  ///< turns both [F], at [L]
  std::size_t count{};
};

/// What a sweep works on, as FastDiscSystem lays it out: some of the discs, which nobody else moves meanwhile, and
/// pairs of them.
struct DiscSweep {
  double kick{}, drift{};  ///< how long velocities change, and places [T]; 0: not at all
  NeighbourList::Flow flow{};
  double* places{};                         ///< x, y of discs, ghosts, and of one that is nowhere [L]
  double *velocities{}, *spins{};           ///< of discs [L/T, 1/T]; no spins if they do not turn
  const double *before{}, *spins_before{};  ///< of all places, and of discs, before the kick; null if not needed
  std::size_t discs{};                      ///< of all
  std::size_t begin{}, end{};               ///< those of this sweep
  const std::uint32_t* ghost_disc{};        ///< whose image each ghost is
  const std::uint8_t* ghost_image{};        ///< which image
  const NeighbourList::Shift* shifts{};     ///< by image

  const double *inverse_mass{}, *radius{}, *per_mass{};  ///< of discs: [1/M], [L], 1/(inertia) over 1/mass [1/L^2]
  std::size_t unlike_mass{}, unlike_radius{};            ///< all bits; 0 if the first number is that of all
  double equal_radii{};                                  ///< sum of two, if all are equal [L]
  const std::uint32_t* wall{};                           ///< of discs; null if there are none

  const SweptPairs* pairs{};
  bool touched_as_listed{};              ///< those of the last sweep have their numbers in the whole list
  const TouchingPairs* touched{};        ///< in the last sweep
  TouchingPairs* touching{};             ///< is filled
  std::vector<PartedPair>* parted{};     ///< is added to
  std::vector<WallPush>* wall_pushes{};  ///< is added to
  const DiscPushes* outgoing{};          ///< of pairs whose first disc is of this sweep and whose second is not
  bool keeps{};                          ///< whether `touching` and `parted` are to tell what contacts keep
};

/// Pairs that are worked on together: to where lists of them are filled.
inline constexpr std::size_t sweep_block = 256;

/// Numbers of the pairs from <= k < to whose surfaces are nearer than so much; how many. At most sweep_block are asked
/// for at once; beyond those found, `found` is written to up to a pack further.
std::size_t find_near(const DiscSweep& sweep, double nearer, std::size_t from, std::size_t to, std::uint32_t* found);

/// What the pairs do to each other, without doing it.
void find_pushes(const LinearSpringDashpot&, const Frictionless&, const DiscSweep&, DiscPushes&);
void find_pushes(const LinearSpringDashpot&, const CoulombFriction&, const DiscSweep&, DiscPushes&);
void find_pushes(const LatchingSpring&, const Frictionless&, const DiscSweep&, DiscPushes&);
void find_pushes(const LatchingSpring&, const CoulombFriction&, const DiscSweep&, DiscPushes&);

/// Kicks the discs and, if they do not turn, drifts them, whichever has a length other than 0; the largest square of
/// the own speeds of those that have moved.
double sweep_discs(const LinearSpringDashpot&, const Frictionless&, const DiscSweep&);
double sweep_discs(const LinearSpringDashpot&, const CoulombFriction&, const DiscSweep&);
double sweep_discs(const LatchingSpring&, const Frictionless&, const DiscSweep&);
double sweep_discs(const LatchingSpring&, const CoulombFriction&, const DiscSweep&);

/// Gives second discs that are of this sweep what others' first discs do to them.
void receive(const DiscSweep& sweep, const DiscPushes& pushes);

/// Stretches the springs of friction over the drift, before the discs move.
void stretch_contacts(const DiscSweep& sweep);

/// Moves the discs; the largest square of their own speeds.
double move_discs(const DiscSweep& sweep);

}  // namespace talus
