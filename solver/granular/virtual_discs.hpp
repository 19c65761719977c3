#pragma once

#include "solver/granular/neighbour_list.hpp"

namespace talus {

/// All pairs of discs in a field that is periodic along x, by virtual discs, as in the program of 1989 (Lacy 1989,
/// "Virtual Elements and Periodic Boundaries"): each disc has a virtual copy in the field to the left. At each step the
/// nearest of three combinations is chosen for each pair: real with real, real with virtual, and virtual with real. The
/// class replaces NeighbourList in DiscSystem, to check it: it has no cells, no skin and no rounding to a nearest
/// image.
class VirtualDiscs : public NeighbourList {
 public:
  using NeighbourList::NeighbourList;

  /// Lists the pairs of which at least one disc can move. The discs must be inside the field.
  void build(const DiscShapes& shapes, const Discs& discs);
  /// Whether all discs are still inside the field; if so, chooses the virtual discs of the pairs again.
  bool holds(const Discs& discs);
  /// Serializes the disc positions by which the virtual discs were chosen.
  void serialize(Archive& archive, const DiscShapes& shapes);

 private:
  void find_nearest(const Discs& discs);
};

}  // namespace talus
