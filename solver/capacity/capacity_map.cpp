#include "solver/capacity/capacity_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "solver/base/error.hpp"

namespace talus {
namespace {

std::array<MapNode, 4> corners(MapNode corner, int size) {
  return {MapNode{corner.i, corner.j}, MapNode{corner.i + size, corner.j}, MapNode{corner.i, corner.j + size},
          MapNode{corner.i + size, corner.j + size}};
}

bool is_refinement(int cells, int first_cells) {
  if (first_cells < 1 || cells < first_cells || cells % first_cells != 0) return false;
  const int quotient = cells / first_cells;
  return (quotient & (quotient - 1)) == 0;
}

}  // namespace

CapacityMap::CapacityMap(const MapRules& rules) : rules_{rules} {
  if (!is_refinement(rules.cells, rules.first_cells)) {
    throw InputError{fmt::format("found {} cells, {} at first; the first must be a power of two times the second",
                                 rules.cells, rules.first_cells)};
  }
  if (rules.few < 1 || rules.few > rules.trials)
    throw InputError{fmt::format("found {} trials, {} at first; it must be at least 1 and at most as many",
                                 rules.trials, rules.few)};
  counts_.resize(static_cast<std::size_t>(side()) * static_cast<std::size_t>(side()));
}

void CapacityMap::add(MapNode node, bool hit) {
  Count& count = counts_[number(node)];
  ++count.trials;
  count.hits += hit ? 1 : 0;
}

std::size_t CapacityMap::all_trials() const {
  return std::transform_reduce(counts_.begin(), counts_.end(), std::size_t{0}, std::plus<>{},
                               [](const Count& count) { return count.trials; });
}

MapState CapacityMap::state(MapNode node) const {
  const Interval interval = wilson_interval(at(node).hits, at(node).trials);
  return interval.low > 0.5 ? MapState::above : interval.high < 0.5 ? MapState::below : MapState::open;
}

std::size_t CapacityMap::needed(MapNode node, const std::vector<Column>& columns) const {
  const std::size_t trials = at(node).trials;
  if (trials < rules_.few) return rules_.few;
  if (state(node) != MapState::open) return trials;
  const Column& column = columns[static_cast<std::size_t>(node.i)];
  const bool is_between = column.first_not_above < node.j && node.j < column.last_not_below;
  return is_between ? trials : std::min(2 * trials, rules_.trials);
}

std::vector<CapacityMap::Column> CapacityMap::columns() const {
  std::vector<Column> columns(static_cast<std::size_t>(side()), Column{.first = side(), .first_not_above = side()});
  for (int j = 0; j < side(); ++j) {
    for (int i = 0; i < side(); ++i) {
      if (trials({i, j}) == 0) continue;
      Column& column = columns[static_cast<std::size_t>(i)];
      column.first = std::min(column.first, j), column.last = j;
      const MapState found = state({i, j});
      if (found != MapState::above) column.first_not_above = std::min(column.first_not_above, j);
      if (found != MapState::below) column.last_not_below = j;
    }
  }
  return columns;
}

bool CapacityMap::is_uniform(const Cell& cell) const {
  // Also nodes of finer cells at its edges.
  for (int j = cell.corner.j; j <= cell.corner.j + cell.size; ++j)
    for (int i = cell.corner.i; i <= cell.corner.i + cell.size; ++i)
      if (trials({i, j}) > 0 && state({i, j}) != state(cell.corner)) return false;
  return true;
}

bool CapacityMap::is_divided(const Cell& cell, const std::vector<Column>& columns) const {
  if (cell.size == 1 || is_uniform(cell)) return false;
  // Not between both ends: these are known without it, unless all nodes of a column up to the cell are above, or all
  // from its other side on are below. Of a column without nodes there, those of the corners decide.
  const int low = cell.corner.j, high = cell.corner.j + cell.size;
  const auto begin = columns.begin() + cell.corner.i;
  return std::any_of(begin, begin + cell.size + 1, [&](const Column& column) {
    return (column.first <= low && column.first_not_above > low) ||
           (column.last >= high && column.last_not_below < high);
  });
}

void CapacityMap::visit(const Cell& cell, const std::vector<Column>& columns, std::vector<std::size_t>& wanted) const {
  bool is_tried = true;
  const auto want = [&](MapNode node, std::size_t trials) {
    wanted[number(node)] = std::max(wanted[number(node)], trials);
    is_tried = is_tried && at(node).trials >= trials;
  };
  const std::array<MapNode, 4> nodes = corners(cell.corner, cell.size);
  for (const MapNode node : nodes)
    want(node, needed(node, columns));
  if (!is_tried || !is_divided(cell, columns)) return;
  const int half = cell.size / 2;
  for (const MapNode corner : corners(cell.corner, half))
    visit({corner, half}, columns, wanted);
}

std::vector<CapacityMap::Cell> CapacityMap::first_cells() const {
  std::vector<Cell> cells;
  const int size = rules_.cells / rules_.first_cells;
  for (int j = 0; j < rules_.cells; j += size)
    for (int i = 0; i < rules_.cells; i += size)
      cells.push_back({{i, j}, size});
  return cells;
}

std::vector<MapTrials> CapacityMap::next() const {
  std::vector<std::size_t> wanted(counts_.size(), 0);
  const std::vector<Column> columns = this->columns();
  for (const Cell& cell : first_cells())
    visit(cell, columns, wanted);
  std::vector<MapTrials> needed;
  for (int j = 0; j < side(); ++j) {
    for (int i = 0; i < side(); ++i) {
      const MapNode node{i, j};
      if (wanted[number(node)] > at(node).trials) needed.push_back({node, at(node).trials, wanted[number(node)]});
    }
  }
  return needed;
}

void CapacityMap::fill(const Cell& cell, const std::vector<Column>& columns, std::vector<MapState>& states) const {
  if (is_uniform(cell)) {
    const MapState state_of_cell = state(cell.corner);
    for (int j = cell.corner.j; j <= cell.corner.j + cell.size; ++j)
      for (int i = cell.corner.i; i <= cell.corner.i + cell.size; ++i)
        if (at({i, j}).trials == 0) states[number({i, j})] = state_of_cell;
    return;
  }
  if (!is_divided(cell, columns)) return;
  const int half = cell.size / 2;
  for (const MapNode corner : corners(cell.corner, half))
    fill({corner, half}, columns, states);
}

std::vector<MapState> CapacityMap::states() const {
  std::vector<MapState> states(counts_.size(), MapState::open);
  for (int j = 0; j < side(); ++j)
    for (int i = 0; i < side(); ++i)
      if (at({i, j}).trials > 0) states[number({i, j})] = state({i, j});
  const std::vector<Column> columns = this->columns();
  for (const Cell& cell : first_cells())
    fill(cell, columns, states);
  return states;
}

MapBoundary boundary_at(const CapacityMap& map, const std::vector<MapState>& states, int i) {
  MapBoundary found;
  for (int j = 0; j < map.side() && states[map.number({i, j})] == MapState::above; ++j)
    found.last_above = j;
  for (int j = map.side() - 1; j >= 0 && states[map.number({i, j})] == MapState::below; --j)
    found.first_below = j;
  return found;
}

}  // namespace talus
