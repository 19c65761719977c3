/// Friction by spring and slider, with prescribed slips under prescribed normal forces.
#include "solver/laws/coulomb_friction.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

BOOST_AUTO_TEST_SUITE(coulomb_friction_tests)

using namespace talus;

namespace {

/// One contact; updates its mode after each slip as the dynamics do before each force evaluation.
struct Drawn {
  CoulombFriction law{0.5, 8.0};
  double stretch{};
  double dissipated{};
  Mode mode{CoulombFriction::open};

  double slip(double by, double normal) {
    const auto settled = law.return_mapping(stretch + by, normal);
    stretch = settled.stretch;
    dissipated += settled.dissipated;
    mode = settled.mode;
    return law(stretch, normal);
  }
};

}  // namespace

BOOST_AUTO_TEST_CASE(sticks_below_the_limit_and_slips_at_it_both_ways) {
  Drawn contact;
  BOOST_TEST(contact.slip(0.125, 4.0) == 1.0);  // k_s s
  BOOST_TEST(contact.mode == CoulombFriction::sticking);
  BOOST_TEST(contact.slip(1.0, 4.0) == 2.0);  // mu N
  BOOST_TEST(contact.mode == CoulombFriction::slipping_forward);
  BOOST_TEST(contact.slip(-0.125, 4.0) == 1.0);  // sticks again at once: the spring is unloaded
  BOOST_TEST(contact.mode == CoulombFriction::sticking);
  BOOST_TEST(contact.slip(-9.0, 4.0) == -2.0);
  BOOST_TEST(contact.mode == CoulombFriction::slipping_backward);
}

BOOST_AUTO_TEST_CASE(a_closed_loop_loses_what_the_slider_takes) {
  // Back and forth between stretches -0.25 and 0.25 under a limit of 2: of a slip of 1 in each direction 0.5 reverses
  // the stretch of the spring, the other 0.5 moves the slider, at a force of 2.
  Drawn contact;
  contact.slip(10.0, 4.0);
  const double before = contact.dissipated;
  for (int i = 0; i < 1024; ++i)
    contact.slip(-1.0 / 1024.0, 4.0);
  for (int i = 0; i < 1024; ++i)
    contact.slip(1.0 / 1024.0, 4.0);
  BOOST_TEST(contact.dissipated - before == 2.0, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(contact.stretch == 0.25);
}

BOOST_AUTO_TEST_CASE(forgets_when_it_opens_and_books_the_spring) {
  Drawn contact;
  contact.slip(0.125, 4.0);
  BOOST_TEST(contact.slip(0.0, 0.0) == 0.0);
  BOOST_TEST(contact.mode == CoulombFriction::open);
  BOOST_TEST(contact.stretch == 0.0);
  BOOST_TEST(contact.dissipated == 0.0625);  // k_s s^2/2
}

BOOST_AUTO_TEST_CASE(begins_with_the_slip_since_the_touch_up_to_the_limit) {
  const CoulombFriction law{0.5, 8.0};
  BOOST_TEST(law.initial_stretch(0.125, 4.0) == 0.125);
  BOOST_TEST(law.initial_stretch(-0.125, 4.0) == -0.125);
  BOOST_TEST(law.initial_stretch(9.0, 4.0) == 0.25);
  BOOST_TEST(law.initial_stretch(-9.0, 4.0) == -0.25);
}

BOOST_AUTO_TEST_CASE(a_pull_has_no_friction) {
  const CoulombFriction law{0.5, 8.0};
  BOOST_TEST(law.initial_stretch(0.125, -4.0) == 0.0);
  BOOST_TEST(law(0.125, -4.0) == 0.0);
  BOOST_TEST(law.return_mapping(0.125, -4.0).mode == CoulombFriction::open);
}

BOOST_AUTO_TEST_CASE(guard_is_positive_while_the_mode_lasts) {
  const CoulombFriction law{0.5, 8.0};
  BOOST_TEST(law.guard(0.0, 1.0, -1.0, CoulombFriction::open) > 0.0);
  BOOST_TEST(law.guard(0.1, 1.0, 4.0, CoulombFriction::sticking) > 0.0);
  BOOST_TEST(law.guard(0.3, 1.0, 4.0, CoulombFriction::sticking) < 0.0);
  BOOST_TEST(law.guard(0.25, 1.0, 4.0, CoulombFriction::slipping_forward) > 0.0);
  BOOST_TEST(law.guard(0.25, -1.0, 4.0, CoulombFriction::slipping_forward) < 0.0);
  BOOST_TEST(law.guard(-0.25, -1.0, 4.0, CoulombFriction::slipping_backward) > 0.0);
}

BOOST_AUTO_TEST_SUITE_END()
