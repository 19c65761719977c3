#include "solver/granular/disc_order.hpp"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(disc_order_tests)

using namespace talus;

BOOST_AUTO_TEST_CASE(discs_are_numbered_by_rows_and_walls_come_last) {
  DiscShapes shapes;
  Discs discs;
  const std::size_t wall = shapes.add(DiscWall{});
  shapes.add(0.5, 0.0, wall);
  discs.add(0.0, -5.0, 0.0, 0.0);
  for (const auto& [x, y] : {std::pair{1.5, 0.3}, {0.5, 1.2}, {-0.5, 0.9}, {3.0, -0.1}}) {
    shapes.add(0.5, 1.0 + x * x);
    discs.add(x, y, 10.0 * x, 10.0 * y);
  }
  const std::vector<std::size_t> order = order_by_rows(shapes, discs);
  BOOST_TEST((order == std::vector<std::size_t>{4, 3, 1, 2, 0}));
  const DiscShapes new_shapes = reordered(shapes, order);
  const Discs new_discs = reordered(discs, order);
  for (std::size_t k = 0; k < order.size(); ++k) {
    BOOST_TEST(new_discs.x[k] == discs.x[order[k]]);
    BOOST_TEST(new_discs.y[k] == discs.y[order[k]]);
    BOOST_TEST(new_discs.vx[k] == discs.vx[order[k]]);
    BOOST_TEST(new_discs.vy[k] == discs.vy[order[k]]);
    BOOST_TEST(new_shapes.inverse_mass[k] == shapes.inverse_mass[order[k]]);
    BOOST_TEST(new_shapes.wall[k] == shapes.wall[order[k]]);
  }
  BOOST_TEST(new_shapes.walls.size() == 1U);
  BOOST_TEST(new_discs.spin.empty());
}

BOOST_AUTO_TEST_SUITE_END()
