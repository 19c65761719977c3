#include "solver/cell/shear_cell.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "solver/base/error.hpp"
#include "solver/granular/disc_system.hpp"

BOOST_AUTO_TEST_SUITE(shear_cell_tests)

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
  refused([](ShearCell& c) { c.friction = CoulombFriction{0.1, 1e4, 1.0}; });
  const auto refused_mindlin = [](const DiscLaw& law, const Mindlin& friction, const std::string& expected) {
    ShearCell cell = ice_cell(8e3, 5e3);
    cell.law = law, cell.friction = friction;
    BOOST_CHECK_EXCEPTION(static_cast<void>(fill(cell)), InputError,
                          [&](const InputError& error) { return error.what() == expected; });
  };
  const Hertz hertz{7e8, 2.5e-4};
  refused_mindlin(
      LatchingSpring{1.7e4, 3.4e4, 0.0}, {0.3, 5e8, 2.5e-4},
      "shear_law: found mindlin with the law latching_spring, which has no contact radius; it must be linear");
  refused_mindlin(hertz, {-0.1, 5e8, 2.5e-4}, "friction: found -0.1; it must be >= 0");
  refused_mindlin(hertz, {0.3, 0.0, 2.5e-4}, "shear_modulus: found 0; it must be > 0");
  refused_mindlin(hertz, {0.3, 5e8, 5e-4}, "radius: found 0.0005; it must be that of the law, 0.00025");
  refused_mindlin(hertz, {0.3, 5e8, 2.5e-4, 0.1},
                  "shear_damping: found 0.1; it must be 0: contacts of discs have no tangential dashpot");
  refused([](ShearCell& c) { c.columns = 12; });
  refused([](ShearCell& c) { c.wall_discs = 2, c.columns = 2; });
  refused([](ShearCell& c) { c.rows = 0; });
  refused([](ShearCell& c) { c.block_mass = 0.0; });
  refused([](ShearCell& c) { c.diameter = std::nan(""); });
  for (const DiscLaw& law : {DiscLaw{LinearSpringDashpot{1.7e4, 0.0, EndRule::clamped, 0.1}},
                             DiscLaw{Hertz{7e8, 2.5e-4, 0.0, EndRule::clamped, HertzDashpot::tsuji, 0.1}},
                             DiscLaw{Hertz{7e8, 2.5e-4, 0.8, EndRule::attractive}},  // does not separate
                             DiscLaw{Hertz{7e8, 2.5e-4, 1e9}}, DiscLaw{HuntCrossley{4.5e4, 1e-5, 1.5, 1e5}},
                             DiscLaw{HuntCrossley{4.5e4, 1e-5, 0.9, 0.5}}})
    refused([&](ShearCell& c) { c.law = law; });
  refused([](ShearCell& c) { c.law = Hertz{7e8, 2.5e-4}, c.block_speed = 0.0; });
  refused([](ShearCell& c) { c.law = Hertz{7e8, 2.5e-4}, c.impact_speed = -1.0; });
  refused([](ShearCell& c) { c.law = Hertz{7e8, 2.5e-4}, c.impact_speed = 1e-300; });
}

BOOST_AUTO_TEST_CASE(impacts_of_laws_that_are_not_linear_are_stated_at_a_speed) {
  const auto close = boost::test_tools::tolerance(1e-12);
  ShearCell cell = ice_cell(8e3, 5e3);
  BOOST_TEST(cell.is_linear());
  BOOST_TEST(cell.nominal_speed() == 0.0);
  const Hertz hertz{7e8, 2.5e-4, 0.02, EndRule::clamped, HertzDashpot::constant};
  cell.law = hertz;
  BOOST_TEST(!cell.is_linear());
  // The rows of the start, 8 of them between base and block, slide past each other at a ninth of the block's speed.
  const FilledCell filled = fill(cell);
  BOOST_TEST(cell.nominal_speed() == filled.discs.vx[10] - filled.discs.vx[0], close);
  for (const double speed : {0.0, 0.02}) {
    cell.impact_speed = speed;
    const double v = speed > 0.0 ? speed : 5.0 / 9.0;
    BOOST_TEST(cell.contact_time() == hertz.contact_time(3.6e-7, v), close);
    BOOST_TEST(cell.restitution() == hertz.restitution(3.6e-7, v), close);
    // At the lower speed the load of the block, 8 mN on a disc, presses deeper than an impact.
    const double factor = 4.0 / 3.0 * 7e8 * std::sqrt(2.5e-4);
    const double overlap = speed > 0.0 ? std::pow(8e-3 / factor, 2.0 / 3.0) : hertz.largest_overlap(3.6e-7, v);
    BOOST_TEST(cell.nominal_overlap() == overlap, close);
    BOOST_TEST(cell.stiffness() == factor * std::sqrt(overlap), close);
    BOOST_TEST(cell.largest_stiffness() == 1.5 * factor * std::sqrt(overlap), boost::test_tools::tolerance(1e-8));
  }
  cell.gravity = 0.0;
  BOOST_TEST(cell.nominal_overlap() == hertz.largest_overlap(3.6e-7, 0.02), close);
  cell.law = Hertz{1e-3, 2.5e-4};
  BOOST_TEST(cell.nominal_overlap() == cell.diameter);
}

BOOST_AUTO_TEST_SUITE_END()
