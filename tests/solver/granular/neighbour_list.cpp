#include "solver/granular/neighbour_list.hpp"

#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>
#include <set>
#include <vector>

#include "solver/base/error.hpp"

BOOST_AUTO_TEST_SUITE(neighbour_list_tests)

using namespace talus;

namespace {

struct Packing {
  DiscShapes shapes;
  Discs discs;
};

/// Randomly placed discs with radii between 0.5 and 1, a fifth of them held.
Packing scattered(std::size_t count, double width, double height, unsigned seed) {
  std::mt19937 random{seed};
  std::uniform_real_distribution<double> unit{0.0, 1.0};
  Packing packing;
  for (std::size_t i = 0; i < count; ++i) {
    packing.shapes.add(0.5 + 0.5 * unit(random), i % 5 == 0 ? 0.0 : 1.0);
    const double y = height * (unit(random) - 0.5), x = width * (unit(random) - 0.5);
    packing.discs.add(x, y, 0.0, 0.0);
  }
  return packing;
}

/// Distance between the surfaces of the nearest images, by trying many images.
double gap(const Packing& p, const PeriodicBox& box, std::size_t i, std::size_t j) {
  double minimum = 1e300;
  for (int up = -2; up <= 2; ++up) {
    for (int right = -3; right <= 3; ++right) {
      if ((up != 0 && !box.repeats_y()) || (right != 0 && !box.repeats_x())) continue;
      const double dx = p.discs.x[j] - p.discs.x[i] + (right == 0 ? 0.0 : right * box.width) +
                        (up == 0 ? 0.0 : up * p.discs.shear_displacement);
      const double dy = p.discs.y[j] - p.discs.y[i] + (up == 0 ? 0.0 : up * box.height);
      minimum = std::min(minimum, std::hypot(dx, dy));
    }
  }
  return minimum - p.shapes.radius[i] - p.shapes.radius[j];
}

const std::array boxes{PeriodicBox{},
                       PeriodicBox{.width = 20.0},
                       PeriodicBox{.width = 20.0, .height = 12.0},
                       PeriodicBox{.width = 20.0, .height = 12.0, .shear_rate = 0.7},
                       PeriodicBox{.width = 9.0, .height = 30.0, .shear_rate = -2.0},
                       PeriodicBox{.height = 12.0, .shear_rate = 0.7}};

}  // namespace

BOOST_AUTO_TEST_CASE(all_pairs_within_the_skin_and_no_others_are_listed_in_order) {
  for (const PeriodicBox& box : boxes) {
    for (const double t : {0.0, 0.3, 1.1, 1.9}) {
      Packing p = scattered(120, std::min(box.width, 30.0), std::min(box.height, 25.0), 3);
      p.discs.shear_displacement = box.sliding() * t;
      if (box.shear_rate * box.height * t > 1.5 * box.width) continue;  // beyond the images that gap() tries
      NeighbourList list{box, 0.3};
      list.build(p.shapes, p.discs);
      std::size_t pair = 0;
      std::array<NeighbourList::Shift, NeighbourList::images> shifts;
      list.shifts(p.discs.shear_displacement, shifts);
      for (std::size_t i = 0; i < p.discs.size(); ++i) {
        for (std::size_t j = i + 1; j < p.discs.size(); ++j) {
          const double apart = gap(p, box, i, j);
          const bool held = p.shapes.inverse_mass[i] == 0.0 && p.shapes.inverse_mass[j] == 0.0;
          if (apart >= 0.3 || held) {
            BOOST_TEST(list.find(i, j) == list.size());
            continue;
          }
          BOOST_TEST(list.find(i, j) == pair);
          const NeighbourList::Shift& shift = shifts[list.image(pair)];
          const double distance =
              std::hypot(p.discs.x[j] - p.discs.x[i] + shift.x, p.discs.y[j] - p.discs.y[i] + shift.y);
          BOOST_TEST(std::abs(distance - p.shapes.radius[i] - p.shapes.radius[j] - apart) < 1e-12);
          ++pair;
        }
      }
      BOOST_TEST(list.size() == pair);
    }
  }
}

BOOST_AUTO_TEST_CASE(pairs_within_the_reach_of_a_law_and_the_skin_are_listed) {
  for (const PeriodicBox& box : boxes) {
    const Packing p = scattered(60, std::min(box.width, 30.0), std::min(box.height, 25.0), 3);
    NeighbourList list{box, 0.1, 0.2}, wide{box, 0.3};
    list.build(p.shapes, p.discs), wide.build(p.shapes, p.discs);
    BOOST_REQUIRE(list.size() == wide.size());
    BOOST_TEST(list.reach() == wide.reach(), boost::test_tools::tolerance(1e-15));
    for (std::size_t pair = 0; pair < list.size(); ++pair)
      BOOST_TEST(list.second(pair) == wide.second(pair));
    BOOST_TEST(list.left() == 0.1);  // motion uses up only the skin
  }
}

