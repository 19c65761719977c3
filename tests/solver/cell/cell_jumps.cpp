/// Runs of cells that skip time intervals in which no discs can touch.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "tests/solver/cell/cell_runs.hpp"

BOOST_AUTO_TEST_SUITE(cell_jumps_tests)

using namespace talus;

namespace {

/// Few, stiff discs: contacts are short and flights long.
ShearCell sparse(ShearCell cell) {
  cell.rows = 4, cell.columns = 3, cell.wall_discs = 6;
  cell.block_mass = 2e3 * 6e-6 / 9.81;
  if (auto* latching = std::get_if<LatchingSpring>(&cell.law))
    latching->stiffness *= 100.0, latching->unloading_stiffness *= 100.0;
  if (auto* linear = std::get_if<LinearSpringDashpot>(&cell.law)) linear->stiffness *= 100.0, linear->damping *= 10.0;
  // A tenth of the contact time and overlap d: K d^(5/2) is the energy of an impact.
  const double nonlinear = std::pow(10.0, 2.5);
  if (auto* hertz = std::get_if<Hertz>(&cell.law))
    hertz->modulus *= nonlinear, hertz->damping *= hertz->dashpot == HertzDashpot::tsuji ? std::sqrt(nonlinear) : 10.0;
  if (auto* hunt_crossley = std::get_if<HuntCrossley>(&cell.law)) hunt_crossley->stiffness *= nonlinear;
  if (!cell.friction) return cell;
  if (auto* linear = std::get_if<CoulombFriction>(&*cell.friction)) linear->stiffness *= 100.0;
  if (auto* mindlin = std::get_if<Mindlin>(&*cell.friction)) mindlin->modulus *= nonlinear;
  return cell;
}

void expect_same_with_jumps(const ShearCell& cell, const std::string& method) {
  // Fewer contacts of laws that are not linear, at whose speeds they are shorter than at the nominal speed: rounding
  // grows tenfold in about ten contacts of a disc.
  const double contacts = cell.is_linear() ? 300.0 : 150.0;
  CellPlan how = plan(cell, contacts, integrator_traits(method).amplitude_growth_rate != 0.0 ? 300.0 : 20.0);
  how.integrator = method;
  FilledCell start = fill(cell);
  for (std::size_t i = 0; i < cell.free_discs(); ++i)
    start.discs.vy[i] *= 200.0;
  CellRun step_by_step{cell, how, start};
  how.jump = true;
  CellRun jumping{cell, how, start};
  run(step_by_step), run(jumping);
  BOOST_TEST(jumping.jumped() > jumping.steps() / 10);
  BOOST_TEST(step_by_step.jumped() == 0);
  BOOST_TEST(jumping.steps() == step_by_step.steps());
  BOOST_TEST(apart(step_by_step, jumping) < 1e-9 * cell.diameter);
  const double scale = step_by_step.ledger().held();
  BOOST_TEST(std::abs(jumping.ledger().dissipated - step_by_step.ledger().dissipated) < 1e-9 * scale);
  const auto impulses = [](const CellRun& of) { return of.impulse_on_block() - of.impulse_on_base(); };
  BOOST_TEST(norm(impulses(step_by_step)) > 0.0);
  BOOST_TEST(norm(impulses(jumping) - impulses(step_by_step)) < 1e-9 * norm(impulses(step_by_step)));
  const auto touching = CellQuantity::touching;
  BOOST_TEST(step_by_step.mean(touching).value > 0.0);
  // Contacts are sampled at different times, some hundred samples in each run.
  BOOST_TEST(std::abs(jumping.mean(touching).value - step_by_step.mean(touching).value) < 0.02);
}

}  // namespace

BOOST_AUTO_TEST_CASE(time_without_contacts_is_passed_at_once_and_changes_nothing) {
  for (const ShearCell& cell : cells()) {
    for (const std::string& name : methods(cell))
      expect_same_with_jumps(sparse(cell), name);
  }
}

