#include "solver/cell/cell_run.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "solver/base/error.hpp"
#include "tests/solver/cell/cell_runs.hpp"

BOOST_AUTO_TEST_SUITE(cell_run_tests)

using namespace talus;

namespace {

void expect_momentum(const ShearCell& cell, const std::string& method) {
  CellPlan how = plan(cell, 400.0, integrator_traits(method).amplitude_growth_rate != 0.0 ? 300.0 : 20.0);
  how.integrator = method;
  CellRun ran{cell, how};
  const Discs before = ran.discs();
  run(ran);
  const Discs after = ran.discs();
  Vec2 gained;
  for (std::size_t i = 0; i < cell.free_discs(); ++i)
    gained += cell.mass * Vec2{after.vx[i] - before.vx[i], after.vy[i] - before.vy[i]};
  // A method that ends its steps with an evaluation has applied half of that force; the first force, of separate discs,
  // is zero.
  const double ahead = integrator_traits(method).ends_with_evaluation ? 0.5 * how.step : 0.0;
  const Vec2 on_block = ran.impulse_on_block() - ahead * ran.wall_force(block_wall);
  const Vec2 on_base = ran.impulse_on_base() - ahead * ran.wall_force(base_wall);
  BOOST_TEST(norm(gained + on_block + on_base) < 1e-10 * cell.mass * 80.0 * cell.block_speed);
  const double weight = cell.block_mass * cell.gravity * after.t;
  BOOST_TEST(std::abs(cell.block_mass * after.vy.back() - (on_block.y - weight)) < 1e-10 * weight);
  BOOST_TEST(ran.largest_fraction() <= CellRun::fullest);
  BOOST_TEST(ran.largest_overlap() < CellRun::deepest * cell.diameter);
  BOOST_TEST(ran.largest_overlap() > 0.0);
  BOOST_TEST(ran.mean(CellQuantity::top_normal).value > 0.0);
  BOOST_TEST(ran.mean(CellQuantity::top_shear).value > 0.0);
  // Free discs spin in the sense of the flow; wall discs do not spin.
  BOOST_TEST((ran.mean(CellQuantity::spin).value < 0.0) == cell.friction.has_value());
  BOOST_TEST((ran.mean(CellQuantity::sliding).value > 0.0) == cell.friction.has_value());
  for (std::size_t i = cell.free_discs(); i < after.spin.size(); ++i)
    BOOST_TEST(after.spin[i] == 0.0);
}

}  // namespace

BOOST_AUTO_TEST_CASE(momentum_comes_from_the_walls_and_the_weight) {
  for (const ShearCell& cell : cells()) {
    for (const std::string& name : methods(cell))
      expect_momentum(cell, name);
  }
}

BOOST_AUTO_TEST_CASE(energy_is_accounted_for) {
  const ShearCell cell = ice_cell(8e3, 5e3);
  std::vector<double> missing;
  for (const double steps : {20.0, 80.0}) {
    CellRun ran{cell, plan(cell, 300.0, steps)};
    run(ran);
    const CellRun::Ledger ledger = ran.ledger();
    BOOST_TEST(ledger.input > 0.0);
    BOOST_TEST(ledger.dissipated > 0.0);
    missing.push_back(std::abs(ledger.spurious_gain) / ledger.dissipated);
  }
  // The step adds about (w1 h)^2/600 of a contact's loss to it, which is 3e-5 at 20 steps (case cooling_gas); 1.2e-5
  // and 7.6e-5 were measured here, where the discs have lost only a few per cent of the kinetic energy.
  BOOST_TEST(missing[0] < 3e-4);
  BOOST_TEST(missing[1] < 3e-4);
}

BOOST_AUTO_TEST_CASE(accounts_of_dashpots_and_friction_close_as_the_step_shrinks) {
  for (const ShearCell& cell : cells()) {
    for (const double steps : {60.0, 240.0, 960.0}) {
      CellRun ran{cell, plan(cell, 300.0, steps)};
      run(ran);
      const CellRun::Ledger ledger = ran.ledger();
      const bool loses = cell.restitution() < 1.0 || cell.friction;
      BOOST_TEST((ledger.dissipated > 0.0) == loses);
      BOOST_TEST((ledger.friction_work > 0.0) == cell.friction.has_value());
      BOOST_TEST(ledger.friction_work <= ledger.dissipated);
      // Powers are evaluated with the velocities before a kick: the error is about (w h)/10 of a contact's energy.
      BOOST_TEST(std::abs(ledger.spurious_gain) < 0.6 / steps * (loses ? ledger.dissipated : ledger.input));
    }
  }
}

