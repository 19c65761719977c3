/// A fence as a scene: derived values in the listing of sample2, equilibrium, and the half model compared with the full
/// one.
#include "solver/scenes/fence_scene.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "solver/base/error.hpp"
#include "solver/run/energy_ledger.hpp"
#include "tests/solver/scenes/fence_end.hpp"
#include "tests/solver/scenes/sample_fence.hpp"

BOOST_AUTO_TEST_SUITE(fence_scene_tests)

using namespace talus;
using namespace talus::scenes;

namespace {

Pose pose_of(const FenceScene& made, const State& state, const char* body) {
  return pose(made.scene.model, state, *find_body(made.scene.model, body));
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_stiffness_beyond_all_numbers_is_refused) {
  for (const double penetration : {1e-200, 1e200}) {
    Fence fence = sample2();
    fence.penetration = penetration;
    BOOST_CHECK_EXCEPTION(static_cast<void>(fence_scene(fence)), InputError, [](const InputError& error) {
      return std::string{error.what()}.starts_with("fence: penetration: found 1e");
    });
  }
}

BOOST_AUTO_TEST_CASE(derives_what_the_listing_prints) {
  const FenceScene made = fence_scene(sample2());
  // Printed with four and three digits.
  BOOST_TEST(std::abs(made.rock_column.stiffness - 0.1944e6) < 50.0);
  BOOST_TEST(std::abs(made.column_column.stiffness - 0.2522e6) < 50.0);
  BOOST_TEST(std::abs(made.rock_ground.stiffness - 0.8723e8) < 5e3);
  BOOST_TEST(std::abs(made.critical_step - 0.827e-4) < 5e-8);
  BOOST_TEST(made.members.size() == 18u);
  BOOST_TEST(std::abs(made.members[8].position.y - 1.96) < 5e-3);
  BOOST_TEST(made.members[9].position.y == 5.5);
  BOOST_TEST(!made.members[9].body.has_value());
}

BOOST_AUTO_TEST_CASE(static_shape_balances_each_column) {
  const Fence fence = sample2();
  const StaticShape shape = static_shape(fence);
  const double weight = std::numbers::pi * 1.25 * 1.25 * 8.0 * 0.76 * 32.18;  // weight of a cylinder: 960.6 lb
  for (std::size_t i = 1; i + 1 < shape.heights.size(); ++i) {
    const double inner = shape.horizontal_tension * (shape.heights[i] - shape.heights[i - 1]) / shape.distances[i - 1];
    const double outer = shape.horizontal_tension * (shape.heights[i + 1] - shape.heights[i]) / shape.distances[i];
    BOOST_TEST(outer - inner == weight, boost::test_tools::tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_CASE(columns_at_rest_stay_at_rest_exactly) {
  Fence fence = sample2();
  fence.rocks[0].position.x = 60.0;  // too far away to arrive
  const FenceScene made = fence_scene(fence);
  const End end = run(made, 100.0 * made.scene.plan.step);
  const std::size_t rock_coordinates = 3;
  for (std::size_t i = rock_coordinates; i < end.state.q.size(); ++i) {
    BOOST_TEST(end.state.q[i] == made.scene.initial.q[i]);
    BOOST_TEST(end.state.v[i] == 0.0);
  }
}

BOOST_AUTO_TEST_CASE(half_and_full_model_agree_to_the_last_bit_for_an_odd_count) {
  for (const int layers : {1, 2}) {
    Fence fence = sample2(layers);
    const FenceScene half = fence_scene(fence);
    fence.options.symmetry = FenceSymmetry::full;
    const FenceScene full = fence_scene(fence);
    BOOST_TEST(full.scene.model.bodies.size() == half.scene.model.bodies.size() + static_cast<std::size_t>(6 * layers));
    const State a = run(half, 0.05).state, b = run(full, 0.05).state;
    for (const Body& body : half.scene.model.bodies) {
      const Pose p = pose_of(half, a, body.name.c_str()), q = pose_of(full, b, body.name.c_str());
      BOOST_TEST(p.p_WB.x == q.p_WB.x);
      BOOST_TEST(p.p_WB.y == q.p_WB.y);
      BOOST_TEST(p.R_WB.sine == q.R_WB.sine);
      BOOST_TEST(p.v_WB.x == q.v_WB.x);
      BOOST_TEST(p.w_WB == q.w_WB);
    }
    // The full model is symmetric.
    BOOST_TEST(pose_of(full, b, "column3").p_WB.x == pose_of(full, b, "column-3").p_WB.x);
    BOOST_TEST(pose_of(full, b, "column3").p_WB.x != 0.0);
  }
}

BOOST_AUTO_TEST_CASE(half_and_full_model_lose_the_same_hangers) {
  Fence fence = sample2(1);
  fence.options.hanger_strength = 1e4;
  const FenceScene half = fence_scene(fence);
  fence.options.symmetry = FenceSymmetry::full;
  const FenceScene full = fence_scene(fence);
  const State a = run(half, 0.1).state, b = run(full, 0.1).state;
  const Layout of_half{half.scene.model}, of_full{full.scene.model};
  int broken = 0;
  for (std::size_t h = 0; h < half.scene.model.hangers.size(); ++h) {
    const Hanger& hanger = half.scene.model.hangers[h];
    const auto& hangers = full.scene.model.hangers;
    const std::ptrdiff_t same = std::ranges::find(hangers, hanger.name, &Hanger::name) - hangers.begin();
    BOOST_TEST(a.mode[of_half.first_hanger + h] == b.mode[of_full.first_hanger + static_cast<std::size_t>(same)]);
    broken += a.mode[of_half.first_hanger + h];
  }
  BOOST_TEST(broken >= 2);  // the central one, next to its segment's mirror image, and a neighbour
  for (const Body& body : half.scene.model.bodies) {
    const Pose p = pose_of(half, a, body.name.c_str()), q = pose_of(full, b, body.name.c_str());
    BOOST_TEST(p.p_WB.x == q.p_WB.x);
    BOOST_TEST(p.v_WB.y == q.v_WB.y);
  }
}

BOOST_AUTO_TEST_CASE(a_broken_hanger_closes_its_ledger_at_the_schemes_order) {
  Fence fence = sample2(1);
  fence.options.contact = FenceContact::resultant;
  fence.options.hanger_strength = 3e4;
  fence.options.column_ground = ColumnGround::contact;
  fence.step_factor = 0.02;
  const End coarse = run(fence_scene(fence), 0.05);
  fence.step_factor = 0.005;
  const End fine = run(fence_scene(fence), 0.05);
  BOOST_TEST(coarse.state.work[static_cast<std::size_t>(Mechanism::hanger_break)] > 0.0);
  BOOST_TEST(std::abs(coarse.balance_error) < 1e-3 * coarse.scale);
  BOOST_TEST(std::abs(fine.balance_error) < 0.4 * std::abs(coarse.balance_error));
}

BOOST_AUTO_TEST_CASE(rocks_off_centre_hit_the_columns_before_them) {
  Fence fence = sample2(1);
  fence.options.symmetry = FenceSymmetry::full;
  fence.rocks[0].along = 5.0;  // the third column's position
  const FenceScene off = fence_scene(fence);
  const State a = run(off, 0.02).state;
  BOOST_TEST(pose_of(off, a, "column3").p_WB.x < -0.1);
  BOOST_TEST(std::abs(pose_of(off, a, "column-3").p_WB.x) < 1e-2);
  // Equal to its mirror image up to the last digits: cables are summed in another order.
  fence.rocks[0].along = -5.0;
  const FenceScene mirrored = fence_scene(fence);
  const State b = run(mirrored, 0.02).state;
  BOOST_TEST(std::abs(pose_of(off, a, "column3").p_WB.x - pose_of(mirrored, b, "column-3").p_WB.x) < 1e-9);
  // Between two columns it hits both.
  fence.rocks[0].along = 1.25;
  BOOST_TEST(find_contact(fence_scene(fence).scene.model, "rock-column1").has_value());
  BOOST_TEST(find_contact(fence_scene(fence).scene.model, "rock-column2").has_value());
  BOOST_TEST(!find_contact(fence_scene(fence).scene.model, "rock-column3").has_value());
}

BOOST_AUTO_TEST_CASE(columns_unlike_the_others_hang_in_balance) {
  Fence fence = sample2(1);
  fence.rocks[0].position.x = 60.0;  // too far away to arrive
  fence.changed_columns = {{1, 1.25, 5.0, 0.76, 7.67, -5.0}, {3, 1.25, 2.0, 0.9, 4.67, -2.0}};
  const FenceScene made = fence_scene(fence);
  const Pose first = pose_of(made, made.scene.initial, "column1");
  const Pose third = pose_of(made, made.scene.initial, "column3");
  // Their top joints are on the cable: above the central one by the moments of the loads, as for equal columns.
  BOOST_TEST(third.p_WB.y + 4.67 > first.p_WB.y + 7.67);
  const End end = run(made, 50.0 * made.scene.plan.step);
  for (std::size_t i = 3; i < end.state.q.size(); ++i)
    BOOST_TEST(end.state.q[i] == made.scene.initial.q[i]);
}

BOOST_AUTO_TEST_CASE(dashpots_by_the_effective_mass_give_the_restitution_off_centre) {
  // One impact 2 ft above the centre of a column; 1 % of the contact's duration later, nothing else has happened yet.
  const auto restitution = [](FenceCalibration calibration) {
    Fence fence = sample2(1);
    fence.options.contact = FenceContact::resultant;
    fence.options.start = FenceStart::plain;
    fence.options.integrator = "velocity_verlet";
    fence.options.calibration = calibration;
    fence.rock_overlap = 0.002;  // an impact so short that the cables have no influence
    fence.step_factor = 0.001;
    fence.rocks[0].position = {2.4511, 2.0};
    fence.rocks[0].spin = 0.0;
    const FenceScene made = fence_scene(fence);
    const State end = run(made, 0.001).state;
    const Pose rock = pose_of(made, end, "rock"), column = pose_of(made, end, "column1");
    return (rock.v_WB.x - velocity_at(column, {1.25, 2.0}).x) / 65.0;
  };
  BOOST_TEST(std::abs(restitution(FenceCalibration::effective_mass) - 0.4) < 0.01);
  BOOST_TEST(std::abs(restitution(FenceCalibration::particles) - 0.4) > 0.015);
}

BOOST_AUTO_TEST_CASE(sleep_costs_nothing_but_digits_that_nobody_reads) {
  Fence fence = sample2(1, 41);
  fence.span = 125.0, fence.sag = 12.5;
  const auto end_of = [&](Sleep sleep) {
    fence.options.sleep = sleep;
    return run(fence_scene(fence), 0.05).state;
  };
  const State off = end_of(Sleep::off), exact = end_of(Sleep::exact), on = end_of(Sleep::on);
  BOOST_TEST(exact.q == off.q);
  BOOST_TEST(exact.v == off.v);
  BOOST_TEST(exact.work == off.work);
  for (std::size_t i = 0; i < off.q.size(); ++i)
    BOOST_TEST(std::abs(on.q[i] - off.q[i]) < 1e-10);
  BOOST_TEST(on.v[0] == off.v[0], boost::test_tools::tolerance(1e-10));
  // The wave has not reached the last column.
  BOOST_TEST(off.q[off.q.size() - 3] != fence_scene(fence).scene.initial.q[off.q.size() - 3]);
  BOOST_TEST(on.q[off.q.size() - 3] == fence_scene(fence).scene.initial.q[off.q.size() - 3]);
}

BOOST_AUTO_TEST_CASE(half_model_of_an_even_count_agrees_with_the_full_one) {
  // The segment between the central columns remains straight: its tension has no component in the plane.
  Fence fence = sample2(1, 12);
  fence.options.even_centre = EvenCentre::pair;
  const FenceScene half = fence_scene(fence);
  fence.options.symmetry = FenceSymmetry::full;
  const FenceScene full = fence_scene(fence);
  const State a = run(half, 0.05).state, b = run(full, 0.05).state;
  for (const Body& body : half.scene.model.bodies) {
    const Pose p = pose_of(half, a, body.name.c_str()), q = pose_of(full, b, body.name.c_str());
    BOOST_TEST(std::abs(p.p_WB.x - q.p_WB.x) < 1e-9);
    BOOST_TEST(std::abs(p.p_WB.y - q.p_WB.y) < 1e-9);
    BOOST_TEST(std::abs(p.v_WB.x - q.v_WB.x) < 1e-7);
  }
}

BOOST_AUTO_TEST_CASE(ledger_closes_at_the_schemes_order) {
  // Plastic cables, two layers, one resultant per pair: all mechanisms at once. The scheme is first order.
  Fence fence = sample2();
  fence.options.contact = FenceContact::resultant;
  fence.limit_top = 4e4;
  fence.friction = 0.3;
  fence.step_factor = 0.02;
  const FenceScene coarse = fence_scene(fence);
  fence.step_factor = 0.005;
  const FenceScene fine = fence_scene(fence);
  const End a = run(coarse, 0.05), b = run(fine, 0.05);
  BOOST_TEST(std::abs(a.balance_error) < 1e-3 * a.scale);
  BOOST_TEST(std::abs(b.balance_error) < 0.4 * std::abs(a.balance_error));
  BOOST_TEST(b.state.work[static_cast<std::size_t>(Mechanism::cable_yield)] > 0.0);
  BOOST_TEST(b.state.work[static_cast<std::size_t>(Mechanism::friction)] > 0.0);
}

BOOST_AUTO_TEST_CASE(column_against_column_by_the_rule_of_1993_keeps_no_energy) {
  // The force acts along a gradient, the overlap is measured along a ray: no potential has that force. The balance
  // error does not decrease with the step; with one layer, where the rule does not act, it does.
  const auto balance_error = [](int layers, double factor) {
    Fence fence = sample2(layers);
    fence.step_factor = factor;
    const End end = run(fence_scene(fence), 0.05);
    return end.balance_error / end.scale;
  };
  BOOST_TEST(std::abs(balance_error(1, 0.005)) < 0.4 * std::abs(balance_error(1, 0.02)));
  BOOST_TEST(std::abs(balance_error(2, 0.005)) > 3e-3);
  BOOST_TEST(std::abs(balance_error(2, 0.005)) < 1e-2);
}

BOOST_AUTO_TEST_CASE(what_cannot_be_is_refused) {
  Fence weak = sample2();
  weak.options.hanger_strength = 900.0;  // a column weighs 960 lb
  BOOST_CHECK_THROW(static_cast<void>(fence_scene(weak)), InputError);
  Fence even = sample2(1, 12);
  even.options.hanger_strength = 1e5;
  BOOST_CHECK_THROW(static_cast<void>(fence_scene(even)), InputError);
  even.options.symmetry = FenceSymmetry::full;
  BOOST_CHECK_NO_THROW(static_cast<void>(fence_scene(even)));
  Fence still = sample2();
  still.rocks[0].velocity = {};
  BOOST_CHECK_THROW(static_cast<void>(fence_scene(still)), InputError);
  Fence crowded = sample2();
  crowded.columns = 25;
  BOOST_CHECK_THROW(static_cast<void>(fence_scene(crowded)), InputError);
}

BOOST_AUTO_TEST_CASE(a_second_rock_meets_the_cables_of_the_first) {
  // The plastic elongation of the top cable from the first impact is present at the start of the second: the columns
  // hang lower, in balance, and the cables are less stretched than new ones would be.
  Fence fence = sample2(1);
  fence.limit_top = 6e4;
  const FenceScene first = fence_scene(fence);
  const State end = run(first, 0.05).state;
  const Layout layout{first.scene.model};
  for (std::size_t c = 0; c < first.scene.model.cables.size(); ++c) {
    const double stretch = end.z[layout.cable_slots[c].memory];
    if (stretch > 0.0) fence.stretched_cables.push_back({first.scene.model.cables[c].name, stretch});
  }
  BOOST_TEST(!fence.stretched_cables.empty());
  const FenceScene second = fence_scene(fence);
  BOOST_TEST(second.members[2].position.y < first.members[2].position.y - 0.01);
  fence.rocks[0].position.x = 60.0;  // too far away to arrive
  const FenceScene still = fence_scene(fence);
  const State rest = run(still, 20.0 * still.scene.plan.step).state;
  for (std::size_t i = 3; i < rest.q.size(); ++i)
    BOOST_TEST(rest.q[i] == still.scene.initial.q[i]);
  fence.stretched_cables.push_back({"tip1", 0.1});
  BOOST_CHECK_THROW(static_cast<void>(fence_scene(fence)), InputError);
}

BOOST_AUTO_TEST_CASE(stretched_on_one_side_it_hangs_alike_in_any_unit_of_length) {
  Fence fence = sample2(1);
  fence.options.symmetry = FenceSymmetry::full;
  fence.stretched_cables = {{"top1", 0.03}};
  Fence other = fence;
  const double unit = 0x1p-30;
  const auto tell = [unit](auto& owner) {
    using T = std::decay_t<decltype(owner)>;
    for (const auto& field : T::fields())
      owner.*field.member *= std::pow(unit, field.dimension.length);
    if constexpr (requires { T::vectors(); }) {
      for (const auto& field : T::vectors())
        owner.*field.member = std::pow(unit, field.dimension.length) * (owner.*field.member);
    }
  };
  tell(other);
  tell(other.ground), tell(other.rocks[0]), tell(other.column), tell(other.stretched_cables[0]);
  const FenceScene one = fence_scene(fence), two = fence_scene(other);
  BOOST_TEST(one.members[3].position.y != one.members[2].position.y);
  for (std::size_t i = 2; i < one.members.size(); ++i)
    BOOST_TEST(two.members[i].position.y == unit * one.members[i].position.y);
}

BOOST_AUTO_TEST_SUITE_END()
