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
    return node.j > 10 || (node.i >= 3 && node.i <= 5 && node.j > 2);
  };
  complete(map, is_hit);
  const std::vector<MapState> states = map.states();
  for (int j = 0; j < map.side(); ++j)
    for (int i = 0; i < map.side(); ++i)
      BOOST_TEST((states[static_cast<std::size_t>(j * map.side() + i)] == MapState::above) == is_hit({i, j}, 0));
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
