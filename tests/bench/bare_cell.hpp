#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "solver/cell/shear_cell.hpp"
#include "solver/granular/neighbour_list.hpp"
#include "solver/granular/step_block.hpp"
#include "solver/granular/swept_pairs.hpp"
#include "solver/laws/latching_spring.hpp"

namespace talus::bench {

/// The shear cell by a loop that is written for it alone: discs of one size with latching springs, without friction,
/// one thread, walls by the numbers of their discs. The law is asked of all pairs of a near list, of which a third
/// touch: what they remember stays in its place, and no pair is looked up. To the bits of FastDiscSystem: what that one
/// takes beyond this is the price of what else it can do.
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
  /// All discs, to be moved so long.
  StepBlock all(double drift);
  void place_ghosts();
  void prune();
  std::size_t push();
  void give(std::size_t touching);

  DiscShapes shapes_;
  NeighbourList list_;
  LatchingSpring law_;
  double diameter_, block_mass_, gravity_, reach_;
  std::size_t base_, block_;                 ///< where the places of their discs begin
  std::vector<double> places_, velocities_;  ///< x, y of discs; of ghosts, and of one that is nowhere
  double impulse_{};                         ///< of a force of 1 on a disc that is free [T/M]
  std::vector<std::uint32_t> ghosts_;        ///< where the places of their discs begin
  std::vector<double> shifts_;               ///< of ghosts, along x [L]
  SweptPairs listed_, near_;
  double used_{};                        ///< of the reach [L]
  std::vector<double> kept_;             ///< between two near lists what listed pairs remember [L]
  std::vector<double> largest_;          ///< overlap of near pairs that touch [L], else 0
  std::vector<double> forces_;           ///< of near pairs on their second discs: x, y of each [F]
  std::vector<std::uint32_t> touching_;  ///< numbers of near pairs
  double force_on_block_{};              ///< along y [F]
};

}  // namespace talus::bench
