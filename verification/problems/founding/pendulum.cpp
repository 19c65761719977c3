#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>

#include "verification/problems/founding/adams_swing.hpp"
#include "verification/problems/founding/leapfrog_swing.hpp"
#include "verification/problems/founding/swing_period_findings.hpp"
#include "verification/problems/founding/work_precision_findings.hpp"
#include "verification/reference/integration/pendulum_steppers.hpp"
#include "verification/reference/motion/elastic_pendulum.hpp"
#include "verification/study/runs/swing.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::pendulum {
namespace {

constexpr double pi = std::numbers::pi;

/// The bob on a cable of softness eps, amplitude 60 degrees.
scenes::CablePendulum hung(const Setup& setup, double eps) {
  scenes::CablePendulum p{.mass = 2.0,
                          .length = 0.8,
                          .stiffness = 2.0 * 9.80665 / (eps * 0.8),
                          .gravity = 9.80665,
                          .amplitude = 60.0 * degree};
  if (setup.has("cable_stiffness_doubled")) p.stiffness *= 2.0;
  return p;
}

reference::ElasticPendulum elastic(double eps) {
  return {2.0, 0.8, 9.80665, 2.0 * 9.80665 / (eps * 0.8), 60.0 * degree};
}

/// Position after `steps` steps of the classical Runge-Kutta method, programmed separately in extended precision: its
/// error is that of the method alone.
std::array<long double, 2> hung_by_classical_runge_kutta(const reference::ElasticPendulum& p, double duration,
                                                         long steps) {
  using Vector = std::array<long double, 4>;  // x, y upwards, and their rates
  const auto rate = [&](const Vector& s) {
    const long double r = std::hypot(s[0], s[1]);
    const long double pull = static_cast<long double>(p.stiffness) / p.mass * (r - p.length) / r;
    return Vector{s[2], s[3], -pull * s[0], -pull * s[1] - p.gravity};
  };
  const auto plus = [](const Vector& s, long double h, const Vector& k) {
    return Vector{s[0] + h * k[0], s[1] + h * k[1], s[2] + h * k[2], s[3] + h * k[3]};
  };
  const long double r = p.length + p.mass * p.gravity * std::cos(p.amplitude) / p.stiffness;
  Vector s{r * std::sin(p.amplitude), -r * std::cos(p.amplitude), 0.0L, 0.0L};
  const long double h = static_cast<long double>(duration) / static_cast<long double>(steps);
  for (long i = 0; i < steps; ++i) {
    const Vector a = rate(s);
    const Vector b = rate(plus(s, h / 2.0L, a));
    const Vector c = rate(plus(s, h / 2.0L, b));
    const Vector d = rate(plus(s, h, c));
    s = plus(plus(plus(plus(s, h / 6.0L, a), h / 3.0L, b), h / 3.0L, c), h / 6.0L, d);
  }
  return {s[0], s[1]};
}

/// The bob on cables of increasing stiffness: approach of the period to that of the rigid pendulum, with the predicted
/// slope. Fault `cable_stiffness_doubled`.
void check_rigid_limit(Findings& findings, const Setup& setup) {
  const double softening = reference::period_softening(60.0 * degree);
  const double rigid = reference::rigid_period(elastic(1.0));
  Convergence approach;
  Series solver{.label = "cable in the solver (rk4)", .style = Style::points};
  Series spring{.label = "elastic reference", .style = Style::crosses};
  for (const double eps : {1e-1, 3e-2, 1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5, 1e-5}) {
    if (setup.coarse && eps != 1e-4) continue;
    const auto p = hung(setup, eps);
    const double h = 2.0 * pi * std::sqrt(eps * 0.8 / 9.80665) / 48.0;
    const double excess = period_of(scenes::cable_pendulum(p), make_integrator("rk4"), h, 2.0 * rigid) / rigid - 1.0;
    if (eps < 2e-2) approach.add(eps, excess);
    if (eps == 1e-4)
      findings.expect_truncation(
          {"excess_on_cable",
           "pendulum on a cable: relative excess of the period over the rigid pendulum, divided by eps, at eps = 1e-4"},
          excess / eps, softening, 0.4 * eps, 1.5,
          "next term of the expansion in eps, its constant measured between eps = 1e-3 and 1e-2");
    solver.add(eps, excess);
    if (eps >= 3e-3) {
      spring.add(eps, reference::elastic_pendulum_period(elastic(eps)) / rigid - 1.0);
    }
  }
  if (setup.coarse) return;
  findings.expect_order({"order_in_eps", "pendulum on a cable: order in eps of the approach to the rigid pendulum"},
                        approach, 0.995, 1.005,
                        "the expansion of the period has terms in eps, eps^2, ...: over eps = 1e-5 ... 1e-2 the second "
                        "term tilts the fitted line by less than 0.005");
  findings.figure({.name = "rigid_limit",
                   .title = "Limit of a stiff cable: the rigid pendulum",
                   .caption = "Relative excess of the period over that of the rigid pendulum (60 degrees) against eps "
                              "= m g/(k L). Dashed: the derived first-order term.",
                   .x = {"eps = m g/(k L)", "1", true},
                   .y = {"T/T_rigid - 1", "1", true},
                   .series = {solver, spring},
                   .slopes = {{1.0, 1e-3, softening * 1e-3, fmt::format("{:.4f} eps", softening)}}});
}

/// The bob on a cable of fixed stiffness, compared with the elastic reference: the only difference is the error of the
/// step.
void check_elastic(Findings& findings, const Setup& setup) {
  const double eps = 1e-2;
  const double duration = 1.3 * reference::rigid_period(elastic(eps));
  const std::array<double, 1> times{duration};
  const auto truth = reference::elastic_pendulum_states(elastic(eps), times).front();
  Figure chart{.name = "elastic",
               .title = "Pendulum on a cable of fixed stiffness",
               .caption =
                   "Distance from the elastic reference after 1.3 periods, eps = 0.01, against the step over the "
                   "period of the cable's axial oscillation.",
               .x = {"step / axial period of the cable", "1", true},
               .y = {"position error", "m", true}};
  const double natural = 2.0 * pi * std::sqrt(eps * 0.8 / 9.80665);
  for (const char* name : {"velocity_verlet", "rk4"}) {
    const int order = integrator_traits(name).order;
    const bool fourth = order == 4;
    Convergence convergence;
    for (long steps = fourth ? 512 : 1024; steps <= (fourth ? 8192 : 65536); steps *= 2) {
      const RunEnd end = run_steps(scenes::cable_pendulum(hung(setup, eps)), make_integrator(name),
                                   duration / static_cast<double>(steps), steps);
      convergence.add(duration / static_cast<double>(steps) / natural,
                      std::hypot(end.state.q[0] - truth.x, end.state.q[1] - truth.y));
    }
    const auto claim = findings.in(fmt::format("integrator.{}", name));
    findings.expect_order({"order_on_cable", fmt::format("pendulum on a cable, eps = 0.01: order of {}", name)},
                          convergence, order - (fourth ? 0.1 : 0.001), order + (fourth ? 0.1 : 0.001),
                          "smooth motion with a cable that is always taut: the declared order, with a margin for the "
                          "tilt by the next term at the coarsest step");
    chart.series.push_back({.label = name, .x = convergence.steps(), .y = convergence.errors()});
    chart.slopes.push_back({static_cast<double>(order), convergence.steps()[1], 2.0 * convergence.errors()[1],
                            fmt::format("h^{}", order)});
    if (!fourth) continue;
    const auto [x, y] = hung_by_classical_runge_kutta(elastic(eps), duration, 4096);
    findings.expect_round_off(
        "pendulum on a cable, eps = 0.01: position error after 1.3 periods, rk4 with 4096 steps",
        convergence.errors()[3], std::hypot(static_cast<double>(x - truth.x), static_cast<double>(y - truth.y)),
        4.0 * std::sqrt(4096.0 * 4.0) * 1.1e-16,
        "the error is predicted by a separate implementation of the method in extended precision; the remainder is a "
        "random walk with 4 roundings of a number near 1 per step, four standard deviations",
        "m");
  }
  findings.figure(chart);
}

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// Compares the pendulum's reference with Boost.Math's elliptic integrals and functions and with itself at 50 digits.
void check_references(Findings& findings) {
  const double w0 = bob_frequency();
  for (const double degrees : {0.1, 60.0, 179.0}) {
    const double k = std::sin(0.5 * degrees * degree);
    const double K = boost::math::ellint_1(k);
    const double condition = (boost::math::ellint_2(k) / ((1.0 - k) * (1.0 + k)) - K) / K;  // d ln K/d ln k
    findings.expect(
        fmt::format("elliptic integral at {:g} degrees", degrees), 4.0 * K / w0, bob_motion(degrees * degree).period(),
        Tolerance::round_off(
            epsilon * (3.0 + 0.5 * condition),
            "3 roundings of K and the quotient, and half an ulp of k times the condition number d ln K/d ln k")
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
    keep_largest(from_boost, motion.at(t).angle - 2.0 * std::asin(k * sn));
    if (i % 5 == 0) keep_largest(from_50_digits, motion.at(t).angle - motion.at_50_digits(t).angle);
  }
  findings.expect_round_off("elliptic function sn over one period", from_boost, 0.0, 8.0 * epsilon,
                            "half an ulp of the argument w0 t + K < 9, times the derivative of the angle of at most 2 "
                            "k = 1: 8 epsilon; sn and asin add less",
                            "rad");
  findings.expect_round_off(
      "reference against its evaluation with 50 digits", from_50_digits, 0.0, epsilon,
      "long double has 11 more bits: the remainder is the rounding of the result to double, half an ulp of 1.05 rad",
      "rad");
}

/// odeint alone, without the solver: error of its step control against the tolerance.
void check_odeint(Findings& findings) {
  const double amplitude = 60.0 * degree;
  const double duration = 0.8 * bob_motion(amplitude).period();
  Figure chart{.name = "odeint_tolerance",
               .title = "Step control of odeint's steppers",
               .caption =
                   "Largest error of the angle over 0.8 periods (60 degrees) of odeint's steppers without the solver, "
                   "against the tolerance per step. Dashed: error equal to the tolerance.",
               .x = {"tolerance per step", "1", true},
               .y = {"error of the angle", "rad", true},
               .series = {},
               .slopes = {{1.0, 1e-8, 1e-8, "tolerance"}}};
  for (const auto& stepper : reference::pendulum_steppers()) {
    reference::PendulumRun run{std::string(stepper.name), bob_frequency(), amplitude, duration, 0, 0.0};
    if (stepper.controlled) {
      Series series{.label = run.stepper};
      for (run.tolerance = 1e-4; run.tolerance > 5e-13; run.tolerance *= 0.1)
        series.add(run.tolerance, reference::run_pendulum(run).largest_angle_error);
      findings.expect_order("odeint without the solver, " + run.stepper + ": order of the error in the tolerance",
                            Convergence{series.x, series.y}, 0.8, 1.2,
                            "step control keeps the error of a step below the tolerance, so the global error is "
                            "proportional to it: order 1, lower by up to 1/p because fewer steps accumulate, higher "
                            "where the higher order of the continued solution is visible");
      chart.series.push_back(series);
    }
  }
  findings.figure(chart);
}

/// Compares the results of the same steppers inside the solver and alone.
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
    findings.expect_round_off(
        {fmt::format("integrator.{}", twin[0]),
         fmt::format("angle after 48 steps: {} in the solver against {} without the solver", twin[0], twin[1])},
        end.state.q[0], alone.angle, 4.0 * std::sqrt(48.0 * 4.0) * 0.5 * epsilon,
        "the same 48 steps with operations in a different order: a random walk with 4 roundings of a number near 1 per "
        "step, four standard deviations",
        "rad");
  }
}

