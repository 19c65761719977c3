/// The contact search compared with brute force: an excluded pair never touches.
#include "solver/dynamics/candidates.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <type_traits>
#include <variant>
#include <vector>

#include "solver/geometry/gap.hpp"

BOOST_AUTO_TEST_SUITE(candidates_tests)

using namespace talus;

namespace {

/// Overlap of a rectangle's lowest corner with a half-plane.
double lowest_corner(const Rectangle& box, const Pose& A, const Pose& plane) {
  double depth = -1e300;
  for (const Vec2 corner : boundary_nodes(Shape{box}, 4))
    depth = std::max(depth, gap(Ball{corner, 0.0}, A, HalfPlane{}, plane).depth);
  return depth;
}

struct RandomPoses {
  std::mt19937_64 random{3};
  std::uniform_real_distribution<double> position{-4.0, 4.0}, angle{-7.0, 7.0};
  Pose operator()() { return {{position(random), position(random)}, rotation(angle(random)), {}, 0.0}; }
};

/// Counts the excluded pairs among 20000 and checks that none of them overlaps according to the exact gap.
template <class A, class B>
int left_out(const A& a, const B& b, auto&& depth) {
  RandomPoses pose;
  int count = 0;
  for (int i = 0; i < 20000; ++i) {
    const Candidate pair{BodyId{}, BodyId{}, bounds(Shape{a}), bounds(Shape{b}), 0, 0};
    const Pose A_pose = pose(), B_pose = pose();
    if (!out_of_reach(pair, A_pose, B_pose)) continue;
    ++count;
    BOOST_REQUIRE(depth(A_pose, B_pose) <= 0.0);
  }
  return count;
}

/// Scattered bodies, every pair of which is a candidate; the last one is ground.
struct Strewn {
  static constexpr std::size_t bodies = 30;
  std::mt19937 random;
  Poses poses{bodies};
  std::vector<double> angles;
  std::vector<Shape> shapes;
  ContactSearch search;

  /// `reach` [L] is the reach of a third of the pairs; another third has twice that, the rest zero.
  explicit Strewn(unsigned seed, double reach = 0.0) : random{seed} {
    std::uniform_real_distribution<double> position{-6.0, 6.0}, turn{0.0, 6.3}, size{0.2, 1.0};
    for (std::size_t i = 0; i < bodies; ++i) {
      angles.push_back(turn(random));
      poses.set(i, {{position(random), position(random)}, rotation(angles[i]), {}, 0.0});
      if (i % 3 == 0)
        shapes.emplace_back(Circle{size(random)});
      else
        shapes.emplace_back(Rectangle{size(random), size(random)});
    }
    shapes.back() = HalfPlane{};
    for (std::size_t a = 0; a < bodies; ++a) {
      for (std::size_t b = a + 1; b < bodies; ++b) {
        // The gap of two separate rectangles is not a distance.
        const bool boxes = std::holds_alternative<Rectangle>(shapes[a]) && std::holds_alternative<Rectangle>(shapes[b]);
        search.add({static_cast<BodyId>(a), static_cast<BodyId>(b), bounds(shapes[a]), bounds(shapes[b]), 0, 0,
                    boxes ? 0.0 : reach * static_cast<double>(b % 3)});
      }
    }
    search.prepare(bodies);
  }

  /// Moves and turns all bodies except the ground by up to `maximum`.
  void wander(double maximum) {
    std::uniform_real_distribution<double> step{-maximum, maximum};
    for (std::size_t i = 0; i + 1 < bodies; ++i) {
      const Vec2 displacement{step(random), step(random)};
      angles[i] += step(random);
      poses.set(i, {poses[i].p_WB + displacement, rotation(angles[i]), {}, 0.0});
    }
  }

