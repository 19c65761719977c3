#pragma once

#include "solver/granular/neighbour_list.hpp"

namespace talus {

/// All pairs of discs in a field that repeats along x, by virtual discs, as the program of 1989 found them (Lacy 1989,
/// "Virtual Elements and Periodic Boundaries"): each disc has a virtual one in the field to the left, and of a real
/// disc with a real one, a real with a virtual and a virtual with a real the nearest are tried, at each step again. It
/// takes the place of a NeighbourList in DiscSystem, as a check of it: there are no cells, no skin and no rounding to a
/// nearest image.
class VirtualDiscs : public NeighbourList {
 public:
  using NeighbourList::NeighbourList;

  /// Lists the pairs of which at least one disc can move. Discs stand in the field.
  void build(const DiscShapes& shapes, const Discs& discs);
  /// Whether all discs are still in the field; finds the pairs' virtual discs.
  bool holds(const Discs& discs);
  /// Names where discs were when virtual ones were found.
  void serialize(Archive& archive, const DiscShapes& shapes);

 private:
  void find_nearest(const Discs& discs);
};

}  // namespace talus