/// Relative energy E/E0 - 1 over 1e4 periods: minimum and maximum in each hundredth of the run, and value at the end.
struct EnergyHistory {
  std::vector<double> lowest = std::vector<double>(100, 0.0);
  std::vector<double> highest = std::vector<double>(100, 0.0);
  double end{};
};

inline EnergyHistory energy_history(const scenes::Pendulum& p, const Integrator& integrator, int per_period,
                                    long periods) {
  const double inertia = p.inertia + p.mass * p.arm * p.arm;
  const double weight = p.mass * p.gravity * p.arm;
  const double half = std::sin(0.5 * p.amplitude);
  const long steps = periods * per_period;
  EnergyHistory history;
  const Watcher watch = [&](const State& s, const StepInfo& info) {
    const double sine = std::sin(0.5 * s.q[0]);
    // Difference of squares as a product: the energy is needed to more digits than a sum of its two parts would have.
    history.end =
        (0.5 * inertia * s.v[0] * s.v[0] + 2.0 * weight * (sine - half) * (sine + half)) / (2.0 * weight * half * half);
    const auto window = static_cast<std::size_t>(std::min(99L, info.step * 100 / steps));
    history.lowest[window] = std::min(history.lowest[window], history.end);
    history.highest[window] = std::max(history.highest[window], history.end);
  };
  const double h = 2.0 * std::numbers::pi / bob_frequency() / per_period;
  const RunEnd end = run_steps(scenes::pendulum(p), integrator, h, steps, nullptr, watch);
  if (!std::isfinite(end.state.q[0])) history.end = end.state.q[0];
  return history;
}

