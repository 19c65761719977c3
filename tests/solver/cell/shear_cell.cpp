#define BOOST_TEST_MODULE shear_cell
#include "solver/cell/shear_cell.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "solver/base/error.hpp"
#include "solver/granular/disc_system.hpp"

using namespace talus;

namespace {

using System = DiscSystem<LatchingSpring>;

}  // namespace

BOOST_AUTO_TEST_CASE(a_cell_is_filled_as_its_numbers_say) {
  const ShearCell cell = ice_cell(8e3, 5e3);
  const FilledCell filled = fill(cell);
  BOOST_TEST(cell.overburden() == 8e3, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(cell.contact_time() == std::numbers::pi / 2 * (1.0 + 0.7) * std::sqrt(7.2e-7 / 3.4e4),
             boost::test_tools::tolerance(1e-14));
  BOOST_TEST(filled.discs.size() == 80U + 22U);
  BOOST_TEST(filled.box.width == 0.011);
  // No discs overlap.
  System system{filled.shapes, filled.box, std::get<LatchingSpring>(cell.law), 0.3 * cell.diameter};
  Discs discs = filled.discs;
  system.begin(discs);
  system.kick(discs, 1e-9);
  long touching = 0;
  system.for_each_contact(discs, [&](const DiscContact& contact) { touching += contact.depth > 0.0 ? 1 : 0; });
  BOOST_TEST(touching == 0);
}

BOOST_AUTO_TEST_CASE(order_is_one_in_a_triangular_array_and_less_elsewhere) {
  ShearCell cell = ice_cell(8e3, 5e3);
  FilledCell filled = fill(cell);
  const double loose = sixfold_order(cell, filled, filled.discs);
  cell.columns = cell.wall_discs;
  filled = fill(cell);
  for (int r = 0; r < cell.rows + 2; ++r) {
    for (int c = 0; c < cell.wall_discs; ++c) {
      const auto free = static_cast<std::size_t>(r - 1) * 11 + static_cast<std::size_t>(c);
      const std::size_t disc = r == 0   ? cell.free_discs() + static_cast<std::size_t>(c)
                               : r == 9 ? first_block_disc(cell) + static_cast<std::size_t>(c)
                                        : free;
      filled.discs.x[disc] = 1e-3 * (c - 5 + 0.5 * (r % 2));
      filled.discs.y[disc] = 1e-3 * std::sqrt(0.75) * r;
    }
  }
  BOOST_TEST(sixfold_order(cell, filled, filled.discs) == 1.0, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(loose < 0.5);
  // Discs that have left across a border count as their images inside.
  Discs outside = filled.discs;
  for (std::size_t i = 0; i < cell.free_discs(); i += 3)
    outside.x[i] += (outside.x[i] > 0.0 ? -1.0 : 1.0) * cell.width();
  BOOST_TEST(sixfold_order(cell, filled, outside) == 1.0, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(cells_that_cannot_be) {
  const auto refused = [](auto&& change) {
    ShearCell cell = ice_cell(8e3, 5e3);
    change(cell);
    BOOST_CHECK_THROW(static_cast<void>(fill(cell)), InputError);
  };
  refused([](ShearCell& c) { c.law = LatchingSpring{1.7e4, 0.9 * 1.7e4, 0.0}; });
  refused([](ShearCell& c) { c.law = LinearSpringDashpot{1.7e4, -1.0}; });
  refused([](ShearCell& c) { c.law = LinearSpringDashpot{1.7e4, 1.0, EndRule::attractive}; });
  refused([](ShearCell& c) { c.friction = CoulombFriction{-0.1, 1e4}; });
  refused([](ShearCell& c) { c.friction = CoulombFriction{0.1, 0.0}; });
  refused([](ShearCell& c) { c.columns = 12; });
  refused([](ShearCell& c) { c.wall_discs = 2, c.columns = 2; });
  refused([](ShearCell& c) { c.rows = 0; });
  refused([](ShearCell& c) { c.block_mass = 0.0; });
  refused([](ShearCell& c) { c.diameter = std::nan(""); });
}
