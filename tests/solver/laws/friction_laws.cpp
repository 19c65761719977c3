/// The contract of all friction laws: spring, rate and motion of the stretch, and energy agree with each other.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>
#include <string>

#include "solver/base/pack.hpp"
#include "solver/laws/law_list.hpp"
#include "tests/solver/laws/law_examples.hpp"

BOOST_AUTO_TEST_SUITE(friction_laws_tests)

using namespace talus;

namespace {

/// Calls test(law) with an example of each friction law.
template <class Test>
void for_each_example(Test&& test) {
  FrictionLaws::for_each([&]<class F>(const F&) {
    BOOST_TEST_CONTEXT(F::name) { test(friction_example<F>()); }
  });
}

/// Stretch after a time h of constant speeds, by many midpoint steps of its rate.
template <class L>
double integrated(const L& law, double stretch, double slip_rate, Kinematics middle, double h) {
  constexpr int steps = 4000;
  const double step = h / steps, rate = middle.deformation_rate;
  for (int i = 0; i < steps; ++i) {
    const double overlap = middle.deformation - 0.5 * h * rate + i * step * rate;
    const double half = stretch + 0.5 * step * law.stretch_rate(stretch, slip_rate, {overlap, rate});
    stretch += step * law.stretch_rate(half, slip_rate, {overlap + 0.5 * step * rate, rate});
  }
  return stretch;
}

}  // namespace

BOOST_AUTO_TEST_CASE(motion_of_the_stretch_is_the_integral_of_its_rate) {
  for_each_example([](const auto& law) {
    for (const double rate : {0.3, -0.3, 0.0}) {
      for (const double h : {0.25, -0.25}) {
        const Kinematics x{0.2, rate};
        BOOST_TEST(law.stretch_after(0.07, -0.4, x, h) == integrated(law, 0.07, -0.4, x, h),
                   boost::test_tools::tolerance(1e-6));
      }
    }
  });
}

BOOST_AUTO_TEST_CASE(onset_is_the_stretch_of_constant_speeds_from_the_touch) {
  for_each_example([](const auto& law) {
    // Overlap 0.3 t, slip 0.4 t, after t = 0.5.
    const double stretch = law.stretch_after(0.0, 0.4, {0.5 * 0.3 * 0.5, 0.3}, 0.5);
    BOOST_TEST(stretch == law.onset * 0.4 * 0.5, boost::test_tools::tolerance(1e-14));
  });
}

BOOST_AUTO_TEST_CASE(work_is_stored_or_dissipated_by_the_changing_stiffness) {
  constexpr double slip_rate = 0.4, stretch = 0.07, step = 1e-6, overlap = 0.2;
  for_each_example([&](const auto& law) {
    for (const double rate : {0.3, -0.3}) {
      const auto energy_after = [&](double h) {
        const Kinematics middle{overlap + 0.5 * h * rate, rate};
        return law.at(overlap + h * rate).stored_energy(law.stretch_after(stretch, slip_rate, middle, h));
      };
      const double change = (energy_after(step) - energy_after(-step)) / (2.0 * step);
      const double lost = law.area_power(stretch, {overlap, rate});
      BOOST_TEST(lost >= 0.0);
      BOOST_TEST(change == law.at(overlap).stiffness * stretch * slip_rate - lost, boost::test_tools::tolerance(1e-7));
    }
  });
}

BOOST_AUTO_TEST_CASE(nothing_is_stored_or_lost_by_an_unstretched_spring) {
  for_each_example([](const auto& law) {
    BOOST_TEST(law.area_power(0.0, {0.2, 0.3}) == 0.0);
    BOOST_TEST(law.stretch_rate(0.0, 0.4, {0.2, 0.3}) == 0.4);
  });
}

BOOST_AUTO_TEST_CASE(apart_there_is_no_rate_but_the_slip_and_no_loss) {
  for_each_example([](const auto& law) {
    for (const double overlap : {0.0, -0.1}) {
      BOOST_TEST(law.stretch_rate(0.07, 0.4, {overlap, 0.3}) == 0.4);
      BOOST_TEST(law.area_power(0.07, {overlap, 0.3}) == 0.0);
      BOOST_TEST(std::isfinite(law.stretch_after(0.07, 0.4, {overlap, 0.3}, 0.1)));
      BOOST_TEST(std::isfinite(law.at(overlap)(0.07, 1.0)));
      BOOST_TEST(law.at(overlap).guard(0.0, 0.4, 0.0, CoulombFriction::sticking) == 0.0);
    }
  });
}

BOOST_AUTO_TEST_CASE(stiffest_branch_has_the_stiffness_of_the_largest_overlap) {
  for_each_example([](const auto& law) {
    BOOST_TEST(law.stiffest().coefficient == law.coefficient);
    BOOST_TEST(law.stiffest().stiffness >= law.at(0.19).stiffness);
    BOOST_TEST(law.stiffest().damping >= law.at(0.19).damping);
    BOOST_TEST(law.at(0.19).damping > 0.0);
  });
}

BOOST_AUTO_TEST_CASE(stiffness_of_mindlin_is_that_of_the_contact_radius) {
  const Mindlin law{0.5, 3.0, 2.0, 0.25};
  BOOST_TEST(law.at(0.125).stiffness == 8.0 * 3.0 * 0.5);  // a = sqrt(2 * 0.125)
  BOOST_TEST(law.at(0.125).damping == 0.125);              // (0.125/2)^(1/4) = 1/2
  BOOST_TEST(law.stiffest().stiffness == law.at(0.2).stiffness);
}

