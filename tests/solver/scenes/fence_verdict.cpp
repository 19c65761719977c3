/// Verdicts on a rock, from states made by hand, and implausible values of a fence.
#include <boost/test/unit_test.hpp>

#include "solver/scenes/fence_plausibility.hpp"
#include "tests/solver/scenes/watched_fence.hpp"

BOOST_AUTO_TEST_SUITE(fence_verdict_tests)

using namespace talus;
using namespace talus::scenes;

namespace {

Fence far_rock() {
  Fence fence = modern_sample2();
  fence.rocks.front().position.x = 4.0;
  return fence;
}

/// Shows one state after another, a second apart, and returns the verdict on the rock.
struct Story : Watched {
  explicit Story(const Fence& given) : Watched{given} { then(given.rocks.front().position, -65.0); }

  State at(Vec2 p, double vx, bool touches = false) const {
    State shown_state = state;
    const std::size_t rock = first("rock");
    shown_state.q[rock] = p.x, shown_state.q[rock + 1] = p.y, shown_state.v[rock] = vx;
    shown_state.v[rock + 1] = shown_state.v[rock + 2] = 0.0;
    const std::size_t contact = index(*find_contact(made.scene.model, "rock-column1"));
    shown_state.mode[dynamics.layout().contact_slots[contact].mode] = touches ? 1 : 0;
    return shown_state;
  }
  Verdict then(Vec2 p, double vx, bool touches = false) { return then(at(p, vx, touches)); }
  Verdict then(const State& seen) {
    show(seen, static_cast<double>(shown));
    return summary().rocks.front().verdict;
  }
};

bool says(const std::vector<std::string>& found, std::string_view expected) {
  return std::any_of(found.begin(), found.end(),
                     [&](const std::string& text) { return text.find(expected) != std::string::npos; });
}

}  // namespace

// The columns are 2.5 ft wide and 8 ft high around x = 0, y = 0; the rock arrives with -65 ft/s.
BOOST_AUTO_TEST_CASE(a_rock_that_passes) {
  Story under{far_rock()};
  BOOST_TEST((under.then({1.0, -3.0}, -60.0, true) == Verdict::undecided));
  BOOST_TEST((under.then({-2.0, -5.0}, -20.0) == Verdict::passed_under));
  BOOST_TEST(under.summary().rocks.front().passed_time == 2.0);
  BOOST_TEST((under.then({-4.0, -5.0}, -20.0) == Verdict::passed_under));
  BOOST_TEST(under.summary().rocks.front().passed_time == 2.0);
  BOOST_TEST((under.summary().verdict() == Verdict::passed_under));
  // It comes back.
  BOOST_TEST((under.then({1.0, -5.0}, 5.0) == Verdict::stopped));
  BOOST_TEST(under.summary().rocks.front().passed_time == 0.0);
  Story over{far_rock()};
  BOOST_TEST((over.then({-2.0, 9.0}, -60.0) == Verdict::passed_over));  // it touched nothing
  BOOST_TEST(!over.summary().rocks.front().touched);
}

BOOST_AUTO_TEST_CASE(a_column_that_is_pushed_is_not_passed) {
  Story story{far_rock()};
  State pushed = story.at({-2.0, 0.0}, -10.0, true);
  pushed.q[story.first("column1")] -= 4.0;
  BOOST_TEST((story.then(pushed) == Verdict::undecided));
  pushed.v[story.first("rock")] = 1.0;
  BOOST_TEST((story.then(pushed) == Verdict::stopped));
  // A column that moves back towards the rock has not let it pass.
  State back = story.at({0.5, 0.0}, -10.0);
  back.q[story.first("column1")] += 2.0;
  BOOST_TEST((story.then(back) == Verdict::undecided));
}

BOOST_AUTO_TEST_CASE(a_rock_that_stops) {
  Story story{far_rock()};
  BOOST_TEST((story.then({3.0, 0.0}, 0.0) == Verdict::undecided));  // it has not reached the fence
  story.then({3.0, 0.0}, -65.0);
  BOOST_TEST((story.then({2.0, 0.0}, -30.0, true) == Verdict::undecided));
  BOOST_TEST((story.then({2.5, 0.0}, 20.0) == Verdict::stopped));
  // Below a hundredth of its speed it is at rest, whatever its direction.
  BOOST_TEST((story.then({2.0, 0.0}, -0.6) == Verdict::stopped));
  BOOST_TEST((story.then({2.0, 0.0}, -1.3) == Verdict::undecided));
  BOOST_TEST(story.summary().rocks.front().end_velocity.x == -1.3);
  BOOST_TEST(story.summary().rocks.front().distance == 2.0);
}