BOOST_AUTO_TEST_CASE(a_mirrored_drive_drags_the_other_way_to_the_last_bit) {
  for (ShearCell cell : cells()) {
    CellRun one{cell, plan(cell, 200.0)};
    run(one);
    FilledCell mirrored = fill(cell);
    for (std::size_t i = 0; i < mirrored.discs.size(); ++i)
      mirrored.discs.x[i] = -mirrored.discs.x[i], mirrored.discs.vx[i] = -mirrored.discs.vx[i];
    cell.block_speed = -cell.block_speed;
    CellRun other{cell, plan(cell, 200.0), mirrored};
    run(other);
    BOOST_TEST(other.mean(CellQuantity::top_shear).value == one.mean(CellQuantity::top_shear).value);
    BOOST_TEST(other.mean(CellQuantity::top_normal).value == one.mean(CellQuantity::top_normal).value);
    BOOST_TEST(other.mean(CellQuantity::spin).value == -one.mean(CellQuantity::spin).value);
    BOOST_TEST(other.impulse_on_base().x == -one.impulse_on_base().x);
    BOOST_TEST((other.discs().y == one.discs().y));
  }
}

BOOST_AUTO_TEST_CASE(seeds_give_other_runs_and_the_same_seed_the_same) {
  ShearCell cell = ice_cell(8e3, 5e3);
  CellRun one{cell, plan(cell, 100.0)}, again{cell, plan(cell, 100.0)};
  BOOST_TEST((run(one).discs() == run(again).discs()));
  cell.seed = 2;
  CellRun other{cell, plan(cell, 100.0)};
  BOOST_TEST(!(run(one).discs() == run(other).discs()));
}