namespace {

/// Whether each lane of a pack has the bits of a number: the same value, or zero of either sign.
bool has_lanes(const Pack& pack, const std::array<double, pack_size>& numbers) {
  for (std::size_t l = 0; l < pack_size; ++l)
    if (!(pack[l] == numbers[l])) return false;
  return true;
}
}  // namespace

BOOST_AUTO_TEST_CASE(lanes_of_disc_friction_have_the_bits_of_numbers) {
  std::mt19937 random{7};
  std::uniform_real_distribution<double> unit{-1.0, 1.0};
  const auto four = [&](double size) {
    return std::array{size * unit(random), size * unit(random), size * unit(random), size * unit(random)};
  };
  DiscFrictions::for_each([&]<class F>(const F&) {
    const F law = friction_example<F>();
    bool same_stiffness = true, same_stretch = true, same_power = true, same_slider = true;
    for (int n = 0; n < 2000; ++n) {
      const auto overlaps = four(0.2), rates = four(0.5), slips = four(0.4), stretches = four(0.1), forces = four(3.0);
      const double h = 0.1 * unit(random);
      Pack overlap, rate, slip, stretch, force, stiffness, moved, power;
      load(overlap, overlaps.data()), load(rate, rates.data()), load(slip, slips.data());
      load(stretch, stretches.data()), load(force, forces.data());
      force = force < Pack{} ? -force : force;
      law.stiffness_at(overlap, stiffness);
      law.move_stretch(stretch, slip, overlap, rate, h, moved);
      law.area_power(stretch, overlap, rate, power);
      std::array<double, pack_size> k, s, p, first, left, pushed, lost;
      for (std::size_t l = 0; l < pack_size; ++l) {
        const Kinematics x{overlaps[l], rates[l]};
        const CoulombFriction at = law.at(overlaps[l]);
        const double normal = std::abs(forces[l]);
        k[l] = at.stiffness, s[l] = law.stretch_after(stretches[l], slips[l], x, h);
        p[l] = law.area_power(stretches[l], x);
        first[l] = at.initial_stretch(slips[l], normal);
        const auto mapped = at.return_mapping(stretches[l], normal);
        left[l] = mapped.stretch, lost[l] = mapped.dissipated, pushed[l] = at(mapped.stretch, normal);
      }
      same_stiffness = same_stiffness && has_lanes(stiffness, k);
      same_stretch = same_stretch && has_lanes(moved, s);
      same_power = same_power && has_lanes(power, p);
      // Without overlap the slider of a stiffness that follows the contact radius has none: no force pushes it.
      Pack initial, kept = stretch, push, work;
      for (std::size_t l = 0; l < pack_size; ++l) {
        if (!(overlaps[l] > 0.0)) first[l] = left[l] = pushed[l] = lost[l] = 0.0;
      }
      const SpringSlider<Pack> slider{law.coefficient, stiffness};
      slider.initial_stretch(slip, force, initial);
      slider.returned_force(force, kept, push);
      slider.dissipated(stretch, force, kept, work);
      for (Pack* const lanes : {&initial, &kept, &push, &work})
        *lanes = overlap > Pack{} ? *lanes : Pack{};
      same_slider = same_slider && has_lanes(initial, first) && has_lanes(kept, left) && has_lanes(push, pushed) &&
                    has_lanes(work, lost);
    }
    BOOST_TEST_CONTEXT(std::string{F::name}) {
      BOOST_TEST(same_stiffness);
      BOOST_TEST(same_stretch);
      BOOST_TEST(same_power);
      BOOST_TEST(same_slider);
    }
  });
}

BOOST_AUTO_TEST_CASE(friction_by_the_contact_radius_needs_a_law_with_this_radius) {
  static_assert(CanHaveFriction<Hertz, Mindlin> && CanHaveFriction<Hertz, CoulombFriction>);
  static_assert(CanHaveFriction<LinearSpringDashpot, CoulombFriction> && CanHaveFriction<LatchingSpring, Frictionless>);
  static_assert(!CanHaveFriction<LinearSpringDashpot, Mindlin> && !CanHaveFriction<HuntCrossley, Mindlin>);
  BOOST_TEST(DiscFrictions::names() == (std::vector<std::string>{"linear", "mindlin"}),
             boost::test_tools::per_element());
}

// Which friction a contact can have, and in which order, is derived from the fields of both laws.
BOOST_AUTO_TEST_CASE(friction_fits_contacts_whose_law_has_the_fields_it_needs) {
  ContactLaws::for_each([]<class L>(const L&) {
    const std::vector<std::string> names = friction_names_of<FrictionLaws, L>();
    BOOST_TEST(names.front() == CoulombFriction::name, L::name);
    const bool has_radius = requires(L law) { law.radius; };
    BOOST_TEST((std::ranges::find(names, Mindlin::name) != names.end()) == has_radius, L::name);
  });
}

BOOST_AUTO_TEST_CASE(linear_friction_follows_the_normal_law) {
  CoulombFriction friction;
  friction.follow(5.0, true);
  BOOST_TEST((friction == CoulombFriction{0.0, 5.0, 0.0, true}));
  friction.follow(6.0, false);
  BOOST_TEST((friction == CoulombFriction{0.0, 6.0, 0.0, false}));
}

BOOST_AUTO_TEST_SUITE_END()
