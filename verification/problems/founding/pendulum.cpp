#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "verification/check/case.hpp"
#include "verification/problems/founding/adams_swing.hpp"
#include "verification/problems/founding/hung_bob_findings.hpp"
#include "verification/problems/founding/leapfrog_swing.hpp"
#include "verification/problems/founding/odeint_findings.hpp"
#include "verification/problems/founding/swing_period_findings.hpp"
#include "verification/problems/founding/work_precision_findings.hpp"
#include "verification/study/scene_run.hpp"
#include "verification/study/swing.hpp"

namespace talus::verification::problems {

Case pendulum();

namespace {

/// Relative energy E/E0 - 1 over 1e4 periods: lowest and highest in each hundredth of the run, and at the end.
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
    // Differences of squares: the energy is needed to more digits than its two parts have together.
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

constexpr double pi = std::numbers::pi;
constexpr long periods = 10000;  // of the runs whose energy is watched
constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// Small swings, where each method is a 2 x 2 matrix whose rotation and growth are known to all orders.
void check_small_swings(Findings& findings, const Setup& setup) {
  const double amplitude = 0.1 * degree;
  const double T = bob_motion(amplitude).period();
  const Scene scene = scenes::pendulum(bob(setup, amplitude));
  const std::string passages =
      "the map is known to all orders; what is left is the interpolation of two passages: |s (1-s) (1+s) (2-s) (s - "
      "1/2)| <= .104, z^5/24 times that each, of 2 pi";
  const double z = 2.0 * pi / 64.38;
  for (const char* name : {"central_difference", "velocity_verlet", "euler_cromer"}) {
    const double leapfrog = z / (2.0 * std::asin(0.5 * z)) - 1.0;
    findings.expect(fmt::format("small swings, {}: relative error of the period", name),
                    period_of(scene, make_integrator(name), z / bob_frequency(), 2.0 * T) / T - 1.0, leapfrog,
                    Tolerance::truncation(std::pow(z, 5.0) / 724.0, 1.0, passages));
  }
  const double y = 2.0 * pi / 32.38;
  const double angle = std::atan2(y - y * y * y / 6.0, 1.0 - y * y / 2.0 + y * y * y * y / 24.0);
  findings.expect("small swings, rk4: relative error of the period",
                  period_of(scene, make_integrator("rk4"), y / bob_frequency(), 2.0 * T) / T - 1.0, y / angle - 1.0,
                  Tolerance::truncation(std::pow(y, 5.0) / 724.0, 1.0, passages));
  constexpr long steps = 64;
  constexpr long started = 7;  // by Fehlberg 7(8), without an error to speak of
  const double error =
      swing_error(scene, make_integrator("odeint_abm8"), 0.8 * T, steps, bob_frequency(), bob_motion(amplitude)).error;
  const double predicted = adams_swing_error(0.8 * 2.0 * pi / steps, steps - started);
  findings.expect("small swings, odeint_abm8: error after 0.8 period over the amplitude, over that predicted",
                  error / amplitude / predicted, 1.0,
                  Tolerance::truncation(std::pow(3.0, 9.0) * amplitude * amplitude / 192.0, 1.0,
                                        "the method's principal root is known to all orders; the swing's third "
                                        "harmonic, A^2/192, has a ninth derivative 3^9 times as large"));
  const double halved = adams_swing_error(0.8 * pi / steps, 2 * steps - started);
  findings.note(fmt::format(
      "**The order of odeint_abm8.** It is 8, not 9: predictor and corrector both use eight values. The predictor's "
      "error, 31 times the corrector's, enters with the next power of the step, as $9.6\\,i\\,w h$ times the leading "
      "term. On small swings this lifts the order between {} and {} steps to {:.2f}, as predicted from the root and "
      "checked above; at 60 degrees, where the third harmonic has most of the ninth derivative and so three times the "
      "phase a step, to about 8.5. It tends to 8 with the step, below which round-off takes over.",
      steps, 2 * steps, std::log2(predicted / halved)));
}

/// The largest error of the energy within each hundredth of the run, for several methods.
Figure energy_chart(const EnergyHistory& kept, double bound, const Setup& setup) {
  Figure chart{.name = "energy_drift",
               .title = "Energy over ten thousand periods",
               .caption =
                   "Largest relative error of the energy within each hundred periods (60 degrees; 64 steps per "
                   "small period). The symplectic methods stay where they begin; Runge-Kutta methods lose "
                   "energy in proportion to time. Line: bound of velocity Verlet from its modified Hamiltonian.",
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
  findings.expect("energy of velocity_verlet: lowest over the run, relative", kept.lowest.front(),
                  verlet_energy_swing(amplitude) * z * z / scale,
                  Tolerance::truncation(1.08e-3 * std::pow(z, 4.0), 1.5,
                                        "next term of the modified Hamiltonian, its constant measured with 32 steps "
                                        "per period"));
  findings.expect(
      "energy of velocity_verlet: trend between first and last hundredth", kept.lowest.back(), kept.lowest.front(),
      Tolerance::round_off(2.2e-3 * 0.5 * std::pow(z / static_cast<double>(periods) * 100.0, 2.0) +
                               4.0 * epsilon * std::sqrt(64.0 * static_cast<double>(periods)),
                           "symplectic: none. The steps of a hundredth of the run come within z/(periods in "
                           "it) of the bottom; the rest is a random walk of 4 roundings a step"));
  if (setup.coarse) return;
  const double y = 2.0 * pi / 32.0;
  const double cosine = 1.0 - y * y / 2.0 + std::pow(y, 4.0) / 24.0;
  const double sine = y - y * y * y / 6.0;
  const double loss = std::log(cosine * cosine + sine * sine) * 32.0 * static_cast<double>(periods);
  const EnergyHistory small = energy_history(bob(setup, 0.1 * degree), make_integrator("rk4"), 32, periods);
  findings.expect("energy of rk4 after 1e4 small swings: ln(E/E0)", std::log1p(small.end), loss,
                  Tolerance::truncation(0.36 * std::pow(0.1 * degree, 2.0) * std::abs(loss), 1.5,
                                        "|R(iz)|^2 a step, to all orders, for a linear pendulum; the sine adds a share "
                                        "proportional to A^2, its constant measured at 1 degree"));
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

Case pendulum() {
  return {
      .id = "pendulum",
      .title = "Rigid pendulum: every integrator on a smooth motion",
      .family = "founding problems",
      .requirements = {{"law.tension_only", {"cable"}},
                       {"integrator.central_difference", {"central_difference"}},
                       {"integrator.velocity_verlet", {"period at", "velocity_verlet", "velocity Verlet's"}},
                       {"integrator.euler_cromer", {"euler_cromer"}},
                       {"integrator.euler", {"order of euler"}},
                       {"integrator.taylor", {"order of taylor"}},
                       {"integrator.rk4", {"rk4"}},
                       {"integrator.blanes_moan4", {"blanes_moan4"}},
                       {"integrator.odeint_dopri5", {"dopri5"}},
                       {"integrator.odeint_cash_karp54", {"cash_karp54"}},
                       {"integrator.odeint_fehlberg78", {"fehlberg78"}},
                       {"integrator.odeint_abm8", {"abm8"}},
                       {"integrator.odeint_bulirsch_stoer", {"bulirsch_stoer"}},
                       {"shape.none", {"period at", "order of"}},
                       {"Eq. 4", {"period at"}},
                       {"Eq. 14", {"cable: "}},
                       {"Eq. 23", {"order of central_difference", "order of velocity_verlet"}},
                       {"Eq. 24", {"order of central_difference", "order of velocity_verlet"}}},
      .main_checks = {"period at 179 degrees", "order of velocity_verlet", "order of rk4", "order of odeint_dopri5",
                      "energy of velocity_verlet: trend between first and last hundredth"},
      .source =
          "E. T. Whittaker, Analytical Dynamics, 4th ed. (1937), art. 44; Hairer, Lubich & Wanner, Geometric "
          "Numerical Integration, 2nd ed. (2006), sect. IX.8",
      .faults = {{"gravity_up", "the scene's gravity points upwards", "order of velocity_verlet"},
                 {"inertia_halved", "half the moment of inertia about the centre of mass", "period at 60 degrees"},
                 {"arm_one_percent", "the pin is 1 % too far from the centre of mass", "period at 60 degrees"},
                 {"euler_cromer_for_verlet", "Euler-Cromer in place of velocity Verlet", "order of velocity_verlet"},
                 {"rk4_for_verlet", "a method that is not symplectic in place of velocity Verlet",
                  "energy of velocity_verlet: trend between first and last hundredth"},
                 {"cable_stiffness_doubled", "the cable is twice as stiff as it should be",
                  "cable: period over the rigid one, less 1, over eps, at eps = 1e-4"}},
      .run = run};
}

}  // namespace talus::verification::problems
