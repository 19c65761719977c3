#include "solver/geometry/gap.hpp"

#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "solver/geometry/path.hpp"

BOOST_AUTO_TEST_SUITE(gap_tests)

using namespace talus;

namespace {

Pose at(double x, double y, double angle = 0.0) { return {{x, y}, rotation(angle), {}, 0.0}; }

double depth_of(const auto& a, const Pose& A, const auto& b, const Pose& B) { return gap(a, A, b, B).depth; }

/// Distance of a point to a rectangle by brute force: the nearest of many points of its outline.
double distance_to_outline(const Rectangle& box, Vec2 p) {
  double nearest = 1e300;
  const int n = 4000;
  for (int i = 0; i <= n; ++i) {
    const double s = -1.0 + 2.0 * i / n;
    for (const Vec2 q : {Vec2{box.half_width, s * box.half_height}, Vec2{-box.half_width, s * box.half_height},
                         Vec2{s * box.half_width, box.half_height}, Vec2{s * box.half_width, -box.half_height}}) {
      nearest = std::min(nearest, norm(p - q));
    }
  }
  return nearest;
}

}  // namespace

BOOST_AUTO_TEST_CASE(circle_pair) {
  const Gap found = gap(Ball{{}, 1.0}, at(0, 0), Circle{2.0}, at(2.5, 0));
  BOOST_TEST(found.depth == 0.5);
  BOOST_TEST(found.n_AB.x == 1.0);
  BOOST_TEST(found.n_AB.y == 0.0);
  BOOST_TEST(found.p_WC.x == 0.75);  // middle of the overlap [0.5, 1]
  BOOST_TEST(depth_of(Ball{{}, 1.0}, at(0, 0), Circle{2.0}, at(3, 4)) == -2.0);
}

BOOST_AUTO_TEST_CASE(ball_on_rectangle_against_brute_force) {
  std::mt19937 random{7};
  std::uniform_real_distribution<double> coordinate{-3.0, 3.0};
  const Rectangle box{1.25, 0.75};
  for (int i = 0; i < 200; ++i) {
    const Vec2 p{coordinate(random), coordinate(random)};
    const bool inside = std::abs(p.x) < box.half_width && std::abs(p.y) < box.half_height;
    const double found = depth_below(box, p).depth;
    BOOST_TEST((found > 0.0) == inside);
    // The outline's points are 6e-4 apart: the nearest is at most half that away from the true foot of the normal.
    BOOST_TEST(std::abs(std::abs(found) - distance_to_outline(box, p)) < 1e-3);
  }
}

BOOST_AUTO_TEST_CASE(normal_is_the_gradient_of_the_depth) {
  std::mt19937 random{11};
  std::uniform_real_distribution<double> coordinate{-3.0, 3.0};
  const double h = 1e-6;
  for (int i = 0; i < 100; ++i) {
    const Vec2 p{coordinate(random), coordinate(random)};
    const auto check = [&](const auto& shape) {
      const Vec2 slope{(depth_below(shape, p + Vec2{h, 0}).depth - depth_below(shape, p - Vec2{h, 0}).depth) / (2 * h),
                       (depth_below(shape, p + Vec2{0, h}).depth - depth_below(shape, p - Vec2{0, h}).depth) / (2 * h)};
      const Vec2 n = depth_below(shape, p).normal;
      BOOST_TEST(std::abs(slope.x + n.x) < 1e-4);  // depth falls along the outward normal; h^2 curvature and 1e-10/h
      BOOST_TEST(std::abs(slope.y + n.y) < 1e-4);
    };
    check(Circle{0.8});
    check(Rectangle{1.25, 0.75});
    check(HalfPlane{});
  }
}

