#include "verification/problems/speed_accuracy/measured_growth.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

namespace talus::verification::problems {
namespace {

constexpr double frequency = 100.0;     // [rad/s]
constexpr double rounding = 3e-16;      // of an overlap near 1, including its propagation through one step
constexpr double largest_start = 5e-3;  // [m]

/// The solver's method, or the one by which a fault replaces it.
Integrator made(const FixedStepMethod& method, const Setup& setup) {
  if (setup.has("dashpot_lags")) return make_integrator("lagged_central_difference");
  if (setup.has("drift_after_kick") && std::string_view{method.name} == "euler") return make_integrator("euler_cromer");
  return make_integrator(method.name);
}

/// w h of the run for a requested w h: changed by some faults.
double run_as(double eta, const Setup& setup) {
  if (setup.has("step_too_long")) return 1.03 * eta;
  return setup.has("stiffness_halved") ? std::sqrt(0.5) * eta : eta;
}

}  // namespace

std::vector<double> exact_limits(const FixedStepMethod& method, double xi) {
  return reference::limits(method.scheme, xi, 2.0 * method.scale + 0.5, xi > 0.0 ? 200 : 5000);
}

SqueezedRuns squeezed_runs(double xi) { return SqueezedRuns{{.frequency = frequency, .damping_ratio = xi}}; }

double first_growth(const SqueezedRuns& disc, const FixedStepMethod& method, double eta, const Setup& setup) {
  const int lags = (method.dimension + 1) / 2;
  // Two runs give as many columns as there are unknowns. If the runs do not grow too fast, more columns are used for
  // the sixteen eigenvalues of Adams' pair, and for methods whose first step differs from the others, because that step
  // may make the two runs nearly dependent.
  for (const int columns : {lags > 2 ? 2 * lags : method.start > 0 ? lags + 1 : lags, lags}) {
    const auto states = static_cast<std::size_t>(method.start + lags + columns);
    for (const double start : {largest_start, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10}) {
      std::array<reference::Motion, 2> runs;
      // Starts that no method's first step maps to zero.
      const std::array<Deviation, 2> starts{Deviation{start, 0.3 * start}, Deviation{-0.3 * start, start}};
      for (std::size_t i = 0; i < runs.size(); ++i)
        runs[i] = disc.run(made(method, setup), run_as(eta, setup), static_cast<long>(states) - 1, starts[i]);
      const auto too_far = [&](const reference::Motion& run) {
        return run.size() < states || !(size(run.back()) < 0.01);
      };
      if (std::any_of(runs.begin(), runs.end(), too_far)) continue;
      for (reference::Motion& run : runs)
        run.erase(run.begin(), run.begin() + method.start);
      return reference::ln_multiplier(runs, method.dimension, rounding);
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}

double in_roundings(const FixedStepMethod& method, double error, double exact) {
  const int steps = method.start + method.dimension + (method.start > 0 ? 1 : 0);
  return error / (rounding / largest_start * std::exp(steps * std::abs(exact)));
}

double long_growth(const SqueezedRuns& disc, const FixedStepMethod& method, double eta, double start,
                   const Setup& setup) {
  const reference::Motion all = disc.run(made(method, setup), run_as(eta, setup), longest_run, {start, 0.0});
  const auto last = std::find_if(all.begin(), all.end(), [](const Deviation& d) { return size(d) > maximum_mark; });
  if (last == all.end()) return std::numeric_limits<double>::quiet_NaN();
  auto first = last;
  while (first - all.begin() > method.start && last - first < 60 && size(*(first - 1)) > 1e-7)
    --first;
  return reference::ln_multiplier(std::array{reference::Motion{first, last}}, method.dimension, rounding);
}

bool stays(const SqueezedRuns& disc, const FixedStepMethod& method, double eta, const Setup& setup) {
  // At xi = 1, where two eigenvalues coincide, a motion may grow 200-fold before it decays.
  const reference::Motion all = disc.run(made(method, setup), run_as(eta, setup), 4000, {1e-6, 0.0});
  if (all.size() < 4001) return false;
  const auto nearer = [](const Deviation& a, const Deviation& b) { return size(a) < size(b); };
  const auto half = all.begin() + 2000;
  return size(*std::max_element(half, all.end(), nearer)) <= size(*std::max_element(all.begin(), half, nearer)) * 1.01;
}

}  // namespace talus::verification::problems