namespace {

void expect_same_when_put_back(const ShearCell& cell, const std::string& method, Images images) {
  CellPlan how = plan(cell, 200.0, integrator_traits(method).amplitude_growth_rate != 0.0 ? 300.0 : 20.0);
  how.integrator = method, how.images = images;
  CellRun whole{cell, how};
  while (whole.steps() < whole.last_step() / 3)
    whole.advance();
  Archive saved;
  whole.serialize(saved);
  CellRun rest{cell, how};
  Archive putting_back{saved.items()};
  rest.serialize(putting_back);
  BOOST_TEST(putting_back.left_over().empty());
  run(whole), run(rest);
  BOOST_TEST((whole.discs() == rest.discs()));
  for (std::size_t k = 0; k < static_cast<std::size_t>(CellQuantity::count); ++k) {
    const auto quantity = static_cast<CellQuantity>(k);
    BOOST_TEST(whole.mean(quantity).value == rest.mean(quantity).value);
    BOOST_TEST(whole.mean(quantity).error == rest.mean(quantity).error);
  }
  BOOST_TEST(whole.ledger().spurious_gain == rest.ledger().spurious_gain);
  BOOST_TEST(whole.ledger().dissipated == rest.ledger().dissipated);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_run_that_is_put_back_goes_on_bit_for_bit) {
  for (const ShearCell& cell : cells()) {
    for (const std::string& name : methods(cell))
      expect_same_when_put_back(cell, name, Images::nearest);
    expect_same_when_put_back(cell, "central_difference", Images::virtual_discs);
  }
}

BOOST_AUTO_TEST_CASE(virtual_discs_act_as_nearest_images_do) {
  for (const ShearCell& cell : cells()) {
    for (const char* const name : {"central_difference", "velocity_verlet"}) {
      CellPlan how = plan(cell, 150.0);
      how.integrator = name;
      FilledCell start = fill(cell);
      for (std::size_t i = 0; i < cell.free_discs(); ++i)
        start.discs.vy[i] *= 60.0;
      CellRun nearest{cell, how, start};
      how.images = Images::virtual_discs;
      CellRun virtuals{cell, how, start};
      run(nearest), run(virtuals);
      // Positions are rounded to 1e-15 in boxes that discs leave at different times; impacts have amplified this to up
      // to 3e-9.
      BOOST_TEST(apart(nearest, virtuals) < 3e-8 * cell.diameter);
      BOOST_TEST(nearest.mean(CellQuantity::contacts).value > 1.0);
      for (const CellQuantity quantity : {CellQuantity::contacts, CellQuantity::multiple, CellQuantity::sliding})
        BOOST_TEST(virtuals.mean(quantity).value == nearest.mean(quantity).value, boost::test_tools::tolerance(1e-12));
      for (const CellQuantity quantity : {CellQuantity::shear_virial, CellQuantity::spin, CellQuantity::bottom_normal})
        BOOST_TEST(virtuals.mean(quantity).value == nearest.mean(quantity).value, boost::test_tools::tolerance(1e-6));
      BOOST_TEST(std::abs(virtuals.ledger().dissipated - nearest.ledger().dissipated) < 1e-9 * nearest.ledger().held());
    }
  }
}

BOOST_AUTO_TEST_CASE(energy_that_contacts_hold_at_the_start_is_accounted_for) {
  for (const std::string method : {"central_difference", "velocity_verlet"}) {
    const ShearCell cell = ice_cell(32e3, 1e3);
    CellPlan how = plan(cell, 200.0);
    how.integrator = method;
    CellRun before{cell, plan(cell, 2000.0)};
    run(before);
    FilledCell start = before.start();
    start.discs = before.discs();
    CellRun ran{cell, how, start};
    run(ran);
    // Without the energy stored in the initial contacts, 4 to 8 % of the dissipation would be missing; 2.6e-5 and
    // 1.1e-4 were measured.
    BOOST_TEST(std::abs(ran.ledger().spurious_gain) < 3e-4 * ran.ledger().dissipated);
  }
}

BOOST_AUTO_TEST_CASE(what_is_steady_is_steady_also_where_a_run_is_left) {
  const ShearCell cell = ice_cell(8e3, 5e3);
  CellRun ran{cell, plan(cell, 20000.0)};
  while (ran.steps() < ran.last_step() * 45 / 100)
    ran.advance();
  // Blocks that were not reached must not count as zeros: counted as zeros, they made the drift some fifty errors.
  for (const CellQuantity quantity : {CellQuantity::solid_fraction, CellQuantity::depth, CellQuantity::touching})
    BOOST_TEST(std::abs(ran.drift(quantity)) < 3.0);
}

BOOST_AUTO_TEST_CASE(contacts_are_counted_from_their_first_moment_on) {
  ShearCell cell = ice_cell(32e3, 1e3);
  cell.law = LinearSpringDashpot{2e4, 0.0};  // repulsive as long as discs overlap
  CellPlan how = plan(cell, 1000.0, 10.0);
  how.integrator = "euler_cromer";
  CellRun ran{cell, how};
  std::size_t maximum = 0;
  while (!ran.finished()) {
    ran.advance();
    // Wall discs do not act on each other.
    const Discs discs = ran.discs();
    std::size_t overlaps = 0;
    for (std::size_t i = 0; i < cell.free_discs(); ++i) {
      for (std::size_t j = i + 1; j < discs.size(); ++j) {
        const double x = std::remainder(discs.x[j] - discs.x[i], cell.width());
        if (std::hypot(x, discs.y[j] - discs.y[i]) < cell.diameter) ++overlaps;
      }
    }
    if (ran.steps() % 5 == 0) BOOST_TEST(ran.acting_contacts().size() == overlaps);  // a sample
    maximum = std::max(maximum, overlaps);
  }
  BOOST_TEST(maximum > 5U);
}

BOOST_AUTO_TEST_CASE(the_number_of_samples_changes_no_result) {
  for (const ShearCell& cell : cells()) {
    for (const std::string& name : methods(cell)) {
      CellPlan how = plan(cell, 300.0, integrator_traits(name).amplitude_growth_rate != 0.0 ? 300.0 : 20.0);
      how.integrator = name;
      CellRun one{cell, how};
      how.every = 3.0 * how.step;
      CellRun other{cell, how};
      run(one), run(other);
      BOOST_TEST(apart(one, other) == 0.0);
      BOOST_TEST(one.ledger().dissipated == other.ledger().dissipated);
    }
  }
}

BOOST_AUTO_TEST_CASE(loops_that_all_but_end_with_a_step_end) {
  const ShearCell cell = ice_cell(8e3, 5e3);
  for (const double more : {1e-13, 1e-12, 1.1e-12, 2e-12}) {
    CellPlan how = plan(cell, 40.0);
    how.every = 50.0 * (1.0 + more) * how.step;
    CellRun ran{cell, how};
    for (int advances = 0; !ran.finished() && advances < 1000; ++advances)
      ran.advance();
    BOOST_TEST(ran.finished());
  }
}

BOOST_AUTO_TEST_CASE(no_output_is_without_a_sample) {
  const ShearCell cell = ice_cell(8e3, 5e3);
  for (const double steps_in_loop : {1.0, 2.5, 3.0, 9.9, 30.0, 99.6}) {
    for (const bool jump : {false, true}) {
      CellPlan how = plan(cell, 40.0);
      how.every = steps_in_loop * how.step, how.jump = jump;
      CellRun ran{cell, how};
      run(ran);
      for (std::size_t k = 0; k < ran.intervals(); ++k)
        BOOST_TEST(ran.interval_mean(k, CellQuantity::depth) > 0.0);
    }
  }
}

BOOST_AUTO_TEST_CASE(what_is_beyond_all_numbers_ends_a_run) {
  const ShearCell cell = ice_cell(8e3, 5e3);
  for (const double speed : {1e300, std::numeric_limits<double>::quiet_NaN()}) {
    FilledCell start = fill(cell);
    start.discs.vx[7] = speed;
    CellRun ran{cell, plan(cell, 400.0), start};
    while (!ran.finished() && ran.failure().empty())
      ran.advance();
    BOOST_TEST(ran.failure().find("positions or speeds of discs overflow") != std::string::npos, ran.failure());
    BOOST_TEST(!ran.finished());
  }
}

BOOST_AUTO_TEST_CASE(outputs_come_at_each_loop_and_at_the_end) {
  const ShearCell cell = ice_cell(8e3, 5e3);
  CellPlan how = plan(cell, 20.0);
  how.every = 3.0 * cell.contact_time();
  CellRun ran{cell, how};
  std::vector<long> outputs;
  while (!ran.finished()) {
    ran.advance();
    if (ran.due()) outputs.push_back(ran.steps());
  }
  const std::vector<long> expected{60, 120, 180, 240, 300, 360, 400};
  BOOST_TEST(outputs == expected, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(plans_that_cannot_be) {
  const ShearCell cell = ice_cell(8e3, 5e3);
  const auto refused = [&](const char* field, auto&& change) {
    CellPlan how = plan(cell, 20.0);
    change(how);
    const auto found = validation_errors(cell, how);
    BOOST_REQUIRE(!found.empty());
    BOOST_TEST(found.front().field == field);
    BOOST_CHECK_THROW(CellRun(cell, how), InputError);
  };
  refused("step", [](CellPlan& how) { how.step = 0.0; });
  refused("step", [](CellPlan& how) { how.step = 2.0 * how.every; });
  refused("every", [](CellPlan& how) { how.every = 2.0 * how.end; });
  refused("step", [&](CellPlan& how) { how.step = cell.contact_time() / 9.9; });
  refused("step", [&](CellPlan& how) { how.integrator = "euler", how.step = cell.contact_time() / 40.0; });
  refused("step", [&](CellPlan& how) { how.integrator = "taylor", how.step = cell.contact_time() / 20.0; });
  refused("step", [](CellPlan& how) { how.step = 1e-16 * how.end; });
  CellPlan how = plan(cell, 20.0, 40.0);
  how.integrator = "euler", how.historical = true;
  BOOST_TEST(validation_errors(cell, how).empty());
  refused("jump", [](CellPlan& changed) { changed.images = Images::virtual_discs, changed.jump = true; });
  ShearCell large = cell;
  large.rows = 200;
  how = plan(large, 20.0);
  how.images = Images::virtual_discs;
  BOOST_TEST(validation_errors(large, how).front().field == "images");
  // Ten steps in a contact whose unloading takes less than one.
  ShearCell dull = cell;
  dull.law = LatchingSpring{1.7e4, 1.7e4 / 0.0009, 0.0};
  how = plan(dull, 20.0, 20.0);
  BOOST_TEST(validation_errors(dull, how).front().field == "step");
  how.step = std::sqrt(dull.mass / (2.0 * 1.7e4 / 0.0009));
  BOOST_TEST(validation_errors(dull, how).empty());
  CellRun ran{dull, how};
  BOOST_TEST(std::abs(run(ran).ledger().relative_balance_error()) < CellRun::maximum_balance_error);
  // Options that apply only to the law of 1989.
  for (const ShearCell& other : cells()) {
    if (other.law_of_1989() != nullptr) continue;
    how = plan(other, 20.0);
    how.historical = true;
    BOOST_TEST(validation_errors(other, how).front().field == "historical");
    for (const char* const name : {"euler", "taylor"}) {
      how = plan(other, 20.0, 1e4);
      how.integrator = name;
      BOOST_TEST(validation_errors(other, how).front().field == "integrator");
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
