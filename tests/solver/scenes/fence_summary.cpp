/// Contents of the engineer's sheet of a fence, checked independently: the static shape, momentum balances, states made
/// by hand.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "solver/run/failure_log.hpp"
#include "tests/solver/scenes/watched_fence.hpp"

BOOST_AUTO_TEST_SUITE(fence_summary_tests)

using namespace talus;
using namespace talus::scenes;

namespace {

Vec2 momentum(const Watched& run, const State& state) {
  Vec2 sum;
  for (std::size_t i = 0; i < run.made.scene.model.bodies.size(); ++i) {
    const Body& body = run.made.scene.model.bodies[i];
    if (body.mobility == Mobility::fixed) continue;
    const std::size_t first = run.dynamics.layout().first[i];
    sum += body.mass * Vec2{state.v[first], state.v[first + 1]};
  }
  return sum;
}

double weight(const Watched& run) {
  double sum = 0.0;
  for (const Body& body : run.made.scene.model.bodies)
    sum += body.mobility == Mobility::fixed ? 0.0 : body.mass * run.fence.gravity;
  return sum;
}

}  // namespace

/// At rest each hanger carries its column, each anchor half of all columns and the horizontal tension of the static
/// shape.
BOOST_AUTO_TEST_CASE(at_rest) {
  Watched run{modern_sample2()};
  const double W = run.mass("column1") * run.fence.gravity;
  run.show(run.state, 0.0);
  run.show(run.state, 0.25);
  const FenceSummary& found = run.summary();
  const auto close = boost::test_tools::tolerance(1e-9);  // the static shape is solved to round-off
  BOOST_TEST(found.columns.size() == 13U);
  for (const ColumnRecord& c : found.columns) {
    BOOST_TEST(c.hanger.peak == W, close);
    BOOST_TEST(c.hanger.impulse.y == 0.25 * W, close);
    BOOST_TEST(c.travel == 0.0);
  }
  BOOST_TEST(found.anchors.size() == 2U);
  for (const AnchorRecord& anchor : found.anchors) {
    const double outwards = run.dynamics.cables().joints()[anchor.joint].along > 0.0 ? 1.0 : -1.0;
    BOOST_TEST(anchor.force.at_peak.y == -6.5 * W, close);
    BOOST_TEST(anchor.force.at_peak.z == -outwards * run.made.horizontal_tension, close);
    BOOST_TEST(anchor.force.impulse.z == -0.25 * outwards * run.made.horizontal_tension, close);
    BOOST_TEST(std::abs(anchor.force.at_peak.x) < 1e-9 * W);
  }
  // The lowest top joint is that of the central column: 6.67 ft above its centre; the ground's surface is 4.5 ft below.
  BOOST_TEST(found.layers.front().top.start == 6.67 + 4.5, close);
  // The highest bottom joint is that of the outermost column: 4 ft below its centre, which is higher by the sag except
  // one segment.
  BOOST_TEST(found.layers.front().bottom.start == static_shape(run.fence).heights[6] - 4.0 + 4.5, close);
}

/// Compares m dv of a column without contact, and of all bodies, with the impulses of hangers, anchors and weights. The
/// trapezoids are a time step h = 0.83e-4 s wide in a motion of the segments of omega ~ 7e2/s: (omega h)^2/12 = 3e-4 of
/// a force's oscillation, much less of its integral.
BOOST_AUTO_TEST_CASE(impulses_balance_momentum) {
  Fence fence = modern_sample2();
  fence.connections = 1;
  fence.step_factor = 0.25;
  Watched run{fence};
  const State start = run.state;
  const double end = 0.06;
  BOOST_TEST(static_cast<bool>(run.run(end)));
  const double t = run.state.t;
  BOOST_TEST(run.summary().rocks.front().touched);
  for (const char* name : {"column2", "column-2", "column3", "column-5"}) {
    const std::size_t first = run.first(name);
    const double m = run.mass(name);
    const Vec3& hanger = column(run, name).hanger.impulse;
    const double scale = column(run, name).hanger.peak * t;
    BOOST_TEST(std::abs(m * (run.state.v[first] - start.v[first]) - hanger.x) < 1e-3 * scale);
    BOOST_TEST(std::abs(m * (run.state.v[first + 1] - start.v[first + 1]) - hanger.y + m * fence.gravity * t) <
               1e-3 * scale);
  }
  Vec3 on_anchors;
  for (const AnchorRecord& anchor : run.summary().anchors) {
    on_anchors.x += anchor.force.impulse.x, on_anchors.y += anchor.force.impulse.y;
    on_anchors.z += anchor.force.impulse.z;
  }
  const Vec2 change = momentum(run, run.state) - momentum(run, start);
  const double scale = norm(momentum(run, start));
  BOOST_TEST(std::abs(change.x + on_anchors.x) < 1e-3 * scale);
  BOOST_TEST(std::abs(change.y + on_anchors.y + weight(run) * t) < 1e-3 * scale);
  BOOST_TEST(std::abs(on_anchors.z) < 1e-9 * scale);  // a symmetric impact
}

