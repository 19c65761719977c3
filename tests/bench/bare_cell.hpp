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

/// The shear cell by a loop written for it alone: discs of one size with latching springs, without friction, one
/// thread, walls identified by the numbers of their discs. The law is evaluated for all pairs of a near list, a third
/// of which are in contact: their history stays in its array, and no pair is looked up. Bit-identical to
/// FastDiscSystem: the additional time of FastDiscSystem is the cost of its generality.
class BareCell {
 public:
  BareCell(const ShearCell& cell, const FilledCell& start, double skin);

  void begin(Discs& discs) { list(discs); }
  void advance(Discs& discs, double h, long steps);

 private:
  void list(Discs& discs);
  void load(const Discs& discs);
  void store(Discs& discs) const;
  /// Index of the x coordinate of the disc that is at, or has its ghost at, this index.
  std::size_t own(std::size_t index) const {
    return index < velocities_.size() ? index : ghosts_[(index - velocities_.size()) / 2];
  }
  /// A block of all discs that drift for this time.
  StepBlock all(double drift);
  void set_ghosts();
  void prune();
  std::size_t push();
  void give(std::size_t touching);

  DiscShapes shapes_;
  NeighbourList list_;
  LatchingSpring law_;
  double diameter_, block_mass_, gravity_, reach_;
  std::size_t base_, block_;                    ///< index of the x coordinate of their first discs
  std::vector<double> positions_, velocities_;  ///< x, y of discs, then of ghosts, then NaN as padding
  double impulse_{};                            ///< velocity change of a free disc by a force of 1 [T/M]
  std::vector<std::uint32_t> ghosts_;           ///< index of the x coordinate of the disc of each ghost
  std::vector<double> shifts_;                  ///< x offset of each ghost from its disc [L]
  SweptPairs listed_, near_;
  double used_{};                        ///< part of the reach that motion has used up [L]
  std::vector<double> kept_;             ///< history of listed pairs between two near lists [L]
  std::vector<double> largest_;          ///< largest overlap so far of near pairs in contact [L], else 0
  std::vector<double> forces_;           ///< x, y of the force on the second disc of each near pair [F]
  std::vector<std::uint32_t> touching_;  ///< indices of the near pairs in contact
  double force_on_block_{};              ///< along y [F]
};

}  // namespace talus::bench
