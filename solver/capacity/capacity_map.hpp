#pragma once

#include <cstddef>
#include <vector>

#include "solver/capacity/proportion.hpp"

namespace talus {

/// Rules of a map.
struct MapRules {
  int cells{64};           ///< along each axis; first_cells times a power of two
  int first_cells{4};      ///< along each axis, at the beginning
  std::size_t trials{20};  ///< at most at one node
  std::size_t few{4};      ///< at first; doubled while the node is open and a boundary may depend on it. With 4 equal
                           ///< outcomes it is no longer open
};

/// What is known of the probability at a node, compared with one half.
enum class MapState {
  above,  ///< its interval is above
  below,  ///< its interval is below
  open,   ///< its interval contains one half
};

/// A node of a map: a point of the grid.
struct MapNode {
  int i{}, j{};

  friend bool operator==(const MapNode&, const MapNode&) = default;
};

/// Trials that a map needs at a node: those with the numbers from `first` up to, but without, `last`.
struct MapTrials {
  MapNode node;
  std::size_t first{}, last{};
};

/// Map of the probability of an outcome over two variables, on a square grid, from random trials at its nodes.
///
/// It begins with coarse cells. A cell is divided into four, down to the cells of the grid, if the states of its nodes
/// differ and it may contain an end of a boundary along j (boundary_at): nodes are tried at both edges of the band in
/// which the state changes, and few elsewhere. Nodes without trials count as the corners of their cell if these are
/// equal, else as open. An island smaller than the first cells may be missed: audit it with trials at nodes without
/// any.
class CapacityMap {
 public:
  /// Errors: InputError if `cells` is not `first_cells` times a power of two, or `few` is not in [1, trials].
  explicit CapacityMap(const MapRules& rules);

  /// Trials that are needed next; empty when the map is complete. They depend on the trials so far, not on their order.
  [[nodiscard]] std::vector<MapTrials> next() const;
  /// Adds the outcome of a trial.
  void add(MapNode node, bool hit);

  const MapRules& rules() const { return rules_; }
  /// Number of nodes along an axis.
  int side() const { return rules_.cells + 1; }
  /// Number of a node, row by row (i changes first).
  std::size_t number(MapNode node) const {
    return static_cast<std::size_t>(node.j) * static_cast<std::size_t>(side()) + static_cast<std::size_t>(node.i);
  }
  std::size_t trials(MapNode node) const { return at(node).trials; }
  std::size_t hits(MapNode node) const { return at(node).hits; }
  /// Number of all trials.
  std::size_t all_trials() const;
  /// The state of a node with trials.
  [[nodiscard]] MapState state(MapNode node) const;
  /// The state of each node of a complete map by its number: of a node without trials that of the cell that contains
  /// it, open if the nodes of this differ.
  [[nodiscard]] std::vector<MapState> states() const;

 private:
  struct Count {
    std::size_t trials{}, hits{};
  };
  /// A square of the grid.
  struct Cell {
    MapNode corner;
    int size{};
  };
  /// What is known along j at one i: the ends of its nodes with trials, the first of these that is not above and the
  /// last that is not below. Without any, the first is at side() and the last at -1.
  struct Column {
    int first{}, last{-1}, first_not_above{}, last_not_below{-1};
  };

  const Count& at(MapNode node) const { return counts_[number(node)]; }
  /// Trials that a node of a cell needs next; as many as it has if that is all: of one that is open also if it lies
  /// between others of its column that are not above and not below, so that no boundary depends on it.
  std::size_t needed(MapNode node, const std::vector<Column>& columns) const;
  std::vector<Column> columns() const;
  bool is_uniform(const Cell& cell) const;
  /// Whether a cell with trials at its corners is to be divided.
  bool is_divided(const Cell& cell, const std::vector<Column>& columns) const;
  void visit(const Cell& cell, const std::vector<Column>& columns, std::vector<std::size_t>& wanted) const;
  void fill(const Cell& cell, const std::vector<Column>& columns, std::vector<MapState>& states) const;
  std::vector<Cell> first_cells() const;

  MapRules rules_;
  std::vector<Count> counts_;
};

/// Where the state along a line of nodes changes: up to one node all are above one half, from the other on all are
/// below. They are neighbours unless open nodes, or nodes of both states in any order, lie between them.
struct MapBoundary {
  int last_above{-1};   ///< -1: the first node is not above
  int first_below{-1};  ///< -1: the last node is not below
};
/// The boundary along j at this i.
[[nodiscard]] MapBoundary boundary_at(const CapacityMap& map, const std::vector<MapState>& states, int i);

}  // namespace talus