/// Peaks compared with those that the recorder finds over every step; the rock's energy compared with its law of
/// motion.
BOOST_AUTO_TEST_CASE(peaks_and_passage) {
  Watched run{modern_sample2()};
  Recorder recorder{run.dynamics, run.state};
  const std::size_t rock = run.first("rock");
  const double m = run.mass("rock");
  double deepest = 0.0;
  State exit;
  run.also = [&](const State& seen) {
    recorder(Snapshot{run.dynamics, seen}, {0, 0, true, false, false, &seen});
    deepest = std::max(deepest, run.made.scene.initial.q[rock] - seen.q[rock]);
    if (run.summary().rocks.front().exit_time == seen.t) exit = seen;
  };
  BOOST_TEST(static_cast<bool>(run.run(0.05)));
  const auto peak = [&](const std::string& name) {
    const auto& columns = recorder.history().columns;
    const auto found = std::find_if(columns.begin(), columns.end(), [&](const Column& c) { return c.name == name; });
    return recorder.extreme(static_cast<std::size_t>(found - columns.begin()));
  };
  for (const SegmentRecord& segment : run.summary().segments) {
    const Extreme kept = peak(run.made.scene.model.cables[index(segment.cable)].name + ".tension");
    BOOST_TEST(segment.peak == kept.maximum);
    BOOST_TEST(segment.peak_time == (kept.maximum > 0.0 ? kept.maximum_time : 0.0));
    BOOST_TEST(segment.margin() == kept.maximum / 1e8);
  }
  const RockPassage& passage = run.summary().rocks.front();
  BOOST_TEST(passage.approach_energy == 0.5 * m * 65.0 * 65.0 + 0.5 * 0.4 * m * 1.201 * 1.201 * 34.0 * 34.0,
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(passage.exit_velocity.x == exit.v[rock]);
  BOOST_TEST(passage.exit_spin == exit.v[rock + 2]);
  const double energy = 0.5 * m * (exit.v[rock] * exit.v[rock] + exit.v[rock + 1] * exit.v[rock + 1]) +
                        0.5 * 0.4 * m * 1.201 * 1.201 * exit.v[rock + 2] * exit.v[rock + 2];
  BOOST_TEST(passage.exit_energy == energy, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(passage.energy_loss_fraction() == 1.0 - energy / passage.approach_energy,
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(passage.travel <= deepest);
  double largest = 0.0;
  for (const ColumnRecord& c : run.summary().columns) {
    const std::string name = run.made.scene.model.bodies[index(c.body)].name;
    const Extreme kept = peak(name + ".x");
    BOOST_TEST(c.travel == std::max(-kept.minimum, kept.maximum));  // columns start at x = 0
    largest = std::max(largest, c.travel);
  }
  BOOST_TEST(run.summary().travel == largest);
}

/// A watch of the rocks alone finds the same passage and verdict, and the heights at the start.
BOOST_AUTO_TEST_CASE(a_watch_of_the_rocks_alone) {
  Watched all{modern_sample2()}, alone{modern_sample2(), FenceResults::of_rocks};
  BOOST_TEST(static_cast<bool>(all.run(0.05)));
  BOOST_TEST(static_cast<bool>(alone.run(0.05)));
  const RockPassage &found = alone.summary().rocks.front(), &expected = all.summary().rocks.front();
  BOOST_TEST(expected.touched);
  BOOST_TEST(found.exit_time == expected.exit_time);
  BOOST_TEST(found.exit_velocity.x == expected.exit_velocity.x);
  BOOST_TEST(found.end_energy == expected.end_energy);
  BOOST_TEST(found.travel == expected.travel);
  BOOST_TEST(found.highest == expected.highest);
  BOOST_TEST(found.distance == expected.distance);
  BOOST_TEST((alone.summary().verdict() == all.summary().verdict()));
  BOOST_TEST(alone.summary().layers.front().top.start == all.summary().layers.front().top.start);
  BOOST_TEST(alone.summary().largest_hanger()->hanger.peak == 0.0);
  BOOST_TEST(alone.watch.history().rows.empty());
}

/// States made by hand: a rock that approaches, touches, is reversed and leaves; a fence that sinks and is pushed.
BOOST_AUTO_TEST_CASE(states_made_by_hand) {
  Fence fence = modern_sample2();
  fence.rocks.front().position.x = 4.0;
  Watched run{fence};
  const std::size_t rock = run.first("rock"), centre = run.first("column1");
  const std::size_t contact = index(*find_contact(run.made.scene.model, "rock-column1"));
  const std::size_t mode = run.dynamics.layout().contact_slots[contact].mode;
  const auto state = [&](double x, double vx, bool touches, double sink, double push) {
    State made = run.state;
    made.q[rock] = x, made.v[rock] = vx;
    made.mode[mode] = touches ? 1 : 0;
    made.q[centre] += push, made.q[centre + 1] -= sink;
    return made;
  };
  run.show(state(4.0, -65.0, false, 0.0, 0.0), 0.0);
  run.show(state(3.0, -60.0, false, 0.0, 0.0), 1.0);
  run.show(state(2.0, -40.0, true, 0.5, -0.25), 2.0);
  run.show(state(1.5, -10.0, true, 1.0, -1.5), 3.0);
  run.show(state(1.75, 5.0, true, 0.75, -1.0), 4.0);
  run.show(state(2.5, 20.0, false, 0.25, 0.0), 5.0);
  run.show(state(4.5, 30.0, false, 0.25, 0.0), 6.0);
  const RockPassage& passage = run.summary().rocks.front();
  BOOST_TEST(passage.touch_time == 2.0);
  BOOST_TEST(passage.approach_velocity.x == -60.0);
  BOOST_TEST(passage.left);
  BOOST_TEST(passage.exit_time == 5.0);
  BOOST_TEST(passage.exit_velocity.x == 20.0);
  BOOST_TEST(passage.turned);
  BOOST_TEST(passage.braking_time == 2.0);
  BOOST_TEST(passage.travel == 0.5);
  BOOST_TEST(column(run, "column1").travel == 1.5);
  BOOST_TEST(column(run, "column1").travel_time == 3.0);
  BOOST_TEST(run.summary().at_travel.t == 3.0);
  const LayerRecord::Height& top = run.summary().layers.front().top;
  const auto close = boost::test_tools::tolerance(1e-12);
  BOOST_TEST(top.start == 11.17, close);
  BOOST_TEST(top.extreme == 10.17, close);
  BOOST_TEST(top.extreme_time == 3.0);
  BOOST_TEST(top.end == 10.92, close);
}

BOOST_AUTO_TEST_CASE(a_rock_that_stays_and_one_that_never_touches) {
  Watched run{modern_sample2()};
  const std::size_t contact = index(*find_contact(run.made.scene.model, "rock-column1"));
  State touching = run.state;
  touching.mode[run.dynamics.layout().contact_slots[contact].mode] = 1;
  run.show(touching, 0.0);
  run.show(touching, 0.5);
  const RockPassage& passage = run.summary().rocks.front();
  BOOST_TEST(!passage.left);
  BOOST_TEST(!passage.turned);
  BOOST_TEST(passage.exit_time == 0.5);
  BOOST_TEST(passage.braking_time == 0.5);
  Watched away{modern_sample2()};
  State apart = away.state;
  std::fill(apart.mode.begin(), apart.mode.end(), Mode{0});
  away.show(apart, 0.0);
  BOOST_TEST(!away.summary().rocks.front().touched);
  BOOST_TEST(away.summary().rocks.front().approach_velocity.x == -65.0);
}

/// A yielding part shows its limit, a broken one at most its own limit; a column without its hanger no longer hangs,
/// and its joint falls with it.
BOOST_AUTO_TEST_CASE(limits) {
  Fence fence = modern_sample2();
  fence.limit_top = 4e4;
  fence.options.hanger_strength = 8000.0;
  Watched run{fence};
  FailureLog log{run.dynamics};
  double broken_at = 0.0;
  Vec3 impulse_then;
  run.also = [&](const State& seen) {
    log(seen, {});
    const bool broke = seen.mode[run.dynamics.layout().first_hanger + 0] != 0;
    if (broke && broken_at == 0.0) broken_at = seen.t, impulse_then = column(run, "column1").hanger.impulse;
  };
  BOOST_TEST(static_cast<bool>(run.run(0.1)));
  BOOST_TEST(broken_at > 0.0);
  const ColumnRecord& central = column(run, "column1");
  BOOST_TEST(central.limit == 8000.0);
  BOOST_TEST(central.margin() < 1.0);  // the last state before the break
  BOOST_TEST(central.margin() > 0.8);
  BOOST_TEST(central.hanger.peak_time < broken_at);
  BOOST_TEST((central.hanger.impulse == impulse_then));
  for (const SegmentRecord& segment : run.summary().segments) {
    const auto part = "cable '" + run.made.scene.model.cables[index(segment.cable)].name + "'";
    const bool yielded = std::any_of(log.failures().begin(), log.failures().end(),
                                     [&](const Failure& failure) { return failure.part == part; });
    BOOST_TEST(yielded == (segment.margin() > 1.0 - 1e-12));
    BOOST_TEST(segment.margin() < 1.0 + 1e-12);
  }
  const std::size_t first = run.first("column1");
  const double joint = run.state.q[first + 1] + 6.67 * std::cos(run.state.q[first + 2]) + 4.5;
  BOOST_TEST(run.summary().layers.front().top.end <= joint + 1e-9);
}

/// Heights over uneven ground, and the joints of a column that differs from the others.
BOOST_AUTO_TEST_CASE(heights_over_terrain) {
  Fence fence = modern_sample2();
  fence.ground_profile = {{-20.0, -6.0}, {-10.0, -7.0}, {10.0, -7.0}, {20.0, -3.0}};
  fence.changed_columns = {{7, 1.25, 3.0, 0.76, 5.0, -3.0}};
  Watched run{fence};
  run.show(run.state, 0.0);
  const LayerRecord& layer = run.summary().layers.front();
  const auto close = boost::test_tools::tolerance(1e-9);
  const std::size_t outer = run.first("column7");
  BOOST_TEST(layer.top.start == 6.67 + 7.0, close);
  BOOST_TEST(layer.bottom.start == run.state.q[outer + 1] - 3.0 + 7.0, close);
}

/// A summary that is restored covers the whole run as if it had seen all states.
BOOST_AUTO_TEST_CASE(a_watch_goes_on) {
  Fence fence = modern_sample2();
  fence.limit_top = 4e4;
  Watched whole{fence};
  std::vector<State> seen;
  whole.also = [&](const State& state) { seen.push_back(state); };
  BOOST_TEST(static_cast<bool>(whole.run(0.03)));
  Watched first{fence}, second{fence};
  const std::size_t half = seen.size() / 2;
  for (std::size_t i = 0; i < half; ++i)
    first.watch(Snapshot{first.dynamics, seen[i]}, {static_cast<long>(i), 0, false, false, false, &seen[i]});
  Archive saving;
  first.watch.serialize(saving);
  Archive putting_back{saving.items()};
  second.watch.serialize(putting_back);
  BOOST_TEST(putting_back.left_over().empty());
  for (std::size_t i = half; i < seen.size(); ++i)
    second.watch(Snapshot{second.dynamics, seen[i]}, {static_cast<long>(i), 0, false, false, false, &seen[i]});
  Archive one, other;
  whole.watch.serialize(one);
  second.watch.serialize(other);
  for (const auto& [name, value] : one.items()) {
    if (!name.starts_with("history.")) BOOST_TEST((other.items().at(name) == value), name);
  }
}

BOOST_AUTO_TEST_SUITE_END()
