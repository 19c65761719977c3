#include "verification/reference/integration/pendulum_steppers.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stdexcept>
#include <string>

BOOST_AUTO_TEST_SUITE(pendulum_steppers_tests)

namespace ref = talus::verification::reference;

BOOST_AUTO_TEST_CASE(declared_orders_are_measured) {
  for (const ref::PendulumStepper& stepper : ref::pendulum_steppers()) {
    if (!stepper.fixed_step) continue;
    // Steps are small enough for the leading term to dominate, large enough for errors far above round-off (8th order:
    // 1e-8 .. 1e-11).
    const int coarse = stepper.order >= 8 ? (stepper.name == "fehlberg78" ? 24 : 120) : 150;
    const auto run = [&](int steps) {
      return ref::run_pendulum({std::string(stepper.name), 1.0, 1.5, 11.0, steps, 0.0});
    };
    const double slope = std::log2(run(coarse).largest_angle_error / run(2 * coarse).largest_angle_error);
    BOOST_TEST_MESSAGE(stepper.name << " " << slope << " " << run(coarse).largest_angle_error);
    BOOST_TEST(slope > stepper.order - 0.6, stepper.name << " slope " << slope);
    BOOST_TEST(slope < stepper.order + 1.6, stepper.name << " slope " << slope);
  }
}

BOOST_AUTO_TEST_CASE(evaluations_are_counted) {
  const auto evaluations = [](const char* name) {
    return ref::run_pendulum({name, 1.0, 1.0, 5.0, 100, 0.0}).evaluations;
  };
  BOOST_TEST(evaluations("rk4") == 400);
  BOOST_TEST(evaluations("cash_karp54") == 600);
  BOOST_TEST(evaluations("dopri5") == 601);  // its last stage is the first of the next step
  BOOST_TEST(evaluations("fehlberg78") == 1300);
}

BOOST_AUTO_TEST_CASE(tolerances_are_obeyed) {
  for (const ref::PendulumStepper& stepper : ref::pendulum_steppers()) {
    if (!stepper.controlled) continue;
    double before = 1.0;
    for (const double tolerance : {1e-5, 1e-8, 1e-11}) {
      const auto result = ref::run_pendulum({std::string(stepper.name), 2.0, 2.5, 20.0, 0, tolerance});
      // Some hundred steps, each with an error below the tolerance, in a motion that amplifies errors by the duration
      // of the run.
      BOOST_TEST(result.largest_angle_error < 5e3 * tolerance, stepper.name << " " << result.largest_angle_error);
      BOOST_TEST(result.largest_energy_error < 5e3 * tolerance);
      BOOST_TEST(result.largest_angle_error < before);
      before = result.largest_angle_error;
    }
  }
}

BOOST_AUTO_TEST_CASE(what_cannot_run_is_refused) {
  BOOST_CHECK_THROW((void)ref::run_pendulum({"verlett", 1.0, 1.0, 1.0, 10, 0.0}), std::invalid_argument);
  BOOST_CHECK_THROW((void)ref::run_pendulum({"rk4", 1.0, 1.0, 1.0, 0, 1e-6}), std::invalid_argument);
  BOOST_CHECK_THROW((void)ref::run_pendulum({"bulirsch_stoer", 1.0, 1.0, 1.0, 10, 0.0}), std::invalid_argument);
  BOOST_CHECK_THROW((void)ref::run_pendulum({"dopri5", 1.0, 1.0, 1.0, 0, 0.0}), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