BOOST_AUTO_TEST_CASE(a_rock_that_breaks_through) {
  Fence hanging = far_rock();
  hanging.options.hanger_strength = 8000.0;
  Story hanger{hanging};
  hanger.then({1.0, -3.0}, -60.0, true);
  State broken = hanger.at({-2.0, -5.0}, -20.0);
  broken.mode[hanger.dynamics.layout().first_hanger] = 1;
  BOOST_TEST((hanger.then(broken) == Verdict::broke_through));
  // The verdict on a rock that touched nothing depends on where it passed, not on parts that another rock has broken.
  Story beside{hanging};
  State gone = beside.at({-2.0, 9.0}, -20.0);
  gone.mode[beside.dynamics.layout().first_hanger] = 1;
  BOOST_TEST((beside.then(gone) == Verdict::passed_over));
  // Parts that break after it has passed do not matter.
  Story later{hanging};
  BOOST_TEST((later.then({-2.0, -5.0}, -20.0) == Verdict::passed_under));
  State after = later.at({-4.0, -5.0}, -20.0);
  after.mode[later.dynamics.layout().first_hanger] = 1;
  BOOST_TEST((later.then(after) == Verdict::passed_under));
  Fence cabled = far_rock();
  cabled.options.strength_top = 1e5;
  Story cable{cabled};
  cable.then({1.0, 3.0}, -60.0, true);
  State torn = cable.at({-2.0, 9.0}, -20.0);
  torn.mode[cable.dynamics.layout().cable_slots[0].mode] = ElasticPlastic::broken;
  BOOST_TEST((cable.then(torn) == Verdict::broke_through));
}

BOOST_AUTO_TEST_CASE(of_two_layers_both_must_be_passed) {
  Fence fence = far_rock();
  fence.layers = 2;
  Story story{fence};
  BOOST_TEST((story.then({-1.0, -6.0}, -20.0, true) == Verdict::undecided));
  BOOST_TEST((story.then({-4.0, -6.0}, -20.0) == Verdict::passed_under));
  BOOST_TEST(story.summary().rocks.front().passed_time == 2.0);  // that of the second layer
}

BOOST_AUTO_TEST_CASE(each_rock_has_the_approach_of_its_own_element) {
  Fence fence = far_rock();
  fence.rocks.push_back(fence.rocks.front());
  fence.rocks[1].position = {9.0, 2.0};
  fence.rocks[1].velocity = {-40.0, 3.0}, fence.rocks[1].spin = 1.5;
  Watched two{fence};
  two.show(two.state, 0.0);
  const double mass = two.mass("rock2"),
               inertia = two.made.scene.model.bodies[index(*find_body(two.made.scene.model, "rock2"))].inertia;
  const std::vector<RockPassage>& rocks = two.summary().rocks;
  BOOST_TEST(rocks.at(0).approach_velocity.x == -65.0);
  BOOST_TEST((rocks.at(1).approach_velocity == Vec2{-40.0, 3.0}));
  BOOST_TEST(rocks.at(1).approach_spin == 1.5);
  BOOST_TEST(rocks.at(1).approach_energy == 0.5 * (mass * (40.0 * 40.0 + 3.0 * 3.0) + inertia * 1.5 * 1.5),
             boost::test_tools::tolerance(1e-14));
  const std::vector<Column>& columns = two.watch.history().columns;
  BOOST_TEST(columns.size() == 10U);
  for (const Column& column : columns)
    BOOST_TEST((column.dimension == (column.name == "time"                                        ? dimension::time
                                     : column.name.ends_with(".vx")                               ? dimension::velocity
                                     : column.name.ends_with(".x") || column.name.ends_with(".y") ? dimension::length
                                                                                                  : dimension::force)),
               column.name);
}

// A rock without a velocity along x is on its way to the fence, from the side where it starts.
BOOST_AUTO_TEST_CASE(a_rock_that_falls_vertically_passes_towards_the_fence) {
  Fence fence = far_rock();
  fence.rocks.front().velocity = {0.0, -5.0};
  Story right{fence};
  BOOST_TEST((right.then({-2.0, -5.0}, -3.0) == Verdict::passed_under));
  fence.rocks.front().position.x = -4.0;
  Story left{fence};
  BOOST_TEST((left.then({2.0, -5.0}, 3.0) == Verdict::passed_under));
}

