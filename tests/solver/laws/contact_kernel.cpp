#include "solver/laws/contact_kernel.hpp"

#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "solver/base/pack.hpp"
#include "solver/laws/law_list.hpp"
#include "solver/laws/mode_update.hpp"
#include "tests/solver/laws/cohesive.hpp"
#include "tests/solver/laws/law_examples.hpp"

BOOST_AUTO_TEST_SUITE(contact_kernel_tests)

using namespace talus;

namespace {

/// All laws of discs, some of them with the parameters of cells, and one that is in no list and acts at a distance.
template <class Visit>
void for_each_law(Visit&& visit) {
  DiscLaws::for_each([&]<class L>(const L&) {
    for (const L& law : examples<L>())
      visit(law);
  });
  visit(LinearSpringDashpot{4e3, 0.0, EndRule::clamped});
  visit(LinearSpringDashpot{4e3, 3.0, EndRule::clamped});
  visit(LinearSpringDashpot{4e3, 3.0, EndRule::attractive});
  for (const double growth : {0.0, 0.3, 20.0}) {
    visit(LatchingSpring{4e3, 4e3 / 0.49, growth});
    visit(LatchingSpring{4e3, 4e3, growth});
    visit(LatchingSpring{0.7, 17.3, growth});
  }
  for (const HertzDashpot dashpot : {HertzDashpot::tsuji, HertzDashpot::constant})
    for (const EndRule rule : {EndRule::attractive, EndRule::clamped})
      visit(Hertz{3e4, 0.7, 5.0, rule, dashpot});
  for (const double exponent : {1.0, 1.5, 2.0, 2.3})
    visit(HuntCrossley{4e3, 0.05, exponent, 0.02});
  visit(Cohesive{4e3, 0.05, 0.0}), visit(Cohesive{4e3, 0.05, 3.0});
}

/// A motion of two bodies through contacts and separations, with reversals at any overlap.
std::vector<Kinematics> path(unsigned seed) {
  std::mt19937 random{seed};
  std::uniform_real_distribution<double> unit{-1.0, 1.0};
  std::vector<Kinematics> points{{-0.1, 1.0}};
  for (int n = 0; n < 4000; ++n) {
    const double to = points.back().deformation + 0.05 * unit(random) - 0.02 * points.back().deformation;
    // The rate need not match the path: rounding may cause a difference.
    points.push_back({std::round(1e3 * to) * 1e-3, 100.0 * unit(random)});
  }
  return points;
}

}  // namespace

BOOST_AUTO_TEST_CASE(kernels_give_the_bits_of_the_modes) {
  for_each_law([](const auto& law) {
    using L = std::decay_t<decltype(law)>;
    const auto kernel = contact_kernel(law);
    static_assert(ContactKernel<std::decay_t<decltype(kernel)>>);
    long acting = 0;
    bool same = true, same_kept = true;
    for (const unsigned seed : {1U, 2U, 3U}) {
      Mode mode = 0;
      std::array<double, 1> memory{};
      double largest = 0.0, before = -1.0, let_go = 0.0;
      for (const Kinematics& x : path(seed)) {
        if (x.deformation == -reach(law)) continue;
        const std::span<double> remembered{memory.data(), L::memory_size};
        double released = 0.0;
        update_mode(law, remembered, x, mode, [&](double energy) { released += energy; });
        const LawForce parts = mode == 0 ? LawForce{} : law(x, remembered, mode);
        const double expected = parts.total();
        double force = 0.0;
        if (x.deformation > -reach(law)) {
          kernel.force(x.deformation, x.deformation_rate, largest, force);
          if constexpr (L::memory_size == 0) {
            double power = 0.0, energy = 0.0;
            kernel.dissipated_power(x.deformation, x.deformation_rate, before, force, power, energy);
            same_kept = same_kept && power == parts.dissipative * x.deformation_rate && energy == released;
            let_go += std::abs(energy);
            before = std::max(force, 0.0);
          }
        } else {
          largest = 0.0, before = -1.0;
        }
        same = same && force == expected && largest == memory[0];
        acting += expected > 0.0 ? 1 : 0;
      }
      if constexpr (HasEndRule<L>)
        BOOST_TEST((let_go > 0.0) == (kernel.needs_rate() && law.end_rule == EndRule::clamped));
    }
    BOOST_TEST(same);
    BOOST_TEST(same_kept);
    BOOST_TEST(acting > 1000);
  });
}

