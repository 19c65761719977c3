/// The contract of a law (solver/laws/law.hpp), tested over the closed lists, and over a law that is in none of them
/// and acts before the surfaces touch.
#include "solver/laws/law_list.hpp"

#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "solver/laws/mode_update.hpp"
#include "tests/solver/laws/cohesive.hpp"
#include "tests/solver/laws/law_examples.hpp"

BOOST_AUTO_TEST_SUITE(every_law_tests)

using namespace talus;

namespace {

template <class Test>
void over_all_laws(Test&& test) {
  const auto each = [&]<class L>(L) {
    for (const L& law : examples<L>()) {
      BOOST_TEST_CONTEXT("law " << L::name << ", damping " << law.tangent().damping) { test(law); }
    }
  };
  ContactLaws::for_each(each);
  CableLaws::for_each(each);
  DiscLaws::for_each(each);
  each(Cohesive{});
}

/// Memory of the size that the law requires, all zero.
template <class L>
std::vector<double> memory_of(const L&) {
  return std::vector<double>(L::memory_size);
}

/// One impact of an effective mass by a law, integrated by the leapfrog until the law no longer acts.
struct SteppedImpact {
  double contact_time{}, restitution{}, largest_overlap{};
};
template <class L>
SteppedImpact stepped_impact(const L& law, std::vector<double> memory, double mass, double speed) {
  const double step = 1e-4 * std::sqrt(mass / law.tangent().stiffness);
  SteppedImpact found;
  Kinematics x{0.5 * step * speed, speed};
  Mode mode = 0;
  for (double time = 0.5 * step; time < 1e6 * step; time += step) {
    update_mode(law, std::span{memory}, x, mode, [](double) {});
    if (!L::acts(mode)) {
      found.contact_time = time - 0.5 * step, found.restitution = -x.deformation_rate / speed;
      return found;
    }
    found.largest_overlap = std::max(found.largest_overlap, x.deformation);
    x.deformation_rate -= step * law(x, memory, mode).total() / mass;
    x.deformation += step * x.deformation_rate;
  }
  return found;
}

/// The mode that the law reaches at x, starting from `mode`.
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

BOOST_AUTO_TEST_CASE(parameters_of_the_examples_are_in_range_and_order) {
  over_all_laws([]<class L>(const L& law) {
    for (const auto& field : L::fields())
      BOOST_TEST(contains(field.range, (law.*field.member)));
    if constexpr (HasOrders<L>) {
      for (const auto& order : L::orders()) {
        BOOST_TEST((law.*order.larger >= law.*order.smaller));
        BOOST_TEST((!field_name(order.larger).empty() && !field_name(order.smaller).empty()));
        BOOST_TEST(!order.why.empty());
      }
    }
  });
}

BOOST_AUTO_TEST_CASE(no_force_out_of_reach) {
  over_all_laws([](const auto& law) {
    const auto memory = memory_of(law);
    BOOST_TEST(reach(law) >= 0.0);
    for (const double rate : {-2.0, 0.0, 2.0}) {
      const Kinematics apart{-reach(law) - 0.1, rate};
      BOOST_TEST(settled(law, apart, 0) == 0);
      BOOST_TEST(settled(law, apart, 1) == 0);
      BOOST_TEST(law(apart, memory, 0).total() == 0.0);
      BOOST_TEST(law.stored_energy(apart, memory, 0) == 0.0);
    }
  });
}

BOOST_AUTO_TEST_CASE(acts_from_the_touch_on_or_from_its_reach) {
  over_all_laws([]<class L>(const L& law) {
    BOOST_TEST(settled(law, {0.0, 1.0}, 0) == 1);
    BOOST_TEST(settled(law, {1e-9, 1.0}, 0) == 1);
    if constexpr (ActsAtDistance<L>) {
      BOOST_TEST(law.reach() > 0.0);
      for (const double rate : {-1.0, 1.0})
        BOOST_TEST(L::acts(settled(law, {-0.5 * law.reach(), rate}, 0)));
    } else {
      BOOST_TEST(settled(law, {0.0, -1.0}, 0) == 0);
    }
  });
}

BOOST_AUTO_TEST_CASE(a_mode_that_does_not_act_exerts_nothing_and_stores_nothing) {
  over_all_laws([]<class L>(const L& law) {
    BOOST_TEST(!L::acts(0));
    BOOST_TEST(L::acts(1));
    for (Mode mode = 0; mode < L::modes.size(); ++mode) {
      double largest = 0.0;
      for (const double kept : {0.0, 0.3}) {
        const std::vector<double> memory(memory_count(law), kept);
        for (const double s : {-0.3, 0.1, 0.25, 2.0}) {
          for (const double rate : {-2.0, 0.0, 2.0}) {
            const Kinematics x{s, rate};
            largest = std::max({largest, std::abs(law(x, memory, mode).total()), law.stored_energy(x, memory, mode)});
          }
        }
      }
      BOOST_TEST((largest > 0.0) == L::acts(mode));
      if (is_broken<L>(mode)) BOOST_TEST(!L::acts(mode));
    }
  });
}

BOOST_AUTO_TEST_CASE(memory_follows_the_motion_in_the_modes_that_say_so) {
  int following = 0;
  over_all_laws([&]<class L>(const L& law) {
    if constexpr (Tracks<L>) {
      for (Mode mode = 0; mode < L::modes.size(); ++mode) {
        std::vector<double> memory(memory_count(law), 0.1);
        const std::vector<double> before = memory;
        law.track({2.0, 1.0}, memory, mode);
        BOOST_TEST((memory != before) == L::memory_follows(mode));
        following += L::memory_follows(mode);
        if constexpr (Yields<L>) {
          if (!L::yields(mode)) continue;
          BOOST_TEST(law.natural_elongation(memory) > law.natural_elongation(before));
        }
      }
    }
  });
  BOOST_TEST(following > 0);
}

BOOST_AUTO_TEST_CASE(linear_parts_are_the_slopes_of_the_force) {
  int linear = 0;
  over_all_laws([&]<class L>(const L& law) {
    if constexpr (HasLinearPart<L>) {
      const std::vector<double> memory(memory_count(law), 0.4);
      for (Mode mode = 0; mode < L::modes.size(); ++mode) {
        const Tangent slopes = law.linear_part(memory, mode);
        for (const auto& [from, to] :
             {std::pair{Kinematics{0.1, 1.0}, Kinematics{0.3, 1.0}}, {Kinematics{0.2, -1.0}, Kinematics{0.2, 3.0}}}) {
          const double change = law(to, memory, mode).total() - law(from, memory, mode).total();
          const double by_slopes = slopes.stiffness * (to.deformation - from.deformation) +
                                   slopes.damping * (to.deformation_rate - from.deformation_rate);
          BOOST_TEST(std::abs(change - by_slopes) < 1e-14 * (1.0 + std::abs(change)));
          linear += change != 0.0;
        }
      }
    }
  });
  BOOST_TEST(linear > 10);
}

BOOST_AUTO_TEST_CASE(elastic_force_is_the_derivative_of_the_stored_energy) {
  over_all_laws([]<class L>(const L& law) {
    std::array<bool, L::modes.size()> seen{};
    // Modes reached along paths: loading, unloading, separating faster than the spring can follow, and separate but
    // within reach. The longest are for laws whose branches change at some deformation: parameters are up to 80.
    std::vector<std::vector<Kinematics>> paths;
    if (reach(law) > 0.0) paths.push_back({{-0.5 * reach(law), -1.0}});
    for (const double s : {0.01, 0.3, 2.0, 100.0}) {
      paths.push_back({{s, 1.0}});
      paths.push_back({{1.2 * s, 1.0}, {s, -1.0}});
      paths.push_back({{s, 1.0}, {s, -20.0}});
    }
    for (const std::vector<Kinematics>& path : paths) {
      auto memory = memory_of(law);
      Mode mode = 0;
      for (const Kinematics& x : path)
        update_mode(law, std::span{memory}, x, mode, [](double) {});
      seen[mode] = true;
      const double s = path.back().deformation, d = std::abs(s) * 1e-3;
      // The four-point difference is exact up to fourth powers, and off by 1e-12 where the energy grows with the power
      // 5/2; the rest is the round-off of energies divided by the step.
      const auto difference = [&](double by) {
        return law.stored_energy({s + by, 0.0}, memory, mode) - law.stored_energy({s - by, 0.0}, memory, mode);
      };
      const double derivative = (8.0 * difference(d) - difference(2.0 * d)) / (12.0 * d);
      const double force = law({s, 0.0}, memory, mode).elastic;
      const double round_off = 4.0 * 0x1p-52 * std::abs(law.stored_energy({s, 0.0}, memory, mode)) / d;
      BOOST_TEST(std::abs(force - derivative) <= 1e-11 * std::abs(force) + round_off);
    }
    for (Mode mode = 0; mode < L::modes.size(); ++mode)
      BOOST_TEST((seen[mode] || !L::acts(mode)));
  });
}

BOOST_AUTO_TEST_CASE(dissipative_force_never_gives_energy_while_its_mode_lasts) {
  over_all_laws([]<class L>(const L& law) {
    const auto memory = memory_of(law);
    for (Mode mode = 0; mode < L::modes.size(); ++mode) {
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
  // Length by 2^3, mass by 2^-2, time by 2^1; hence force [M L/T^2] by 2^-1.
  over_all_laws([]<class L>(const L& law) {
    const auto memory = memory_of(law);
    L scaled = law;
    for (const auto& field : L::fields()) {
      const Dimension of = field.dimension;
      scaled.*field.member = std::ldexp(law.*field.member, 3 * of.length - 2 * of.mass + of.time);
    }
    const Kinematics x{0.1234567, -0.7654321};
    const Kinematics y{std::ldexp(x.deformation, 3), std::ldexp(x.deformation_rate, 2)};
    BOOST_TEST(scaled(y, memory, 1).total() == std::ldexp(law(x, memory, 1).total(), -1));
  });
}

BOOST_AUTO_TEST_CASE(guard_is_positive_while_the_mode_lasts) {
  over_all_laws([](const auto& law) {
    const auto memory = memory_of(law);
    const double apart = -reach(law) - 0.5;
    BOOST_TEST(law.guard({apart, 1.0}, memory, 0) > 0.0);
    BOOST_TEST(law.guard({0.5, 1.0}, memory, 0) < 0.0);
    BOOST_TEST(law.guard({0.5, 1.0}, memory, 1) > 0.0);
    BOOST_TEST(law.guard({apart, -1.0}, memory, 1) < 0.0);
  });
}

BOOST_AUTO_TEST_CASE(impacts_are_as_long_and_as_elastic_as_laws_say) {
  using boost::test_tools::tolerance;
  int impacts = 0;
  const double mass = 0.7, speed = 0.3;
  over_all_laws([&]<class L>(const L& law) {
    if constexpr (KnowsImpacts<L>) {
      const SteppedImpact found = stepped_impact(law, memory_of(law), mass, speed);
      if (!std::isfinite(law.contact_time(mass, speed))) return;
      BOOST_TEST(found.contact_time == law.contact_time(mass, speed), tolerance(1e-3));
      BOOST_TEST(found.restitution == law.restitution(mass, speed), tolerance(1e-3));
      BOOST_TEST(found.largest_overlap == law.largest_overlap(mass, speed), tolerance(1e-3));
      ++impacts;
    }
    if constexpr (SetsRestitution<L>) {
      L set = law;
      set.set_restitution(0.6, mass, speed);
      BOOST_TEST(set.restitution(mass, speed) == 0.6, tolerance(1e-11));
      BOOST_TEST((set.restitution(mass, 3.0 * speed) != set.restitution(mass, speed)) == restitution_varies(set));
      bool is_field = false;
      for (const auto& field : L::fields())
        is_field = is_field || (field.name == L::restitution_field.name && set.*field.member != law.*field.member);
      BOOST_TEST(is_field);
    }
    if constexpr (SetsEveryRestitution<L> && StartsByMass<L>) {
      L set = law;
      set.set_every_restitution(0.6, speed);
      for (const double other_mass : {0.1, 3.0}) {
        std::vector<double> memory(memory_count(set));
        set.start_contact(memory, other_mass);
        BOOST_TEST(set.restitution(other_mass, speed) == 0.6, tolerance(1e-11));
        BOOST_TEST(stepped_impact(set, memory, other_mass, speed).restitution == 0.6, tolerance(1e-3));
      }
    }
  });
  BOOST_TEST(impacts > 4);
}

BOOST_AUTO_TEST_CASE(clamped_contact_never_pulls_and_attractive_does) {
  const double s = 0.01, fast = -10.0;  // k s + c ds/dt = 0.05 - 7.5 < 0
  const LinearSpringDashpot clamped{5.0, 0.75, EndRule::clamped};
  const LinearSpringDashpot attractive{5.0, 0.75, EndRule::attractive};
  const Mode mode = settled(clamped, {s, fast}, 1);
  BOOST_TEST(mode == 2);
  BOOST_TEST(clamped({s, fast}, {}, mode).total() == 0.0);
  BOOST_TEST(settled(attractive, {s, fast}, 1) == 1);
  BOOST_TEST(attractive({s, fast}, {}, 1).total() < 0.0);
  BOOST_TEST(settled(clamped, {s, 1.0}, 2) == 1);    // repulsive again
  BOOST_TEST(settled(clamped, {-s, fast}, 2) == 0);  // separated
}

BOOST_AUTO_TEST_CASE(release_books_the_spring_energy_once) {
  const LinearSpringDashpot law{5.0, 0.75, EndRule::clamped};
  const Kinematics x{0.2, -10.0};
  BOOST_TEST(law.reset(x, {}, 1).released == law.stored_energy(x, {}, 1));
  BOOST_TEST(law.reset({0.2, 0.0}, {}, 2).released == -law.stored_energy({0.2, 0.0}, {}, 1));
  BOOST_TEST(law.reset({0.0, -1.0}, {}, 1).released == 0.0);
}

// Property used by the rows of a fence: on its linear branch a law need not be evaluated, with identical bits.
BOOST_AUTO_TEST_CASE(a_straight_line_is_the_law_as_long_as_it_lasts) {
  int lines = 0;
  over_all_laws([&lines]<class L>(const L& law) {
    if constexpr (HasLinearBranch<L>) {
      for (Mode mode = 0; mode < L::modes.size(); ++mode) {
        for (const double kept : {0.0, 0.3, 1.7}) {
          const std::vector<double> memory(L::memory_size, kept);
          const LinearBranch piece = law.linear_branch(memory, mode);
          lines += piece.low < piece.high;
          for (int i = -400; i <= 400; ++i) {
            for (const double end : {0.0, piece.low, piece.high}) {
              // Values spread over the range, and within a few roundings of its ends.
              const double deformation = end == 0.0 ? 0.01 * i : end + i * 0x1p-52 * std::abs(end);
              if (!(piece.low < deformation && deformation < piece.high)) continue;
              const double force = piece.stiffness * (deformation - piece.natural);
              for (const double rate : {-2.0, 0.0, 2.0}) {
                const Kinematics x{deformation, rate};
                const LawForce full = law(x, memory, mode);
                const double elastic = deformation - piece.natural;
                const double energy = 0.5 * piece.stiffness * elastic * elastic;
                if (full.total() != force || full.dissipative != 0.0 || !(law.guard(x, memory, mode) > 0.0) ||
                    law.stored_energy(x, memory, mode) != energy)
                  BOOST_ERROR(L::name << ", mode " << mode << ": not on its line at " << deformation);
              }
            }
          }
        }
      }
    }
  });
  BOOST_TEST(lines > 10);
}

// The range of a scene's numbers is that of doubles.
BOOST_AUTO_TEST_CASE(impacts_have_a_duration_with_the_weakest_and_the_strongest_dashpots) {
  const auto close = boost::test_tools::tolerance(1e-10);
  for (const HertzDashpot dashpot : {HertzDashpot::tsuji, HertzDashpot::constant}) {
    for (const EndRule rule : {EndRule::attractive, EndRule::clamped}) {
      for (const double damping : {1e-300, 1e-30, 1e-20}) {
        const HertzImpact weak = hertz_impact(damping, dashpot, rule), elastic = hertz_impact(0.0, dashpot, rule);
        BOOST_TEST(weak.restitution == 1.0, close);
        BOOST_TEST(weak.contact_time == elastic.contact_time, close);
        BOOST_TEST(weak.largest_overlap == elastic.largest_overlap, close);
      }
    }
  }
  BOOST_TEST(hertz_impact(1e80, HertzDashpot::tsuji, EndRule::clamped).restitution == 0.0);
  BOOST_TEST(hertz_impact(1.0, HertzDashpot::tsuji, EndRule::attractive).largest_overlap ==
                 hertz_impact(1.0, HertzDashpot::tsuji, EndRule::clamped).largest_overlap,
             close);
  for (const double n : {1.0, 1.5, 2.3, 10.0, 50.0, 100.0}) {
    // Without damping the contact lasts sqrt(pi) 2 d Gamma(1 + p)/Gamma(1/2 + p) at the speed 1, with p = 1/(n + 1) and
    // the overlap d = ((n + 1)/2)^p.
    const double p = 1.0 / (n + 1.0), overlap = std::pow(0.5 * (n + 1.0), p);
    const double exact = 2.0 * std::sqrt(std::numbers::pi) * overlap * std::tgamma(1.0 + p) / std::tgamma(0.5 + p);
    BOOST_TEST(hunt_crossley_impact(0.0, n).contact_time == exact, close);
    BOOST_TEST(hunt_crossley_impact(0.0, n).largest_overlap == overlap, close);
  }
  for (const double exponent : {1.0, 1.5, 2.3, 50.0}) {
    for (const double damping : {1e-300, 1e-200, 1e-31, 1e-14, 1e-13}) {
      const HuntCrossleyImpact weak = hunt_crossley_impact(damping, exponent);
      const HuntCrossleyImpact elastic = hunt_crossley_impact(0.0, exponent);
      BOOST_TEST(weak.restitution == 1.0, close);
      BOOST_TEST(weak.contact_time == elastic.contact_time, close);
      BOOST_TEST(weak.largest_overlap == elastic.largest_overlap, close);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