  /// Overlap of the pair according to its exact gap.
  double depth(const Candidate& pair) const {
    const Pose A = poses[index(pair.a)], B = poses[index(pair.b)];
    return std::visit(
        [&]<class S, class T>(const S& a, const T& b) -> double {
          constexpr bool ball_a = std::is_same_v<S, Circle>, ball_b = std::is_same_v<T, Circle>;
          constexpr bool box_a = std::is_same_v<S, Rectangle>, box_b = std::is_same_v<T, Rectangle>;
          constexpr bool ground_b = std::is_same_v<T, HalfPlane>;
          if constexpr (ball_a && (ball_b || box_b || ground_b))
            return gap(Ball{{}, a.radius}, A, b, B).depth;
          else if constexpr (box_a && ball_b)
            return gap(Ball{{}, b.radius}, B, a, A).depth;
          else if constexpr (box_a && box_b)
            return gap(a, A, b, B).depth;
          else if constexpr (box_a && ground_b)
            return lowest_corner(a, A, B);
          else
            throw std::logic_error{"no such pair"};
        },
        shapes[index(pair.a)], shapes[index(pair.b)]);
  }
};

/// Checks that found pairs are within reach, and that the others are beyond the law's reach; returns the number of
/// pairs found.
long check_found(const Strewn& scene, const std::vector<char>& found) {
  for (std::size_t p = 0; p < found.size(); ++p) {
    const Candidate& pair = scene.search.pairs()[p];
    if (found[p])
      BOOST_TEST(!out_of_reach(pair, scene.poses[index(pair.a)], scene.poses[index(pair.b)]));
    else
      BOOST_TEST(scene.depth(pair) < -pair.reach);
  }
  return std::count(found.begin(), found.end(), 1);
}

}  // namespace

BOOST_AUTO_TEST_CASE(circle_and_rectangle) {
  const Circle circle{0.7};
  const Rectangle box{0.5, 1.5};
  const int found = left_out(circle, box, [&](const Pose& A, const Pose& B) {
    return gap(Ball{{}, circle.radius}, A, box, B).depth;
  });
  BOOST_TEST(found > 10000);
  const int swapped = left_out(box, circle, [&](const Pose& A, const Pose& B) {
    return gap(Ball{{}, circle.radius}, B, box, A).depth;
  });
  BOOST_TEST(swapped > 10000);
}

BOOST_AUTO_TEST_CASE(rectangles) {
  const Rectangle a{0.5, 1.5}, b{1.0, 0.3};
  BOOST_TEST(left_out(a, b, [&](const Pose& A, const Pose& B) { return gap(a, A, b, B).depth; }) > 10000);
}

BOOST_AUTO_TEST_CASE(rectangle_and_half_plane_at_any_slope) {
  const Rectangle a{0.5, 1.5};
  BOOST_TEST(left_out(a, HalfPlane{}, [&](const Pose& A, const Pose& B) { return lowest_corner(a, A, B); }) > 5000);
}

BOOST_AUTO_TEST_CASE(what_touches_is_found_however_the_bodies_move) {
  // Steps that keep the list of close pairs valid for a while, and at times one that invalidates it.
  for (unsigned seed = 0; seed < 40; ++seed) {
    Strewn scene{seed};
    Sweep scratch;
    for (int move = 0; move < 60; ++move) {
      std::vector<char> found(scene.search.pairs().size(), 0);
      BOOST_TEST(scene.search.find(scene.poses, found, scratch));
      BOOST_TEST(check_found(scene, found) > 10);
      scene.wander(move % 20 == 19 ? 0.5 : 0.003);
    }
  }
}