BOOST_AUTO_TEST_CASE(discs_that_overlap_at_the_start_do_not_fly) {
  ShearCell cell = sparse(ice_cell(8e3, 5e3));
  FilledCell start = fill(cell);
  Discs& discs = start.discs;
  discs.x[1] = discs.x[0] + 0.999 * cell.diameter, discs.y[1] = discs.y[0];
  discs.vx[0] = -1.0, discs.vx[1] = 1.0;
  CellPlan how = plan(cell, 1000.0);
  CellRun step_by_step{cell, how, start};
  how.jump = true;
  CellRun jumping{cell, how, start};
  run(step_by_step), run(jumping);
  BOOST_TEST(jumping.jumped() > 0);
  BOOST_TEST(apart(step_by_step, jumping) < 1e-9 * cell.diameter);
}

BOOST_AUTO_TEST_CASE(profiles_are_those_of_all_moments_with_jumps_too) {
  // A disc that moves vertically between a disc of the base and one of the block.
  ShearCell cell = sparse(ice_cell(8e3, 5e3));
  cell.law = LinearSpringDashpot{2e6, 0.0};
  cell.rows = 1, cell.columns = 1, cell.wall_discs = 4, cell.block_speed = 1e-9;
  cell.gravity = 1e-6, cell.block_mass = 1e3;
  FilledCell start = fill(cell);
  const std::size_t block = first_block_disc(cell);
  start.discs.x[0] = start.discs.x[1], start.discs.x[block] = start.discs.x[1];
  start.discs.vx[0] = 0.0, start.discs.vy[0] = 2.0;
  CellPlan how = plan(cell, 13000.0);
  CellRun step_by_step{cell, how, start};
  how.jump = true;
  CellRun jumping{cell, how, start};
  run(step_by_step), run(jumping);
  BOOST_TEST(jumping.jumped() > jumping.steps() / 2);
  const auto one = step_by_step.profile().layers(), other = jumping.profile().layers();
  BOOST_TEST_REQUIRE(one.size() == other.size());
  double apart = 0.0, all = 0.0;
  for (std::size_t k = 0; k < one.size(); ++k)
    apart += std::abs(one[k].fraction.value - other[k].fraction.value), all += one[k].fraction.value;
  BOOST_TEST(apart < 0.006 * all);  // 0.003 was measured: some thirty samples per crossing
}

BOOST_AUTO_TEST_CASE(means_of_flights_are_those_of_their_steps) {
  // A block thrown up from discs that do not reach it, and a few discs that fly past each other: no contact at all.
  ShearCell cell = sparse(ice_cell(8e3, 5e3));
  cell.rows = 2, cell.gravity = 500.0;
  cell.block_speed = 0.1;  // the speed of the fastest disc limits the length of flights; a low speed makes them long
  FilledCell start = fill(cell);
  for (std::size_t i = 0; i < start.discs.size(); ++i) {
    if (i < cell.free_discs()) start.discs.vx[i] = 0.1, start.discs.vy[i] = start.discs.y[i] > 2e-3 ? 0.02 : -0.01;
    if (i >= first_block_disc(cell)) start.discs.vy[i] = 1.0;
  }
  for (const char* const method : {"central_difference", "velocity_verlet", "euler_cromer"}) {
    CellPlan how = plan(cell, 3000.0);
    how.integrator = method;
    CellRun step_by_step{cell, how, start};
    how.jump = true;
    CellRun jumping{cell, how, start};
    run(step_by_step), run(jumping);
    BOOST_TEST_REQUIRE(step_by_step.mean(CellQuantity::touching).value == 0.0);
    BOOST_TEST(jumping.jumped() > 9 * jumping.steps() / 10);
    // Steps are summed at their ends, flights are integrated: the difference is half a step's displacement.
    for (const CellQuantity quantity : {CellQuantity::depth, CellQuantity::depth_square, CellQuantity::kinetic_shear})
      BOOST_TEST(jumping.mean(quantity).value == step_by_step.mean(quantity).value, boost::test_tools::tolerance(4e-6));
    // Sampled in the middle of each flight.
    BOOST_TEST(
        jumping.mean(CellQuantity::solid_fraction).value == step_by_step.mean(CellQuantity::solid_fraction).value,
        boost::test_tools::tolerance(2e-3));
  }
}

BOOST_AUTO_TEST_SUITE_END()
