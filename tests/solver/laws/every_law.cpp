/// The contract of a law (solver/laws/law_list.hpp), tested over both closed lists.
#define BOOST_TEST_MODULE every_law
#include "solver/laws/law_list.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

using namespace talus;

namespace {

/// The law with its fields set to different values, with and without damping, and each end rule where it has one.
template <class L>
std::vector<L> examples() {
  std::vector<L> made;
  for (const EndRule rule : {EndRule::attractive, EndRule::clamped}) {
    for (const double damping : {0.0, 0.75}) {
      L law;
      if constexpr (requires { law.stiffness; }) law.stiffness = 5.0;
      if constexpr (requires { law.unloading_stiffness; }) law.unloading_stiffness = 20.0;
      if constexpr (requires { law.growth; }) law.growth = damping;
      if constexpr (requires { law.modulus; }) law.modulus = 5.0;
      if constexpr (requires { law.radius; }) law.radius = 0.7;
      if constexpr (requires { law.damping; }) law.damping = damping;
      if constexpr (requires { law.yield; }) law.yield = 3.0;
      if constexpr (requires { law.end_rule; }) law.end_rule = rule;
      made.push_back(law);
    }
  }
  return made;
}

template <class Test>
void over_all_laws(Test&& test) {
  const auto each = [&]<class L>(L) {
    for (const L& law : examples<L>()) {
      BOOST_TEST_CONTEXT("law " << L::name << ", damping " << law.tangent().damping) { test(law); }
    }
  };
  ContactLaws::for_each(each);
  CableLaws::for_each(each);
}

/// Memory of the size the law asks for, all zero.
template <class L>
std::vector<double> memory_of(const L&) {
  return std::vector<double>(L::memory_size);
}

/// The mode that the law settles into at x, coming from `mode`.
template <class L>
Mode settled(const L& law, Kinematics x, Mode mode) {
  auto memory = memory_of(law);
  for (std::size_t pass = 0; pass < L::modes.size() && law.guard(x, memory, mode) <= 0.0; ++pass) {
    const Mode next = law.reset(x, memory, mode).mode;
    if (next == mode) break;
    mode = next;
  }
  return mode;
}

}  // namespace

BOOST_AUTO_TEST_CASE(no_force_apart) {
  over_all_laws([](const auto& law) {
    const auto memory = memory_of(law);
    for (const double rate : {-2.0, 0.0, 2.0}) {
      const Kinematics apart{-0.1, rate};
      BOOST_TEST(settled(law, apart, 0) == 0);
      BOOST_TEST(settled(law, apart, 1) == 0);
      BOOST_TEST(law(apart, memory, 0).total() == 0.0);
      BOOST_TEST(law.stored_energy(apart, memory, 0) == 0.0);
    }
  });
}

BOOST_AUTO_TEST_CASE(acts_from_the_touch_on) {
  over_all_laws([](const auto& law) {
    BOOST_TEST(settled(law, {0.0, 1.0}, 0) == 1);
    BOOST_TEST(settled(law, {1e-9, 1.0}, 0) == 1);
    BOOST_TEST(settled(law, {0.0, -1.0}, 0) == 0);
  });
}

BOOST_AUTO_TEST_CASE(elastic_force_is_the_derivative_of_the_stored_energy) {
  over_all_laws([](const auto& law) {
    const auto memory = memory_of(law);
    for (const Mode mode : {Mode{0}, Mode{1}, Mode{2}}) {
      for (const double s : {0.01, 0.3, 2.0}) {
        // The difference over four points is exact up to fourth powers, and off by 1e-12 where the energy grows with
        // the power 5/2; what is left is the round-off of energies over the step.
        const double d = s * 1e-3;
        const auto difference = [&](double by) {
          return law.stored_energy({s + by, 0.0}, memory, mode) - law.stored_energy({s - by, 0.0}, memory, mode);
        };
        const double derivative = (8.0 * difference(d) - difference(2.0 * d)) / (12.0 * d);
        BOOST_TEST(law({s, 0.0}, memory, mode).elastic == derivative, boost::test_tools::tolerance(1e-11));
      }
    }
  });
}

BOOST_AUTO_TEST_CASE(dissipative_force_never_gives_energy_while_its_mode_lasts) {
  over_all_laws([](const auto& law) {
    const auto memory = memory_of(law);
    for (const Mode mode : {Mode{0}, Mode{1}, Mode{2}}) {
      for (const double s : {-0.1, 0.0, 0.2}) {
        for (const double rate : {-3.0, -1e-6, 0.0, 4.0}) {
          if (law.guard({s, rate}, memory, mode) < 0.0) continue;
          BOOST_TEST(law({s, rate}, memory, mode).dissipative * rate >= 0.0);
        }
      }
    }
  });
}

