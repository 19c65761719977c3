#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "solver/granular/neighbour_list.hpp"
#include "solver/granular/shear_cell.hpp"
#include "solver/laws/latching_spring.hpp"

namespace talus::bench {

/// The shear cell by a loop that is written for it alone: discs of one size with latching springs, without friction,
/// one thread, each listed pair looked at in each step, walls by the numbers of their discs. To the bits of
/// FastDiscSystem: what that one takes beyond this is the price of what else it can do.
class BareCell {
 public:
  BareCell(const ShearCell& cell, const FilledCell& start, double skin);

  void begin(Discs& discs) { list(discs); }
  void advance(Discs& discs, double h, long steps);

 private:
  void list(Discs& discs);
  void load(const Discs& discs);
  void store(Discs& discs) const;
  /// Where the place of the disc begins that is, or whose image is, there.
  std::size_t own(std::size_t place) const {
    return place < velocities_.size() ? place : ghosts_[(place - velocities_.size()) / 2];
  }
  void place_ghosts();
  std::size_t find_touching();
  void push(std::size_t count);
  void give(std::size_t count);

  DiscShapes shapes_;
  NeighbourList list_;
  LatchingSpring law_;
  double diameter_, block_mass_, gravity_;
  std::size_t base_, block_;                           ///< where the places of their discs begin
  std::vector<double> places_, velocities_;            ///< x, y of discs; of ghosts, and of one that is nowhere
  std::vector<double> impulses_;                       ///< of a force of 1, twice each disc [T/M]
  std::vector<std::uint32_t> ghosts_;                  ///< where the places of their discs begin
  std::vector<double> shifts_;                         ///< of ghosts, along x [L]
  std::vector<std::uint32_t> first_, second_;          ///< where the places of pairs begin
  std::vector<double> largest_;                        ///< overlap of pairs that touch [L], else 0
  std::vector<std::uint64_t> touched_, touching_now_;  ///< bytes of eight pairs: whether they did in the last step, do
  std::vector<std::uint32_t> touching_;                ///< numbers of pairs
  std::vector<double> forces_;                         ///< on their second discs: x, y of each [F]
  double force_on_block_{};                            ///< along y [F]
};

}  // namespace talus::bench