BOOST_AUTO_TEST_CASE(packs_are_evaluated_as_their_lanes_would_be_alone) {
  for_each_law([](const auto& law) {
    const auto kernel = contact_kernel(law);
    std::mt19937 random{7};
    std::uniform_real_distribution<double> unit{0.0, 1.0};
    bool same = true;
    for (int n = 0; n < 500; ++n) {
      Pack overlap, rate, largest, force;
      for (std::size_t l = 0; l < pack_size; ++l)
        overlap[l] = 0.1 * unit(random), rate[l] = 40.0 * unit(random) - 20.0, largest[l] = 0.12 * unit(random);
      Pack after = largest;
      kernel.force(overlap, rate, after, force);
      for (std::size_t l = 0; l < pack_size; ++l) {
        double one = largest[l], alone = 0.0;
        kernel.force(double{overlap[l]}, double{rate[l]}, one, alone);
        same = same && one == after[l] && alone == force[l];
      }
    }
    BOOST_TEST(same);
  });
}

BOOST_AUTO_TEST_CASE(rates_have_a_part_where_a_dashpot_is) {
  for_each_law([]<class L>(const L& law) {
    double with = 0.0, without = 0.0, largest = 0.0, other = 0.0;
    const auto kernel = contact_kernel(law);
    kernel.force(0.1, 0.2, largest, with), kernel.force(0.1, 0.0, other, without);
    BOOST_TEST(kernel.needs_rate() == (with != without));
  });
}

BOOST_AUTO_TEST_CASE(kernels_are_derived_where_a_law_is_one_sided) {
  static_assert(OneSided<LinearSpringDashpot> && !IsKernel<LinearSpringDashpot>);
  static_assert(IsKernel<LatchingSpring> && !OneSided<LatchingSpring>);
  static_assert(HasSecant<Hertz> && OneSided<Hertz> && HasSecant<HuntCrossley> && !HasSecant<LinearSpringDashpot>);
  static_assert(std::same_as<DiscLaws::Variant, ContactLaws::Variant>);
  const OneSidedKernel kernel = contact_kernel(LinearSpringDashpot{4e3, 3.0, EndRule::attractive});
  BOOST_TEST(kernel.stiffness == 4e3);
  BOOST_TEST(kernel.damping == 3.0);
  BOOST_TEST(!kernel.clamped);
  BOOST_TEST(contact_kernel(LinearSpringDashpot{4e3}).clamped);
}

BOOST_AUTO_TEST_CASE(forces_and_energies_of_secants_are_those_of_the_formulas) {
  const auto close = boost::test_tools::tolerance(1e-14);
  const double d = 0.03, v = -0.2, E = 3e4, R = 0.7, c = 5.0, k = 4e3, d_r = 0.05, a = 0.6;
  double largest = 0.0, force = 0.0, power = 0.0, released = 0.0;
  const auto evaluate = [&](const auto& law) {
    const auto kernel = contact_kernel(law);
    kernel.force(d, v, largest, force);
    kernel.dissipated_power(d, v, 0.0, force, power, released);  // the contact acts again: its energy is stored again
    BOOST_TEST(-released == law.stored_energy({d, v}, {}, 1), close);
  };
  const double hertz = 4.0 / 3.0 * E * std::sqrt(R) * std::pow(d, 1.5);
  evaluate(Hertz{E, R, c, EndRule::clamped, HertzDashpot::tsuji});
  BOOST_TEST(force == hertz + c * std::pow(d / R, 0.25) * v, close);
  BOOST_TEST(power == c * std::pow(d / R, 0.25) * v * v, close);
  BOOST_TEST(-released == 0.4 * hertz * d, close);
  evaluate(Hertz{E, R, c, EndRule::clamped, HertzDashpot::constant});
  BOOST_TEST(force == hertz + c * v, close);
  for (const double n : {1.0, 1.5, 2.0, 2.3}) {
    const double elastic = k * d * std::pow(d / d_r, n - 1.0);
    evaluate(HuntCrossley{k, d_r, n, a});
    BOOST_TEST(force == elastic * (1.0 + a * v), close);
    BOOST_TEST(power == elastic * a * v * v, close);
    BOOST_TEST(-released == elastic * d / (n + 1.0), close);
  }
}

BOOST_AUTO_TEST_SUITE_END()
