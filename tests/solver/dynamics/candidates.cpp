/// The contact search against brute force: a pair that it leaves out never touches.
#define BOOST_TEST_MODULE candidates
#include "solver/dynamics/candidates.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <random>

#include "solver/geometry/gap.hpp"

using namespace talus;

namespace {

struct RandomPoses {
  std::mt19937_64 random{3};
  std::uniform_real_distribution<double> place{-4.0, 4.0}, angle{-7.0, 7.0};
  Pose operator()() { return {{place(random), place(random)}, rotation(angle(random)), {}, 0.0}; }
};

/// Counts the pairs left out of 20000 and demands that none of them overlaps by the exact gap.
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
  BOOST_TEST(left_out(a, HalfPlane{}, [&](const Pose& A, const Pose& B) { return gap(a, A, HalfPlane{}, B).depth; }) >
             5000);
}

BOOST_AUTO_TEST_CASE(a_sweep_finds_what_looking_at_each_pair_finds) {
  // A hundred scenes of 30 bodies that wander: each pair that touches is near by both ways; one that only the sweep
  // leaves out lies apart along x.
  std::mt19937 random{5};
  std::uniform_real_distribution<double> place{-6.0, 6.0}, turn{0.0, 6.3}, size{0.2, 1.0}, step{-0.3, 0.3};
  for (int scene = 0; scene < 100; ++scene) {
    constexpr std::size_t bodies = 30;
    Poses poses{bodies};
    std::vector<Bounds> boxes;
    for (std::size_t i = 0; i < bodies; ++i) {
      poses.set(i, {{place(random), place(random)}, rotation(turn(random)), {}, 0.0});
      boxes.push_back(i % 3 == 0 ? bounds(Circle{size(random)}) : bounds(Rectangle{size(random), size(random)}));
    }
    boxes.back() = bounds(HalfPlane{});
    ContactSearch sweep, single;
    for (std::size_t a = 0; a < bodies; ++a) {
      for (std::size_t b = a + 1; b < bodies; ++b) {
        const Candidate pair{static_cast<BodyId>(a), static_cast<BodyId>(b), boxes[a], boxes[b], 0, 0};
        sweep.add(pair), single.add(pair);
      }
    }
    sweep.prepare(bodies, true), single.prepare(bodies, false);
    std::vector<char> swept(sweep.pairs().size()), each(sweep.pairs().size());
    Sweep order, unused;
    for (int move = 0; move < 5; ++move) {
      sweep.find(poses, swept, order);
      single.find(poses, each, unused);
      BOOST_TEST(std::count(each.begin(), each.end(), 1) > 3);
      for (std::size_t p = 0; p < each.size(); ++p) {
        const auto& [a, b, box_a, box_b, first, last] = sweep.pairs()[p];
        if (swept[p] == each[p]) continue;
        const double apart = std::abs(poses.x[index(a)] - poses.x[index(b)]);
        BOOST_TEST(!swept[p]);
        BOOST_TEST(apart > 0.2);
      }
      for (std::size_t i = 0; i < bodies; ++i)
        poses.x[i] += step(random), poses.y[i] += step(random);
    }
  }
}