constexpr long periods = 10000;  // of the runs whose energy is recorded

/// Small oscillations, for which each method is a 2 x 2 matrix whose rotation and growth are known to all orders.
void check_small_swings(Findings& findings, const Setup& setup) {
  const double amplitude = 0.1 * degree;
  const double T = bob_motion(amplitude).period();
  const Scene scene = scenes::pendulum(bob(setup, amplitude));
  const std::string passages =
      "the map is known to all orders; the remainder is the interpolation of two zero crossings, each with an error of "
      "z^5/24 times |s (1-s) (1+s) (2-s) (s - 1/2)| <= 0.104, relative to 2 pi";
  const double z = 2.0 * pi / 64.38;
  for (const char* name : {"central_difference", "velocity_verlet", "euler_cromer"}) {
    const double leapfrog = z / (2.0 * std::asin(0.5 * z)) - 1.0;
    findings.expect_truncation(
        {fmt::format("integrator.{}", name), fmt::format("small oscillations, {}: relative error of the period", name)},
        period_of(scene, make_integrator(name), z / bob_frequency(), 2.0 * T) / T - 1.0, leapfrog,
        std::pow(z, 5.0) / 724.0, 1.0, passages);
  }
  const double y = 2.0 * pi / 32.38;
  const double angle = std::atan2(y - y * y * y / 6.0, 1.0 - y * y / 2.0 + y * y * y * y / 24.0);
  findings.expect_truncation({"integrator.rk4", "small oscillations, rk4: relative error of the period"},
                             period_of(scene, make_integrator("rk4"), y / bob_frequency(), 2.0 * T) / T - 1.0,
                             y / angle - 1.0, std::pow(y, 5.0) / 724.0, 1.0, passages);
  constexpr long steps = 64;
  constexpr long started = 7;  // steps by Fehlberg 7(8), with negligible error
  const double error =
      swing_error(scene, make_integrator("odeint_abm8"), 0.8 * T, steps, bob_frequency(), bob_motion(amplitude)).error;
  const double predicted = adams_swing_error(0.8 * 2.0 * pi / steps, steps - started);
  findings.expect_truncation(
      {"integrator.odeint_abm8", "small oscillations, odeint_abm8: error after 0.8 periods over its prediction"},
      error / amplitude / predicted, 1.0, std::pow(3.0, 9.0) * amplitude * amplitude / 192.0, 1.0,
      "the principal root of the method is known to all orders; the third harmonic of the oscillation, A^2/192, has a "
      "ninth derivative 3^9 times as large");
  const double halved = adams_swing_error(0.8 * pi / steps, 2 * steps - started);
  findings.note(fmt::format(
      "**The order of odeint_abm8.** It is 8, not 9: predictor and corrector both use eight values. The predictor's "
      "error, 31 times the corrector's, enters with the next power of the step, as $9.6\\,i\\,w h$ times the leading "
      "term. For small oscillations this raises the order between {} and {} steps to {:.2f}, as predicted from the "
      "root and checked above; at 60 degrees, where the third harmonic dominates the ninth derivative and has three "
      "times the phase per step, to about 8.5. The order tends to 8 as the step decreases, until round-off dominates.",
      steps, 2 * steps, std::log2(predicted / halved)));
}

