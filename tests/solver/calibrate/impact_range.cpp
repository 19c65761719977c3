#include "solver/calibrate/impact_range.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <string>

#include "solver/base/error.hpp"
#include "solver/calibrate/impact.hpp"

BOOST_AUTO_TEST_SUITE(impact_range_tests)

using namespace talus;

namespace {

/// Four pairs of different mass and speed for each law, end rule and dashpot.
template <class Visit>
void for_each_range(Visit&& visit) {
  const auto pairs_of = [&](const ContactLaw& law) {
    std::vector<ImpactingPair> pairs;
    for (const auto& [mass, speed] :
         {std::pair{2.0, 0.5}, std::pair{0.3, 4.0}, std::pair{11.0, 1.0}, std::pair{2.0, 6.0}})
      pairs.push_back({law, mass, speed});
    visit(pairs);
  };
  ContactLaws::for_each([&]<class L>(L law) {
    if constexpr (SetsEveryRestitution<L>) {
      for (const auto& field : L::fields())
        if (field.name != L::restitution_field.name)
          law.*field.member = field.range == Range::one_to_hundred ? 1.5 : 0.7;
      if constexpr (HasHertzDashpot<L>) {
        law.dashpot = HertzDashpot::constant;
        pairs_of(law);
        law.dashpot = HertzDashpot::tsuji;
      }
      if constexpr (HasEndRule<L>) {
        law.end_rule = EndRule::attractive;
        pairs_of(law);
        law.end_rule = EndRule::clamped;
      }
      pairs_of(law);
    }
  });
}

double minimax_of(const std::vector<ImpactingPair>& pairs, double e) {
  std::vector<double> exact;
  for (const ImpactingPair& pair : pairs)
    exact.push_back(exact_dissipation(pair, e));
  return minimax_dissipation(pairs, exact, e);
}

}  // namespace

BOOST_AUTO_TEST_CASE(exact_dissipation_gives_each_pair_its_restitution) {
  for_each_range([](const std::vector<ImpactingPair>& pairs) {
    for (const double e : {0.2, 0.6, 0.95}) {
      for (const ImpactingPair& pair : pairs)
        BOOST_TEST(restitution_with(pair, exact_dissipation(pair, e)) == e, boost::test_tools::tolerance(1e-11));
    }
  });
}

// The bracket of the search, and its root, require that e decreases.
BOOST_AUTO_TEST_CASE(restitution_decreases_with_the_dissipation) {
  for_each_range([](const std::vector<ImpactingPair>& pairs) {
    for (const ImpactingPair& pair : pairs) {
      const double exact = exact_dissipation(pair, 0.6);
      double before = restitution_with(pair, 0.0);
      BOOST_TEST(before == 1.0, boost::test_tools::tolerance(1e-12));
      for (const double multiple : {0.1, 0.5, 0.9, 1.0, 1.1, 2.0}) {
        const double e = restitution_with(pair, multiple * exact);
        BOOST_TEST(e < before);
        before = e;
      }
    }
  });
}

BOOST_AUTO_TEST_CASE(minimax_deviates_equally_on_both_sides_and_no_other_value_is_better) {
  for_each_range([](const std::vector<ImpactingPair>& pairs) {
    const double e = 0.6, best = minimax_of(pairs, e), deviation = largest_deviation(pairs, best, e);
    double smallest = 1.0, largest = 0.0;
    for (const ImpactingPair& pair : pairs) {
      smallest = std::min(smallest, restitution_with(pair, best));
      largest = std::max(largest, restitution_with(pair, best));
    }
    BOOST_TEST(std::abs((largest - e) - (e - smallest)) < 1e-13);
    BOOST_TEST(deviation == largest - e, boost::test_tools::tolerance(1e-11));
    for (double other = 0.01 * best; other < 100.0 * best; other *= 1.1)
      BOOST_TEST(largest_deviation(pairs, other, e) > deviation);
    for (const double other : {best * (1.0 - 1e-9), best * (1.0 + 1e-9)})
      BOOST_TEST(largest_deviation(pairs, other, e) > deviation);
  });
}