BOOST_AUTO_TEST_CASE(same_input_same_bits) {
  over_all_laws([](const auto& law) {
    const auto memory = memory_of(law);
    const Kinematics x{0.123456789, -0.987654321};
    BOOST_TEST(law(x, memory, 1).elastic == law(x, memory, 1).elastic);
    BOOST_TEST(law(x, memory, 1).dissipative == law(x, memory, 1).dissipative);
  });
}

BOOST_AUTO_TEST_CASE(power_of_two_scaling_is_exact) {
  // Length by 2^3, mass by 2^-2, time by 2^1; so force [M L/T^2] by 2^-1.
  over_all_laws([]<class L>(const L& law) {
    const auto memory = memory_of(law);
    L scaled = law;
    for (const auto& field : L::fields()) {
      const Dimension of = field.dimension;
      scaled.*field.member = std::ldexp(law.*field.member, 3 * of.length - 2 * of.mass + of.time);
    }
    const Kinematics x{0.1234567, -0.7654321};
    const Kinematics y{std::ldexp(x.extent, 3), std::ldexp(x.extent_rate, 2)};
    BOOST_TEST(scaled(y, memory, 1).total() == std::ldexp(law(x, memory, 1).total(), -1));
  });
}

BOOST_AUTO_TEST_CASE(guard_is_positive_while_the_mode_lasts) {
  over_all_laws([](const auto& law) {
    const auto memory = memory_of(law);
    BOOST_TEST(law.guard({-0.5, 1.0}, memory, 0) > 0.0);
    BOOST_TEST(law.guard({0.5, 1.0}, memory, 0) < 0.0);
    BOOST_TEST(law.guard({0.5, 1.0}, memory, 1) > 0.0);
    BOOST_TEST(law.guard({-0.5, -1.0}, memory, 1) < 0.0);
  });
}

BOOST_AUTO_TEST_CASE(clamped_contact_never_pulls_and_attractive_does) {
  const double s = 0.01, fast = -10.0;  // k s + c ds/dt = .05 - 7.5 < 0
  const LinearSpringDashpot clamped{5.0, 0.75, EndRule::clamped};
  const LinearSpringDashpot attractive{5.0, 0.75, EndRule::attractive};
  const Mode mode = settled(clamped, {s, fast}, 1);
  BOOST_TEST(mode == 2);
  BOOST_TEST(clamped({s, fast}, {}, mode).total() == 0.0);
  BOOST_TEST(settled(attractive, {s, fast}, 1) == 1);
  BOOST_TEST(attractive({s, fast}, {}, 1).total() < 0.0);
  BOOST_TEST(settled(clamped, {s, 1.0}, 2) == 1);    // pushed again
  BOOST_TEST(settled(clamped, {-s, fast}, 2) == 0);  // parted
}

BOOST_AUTO_TEST_CASE(release_books_the_spring_energy_once) {
  const LinearSpringDashpot law{5.0, 0.75, EndRule::clamped};
  const Kinematics x{0.2, -10.0};
  BOOST_TEST(law.reset(x, {}, 1).released == law.stored_energy(x, {}, 1));
  BOOST_TEST(law.reset({0.2, 0.0}, {}, 2).released == -law.stored_energy({0.2, 0.0}, {}, 1));
  BOOST_TEST(law.reset({0.0, -1.0}, {}, 1).released == 0.0);
}

// What the rows of a fence rely on: on its straight line a law need not be asked, with the same bits.
BOOST_AUTO_TEST_CASE(a_straight_line_is_the_law_as_long_as_it_lasts) {
  int lines = 0;
  over_all_laws([&lines]<class L>(const L& law) {
    if constexpr (requires(std::span<const double> memory) { law.linear_piece(memory, Mode{0}); }) {
      for (Mode mode = 0; mode < L::modes.size(); ++mode) {
        for (const double kept : {0.0, 0.3, 1.7}) {
          const std::vector<double> memory(L::memory_size, kept);
          const LinearPiece piece = law.linear_piece(memory, mode);
          lines += piece.low < piece.high;
          for (int i = -400; i <= 400; ++i) {
            for (const double end : {0.0, piece.low, piece.high}) {
              // Spread over the range, and by single roundings around its ends.
              const double extent = end == 0.0 ? 0.01 * i : end + i * 0x1p-52 * std::abs(end);
              if (!(piece.low < extent && extent < piece.high)) continue;
              const double force = piece.stiffness * (extent - piece.natural);
              for (const double rate : {-2.0, 0.0, 2.0}) {
                const Kinematics x{extent, rate};
                const LawForce asked = law(x, memory, mode);
                if (asked.total() != force || asked.dissipative != 0.0 || !(law.guard(x, memory, mode) > 0.0))
                  BOOST_ERROR(L::name << ", mode " << mode << ": not on its line at " << extent);
              }
            }
          }
        }
      }
    }
  });
  BOOST_TEST(lines > 10);
}