/// Figure of the largest energy error within each hundredth of the run, for several methods.
Figure energy_chart(const EnergyHistory& kept, double bound, const Setup& setup) {
  Figure chart{.name = "energy_drift",
               .title = "Energy over ten thousand periods",
               .caption =
                   "Largest relative error of the energy within each hundred periods (60 degrees; 64 steps per period "
                   "of small oscillations). The error of symplectic methods does not grow; Runge-Kutta methods lose "
                   "energy in proportion to time. Line: bound for velocity Verlet from its modified Hamiltonian.",
               .x = {"time", "periods", true},
               .y = {"|E/E0 - 1|", "1", true},
               .series = {},
               .slopes = {},
               .lines = {{'y', bound, "predicted bound"}}};
  for (const char* name : {"central_difference", "velocity_verlet", "euler_cromer", "rk4", "odeint_dopri5"}) {
    const EnergyHistory run = std::string_view{name} == "velocity_verlet"
                                  ? kept
                                  : energy_history(bob(setup, 60.0 * degree), make_integrator(name), 64, periods);
    Series series{.label = name, .style = Style::lines};
    for (std::size_t i = 0; i < run.lowest.size(); ++i)
      series.add(static_cast<double>(periods) / 100.0 * (static_cast<double>(i) + 1.0),
                 std::max(-run.lowest[i], run.highest[i]));
    chart.series.push_back(series);
  }
  return chart;
}