BOOST_AUTO_TEST_CASE(minimax_of_equal_pairs_is_exact) {
  for_each_range([](const std::vector<ImpactingPair>& pairs) {
    const std::vector<ImpactingPair> equal(3, pairs.front());
    const double best = minimax_of(equal, 0.6);
    BOOST_TEST(best == exact_dissipation(pairs.front(), 0.6));
    BOOST_TEST(largest_deviation(equal, best, 0.6) < 1e-12);
    BOOST_TEST(minimax_of(pairs, 1.0) == 0.0);
    BOOST_TEST(largest_deviation(pairs, 0.0, 1.0) < 1e-12);
  });
}

// The 1000 times as heavy contact of the attractive rule does not end with the dashpot of the light one.
BOOST_AUTO_TEST_CASE(a_contact_that_does_not_end_has_no_restitution) {
  const LinearSpringDashpot law{1e4, 0.0, EndRule::attractive};
  const ImpactingPair light{law, 1.0, 1.0}, heavy{law, 1000.0, 1.0};
  const double of_heavy = exact_dissipation(heavy, 0.2);
  BOOST_TEST(restitution_with(light, of_heavy) == 0.0);
  const std::vector<ImpactingPair> both{light, heavy};
  BOOST_TEST(largest_deviation(both, of_heavy, 0.2) == 0.2);
  BOOST_TEST(largest_deviation(both, minimax_of(both, 0.2), 0.2) < 0.2 + 1e-12);
}

/// Largest error of the restitution of a pair over 16 phases at a step.
double largest_error(const ImpactingPair& pair, double dissipation, double step) {
  const ImpactError error = restitution_error(with_dissipation(pair.law, dissipation), pair.effective_mass, pair.speed,
                                              make_integrator("velocity_verlet"));
  double largest = 0.0;
  for (int i = 0; i < 16; ++i)
    largest = std::max(largest, error(step, (i + 0.5) / 16.0));
  return largest;
}

// All pairs are as accurate as required; with twice the step, some pair is not.
BOOST_AUTO_TEST_CASE(a_step_for_a_range_is_accurate_for_each_pair) {
  const Integrator integrator = make_integrator("velocity_verlet");
  constexpr double bound = 0.01;
  for_each_range([&](const std::vector<ImpactingPair>& pairs) {
    const double used = minimax_of(pairs, 0.6);
    const std::optional<RangeStep> found = advise_range_step(pairs, used, bound, integrator);
    BOOST_REQUIRE(found.has_value());
    double shortest = 1e300;
    for (const ImpactingPair& pair : pairs) {
      const ContactLaw law = with_dissipation(pair.law, used);
      if (restitution_with(pair, used) == 0.0) continue;
      BOOST_TEST(largest_error(pair, used, found->step) <= bound);
      shortest = std::min(shortest, advise_impact_step(law, pair.effective_mass, pair.speed, bound, integrator).step);
    }
    BOOST_TEST(found->largest_error <= bound);
    BOOST_TEST(found->step >= shortest * (1.0 - 1e-12));
    BOOST_TEST(found->step <= 2.1 * shortest);
    const std::vector<ImpactingPair> one{pairs.front()};
    const ContactLaw law = with_dissipation(one[0].law, used);
    BOOST_TEST(advise_range_step(one, used, bound, integrator)->step ==
               advise_impact_step(law, one[0].effective_mass, one[0].speed, bound, integrator).step);
  });
}

// The pair that needs the shortest step is named; contacts that do not end need none.
BOOST_AUTO_TEST_CASE(a_step_for_a_range_leaves_out_contacts_that_do_not_end) {
  const Integrator integrator = make_integrator("velocity_verlet");
  const LinearSpringDashpot law{1e4, 0.0, EndRule::attractive};
  const ImpactingPair light{law, 1.0, 1.0}, heavy{law, 1000.0, 1.0};
  const std::vector<ImpactingPair> both{heavy, light};
  BOOST_TEST(advise_range_step(both, 10.0, 0.01, integrator)->pair == 1U);
  const double of_heavy = exact_dissipation(heavy, 0.2);
  BOOST_TEST(advise_range_step(both, of_heavy, 0.01, integrator)->pair == 0U);
  const std::vector<ImpactingPair> none{light};
  BOOST_TEST(!advise_range_step(none, of_heavy, 0.01, integrator).has_value());
}