BOOST_AUTO_TEST_CASE(ball_sinks_into_a_tilted_plane) {
  const double tilt = std::numbers::pi / 6;
  const Gap found = gap(Ball{{}, 1.0}, at(0.0, 1.0), HalfPlane{}, at(0.0, 0.0, tilt));
  BOOST_TEST(found.depth == 1.0 - std::cos(tilt), boost::test_tools::tolerance(1e-14));
  BOOST_TEST(found.n_AB.x == std::sin(tilt), boost::test_tools::tolerance(1e-14));
  BOOST_TEST(found.n_AB.y == -std::cos(tilt), boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(rectangles_flat_on_each_other_rest_on_both_ends_of_the_common_side) {
  const Rectangle a{1.0, 0.5}, b{1.0, 0.5};
  const Pose A = at(0.5, 0.95), B = at(0, 0);
  const Gap whole = gap(a, A, b, B);
  BOOST_TEST(whole.depth == 0.05, boost::test_tools::tolerance(1e-13));
  BOOST_TEST(whole.n_AB.y == -1.0);
  BOOST_TEST(whole.p_WC.x == 0.25, boost::test_tools::tolerance(1e-14));  // common part [-0.5, 1]
  // Counter-clockwise of the normal, which points down, is to the right.
  const Gap behind = gap(RectangleEnd{a, 0}, A, b, B), ahead = gap(RectangleEnd{a, 1}, A, b, B);
  BOOST_TEST(behind.p_WC.x == -0.5, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(ahead.p_WC.x == 1.0, boost::test_tools::tolerance(1e-14));
  for (const Gap& end : {behind, ahead}) {
    BOOST_TEST(end.depth == 0.05, boost::test_tools::tolerance(1e-13));
    BOOST_TEST(end.n_AB.y == -1.0);
  }
}

// For every tilt, and where corners pass each other, no depth jumps, and springs at both ends have the potential (d_0^2
// + d_1^2)/2.
BOOST_AUTO_TEST_CASE(ends_of_two_rectangles_move_without_a_jump_and_have_a_potential) {
  const Rectangle a{0.5, 0.4}, b{0.6, 0.3};
  const auto depths = [&](double x, double tilt) {
    std::array<double, 2> found{};
    for (int end : {0, 1})
      found[static_cast<std::size_t>(end)] = gap(RectangleEnd{a, end}, at(x, 0.65, tilt), b, at(0, 0)).depth;
    return found;
  };
  double jump = 0.0, step = 1e-5;
  for (double tilt = -0.3; tilt < 0.3; tilt += 0.01) {
    for (double x = -0.6; x < 0.6; x += 0.013) {
      const auto here = depths(x, tilt), moved = depths(x + step, tilt), turned = depths(x, tilt + step);
      if (std::max(here[0], here[1]) < 0.0) continue;
      for (std::size_t end : {0U, 1U}) {
        if (std::min({here[end], moved[end], turned[end]}) <= 0.0) continue;
        jump = std::max({jump, std::abs(moved[end] - here[end]), std::abs(turned[end] - here[end])});
      }
    }
  }
  BOOST_TEST(jump < 1.2 * step);  // a corner moves no farther
  double worst = 0.0;
  int positions = 0;
  for (double tilt = -0.25; tilt < 0.25; tilt += 0.0617) {
    for (double x = -0.55; x < 0.55; x += 0.0731) {
      const auto energy = [&](double dx, double turn) {
        const auto d = depths(x + dx, tilt + turn);
        return 0.5 * (std::max(d[0], 0.0) * std::max(d[0], 0.0) + std::max(d[1], 0.0) * std::max(d[1], 0.0));
      };
      double force = 0.0, moment = 0.0;
      const Pose A = at(x, 0.65, tilt);
      for (int end : {0, 1}) {
        const Gap found = gap(RectangleEnd{a, end}, A, b, at(0, 0));
        const Vec2 on_a = -std::max(found.depth, 0.0) * found.n_AB;
        force += on_a.x, moment += cross(found.p_WC - A.p_WB, on_a);
      }
      const double h = 1e-6;
      worst = std::max(worst, std::abs(force + (energy(h, 0) - energy(-h, 0)) / (2 * h)));
      worst = std::max(worst, std::abs(moment + (energy(0, h) - energy(0, -h)) / (2 * h)));
      positions += energy(0, 0) > 0.0 ? 1 : 0;
    }
  }
  BOOST_TEST(positions > 60);
  BOOST_TEST(worst < 1e-8);  // h^2 times the third derivative, and 1e-17/h
}

BOOST_AUTO_TEST_CASE(ends_of_rectangles_apart_are_at_least_as_far_apart_as_the_sides) {
  std::mt19937 random{17};
  std::uniform_real_distribution<double> coordinate{-3.0, 3.0};
  const Rectangle a{1.0, 0.4}, b{0.6, 0.8};
  int apart = 0;
  for (int i = 0; i < 20000; ++i) {
    const Pose A = at(coordinate(random), coordinate(random), coordinate(random)),
               B = at(coordinate(random), coordinate(random), coordinate(random));
    const double depth = gap(a, A, b, B).depth;
    if (depth >= 0.0) {
      BOOST_TEST(std::max(depth_of(RectangleEnd{a, 0}, A, b, B), depth_of(RectangleEnd{a, 1}, A, b, B)) > 0.0);
      continue;
    }
    ++apart;
    for (int end : {0, 1})
      BOOST_TEST(depth_of(RectangleEnd{a, end}, A, b, B) <= depth);
  }
  BOOST_TEST(apart > 5000);
}

BOOST_AUTO_TEST_CASE(crossed_rectangles_are_found_without_a_vertex_inside) {
  BOOST_TEST(depth_of(Rectangle{2.0, 0.1}, at(0, 0), Rectangle{0.1, 2.0}, at(0, 0)) > 0.0);
  BOOST_TEST(depth_of(Rectangle{2.0, 0.1}, at(0, 0), Rectangle{0.1, 2.0}, at(5, 0)) < 0.0);
}

BOOST_AUTO_TEST_CASE(swapping_the_rectangles_turns_the_normal_round) {
  std::mt19937 random{3};
  std::uniform_real_distribution<double> coordinate{-1.5, 1.5};
  const Rectangle a{1.0, 0.4}, b{0.6, 0.8};
  for (int i = 0; i < 100; ++i) {
    const Pose A = at(coordinate(random), coordinate(random), coordinate(random)),
               B = at(coordinate(random), coordinate(random), coordinate(random));
    const Gap one = gap(a, A, b, B), two = gap(b, B, a, A);
    BOOST_TEST(one.depth == two.depth, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(one.n_AB.x == -two.n_AB.x, boost::test_tools::tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_CASE(depth_rate_is_the_rate_of_the_depth) {
  std::mt19937 random{5};
  std::uniform_real_distribution<double> coordinate{-1.0, 1.0};
  const double h = 1e-6;
  const auto moved = [](Pose pose, double angle, double t) {
    pose.p_WB += t * pose.v_WB;
    pose.R_WB = rotation(angle + t * pose.w_WB);
    return pose;
  };
  const auto check = [&](const auto& a, const auto& b, double apart) {
    for (int i = 0; i < 50; ++i) {
      const double turn_a = coordinate(random), turn_b = coordinate(random);
      Pose A = at(0.2 * coordinate(random), apart + 0.2 * coordinate(random), turn_a), B = at(0, 0, turn_b);
      A.v_WB = {coordinate(random), coordinate(random)}, A.w_WB = coordinate(random);
      B.v_WB = {coordinate(random), coordinate(random)}, B.w_WB = coordinate(random);
      const double rate = depth_rate(gap(a, A, b, B), A, B);
      const double later = depth_of(a, moved(A, turn_a, h), b, moved(B, turn_b, h));
      const double sooner = depth_of(a, moved(A, turn_a, -h), b, moved(B, turn_b, -h));
      BOOST_TEST(std::abs((later - sooner) / (2.0 * h) - rate) < 1e-6);  // h^2 times curvature, round-off 1e-16/h
    }
  };
  check(Ball{{0.3, 0.1}, 0.5}, Circle{1.0}, 1.4);
  check(Ball{{}, 0.5}, Rectangle{1.0, 0.6}, 1.0);
  check(Ball{{0.2, 0.0}, 0.0}, HalfPlane{}, 0.1);
  check(RectangleEnd{{1.0, 0.5}, 0}, Rectangle{0.8, 0.7}, 1.1);
  check(RectangleEnd{{1.0, 0.5}, 1}, Rectangle{0.8, 0.7}, 1.1);
}

BOOST_AUTO_TEST_CASE(path_length_rate_and_pull) {
  const Path found = path({0, 0}, {0, 0}, {3, 4}, {1, 2}, 144);
  BOOST_TEST(found.length == 13.0);
  BOOST_TEST(found.length_rate == (3.0 + 8.0) / 13.0, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(found.pull_A.x == 3.0 / 13.0, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(path({1, 1}, {}, {1, 1}, {}, 0.0).pull_A.x == 0.0);
}

BOOST_AUTO_TEST_CASE(nodes_of_a_circle_start_at_local_x_and_a_rectangle_has_its_corners) {
  const auto nodes = boundary_nodes(Circle{2.0}, 12);
  BOOST_REQUIRE(nodes.size() == 12);
  BOOST_TEST(nodes[0].x == 2.0);
  BOOST_TEST(nodes[3].y == 2.0);
  BOOST_TEST(boundary_nodes(Rectangle{1.0, 2.0}, 12).size() == 4);
  BOOST_TEST(boundary_nodes(HalfPlane{}, 12).empty());
}

BOOST_AUTO_TEST_SUITE_END()