void check_energy(Findings& findings, const Setup& setup) {
  const double amplitude = 60.0 * degree;
  const double z = 2.0 * pi / 64.0;
  const double scale = 1.0 - std::cos(amplitude);  // E0 over m g a
  const EnergyHistory kept = energy_history(bob(setup, amplitude), verlet(setup), 64, periods);
  findings.expect_truncation(
      {"integrator.velocity_verlet", "energy of velocity_verlet: relative minimum over the first hundredth of the run"},
      kept.lowest.front(), verlet_energy_swing(amplitude) * z * z / scale, 1.08e-3 * std::pow(z, 4.0), 1.5,
      "next term of the modified Hamiltonian, its constant measured with 32 steps per period");
  findings.expect_round_off(
      {"integrator.velocity_verlet",
       "energy of velocity_verlet: drift of the minimum between first and last hundredth of the run"},
      kept.lowest.back(), kept.lowest.front(),
      2.2e-3 * 0.5 * std::pow(z / static_cast<double>(periods) * 100.0, 2.0) +
          4.0 * epsilon * std::sqrt(64.0 * static_cast<double>(periods)),
      "a symplectic method has no drift. The steps in a hundredth of the run come within z/(periods in it) of the "
      "lowest position; the rest is a random walk with 4 roundings per step");
  if (setup.coarse) return;
  const double y = 2.0 * pi / 32.0;
  const double cosine = 1.0 - y * y / 2.0 + std::pow(y, 4.0) / 24.0;
  const double sine = y - y * y * y / 6.0;
  const double loss = std::log(cosine * cosine + sine * sine) * 32.0 * static_cast<double>(periods);
  const EnergyHistory small = energy_history(bob(setup, 0.1 * degree), make_integrator("rk4"), 32, periods);
  findings.expect_truncation({"integrator.rk4", "energy of rk4 after 1e4 small oscillations: ln(E/E0)"},
                             std::log1p(small.end), loss, 0.36 * std::pow(0.1 * degree, 2.0) * std::abs(loss), 1.5,
                             "|R(iz)|^2 per step, to all orders, for a linear pendulum; the sine adds a fraction "
                             "proportional to A^2, its constant measured at 1 degree");
  findings.figure(energy_chart(kept, std::abs(verlet_energy_swing(amplitude)) * z * z / scale, setup));
}

void run(Findings& findings, const Setup& setup) {
  check_amplitudes(findings, setup);
  check_work_and_precision(findings, setup);
  check_energy(findings, setup);
  check_rigid_limit(findings, setup);
  if (setup.coarse) return;
  check_small_swings(findings, setup);
  check_elastic(findings, setup);
  check_adapter(findings, setup);
  check_odeint(findings);
  check_references(findings);
}

}  // namespace

Case definition() {
  return {
      .id = "pendulum",
      .title = "Rigid pendulum: integrators on a smooth motion",
      .family = "founding problems",
      .requirements = {{"law.tension_only",
                        {"excess_on_cable", "order_in_eps", "order_on_cable",
                         "pendulum on a cable, eps = 0.01: position error after 1.3 periods, rk4 with 4096 steps"}},
                       {"shape.none", {"periods", "order", "order_on_cable"}},
                       {"Eq. 4", {"periods"}},
                       {"Eq. 14", {"excess_on_cable", "order_in_eps"}},
                       {"Eq. 23, Eq. 24",
                        {"order of central_difference", "order of velocity_verlet",
                         "pendulum on a cable, eps = 0.01: order of velocity_verlet"}}},
      .main_checks = {"period at 179 degrees", "order of velocity_verlet", "order of rk4", "order of odeint_dopri5",
                      "energy of velocity_verlet: drift of the minimum between first and last hundredth of the run"},
      .source =
          "E. T. Whittaker, Analytical Dynamics, 4th ed. (1937), art. 44; Hairer, Lubich & Wanner, Geometric Numerical "
          "Integration, 2nd ed. (2006), sect. IX.8",
      .faults = {{"gravity_up", "the scene's gravity points upwards", "order of velocity_verlet"},
                 {"inertia_halved", "half the moment of inertia about the centre of mass", "period at 60 degrees"},
                 {"arm_one_percent", "the pin is 1 % too far from the centre of mass", "period at 60 degrees"},
                 {"euler_cromer_for_verlet", "Euler-Cromer in place of velocity Verlet", "order of velocity_verlet"},
                 {"rk4_for_verlet", "RK4, which is not symplectic, in place of velocity Verlet",
                  "energy of velocity_verlet: drift of the minimum between first and last hundredth of the run"},
                 {"cable_stiffness_doubled", "the stiffness of the cable is doubled", "excess_on_cable"}},
      .run = run};
}

}  // namespace talus::verification::problems::pendulum
