#include "verification/problems/founding/odeint_findings.hpp"

#include <fmt/format.h>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "verification/reference/pendulum_steppers.hpp"
#include "verification/study/scene_run.hpp"
#include "verification/study/swing.hpp"

namespace talus::verification::problems {

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

}  // namespace

void check_references(Findings& findings) {
  const double w0 = bob_frequency();
  for (const double degrees : {0.1, 60.0, 179.0}) {
    const double k = std::sin(0.5 * degrees * degree);
    const double K = boost::math::ellint_1(k);
    const double condition = (boost::math::ellint_2(k) / ((1.0 - k) * (1.0 + k)) - K) / K;  // d ln K/d ln k
    findings.expect(fmt::format("elliptic integral at {:g} degrees", degrees), 4.0 * K / w0,
                    bob_motion(degrees * degree).period(),
                    Tolerance::round_off(epsilon * (3.0 + 0.5 * condition),
                                         "3 roundings of K and the quotient, and half a unit of k times the condition "
                                         "d ln K/d ln k")
                        .relative(),
                    "s");
  }
  const double amplitude = 60.0 * degree;
  const double k = std::sin(0.5 * amplitude);
  const auto motion = bob_motion(amplitude);
  double from_boost = 0.0;
  double from_50_digits = 0.0;
  for (int i = 0; i < 50; ++i) {
    const double t = 0.0437 * i;
    const double sn = boost::math::jacobi_sn(k, w0 * t + boost::math::ellint_1(k));
    from_boost = std::max(from_boost, std::abs(motion.at(t).angle - 2.0 * std::asin(k * sn)));
    if (i % 5 == 0)
      from_50_digits = std::max(from_50_digits, std::abs(motion.at(t).angle - motion.at_50_digits(t).angle));
  }
  findings.expect("elliptic function sn over one period", from_boost, 0.0,
                  Tolerance::round_off(8.0 * epsilon,
                                       "half a unit of the argument w0 t + K < 9, times the rate of the angle, at most "
                                       "2 k = 1: 8 epsilon; sn and asin add less"),
                  "rad");
  findings.expect("reference against 50 digits", from_50_digits, 0.0,
                  Tolerance::round_off(epsilon,
                                       "long double carries 11 more bits: what is left is the rounding of the "
                                       "result to double, half a unit of 1.05 rad"),
                  "rad");
}

void check_odeint(Findings& findings) {
  const double amplitude = 60.0 * degree;
  const double duration = 0.8 * bob_motion(amplitude).period();
  Figure chart{.name = "odeint_tolerance",
               .title = "odeint's step control",
               .caption =
                   "Error at the end of 0.8 period (60 degrees) of odeint's steppers run without the solver, "
                   "against the tolerance of one step. The dashed line is the tolerance itself.",
               .x = {"tolerance of a step", "1", true},
               .y = {"error of the angle", "rad", true},
               .series = {},
               .slopes = {{1.0, 1e-8, 1e-8, "tolerance"}}};
  for (const auto& stepper : reference::pendulum_steppers()) {
    reference::PendulumRun run{std::string(stepper.name), bob_frequency(), amplitude, duration, 0, 0.0};
    if (stepper.controlled) {
      Series series{.label = run.stepper};
      for (run.tolerance = 1e-4; run.tolerance > 5e-13; run.tolerance *= 0.1)
        series.add(run.tolerance, reference::run_pendulum(run).largest_angle_error);
      findings.expect_order("odeint alone, " + run.stepper + ": error against tolerance",
                            Convergence{series.x, series.y}, 0.8, 1.2,
                            "step control keeps the error of a step below the tolerance, so the global error is "
                            "proportional to it: 1, less up to 1/p where fewer steps add up, more where the higher "
                            "order of the solution carried on shows");
      chart.series.push_back(series);
    }
  }
  findings.figure(chart);
}

void check_adapter(Findings& findings, const Setup& setup) {
  const double amplitude = 60.0 * degree;
  const auto motion = bob_motion(amplitude);
  const double duration = 0.8 * motion.period();
  constexpr std::array<std::array<const char*, 2>, 4> twins{{{"rk4", "rk4"},
                                                             {"odeint_dopri5", "dopri5"},
                                                             {"odeint_cash_karp54", "cash_karp54"},
                                                             {"odeint_fehlberg78", "fehlberg78"}}};
  for (const auto& twin : twins) {
    const RunEnd end =
        run_steps(scenes::pendulum(bob(setup, amplitude)), make_integrator(twin[0]), duration / 48.0, 48);
    const auto alone = reference::run_pendulum({twin[1], bob_frequency(), amplitude, duration, 48, 0.0});
    findings.expect(fmt::format("{} in the solver, {} alone", twin[0], twin[1]), end.state.q[0], alone.angle,
                    Tolerance::round_off(4.0 * std::sqrt(48.0 * 4.0) * 0.5 * epsilon,
                                         "the same 48 steps in another order of operations: a random walk of 4 "
                                         "roundings of a number near 1 a step, four standard deviations"),
                    "rad");
  }
}

}  // namespace talus::verification::problems
