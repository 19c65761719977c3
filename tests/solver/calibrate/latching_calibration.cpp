#include "solver/calibrate/latching_calibration.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <string>

#include "solver/base/error.hpp"

BOOST_AUTO_TEST_SUITE(latching_calibration_tests)

using namespace talus;

namespace {

/// Two unit masses, so that w1 h is the requested loading angle.
SteppedContact contact_of(const char* method, double loading_angle) {
  return {4.0, 1.0, 0.5 * loading_angle, make_disc_method(method)};
}

}  // namespace

// e of 0.45 is 0.7 by euler at w1 h = 0.02177 and by taylor at 0.0434; 0.49 without gain (computed by hand).
BOOST_AUTO_TEST_CASE(the_ratio_of_1989) {
  BOOST_TEST(std::abs(ratio_by_formula(contact_of("euler", 0.02177), 0.7) - 0.45) < 5e-5);
  BOOST_TEST(std::abs(ratio_by_formula(contact_of("taylor", 0.0434), 0.7) - 0.45) < 5e-4);
  BOOST_TEST(std::abs(ratio_by_simulation(contact_of("euler", 0.02177), 0.7) - 0.45) < 2e-4);
  BOOST_TEST(std::abs(ratio_by_simulation(contact_of("taylor", 0.0434), 0.7) - 0.45) < 5e-4);
  for (const char* method : {"velocity_verlet", "euler_cromer", "central_difference"}) {
    BOOST_TEST(ratio_by_formula(contact_of(method, 0.0434), 0.7) == 0.7 * 0.7);
    BOOST_TEST(std::abs(ratio_by_simulation(contact_of(method, 0.0434), 0.7) - 0.49) < 2e-5);
  }
}

BOOST_AUTO_TEST_CASE(formula_and_its_inverse) {
  for (const char* method : {"euler", "taylor", "velocity_verlet"}) {
    for (const double angle : {0.001, 0.02, 0.1}) {
      const SteppedContact contact = contact_of(method, angle);
      for (const double e : {1.0, 0.9, 0.5, 1.001 * minimum_restitution(contact)})
        BOOST_TEST(stepped_restitution(contact, ratio_by_formula(contact, e)) == e,
                   boost::test_tools::tolerance(1e-12));
    }
  }
  const SteppedContact contact = contact_of("euler", 0.1);
  BOOST_TEST(contact.steps_in_contact(0.25) == 7.5 * std::numbers::pi, boost::test_tools::tolerance(1e-15));
  // The minimum: values on both sides are larger.
  const double root = 0.025 * std::numbers::pi, minimum = minimum_restitution(contact);
  BOOST_TEST(stepped_restitution(contact, root * root) == minimum, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(stepped_restitution(contact, 0.9 * root * root) > minimum);
  BOOST_TEST(stepped_restitution(contact, 1.1 * root * root) > minimum);
}

BOOST_AUTO_TEST_CASE(simulated_impacts_have_the_required_mean) {
  for (const char* method : {"euler", "taylor", "velocity_verlet"}) {
    for (const double e : {0.95, 0.6, 0.4}) {
      const SteppedContact contact = contact_of(method, 0.1);
      const SimulatedRestitution found = simulated_restitution(contact, ratio_by_simulation(contact, e));
      BOOST_TEST(found.mean == e, boost::test_tools::tolerance(1e-9));
      // The phases of first contact, reversal and release have an effect of about (w2 h)^2/20.
      BOOST_TEST(found.deviation < 0.1 * 0.1 * 0.1 / (e * e));
      BOOST_TEST(found.deviation > 0.0);
    }
  }
}

BOOST_AUTO_TEST_CASE(what_cannot_be_reached_is_refused_with_the_range) {
  const auto says = [](const char* expected) {
    return
        [expected](const InputError& error) { return std::string{error.what()}.find(expected) != std::string::npos; };
  };
  // c pi w1 h = 0.0785: 0.0785 e^1.0785 = 0.2309.
  BOOST_CHECK_EXCEPTION((void)ratio_by_formula(contact_of("euler", 0.1), 0.2), InputError,
                        says("found 0.2; possible with euler at this step, w1 h = 0.1: 0.2309 to 1;"));
  BOOST_CHECK_EXCEPTION((void)ratio_by_simulation(contact_of("velocity_verlet", 0.1), 0.04), InputError,
                        says(": 0.05 to 1"));
  BOOST_CHECK_THROW((void)ratio_by_formula(contact_of("euler", 0.1), 1.01), InputError);
  BOOST_CHECK_THROW((void)ratio_by_formula(contact_of("euler", 0.1), std::nan("")), InputError);
  BOOST_TEST(ratio_by_formula(contact_of("velocity_verlet", 0.1), 1.0) == 1.0);
  BOOST_TEST(ratio_by_simulation(contact_of("velocity_verlet", 0.1), 1.0) == 1.0, boost::test_tools::tolerance(1e-3));
}

BOOST_AUTO_TEST_SUITE_END()
