#include "verification/problems/swing_timing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <numeric>
#include <random>

#include "verification/problems/swing.hpp"
#include "verification/problems/work_precision_findings.hpp"

namespace talus::verification::problems {
namespace {

constexpr int repetitions = 15;
/// A measurement is of so many runs that it takes at least this long: the clock's own cost is then below a thousandth.
constexpr double least_seconds = 1e-4;

/// One method with one number of steps, and its times.
struct Timed {
  std::string_view method;
  long steps{};
  double error{};
  int runs{1};
  std::vector<double> seconds;  // of one run
};

/// Runs 0.8 of a period; the result is returned so that nothing of it can be left out.
double swing(const Scene& scene, const Dynamics& dynamics, std::string_view method, double duration, long steps) {
  RigidBodySystem system{dynamics, false};
  State state = scene.initial;
  Integrator integrator = make_integrator(method);
  const double step = duration / static_cast<double>(steps);
  const RunPlan plan{.step = step, .end = duration, .interval = duration, .ledger = false};
  const Outcome outcome = simulate(system, integrator, state, plan);
  return outcome ? state.q[0] : std::numeric_limits<double>::quiet_NaN();
}

/// Seconds for one of `timed.runs` runs; the sum of the results keeps them from being left out.
double measured_seconds(const Scene& scene, const Dynamics& dynamics, const Timed& timed, double duration,
                        double& sum) {
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < timed.runs; ++i)
    sum += swing(scene, dynamics, timed.method, duration, timed.steps);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / timed.runs;
}

std::vector<Timed> points(const Scene& scene, double duration, const reference::PendulumMotion& motion) {
  std::vector<Timed> found;
  for (const MethodRange& method : method_ranges) {
    for (long steps = 16; steps <= 65536; steps *= 2) {
      const double error =
          swing_error(scene, make_integrator(method.name), duration, steps, bob_frequency(), motion).error;
      if (error > 1.0) continue;
      found.push_back({method.name, steps, error, 1, {}});
      if (error < 2e-14) break;
    }
  }
  return found;
}

/// Times all points, in another order each repetition. Returns the sum of the results, which shows that all were made.
double measure(std::vector<Timed>& timed, const Scene& scene, double duration) {
  const Dynamics dynamics{scene.model};
  double sum = 0.0;
  for (Timed& point : timed) {
    const double once = measured_seconds(scene, dynamics, point, duration, sum);
    point.runs = 1 + static_cast<int>(least_seconds / std::max(once, 1e-7));
  }
  std::vector<std::size_t> order(timed.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::mt19937 random{1993};
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    std::shuffle(order.begin(), order.end(), random);
    for (const std::size_t i : order)
      timed[i].seconds.push_back(measured_seconds(scene, dynamics, timed[i], duration, sum));
  }
  return sum;
}

/// Error against the median time of one method.
Series curve(const MethodRange& method, std::vector<Timed>& timed) {
  Series series{.label = std::string{method.name}, .x = {}, .y = {}};
  for (Timed& point : timed) {
    if (point.method != method.name) continue;
    std::nth_element(point.seconds.begin(), point.seconds.begin() + repetitions / 2, point.seconds.end());
    series.x.push_back(1e6 * point.seconds[repetitions / 2]);
    series.y.push_back(point.error);
  }
  return series;
}

Figure chart(const char* name, const char* title, const std::string& caption) {
  return {.name = name,
          .title = title,
          .caption = caption,
          .x = {"time of a run", "us", true},
          .y = {"error", "rad", true},
          .series = {},
          .slopes = {},
          .lines = {{'y', 0.5 * std::numeric_limits<double>::epsilon(), "round-off of one operation"}}};
}

}  // namespace

void chart_error_against_time(Findings& findings) {
  const double amplitude = 60.0 * degree;
  const auto motion = bob_motion(amplitude);
  const double duration = 0.8 * motion.period();
  const Scene scene = scenes::pendulum(bob({}, amplitude));
  std::vector<Timed> timed = points(scene, duration, motion);
  const double sum = measure(timed, scene, duration);
  Figure own = chart(
      "work_precision_time", "Error against time on a smooth swing: the solver's own methods",
      fmt::format("As the charts against force evaluations, the steps halved from point to point for every method, on "
                  "this machine (see the first page): median of {} interleaved repetitions of one run of .8 period "
                  "without output; ledger off. Nothing is checked on times. (Sum of the results, which shows that all "
                  "were made: {:.6g}.)",
                  repetitions, sum));
  Figure odeint = chart("work_precision_time_odeint", "Error against time on a smooth swing: odeint's steppers",
                        "As the figure before, for odeint's steppers, and rk4 again to compare with.");
  Series rk4;
  for (const MethodRange& method : method_ranges) {
    const Series series = curve(method, timed);
    draw(method, series, method.is_odeint() ? odeint : own);
    if (method.name == "rk4") rk4 = series;
  }
  rk4.style = Style::lines;
  odeint.series.push_back(rk4);
  findings.figure(own);
  findings.figure(odeint);
}

}  // namespace talus::verification::problems