BOOST_AUTO_TEST_CASE(pairs_are_found_from_the_reach_of_their_law_on) {
  long nearer = 0, found_at_a_distance = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    Strewn acting{seed, 0.4}, touching{seed};
    Sweep scratch, other_scratch;
    for (int move = 0; move < 30; ++move) {
      std::vector<char> found(acting.search.pairs().size(), 0), others = found;
      acting.search.find(acting.poses, found, scratch), touching.search.find(touching.poses, others, other_scratch);
      check_found(acting, found);
      for (std::size_t p = 0; p < found.size(); ++p) {
        const Candidate& pair = acting.search.pairs()[p];
        const double depth = acting.depth(pair);
        nearer += found[p] && !others[p];
        found_at_a_distance += found[p] && depth < 0.0 && depth > -pair.reach;
        BOOST_TEST((found[p] || !others[p]));
        if (!is_unbounded(pair.bounds_b)) BOOST_TEST(!(depth > -pair.reach && cannot_touch(pair, acting.poses, 0.0)));
      }
      acting.wander(move % 10 == 9 ? 0.5 : 0.003), touching.wander(move % 10 == 9 ? 0.5 : 0.003);
    }
  }
  BOOST_TEST(nearer > 1000);
  BOOST_TEST(found_at_a_distance > 1000);
}

BOOST_AUTO_TEST_CASE(a_list_stands_until_a_body_has_moved_by_its_skin) {
  // A disc of radius 1 and a box with sides 2 and 1 whose corners are at most 1.5 from its centre: skins of 0.05 and
  // 0.025.
  ContactSearch search;
  search.add({BodyId{0}, BodyId{1}, bounds(Shape{Circle{1.0}}), bounds(Shape{Rectangle{1.0, 0.5}}), 0, 0});
  search.prepare(2);
  Poses at_rest{2};
  at_rest.set(0, {{0.0, 0.0}, {}, {}, 0.0});
  at_rest.set(1, {{3.0, 0.0}, {}, {}, 0.0});
  Sweep scratch;
  std::vector<char> found(1, 0);
  const auto is_within = [&](std::size_t body, const Pose& pose) {
    search.find(at_rest, found, scratch);
    Poses poses = at_rest;
    poses.set(body, pose);
    search.find(poses, found, scratch);
    const Positions& listed = scratch.positions;
    return listed.x[body] == at_rest.x[body] && listed.y[body] == at_rest.y[body] &&
           listed.cosine[body] == at_rest.cosine[body] && listed.sine[body] == at_rest.sine[body];
  };
  const auto none = std::numeric_limits<double>::quiet_NaN();
  for (const double sign : {1.0, -1.0}) {
    BOOST_TEST(is_within(0, {{sign * 0.0499, 0.0}, {}, {}, 0.0}));
    BOOST_TEST(!is_within(0, {{sign * 0.0501, 0.0}, {}, {}, 0.0}));
    BOOST_TEST(!is_within(0, {{0.0, sign * 0.0501}, {}, {}, 0.0}));
    BOOST_TEST(is_within(0, {{0.0, 0.0}, rotation(sign), {}, 0.0}));  // no point of its outline moves
    BOOST_TEST(is_within(1, {{3.0 + sign * 0.0249, 0.0}, {}, {}, 0.0}));
    BOOST_TEST(!is_within(1, {{3.0 + sign * 0.0251, 0.0}, {}, {}, 0.0}));
    BOOST_TEST(is_within(1, {{3.0, 0.0}, rotation(sign * 0.0164), {}, 0.0}));
    BOOST_TEST(!is_within(1, {{3.0, 0.0}, rotation(sign * 0.0168), {}, 0.0}));
    BOOST_TEST(!is_within(0, {{sign * none, 0.0}, {}, {}, 0.0}));
    BOOST_TEST(!is_within(1, {{3.0, 0.0}, {1.0, sign * none}, {}, 0.0}));
  }
}