BOOST_AUTO_TEST_CASE(discs_that_have_gone_astray_leave_the_list_of_the_others_as_it_is) {
  for (const PeriodicBox& box : boxes) {
    Packing p = scattered(60, std::min(box.width, 30.0), std::min(box.height, 25.0), 3);
    NeighbourList list{box, 0.3};
    for (const std::size_t gone : {7UL, 20UL, 41UL}) {
      p.shapes.inverse_mass[gone] = 0.0;
      p.discs.x[gone] = gone == 7 ? std::nan("") : 0.0;
      p.discs.y[gone] = gone == 7 ? 0.0 : gone == 20 ? 1e300 : -HUGE_VAL;
    }
    list.build(p.shapes, p.discs);
    for (std::size_t i = 0; i < p.discs.size(); ++i) {
      for (std::size_t j = i + 1; j < p.discs.size(); ++j) {
        const bool held = p.shapes.inverse_mass[i] == 0.0 && p.shapes.inverse_mass[j] == 0.0;
        const bool near = gap(p, box, i, j) < 0.3 && !std::isnan(p.discs.x[i]) && !std::isnan(p.discs.x[j]);
        BOOST_TEST((list.find(i, j) != list.size()) == (near && !held));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(any_number_of_threads_makes_the_same_list) {
  for (const PeriodicBox& box : boxes) {
    for (const std::size_t discs : {2U, 5U, 120U}) {
      const Packing p = scattered(discs, std::min(box.width, 30.0), std::min(box.height, 25.0), 3);
      NeighbourList alone{box, 0.3};
      alone.build(p.shapes, p.discs);
      for (const std::size_t threads : {1U, 2U, 3U, 7U}) {
        ThreadPool pool{threads};
        NeighbourList list{box, 0.3};
        for (int again = 0; again < 2; ++again)
          list.build(p.shapes, p.discs, &pool);
        BOOST_REQUIRE(list.size() == alone.size());
        for (std::size_t i = 0; i < discs; ++i)
          BOOST_TEST((list.begin(i) == alone.begin(i) && list.end(i) == alone.end(i)));
        for (std::size_t pair = 0; pair < list.size(); ++pair)
          BOOST_TEST((list.second(pair) == alone.second(pair) && list.image(pair) == alone.image(pair)));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(the_list_lasts_until_discs_have_gone_half_its_skin) {
  Packing p = scattered(30, 20.0, 20.0, 5);
  NeighbourList list{PeriodicBox{}, 0.5};
  list.build(p.shapes, p.discs);
  list.use(0.3);
  BOOST_TEST(!list.may_end());
  list.use(0.3);
  BOOST_TEST(list.may_end());
  p.discs.x[7] += 0.1;
  BOOST_TEST(list.holds(p.discs));
  BOOST_TEST(!list.may_end());  // 0.2 of 0.5 are used
  list.use(0.31);
  BOOST_TEST(list.may_end());
  p.discs.y[7] += 0.25;
  BOOST_TEST(!list.holds(p.discs));
  list.build(p.shapes, p.discs);
  BOOST_TEST(list.holds(p.discs));
}

BOOST_AUTO_TEST_CASE(what_leaves_the_box_comes_back_into_it) {
  const PeriodicBox box{.width = 20.0, .height = 12.0, .shear_rate = 0.5};
  Discs discs;
  discs.shear_displacement = 9.0;  // boundary shear displacement: the box above is shifted to the right
  discs.add(10.5, 0.0, 1.0, 2.0);
  discs.add(0.0, 6.5, 1.0, 2.0);
  discs.add(-9.0, -6.5, 1.0, 2.0);
  discs.add(3.0, 4.0, 1.0, 2.0);
  wrap(box, discs);
  BOOST_TEST(discs.x[0] == -9.5);
  BOOST_TEST(discs.x[1] == -9.0);
  BOOST_TEST(discs.y[1] == -5.5);
  BOOST_TEST(discs.vx[1] == -5.0);
  BOOST_TEST(discs.x[2] == 0.0);
  BOOST_TEST(discs.y[2] == 5.5);
  BOOST_TEST(discs.vx[2] == 7.0);
  BOOST_TEST(discs.x[3] == 3.0);
  BOOST_TEST(discs.vx[3] == 1.0);
}

BOOST_AUTO_TEST_CASE(boxes_that_are_too_small_are_refused) {
  Packing p = scattered(5, 4.0, 4.0, 1);
  NeighbourList list{PeriodicBox{.width = 4.0}, 0.3};
  BOOST_CHECK_THROW(list.build(p.shapes, p.discs), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
