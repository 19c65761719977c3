#define BOOST_TEST_MODULE shear_cell
#include "solver/granular/shear_cell.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "solver/base/error.hpp"

using namespace talus;

namespace {

using System = DiscSystem<LatchingSpring>;

/// Discs of ice of a millimetre, restitution .7, at 5000 diameters a second under 8 kPa.
ShearCell ice() {
  return {.law = {1.7e4, 1.7e4 / 0.49, 0.0},
          .diameter = 1e-3,
          .mass = 7.2e-7,
          .gravity = 9.81,
          .block_mass = 8e3 * 11e-6 / 9.81,
          .rows = 8,
          .columns = 10,
          .wall_discs = 11,
          .block_speed = 5.0,
          .seed = 1};
}

/// Sums of a run that conservation is told by.
struct Ran {
  Discs discs;
  Vec2 from_walls;    ///< impulse on the free discs
  double on_block{};  ///< impulse along y
  double largest_overlap{};
  double fullest{};        ///< largest solid fraction
  WallStress top, bottom;  ///< means
};

template <class Change>
Ran run(const ShearCell& cell, long steps, Change&& change) {
  FilledCell filled = fill(cell);
  change(filled.discs);
  System system{filled.shapes, filled.box, cell.law, 0.3 * cell.diameter};
  const double h = cell.contact_time() / 20.0;
  Ran ran;
  ran.discs = filled.discs;
  system.begin(ran.discs);
  for (long n = 0; n < steps; ++n) {
    system.kick(ran.discs, h);
    const Vec2 base = system.wall_force(base_wall), block = system.wall_force(block_wall);
    ran.from_walls -= h * (base + block);
    ran.on_block += h * block.y;
    const WallStress top = block_stress(cell, system), bottom = base_stress(cell, system);
    const double part = 1.0 / static_cast<double>(steps);
    ran.top.shear += part * top.shear, ran.top.normal += part * top.normal;
    ran.bottom.shear += part * bottom.shear, ran.bottom.normal += part * bottom.normal;
    if (n % 16 == 0) {
      system.for_each_contact(ran.discs, [&](const System::Contact& contact) {
        ran.largest_overlap = std::max(ran.largest_overlap, contact.depth / cell.diameter);
      });
      ran.fullest = std::max(ran.fullest, solid_fraction(cell, ran.discs));
    }
    system.drift(ran.discs, h);
  }
  return ran;
}

Ran run(const ShearCell& cell, long steps) {
  return run(cell, steps, [](Discs&) {});
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_cell_is_filled_as_its_numbers_say) {
  const ShearCell cell = ice();
  const FilledCell filled = fill(cell);
  BOOST_TEST(cell.overburden() == 8e3, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(cell.contact_time() == std::numbers::pi / 2 * (1.0 + 0.7) * std::sqrt(7.2e-7 / 3.4e4),
             boost::test_tools::tolerance(1e-14));
  BOOST_TEST(filled.discs.size() == 80U + 22U);
  BOOST_TEST(filled.box.width == 0.011);
  // Nothing overlaps.
  System system{filled.shapes, filled.box, cell.law, 0.3 * cell.diameter};
  Discs discs = filled.discs;
  system.begin(discs);
  system.kick(discs, 1e-9);
  long touching = 0;
  system.for_each_contact(discs, [&](const System::Contact& contact) { touching += contact.depth > 0.0 ? 1 : 0; });
  BOOST_TEST(touching == 0);
}

BOOST_AUTO_TEST_CASE(momentum_comes_from_the_walls_and_the_weight) {
  const ShearCell cell = ice();
  const FilledCell filled = fill(cell);
  const long steps = 20000;
  const Ran ran = run(cell, steps);
  Vec2 gained;
  for (std::size_t i = 0; i < cell.free_discs(); ++i)
    gained += cell.mass * Vec2{ran.discs.vx[i] - filled.discs.vx[i], ran.discs.vy[i] - filled.discs.vy[i]};
  BOOST_TEST(norm(gained - ran.from_walls) < 1e-10 * cell.mass * 80.0 * cell.block_speed);
  const double time = static_cast<double>(steps) * cell.contact_time() / 20.0;
  BOOST_TEST(std::abs(cell.block_mass * ran.discs.vy.back() - (ran.on_block - cell.block_mass * cell.gravity * time)) <
             1e-10 * cell.block_mass * cell.gravity * time);
  // The field flows, carries the block, and no disc is pressed or packed beyond what discs can be.
  BOOST_TEST(ran.fullest <= 0.9069);
  BOOST_TEST(ran.largest_overlap < 0.1);
  BOOST_TEST(ran.largest_overlap > 0.0);
  BOOST_TEST(ran.top.normal > 0.0);
  BOOST_TEST(ran.top.shear > 0.0);
}

BOOST_AUTO_TEST_CASE(a_mirrored_drive_drags_the_other_way_to_the_last_bit) {
  ShearCell cell = ice();
  const Ran one = run(cell, 4000);
  cell.block_speed = -cell.block_speed;
  const Discs before = fill(ice()).discs;
  const Ran other = run(cell, 4000, [&](Discs& discs) {
    discs = before;
    for (std::size_t i = 0; i < discs.size(); ++i)
      discs.x[i] = -discs.x[i], discs.vx[i] = -discs.vx[i];
  });
  BOOST_TEST(other.top.shear == -one.top.shear);
  BOOST_TEST(other.bottom.shear == -one.bottom.shear);
  BOOST_TEST(other.top.normal == one.top.normal);
  BOOST_TEST((other.discs.y == one.discs.y));
}

BOOST_AUTO_TEST_CASE(seeds_give_other_runs_and_the_same_seed_the_same) {
  ShearCell cell = ice();
  const Ran one = run(cell, 2000), again = run(cell, 2000);
  cell.seed = 2;
  const Ran other = run(cell, 2000);
  BOOST_TEST((one.discs == again.discs));
  BOOST_TEST(!(one.discs == other.discs));
}

BOOST_AUTO_TEST_CASE(cells_that_cannot_be) {
  const auto refused = [](auto&& change) {
    ShearCell cell = ice();
    change(cell);
    BOOST_CHECK_THROW(static_cast<void>(fill(cell)), InputError);
  };
  refused([](ShearCell& c) { c.law.unloading_stiffness = 0.9 * c.law.stiffness; });
  refused([](ShearCell& c) { c.columns = 12; });
  refused([](ShearCell& c) { c.wall_discs = 2, c.columns = 2; });
  refused([](ShearCell& c) { c.rows = 0; });
  refused([](ShearCell& c) { c.block_mass = 0.0; });
  refused([](ShearCell& c) { c.diameter = std::nan(""); });
}