BOOST_AUTO_TEST_CASE(what_is_said_at_once_is_never_too_little) {
  const Strewn strewn{5};
  std::mt19937 random{6};
  std::uniform_real_distribution<double> speed{-3.0, 3.0}, size{0.0, 0.5};
  Poses poses = strewn.poses;
  const auto largest_radius = [](const Bounds& of) {
    return of.round ? of.half_width : std::hypot(of.half_width, of.half_height);
  };
  long apart = 0;
  for (int i = 0; i < 200; ++i) {
    for (std::size_t body = 0; body < Strewn::bodies; ++body)
      poses.vx[body] = speed(random), poses.vy[body] = speed(random), poses.w[body] = speed(random);
    for (const Candidate& pair : strewn.search.pairs()) {
      if (is_unbounded(pair.bounds_a) || is_unbounded(pair.bounds_b)) continue;
      const Pose A = poses[index(pair.a)], B = poses[index(pair.b)];
      BOOST_REQUIRE(closing_speed_bound(pair, poses) >= largest_closing_speed(pair, A, B));
      const double displacement = size(random);
      if (!cannot_touch(pair, poses, displacement)) continue;
      ++apart;
      BOOST_REQUIRE(norm(B.p_WB - A.p_WB) - largest_radius(pair.bounds_a) - largest_radius(pair.bounds_b) >
                    displacement);
      BOOST_REQUIRE(displacement <= 0.5 * (minimum_half_width(pair.bounds_a) + minimum_half_width(pair.bounds_b)));
    }
  }
  BOOST_TEST(apart > 10000);
}

BOOST_AUTO_TEST_CASE(bodies_that_come_from_beyond_their_skins_are_found_as_they_touch) {
  // Both bodies approach: after the list was made each moves by slightly less than its skin, then by another step.
  ContactSearch search;
  search.add({BodyId{0}, BodyId{1}, bounds(Shape{Circle{1.0}}), bounds(Shape{Circle{2.0}}), 0, 0});
  search.prepare(2);
  Sweep scratch;
  Poses poses{2};
  poses.x[1] = 3.1501;
  std::vector<char> found(1, 0);
  BOOST_TEST(!search.find(poses, found, scratch));
  BOOST_TEST(scratch.close.empty());
  poses.x[0] += 0.0499, poses.x[1] -= 0.0999;
  BOOST_TEST(!search.find(poses, found, scratch));
  poses.x[0] += 0.0001, poses.x[1] -= 0.0003;
  BOOST_TEST(search.find(poses, found, scratch));
  // Pairs whose skins overlap are listed; they are found in contact without a new list.
  Sweep fresh;
  poses.x[0] = 0.0, poses.x[1] = 3.1497;
  found[0] = 0;
  BOOST_TEST(!search.find(poses, found, fresh));
  poses.x[0] += 0.0499, poses.x[1] -= 0.0999;
  BOOST_TEST(search.find(poses, found, fresh));
  BOOST_TEST(fresh.positions.x[0] == 0.0);
}

// With this many bodies the search has no table of all pairs: it finds the same pairs, also after a move.
BOOST_AUTO_TEST_CASE(a_chain_of_many_discs) {
  constexpr std::size_t discs = 6000;
  Poses poses{discs};
  ContactSearch search;
  const Bounds disc = bounds(Shape{Circle{1.0}});
  for (std::size_t i = 0; i + 1 < discs; ++i)
    search.add({static_cast<BodyId>(i), static_cast<BodyId>(i + 1), disc, disc, 0, 0});
  search.prepare(discs);
  Sweep sweep;
  for (const double shift : {0.0, 0.7}) {
    // Every third gap is closed; the shift opens these gaps and closes the next ones.
    for (std::size_t i = 0; i < discs; ++i)
      poses.set(i, {{2.2 * static_cast<double>(i) + (i % 3 == 1 ? shift - 0.35 : 0.0), 0.0}, {}, {}, 0.0});
    std::vector<char> found(search.pairs().size());
    BOOST_TEST(search.find(poses, found, sweep));
    std::size_t wrong = 0;
    for (std::size_t p = 0; p < found.size(); ++p) {
      const bool touches = norm(poses[p + 1].p_WB - poses[p].p_WB) <= 2.0;
      wrong += touches != (found[p] != 0) ? 1 : 0;
    }
    BOOST_TEST(wrong == 0U);
  }
}

BOOST_AUTO_TEST_SUITE_END()