BOOST_AUTO_TEST_CASE(a_rock_that_starts_behind_has_passed_nothing) {
  Fence fence = far_rock();
  fence.rocks.front().position.x = -4.0;
  Story story{fence};
  BOOST_TEST((story.then({-9.0, 0.0}, -65.0) == Verdict::undecided));
  // The verdict is the same for a rock from the left.
  fence.rocks.front().velocity.x = 65.0;
  Story mirrored{fence};
  BOOST_TEST((mirrored.then({2.0, -5.0}, 30.0) == Verdict::passed_under));
}

BOOST_AUTO_TEST_CASE(the_worst_of_several_rocks_counts) {
  FenceSummary summary;
  BOOST_TEST((summary.verdict() == Verdict::undecided));
  BOOST_TEST(summary.largest_anchor() == nullptr);
  for (const Verdict verdict : {Verdict::stopped, Verdict::passed_under, Verdict::undecided})
    summary.rocks.emplace_back().verdict = verdict;
  BOOST_TEST((summary.verdict() == Verdict::passed_under));
  summary.segments = {{.top = true, .peak = 5.0, .limit = 50.0}, {.top = false, .peak = 3.0, .limit = 4.0}};
  BOOST_TEST(summary.largest_segment() == &summary.segments[0]);
  BOOST_TEST(summary.closest_segment() == &summary.segments[1]);
}

BOOST_AUTO_TEST_CASE(a_verdict_is_put_back) {
  Story one{far_rock()};
  one.then({-2.0, 9.0}, -20.0);
  Archive saving;
  one.watch.serialize(saving);
  Watched other{far_rock()};
  Archive putting_back{saving.items()};
  other.watch.serialize(putting_back);
  other.show(one.at({-3.0, 1.0}, -20.0), 9.0);
  BOOST_TEST((other.summary().verdict() == Verdict::passed_over));
  BOOST_TEST(other.summary().rocks.front().passed_time == 1.0);
  ArchiveItems wrong = saving.items();
  wrong.at("rock_0.verdict") = std::vector{7.0};
  Archive refused{wrong};
  BOOST_CHECK_THROW(other.watch.serialize(refused), std::exception);
}

BOOST_AUTO_TEST_CASE(geometry_that_is_unlikely_to_be_meant) {
  const auto found = [](const Fence& fence) { return implausible_geometry(fence, fence_scene(fence)); };
  BOOST_TEST(found(modern_sample2()).empty());
  Fence close = modern_sample2();
  close.spacing = 2.0;
  BOOST_TEST(says(found(close),
                  "spacing: columns of a width of 2.5 ft have a spacing of 2 ft, so that neighbours overlap by "
                  "0.5 ft"));
  Fence deep = modern_sample2();
  deep.ground.position.y = -4.25;  // its surface is at -3.75, the columns reach down to -4
  BOOST_TEST(says(found(deep), "ground: it reaches 0.25 ft into the columns"));
  Fence slack = modern_sample2();
  slack.sag = 60.0;
  BOOST_TEST(says(found(slack), "sag: the top cable hangs 60 ft down over a span of only 55 ft"));
  Fence layers = sample2(2);
  BOOST_TEST(found(layers).empty());
  layers.layer_spacing = 2.0;
  BOOST_TEST(says(found(layers), "layer_spacing: the layers are 2 ft apart, columns 2.5 ft thick"));
}

BOOST_AUTO_TEST_CASE(motion_that_is_unlikely_to_be_meant) {
  Story story{far_rock()};
  BOOST_TEST(says(implausible_motion(story.fence, story.summary()),
                  "'rock' never touches the fence; at the end it is 4 "
                  "ft from it"));
  story.then({2.0, 0.0}, -20.0, true);
  BOOST_TEST(implausible_motion(story.fence, story.summary()).empty());
  story.then({20.0, 100.0}, 20.0);
  // 104.5 ft above the ground; the lowest top joint is at 11.17 ft.
  BOOST_TEST(says(implausible_motion(story.fence, story.summary()),
                  "'rock' flies away: it rises to 104.5 ft over the ground, 9.36 times as high as the fence"));
  // The height of a fence is that of its higher layer.
  FenceSummary layers;
  layers.rocks.resize(1), layers.layers.resize(2);
  layers.rocks[0].touched = true, layers.rocks[0].highest = 30.0;
  for (const auto& [first, second] : {std::pair{5.0, 10.0}, {10.0, 5.0}}) {
    layers.layers[0].top.start = first, layers.layers[1].top.start = second;
    BOOST_TEST(implausible_motion(story.fence, layers).empty());
  }
}

BOOST_AUTO_TEST_SUITE_END()