BOOST_AUTO_TEST_CASE(laws_without_a_dashpot_are_refused) {
  const ImpactingPair pair{LatchingSpring{100.0, 400.0, 0.0}, 1.0, 1.0};
  const auto refused = [](const InputError& error) {
    return std::string{error.what()} == "the law 'latching_spring' has no damping";
  };
  BOOST_CHECK_EXCEPTION((void)exact_dissipation(pair, 0.5), InputError, refused);
  BOOST_CHECK_EXCEPTION((void)restitution_with(pair, 1.0), InputError, refused);
  BOOST_CHECK_THROW((void)exact_dissipation({LinearSpringDashpot{1.0, 0.0}, 1.0, 1.0}, 1.5), InputError);
}

// Two spheres of 2 m and 3 kg/m^3: 32 pi kg each.
BOOST_AUTO_TEST_CASE(equal_spheres_have_half_the_mass_and_half_the_radius) {
  const EqualSpheres spheres{2.0, 3.0};
  BOOST_TEST(spheres.effective_mass() == 16.0 * std::numbers::pi, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(spheres.effective_radius() == 1.0);
}

BOOST_AUTO_TEST_CASE(numbers_are_spaced_by_one_ratio) {
  const std::vector<double> numbers = log_spaced(0.1, 10.0, 5);
  BOOST_REQUIRE(numbers.size() == 5U);
  BOOST_TEST(numbers.front() == 0.1);
  BOOST_TEST(numbers.back() == 10.0);
  for (std::size_t i = 1; i < numbers.size(); ++i)
    BOOST_TEST(numbers[i] / numbers[i - 1] == std::sqrt(10.0), boost::test_tools::tolerance(1e-14));
}

// A light pair of a wide range has many times the critical dashpot, which stops the body before the spring matters:
// the impulse of the dashpot, its coefficient integrated over the overlap, is the momentum: c x = m v (constant),
// 4/5 c x (x/R)^(1/4) = m v (tsuji).
BOOST_AUTO_TEST_CASE(a_hertz_contact_with_a_very_strong_dashpot_stops_the_body) {
  Hertz law{.modulus = 1e6, .radius = 0.01};
  const double mass = 0.1, speed = 2.0;
  for (const HertzDashpot dashpot : {HertzDashpot::constant, HertzDashpot::tsuji}) {
    law.dashpot = dashpot;
    law.set_restitution(0.5, mass, speed);
    const double moderate = law.damping;
    for (const double times : {1e6, 1e8, 1e10, 1e12}) {
      law.damping = times * moderate;
      const double momentum = mass * speed / law.damping;
      const double overlap =
          dashpot == HertzDashpot::constant ? momentum : std::pow(1.25 * momentum * std::pow(law.radius, 0.25), 0.8);
      const KnownImpact known = known_impact(law, mass, speed);
      BOOST_TEST(known.largest_overlap == overlap, boost::test_tools::tolerance(1e-6));
      BOOST_TEST(known.restitution >= 0.0);
      BOOST_TEST(known.restitution < 1e-3);
    }
  }
}

// Errors that no step makes small, and a method without the closed form that it needs.
BOOST_AUTO_TEST_CASE(a_step_that_does_not_exist_is_refused) {
  int calls = 0;
  const ImpactError same = [&calls](double, double) { return ++calls, 0.5; };
  BOOST_CHECK_EXCEPTION((void)accurate_step(same, 1.0, 0.1), InputError, [](const InputError& error) {
    return std::string{error.what()} ==
           "an error of e below 0.1 is not reached with 2^18 steps in a contact; allow a larger error, or choose "
           "another integrator";
  });
  BOOST_TEST(calls == 16);  // 8 to 2^18 steps in a contact, each given up at the first phase
  BOOST_CHECK_EXCEPTION((void)restitution_error(Hertz{.modulus = 1e6, .radius = 0.01}, 1.0, 1.0, Exact{}), InputError,
                        [](const InputError& error) {
                          return std::string{error.what()} ==
                                 "integrator 'exact': the motion between events must be linear, but contact 'impact': "
                                 "the law hertz is not linear";
                        });
}

BOOST_AUTO_TEST_SUITE_END()
