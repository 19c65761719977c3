/// A latching contact, compressed along prescribed paths with piecewise linear results.
#include "solver/laws/latching_spring.hpp"

#include <array>
#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(latching_spring_tests)

using namespace talus;

namespace {

/// One contact whose overlap is prescribed; updates its mode as the dynamics do before each force evaluation. All
/// numbers in the tests are powers of two or short sums of them: no operation rounds.
struct PressedContact {
  LatchingSpring law;
  std::array<double, 1> memory{};
  Mode mode{LatchingSpring::open};
  double overlap{-0.25};
  double work{};  ///< work input, by the trapezoidal rule

  double force(double rate) const { return law({overlap, rate}, memory, mode).total(); }
  double stored() const { return law.stored_energy({overlap, 0.0}, memory, mode); }

  void press(double to, int steps) {
    const double step = (to - overlap) / steps;
    for (int i = 0; i < steps; ++i) {
      const double before = force(step);
      overlap += step;
      press({overlap, step});
      work += 0.5 * (before + force(step)) * step;
    }
  }

  void press(Kinematics x) {
    law.track(x, memory, mode);
    for (std::size_t pass = 0; pass < LatchingSpring::modes.size(); ++pass) {
      if (law.guard(x, memory, mode) > 0.0) return;
      const Reset next = law.reset(x, memory, mode);
      if (next.mode == mode) return;
      mode = next.mode;
    }
  }
};

constexpr LatchingSpring quarter{.stiffness = 4.0, .unloading_stiffness = 16.0, .growth = 0.0};

}  // namespace

BOOST_AUTO_TEST_CASE(comes_back_on_the_stiff_line_and_leaves_a_quarter) {
  PressedContact contact{.law = quarter};
  contact.press(1.0, 80);
  BOOST_TEST(contact.mode == LatchingSpring::loading);
  BOOST_TEST(contact.force(1.0) == 4.0);
  BOOST_TEST(contact.stored() == 0.5);
  contact.press(0.875, 8);
  BOOST_TEST(contact.mode == LatchingSpring::unloading);
  BOOST_TEST(contact.force(-1.0) == 2.0);
  contact.press(0.5, 24);
  BOOST_TEST(contact.mode == LatchingSpring::slack);
  BOOST_TEST(contact.force(-1.0) == 0.0);
  BOOST_TEST(contact.work == 1.5);  // 2 input, 1/2 recovered
}

BOOST_AUTO_TEST_CASE(within_the_loop_it_goes_up_and_down_the_stiff_line) {
  PressedContact contact{.law = quarter};
  contact.press(1.0, 80);
  contact.press(0.875, 8);
  const double work = contact.work;
  contact.press(0.9375, 4);
  BOOST_TEST(contact.mode == LatchingSpring::unloading);
  BOOST_TEST(contact.force(1.0) == 3.0);
  contact.press(0.875, 4);
  BOOST_TEST(contact.work == work);
  contact.press(0.5, 8);
  contact.press(0.875, 8);  // from the slack mode back onto the same line
  BOOST_TEST(contact.mode == LatchingSpring::unloading);
  BOOST_TEST(contact.force(1.0) == 2.0);
  contact.press(1.5, 8);
  BOOST_TEST(contact.mode == LatchingSpring::loading);
  BOOST_TEST(contact.force(1.0) == 6.0);
  BOOST_TEST(contact.memory[0] == 1.5);
}

BOOST_AUTO_TEST_CASE(remembers_until_the_surfaces_part) {
  PressedContact contact{.law = quarter};
  contact.press(1.0, 80);
  contact.press(0.125, 64);
  BOOST_TEST(contact.mode == LatchingSpring::slack);
  BOOST_TEST(contact.memory[0] == 1.0);
  contact.press(-0.125, 8);
  BOOST_TEST(contact.mode == LatchingSpring::open);
  BOOST_TEST(contact.memory[0] == 0.0);
  contact.press(0.5, 40);
  BOOST_TEST(contact.mode == LatchingSpring::loading);
  BOOST_TEST(contact.force(1.0) == 2.0);
}

BOOST_AUTO_TEST_CASE(stiffens_with_the_largest_force) {
  // K2 = 4 + 3 F: a force of 4 makes it 16.
  PressedContact contact{.law = {.stiffness = 4.0, .unloading_stiffness = 4.0, .growth = 3.0}};
  contact.press(1.0, 80);
  contact.press(0.875, 8);
  BOOST_TEST(contact.force(-1.0) == 2.0);
}

BOOST_AUTO_TEST_CASE(turns_round_where_it_stands) {
  PressedContact contact{.law = quarter};
  contact.press(1.0, 80);
  contact.press({1.0, 0.0});
  BOOST_TEST(contact.mode == LatchingSpring::unloading);
  BOOST_TEST(contact.force(0.0) == 4.0);
  contact.press({1.0, 1.0});
  BOOST_TEST(contact.mode == LatchingSpring::loading);
}

BOOST_AUTO_TEST_SUITE_END()
