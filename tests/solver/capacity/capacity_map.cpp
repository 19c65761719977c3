#include "solver/capacity/capacity_map.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <string>

#include "solver/base/error.hpp"

BOOST_AUTO_TEST_SUITE(capacity_map_tests)

using namespace talus;

namespace {

/// A map whose trials all have the outcome of their node; returns the number of rounds.
template <class Hit>
int complete(CapacityMap& map, const Hit& hit) {
  int rounds = 0;
  for (std::vector<MapTrials> wanted = map.next(); !wanted.empty(); wanted = map.next(), ++rounds)
    for (const MapTrials& trials : wanted)
      for (std::size_t trial = trials.first; trial < trials.last; ++trial)
        map.add(trials.node, hit(trials.node, trial));
  return rounds;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_certain_edge_is_found_between_neighbours) {
  for (const int edge : {1, 5, 16}) {
    CapacityMap map{{.cells = 16, .first_cells = 2, .trials = 20, .few = 4}};
    complete(map, [&](MapNode node, std::size_t) { return node.j < edge; });
    const std::vector<MapState> states = map.states();
    for (int i = 0; i < map.side(); ++i) {
      const MapBoundary boundary = boundary_at(map, states, i);
      BOOST_TEST(boundary.last_above == edge - 1);
      BOOST_TEST(boundary.first_below == edge);
      for (int j = 0; j < map.side(); ++j)
        BOOST_TEST(
            (states[static_cast<std::size_t>(j * map.side() + i)] == (j < edge ? MapState::above : MapState::below)));
    }
    // No node needs more than the first trials.
    BOOST_TEST(map.all_trials() % 4 == 0U);
    BOOST_TEST(map.trials({0, edge}) == 4U);
  }
}

BOOST_AUTO_TEST_CASE(an_outcome_everywhere_needs_the_first_nodes_alone) {
  for (const bool hit : {true, false}) {
    CapacityMap map{{.cells = 64, .first_cells = 4, .trials = 20, .few = 4}};
    const int rounds = complete(map, [&](MapNode, std::size_t) { return hit; });
    BOOST_TEST(rounds == 1);
    BOOST_TEST(map.all_trials() == 25U * 4U);
    const MapBoundary boundary = boundary_at(map, map.states(), 7);
    BOOST_TEST(boundary.last_above == (hit ? 64 : -1));
    BOOST_TEST(boundary.first_below == (hit ? -1 : 0));
  }
}

BOOST_AUTO_TEST_CASE(a_boundary_contains_islands) {
  CapacityMap map{{.cells = 8, .first_cells = 8, .trials = 4, .few = 4}};
  complete(map, [](MapNode node, std::size_t) { return node.j < 3 || node.j == 5; });
  const MapBoundary boundary = boundary_at(map, map.states(), 2);
  BOOST_TEST(boundary.last_above == 2);
  BOOST_TEST(boundary.first_below == 6);
  CapacityMap ends_above{{.cells = 4, .first_cells = 4, .trials = 4, .few = 4}};
  complete(ends_above, [](MapNode node, std::size_t) { return node.j != 2; });
  BOOST_TEST(boundary_at(ends_above, ends_above.states(), 0).last_above == 1);
  BOOST_TEST(boundary_at(ends_above, ends_above.states(), 0).first_below == -1);
}

BOOST_AUTO_TEST_CASE(trials_are_doubled_while_a_node_is_open_and_have_consecutive_numbers) {
  CapacityMap map{{.cells = 1, .first_cells = 1, .trials = 20, .few = 4}};
  std::vector<std::size_t> lasts;
  for (std::vector<MapTrials> wanted = map.next(); !wanted.empty(); wanted = map.next()) {
    for (const MapTrials& trials : wanted) {
      BOOST_TEST(trials.first == map.trials(trials.node));
      if (trials.node == MapNode{0, 0}) lasts.push_back(trials.last);
      for (std::size_t trial = trials.first; trial < trials.last; ++trial)
        map.add(trials.node, trials.node == MapNode{0, 0} && trial % 2 == 0);
    }
  }
  BOOST_TEST(lasts == (std::vector<std::size_t>{4, 8, 16, 20}), boost::test_tools::per_element());
  BOOST_TEST((map.state({0, 0}) == MapState::open));
  BOOST_TEST(map.hits({0, 0}) == 10U);
  BOOST_TEST(map.trials({1, 1}) == 4U);
}

// A tongue between two of the first nodes, found where it crosses a cell that is divided anyway.
BOOST_AUTO_TEST_CASE(a_tongue_is_followed_into_a_cell_whose_corners_are_equal) {
  CapacityMap map{{.cells = 16, .first_cells = 2, .trials = 20, .few = 4}};
  const auto is_hit = [](MapNode node, std::size_t) {
    return node.j < 6 || (node.i >= 3 && node.i <= 5 && node.j < 14);
  };
  complete(map, is_hit);
  const std::vector<MapState> states = map.states();
  for (int j = 0; j < map.side(); ++j)
    for (int i = 0; i < map.side(); ++i)
      BOOST_TEST((states[static_cast<std::size_t>(j * map.side() + i)] == MapState::above) == is_hit({i, j}, 0));
}

// Between both ends the states are mixed: few cells there are divided, but both ends are found at every i.
BOOST_AUTO_TEST_CASE(a_band_is_divided_at_its_ends_alone) {
  CapacityMap map{{.cells = 64, .first_cells = 4, .trials = 4, .few = 4}};
  const auto first = [](int i) { return 12 + i / 8; };  // not above
  const auto last = [](int i) { return 52 - i / 6; };   // not below
  const auto is_hit = [&](MapNode node) {
    const bool is_end = node.j == first(node.i), is_mixed = (7 * node.i + 5 * node.j + node.i * node.j) % 4 < 2;
    return node.j < first(node.i) || node.j == last(node.i) || (node.j < last(node.i) && !is_end && is_mixed);
  };
  complete(map, [&](MapNode node, std::size_t) { return is_hit(node); });
  const std::vector<MapState> states = map.states();
  std::size_t inside = 0, open = 0;
  for (int i = 0; i < map.side(); ++i) {
    const MapBoundary boundary = boundary_at(map, states, i);
    BOOST_TEST(boundary.last_above == first(i) - 1);
    BOOST_TEST(boundary.first_below == last(i) + 1);
    for (int j = first(i); j <= last(i); ++j) {
      inside += map.trials({i, j}) > 0 ? 1 : 0;
      open += states[map.number({i, j})] == MapState::open ? 1 : 0;
    }
  }
  // Of 2,250 nodes in the band.
  BOOST_TEST(inside < 1200U);
  BOOST_TEST(open > 700U);
}

BOOST_AUTO_TEST_CASE(open_nodes_between_others_get_no_more_trials) {
  CapacityMap map{{.cells = 4, .first_cells = 4, .trials = 20, .few = 4}};
  complete(map, [](MapNode node, std::size_t trial) { return node.j == 0 || (node.j < 4 && trial % 2 == 0); });
  for (int i = 0; i < map.side(); ++i) {
    BOOST_TEST(map.trials({i, 1}) == 20U);
    BOOST_TEST(map.trials({i, 2}) == 4U);
    BOOST_TEST(map.trials({i, 3}) == 20U);
  }
  // The first of them is above after all: the next one decides.
  CapacityMap later{{.cells = 4, .first_cells = 4, .trials = 20, .few = 4}};
  complete(later, [](MapNode node, std::size_t trial) {
    return node.j == 0 || (node.j == 1 && trial > 1) || (node.j > 1 && node.j < 4 && trial % 2 == 0);
  });
  BOOST_TEST((later.state({2, 1}) == MapState::above));
  BOOST_TEST(later.trials({2, 2}) == 20U);
}

BOOST_AUTO_TEST_CASE(wrong_rules_are_refused) {
  const auto message = [](const MapRules& rules) {
    try {
      static_cast<void>(CapacityMap{rules});
    } catch (const InputError& error) {
      return std::string{error.what()};
    }
    return std::string{};
  };
  BOOST_TEST(message({.cells = 12, .first_cells = 4}) ==
             "found 12 cells, 4 at first; the first must be a power of two times the second");
  BOOST_TEST(message({.cells = 2, .first_cells = 4}) ==
             "found 2 cells, 4 at first; the first must be a power of two times the second");
  BOOST_TEST(message({.cells = 4, .first_cells = 4, .trials = 3, .few = 4}) ==
             "found 3 trials, 4 at first; it must be at least 1 and at most as many");
  BOOST_TEST(message({.cells = 24, .first_cells = 3}).empty());
}

BOOST_AUTO_TEST_SUITE_END()
