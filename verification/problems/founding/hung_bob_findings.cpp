#include "verification/problems/founding/hung_bob_findings.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

#include "verification/reference/elastic_pendulum.hpp"
#include "verification/study/scene_run.hpp"
#include "verification/study/swing.hpp"

namespace talus::verification::problems {

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

/// Position after `steps` steps of the classical Runge-Kutta method, by itself and in extended precision: its error is
/// that of the method alone.
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

}  // namespace

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
      findings.expect("cable: period over the rigid one, less 1, over eps, at eps = 1e-4", excess / eps, softening,
                      Tolerance::truncation(0.4 * eps, 1.5,
                                            "next term of the expansion in eps, its constant measured between "
                                            "eps = 1e-3 and 1e-2"));
    solver.add(eps, excess);
    if (eps >= 3e-3) {
      spring.add(eps, reference::elastic_pendulum_period(elastic(eps)) / rigid - 1.0);
    }
  }
  if (setup.coarse) return;
  findings.expect_order("cable: order in eps of the approach to the rigid pendulum", approach, 0.995, 1.005,
                        "the period's expansion starts with eps and goes on with eps^2: over eps = 1e-5 ... 1e-2 the "
                        "next term tilts the slope by less than .005");
  findings.figure({.name = "rigid_limit",
                   .title = "A stiff cable tends to the rigid pendulum",
                   .caption = "Excess of the period over the rigid pendulum's (60 degrees) against eps = m g/(k L). "
                              "Dashed: the first-order term derived.",
                   .x = {"eps = m g/(k L)", "1", true},
                   .y = {"T/T_rigid - 1", "1", true},
                   .series = {solver, spring},
                   .slopes = {{1.0, 1e-3, softening * 1e-3, fmt::format("{:.4f} eps", softening)}}});
}

void check_elastic(Findings& findings, const Setup& setup) {
  const double eps = 1e-2;
  const double duration = 1.3 * reference::rigid_period(elastic(eps));
  const std::array<double, 1> times{duration};
  const auto truth = reference::elastic_pendulum_states(elastic(eps), times).front();
  Figure chart{.name = "elastic",
               .title = "The bob on a cable of fixed stiffness",
               .caption =
                   "Distance from the elastic reference after 1.3 periods, eps = 0.01, against the step over the "
                   "cable's own period.",
               .x = {"step over period of the cable", "1", true},
               .y = {"position error", "m", true}};
  const double natural = 2.0 * pi * std::sqrt(eps * 0.8 / 9.80665);
  for (const char* name : {"velocity_verlet", "rk4"}) {
    const bool fourth = std::string_view{name} == "rk4";
    Convergence convergence;
    for (long steps = fourth ? 512 : 1024; steps <= (fourth ? 8192 : 65536); steps *= 2) {
      const RunEnd end = run_steps(scenes::cable_pendulum(hung(setup, eps)), make_integrator(name),
                                   duration / static_cast<double>(steps), steps);
      convergence.add(duration / static_cast<double>(steps) / natural,
                      std::hypot(end.state.q[0] - truth.x, end.state.q[1] - truth.y));
    }
    const int order = fourth ? 4 : 2;
    findings.expect_order(fmt::format("cable at eps = 0.01: order of {}", name), convergence,
                          order - (fourth ? 0.1 : 0.001), order + (fourth ? 0.1 : 0.001),
                          "smooth motion, the cable being taut throughout: the declared order, within what the next "
                          "term of the coarsest step tilts");
    chart.series.push_back({.label = name, .x = convergence.steps(), .y = convergence.errors()});
    chart.slopes.push_back({static_cast<double>(order), convergence.steps()[1], 2.0 * convergence.errors()[1],
                            fmt::format("h^{}", order)});
    if (!fourth) continue;
    const auto [x, y] = hung_by_classical_runge_kutta(elastic(eps), duration, 4096);
    findings.expect("cable at eps = 0.01: position after 1.3 periods, rk4 of 4096 steps", convergence.errors()[3],
                    std::hypot(static_cast<double>(x - truth.x), static_cast<double>(y - truth.y)),
                    Tolerance::round_off(4.0 * std::sqrt(4096.0 * 4.0) * 1.1e-16,
                                         "the error itself is predicted, by the same method written out in extended "
                                         "precision: what is left is a random walk of 4 roundings of a number near 1 "
                                         "a step, four standard deviations"),
                    "m");
  }
  findings.figure(chart);
}

}  // namespace talus::verification::problems
