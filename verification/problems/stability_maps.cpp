#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "solver/calibrate/step_advice.hpp"
#include "verification/check/case.hpp"
#include "verification/problems/bilateral_findings.hpp"
#include "verification/problems/common_formula.hpp"
#include "verification/problems/squeezed_disc.hpp"
#include "verification/reference/amplification.hpp"

namespace talus::verification::problems {

Case stability_maps();

namespace {

using reference::Scheme;

constexpr const char* page = R"(
**Problem.** From which step on does a method feed a contact instead of following it? The disc between two planes, both
contacts closed, is $\ddot x + 2\xi\omega\dot x + \omega^2 x = 0$. One step of a linear method multiplies it by a matrix;
the motion grows where the largest eigenvalue has $|\lambda| > 1$.

**Equations,** $\eta = \omega h$. A leapfrog's limit depends on the moment of the velocity that the dashpot sees:

| velocity in the dashpot | limit of $\eta$ | methods |
|:----|:---|:----|
| half a step old | $2(\sqrt{1+\xi^2}-\xi)$ | velocity Verlet, central difference, Euler-Cromer |
| one and a half steps old | $\sqrt{1+\xi^2}-\xi$ | lagged central difference |
| mean; new; Verlet's $v_n$; $v_n + h a_n$ | $2$; $2(\sqrt{1+\xi^2}+\xi)$; $\sqrt{2+\xi^2}-\xi$; $2(\sqrt{1+4\xi^2}-2\xi)$ | none here |

Runge-Kutta methods: $\lambda = R(z)$, $z = \eta(-\xi \pm \sqrt{\xi^2-1})$, $R$ from the tableau; Adams' pair: an $8
\times 8$ companion matrix. Two traps: undamped, Cash-Karp grows at *every* step, by $(1/720 - 1/800)\,\eta^6$, and
the late dashpot has the limit 1, not 2, for $\xi \to 0$.

**Measured** is the solver: its model, its contacts, its methods. A linear map is fitted to the states of a run's
first steps; at .98, .999, 1.001 and 1.02 of each limit, runs of up to 50 000 steps keep their
size or grow from $10^{-9}$ to $10^{-2}$. $\omega$ of other systems: a disc on a plane $\sqrt{k_n/m}$ and, as
it sticks, $\sqrt{3k_t/m}$: **the tangent decides where $k_t > k_n/3$**; an equal pair $\sqrt{2k_n/m}$ and
$\sqrt{6k_t/m}$; $n$ discs between walls $2\sqrt{k/m}\,\sin\frac{n\pi}{2(n+1)}$; a fence: by power iteration on
differences of the solver's forces.

**Source.** Mustoe & Huttelmaier 1993, Eq. 25; tableaus of Dormand & Prince 1980, Cash & Karp 1990, Fehlberg 1968.

**What would break it.** A dashpot that sees a velocity of another moment; a step other than said; a stiffness lost.
)";

/// One method and what is known of it: a line for each.
struct Method {
  const char* name;
  Scheme scheme;
  int dimension;    ///< eigenvalues other than zero of one step
  int start;        ///< first of a run's states from which each follows from those before by the same map
  double scale;     ///< its map reaches 1.25 of this eta
  double undamped;  ///< its limit at xi = 0; 0: none that can be seen
};
constexpr std::array methods{
    Method{"velocity_verlet", Scheme::half_step, 2, 1, 2.0, 2.0},
    Method{"central_difference", Scheme::half_step, 2, 1, 2.0, 2.0},
    Method{"euler_cromer", Scheme::half_step, 2, 1, 2.0, 2.0},
    Method{"lagged_central_difference", Scheme::late, 3, 1, 1.0, 2.0},
    Method{"rk4", Scheme::rk4, 2, 0, 3.0, 2.0 * 1.4142135623730951},
    Method{"odeint_dopri5", Scheme::dopri5, 2, 0, 3.4, 0.0},
    Method{"odeint_cash_karp54", Scheme::cash_karp54, 2, 0, 3.8, 0.0},
    Method{"odeint_fehlberg78", Scheme::fehlberg78, 2, 0, 4.2, 0.0},
    Method{"odeint_abm8", Scheme::abm8, 16, 9, 0.4, 0.0},
};

constexpr double frequency = 100.0;  // [rad/s]
constexpr double rounding = 3e-16;   // of a depth near 1, and of what a step makes of it

/// The solver's method, or what a fault puts in its place.
Integrator made(const Method& method, const Setup& setup) {
  return make_integrator(setup.has("dashpot_lags") ? "lagged_central_difference" : method.name);
}

/// w h of the run in place of that asked for.
double run_as(double eta, const Setup& setup) {
  if (setup.has("step_too_long")) return 1.03 * eta;
  return setup.has("stiffness_halved") ? std::sqrt(0.5) * eta : eta;
}

/// ln of the largest multiplier of the first steps. They begin as far out as a run of that length may without coming to
/// where a contact opens; a method's own start (eight steps of Adams', one of Verlet's) is left out.
double ln_multiplier(const SqueezedRuns& disc, const Method& method, double eta, const Setup& setup) {
  const bool many = method.dimension > 3;
  const long steps = many ? 44 : 2 + 2L * method.dimension;
  std::vector<Deviation> kept;
  for (const double start : {5e-3, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10}) {
    const std::vector<Deviation> all = disc.run(made(method, setup), run_as(eta, setup), steps, start);
    kept.clear();
    for (auto n = static_cast<std::size_t>(method.start); n < all.size(); ++n) {
      if (size(all[n]) > 1e-9) kept.push_back(all[n]);
    }
    if (all.size() == static_cast<std::size_t>(steps) + 1 && size(all.back()) < 0.01) break;
  }
  return reference::ln_multiplier(kept, method.dimension, rounding);
}

/// The deviation of larger size; one that is not a number stays.
void keep_worst(double& worst, double deviation) {
  if (!(std::abs(deviation) <= std::abs(worst))) worst = deviation;
}

/// Measured against exact growth on a grid, and both drawn in a panel.
void check_map(const Method& method, Findings& findings, const Setup& setup, Figure& figure) {
  const int across = setup.coarse ? 8 : 41, up = setup.coarse ? 10 : 40;
  Series map{.label = fmt::format("{}, ln growth", method.name), .x = {}, .y = {}, .style = Style::heat};
  Series curve{.label = fmt::format("{}, exact limit", method.name), .x = {}, .y = {}, .style = Style::lines};
  double worst = 0.0;
  int wrong = 0;
  for (int i = 0; i < across; ++i) {
    const double xi = 0.98 * i / (across - 1);
    const SqueezedRuns disc{{.frequency = frequency, .damping_ratio = xi}};
    for (int j = 0; j < up; ++j) {
      const double part = 1.25 * (j + 0.5) / up, eta = part * method.scale;
      const double measured = ln_multiplier(disc, method, eta, setup);
      const double exact = reference::ln_growth(method.scheme, eta, xi);
      keep_worst(worst, measured - exact);
      if (std::abs(exact) > 1e-5 && !((measured > 0.0) == (exact > 0.0))) ++wrong;
      map.x.push_back(xi);
      map.y.push_back(part);
      map.values.push_back(measured);
    }
    findings.count(static_cast<std::uint64_t>(up) * 16);
  }
  const std::string name = method.name;
  findings.expect(name + ": ln growth over the map, largest error", worst, 0.0,
                  method.dimension > 3
                      ? Tolerance::round_off(1e-3,
                                             "sixteen eigenvalues, fitted to 36 states in which rounding is up to 3e-7 "
                                             "of the smallest: those smaller than that are taken for none, and the "
                                             "largest is off by as much over their distance from it")
                      : Tolerance::round_off(1e-5,
                                             "rounding is up to 3e-7 of the smallest state, 1e-9, and a fit to three "
                                             "states may make ten times that of it; where two eigenvalues nearly meet, "
                                             "of states of 1e-3, its root: sqrt(3e-13) = 5e-7"));
  findings.expect(name + ": points of the map on the wrong side of the exact curve", wrong, 0.0,
                  Tolerance::exact("a count, of all points at which ln growth is further from nought than 1e-5"));
  if (setup.coarse) return;
  for (double xi = 0.0; xi < 0.981; xi += 0.02) {
    const std::vector<double> limits = reference::limits(method.scheme, xi, 1.25 * method.scale);
    if (limits.empty()) continue;
    curve.x.push_back(xi);
    curve.y.push_back(limits.front() / method.scale);
  }
  map.panel = curve.panel = static_cast<int>(figure.panels.size());
  figure.panels.push_back(fmt::format("{} {:g}", name.starts_with("odeint_") ? name.substr(7) : name, method.scale));
  figure.series.push_back(map);
  figure.series.push_back(curve);
}

constexpr double most_mark = 9e-3;   // [m]
constexpr long longest_run = 50000;  // steps

/// ln growth per step of a run by its last sixty states or fewer, between 1e-7 and that mark. NaN if it does not come
/// so far.
double long_growth(const SqueezedRuns& disc, const Method& method, const Integrator& integrator, double eta,
                   double start) {
  const std::vector<Deviation> all = disc.run(integrator, eta, longest_run, start);
  const auto last = std::find_if(all.begin(), all.end(), [](const Deviation& d) { return size(d) > most_mark; });
  if (last == all.end()) return std::numeric_limits<double>::quiet_NaN();
  auto first = last;
  while (first - all.begin() > method.start && last - first < 60 && size(*(first - 1)) > 1e-7)
    --first;
  return reference::ln_multiplier({first, last}, method.dimension, rounding);
}

/// Whether a run keeps its size: the largest distance in the second half is not above that in the first by
/// more than a hundredth, by which the highest states of two beats may differ.
bool stays(const SqueezedRuns& disc, const Integrator& integrator, double eta) {
  const std::vector<Deviation> all = disc.run(integrator, eta, 4000, 1e-4);
  if (all.size() < 4001) return false;
  const auto nearer = [](const Deviation& a, const Deviation& b) { return size(a) < size(b); };
  const auto half = all.begin() + 2000;
  return size(*std::max_element(half, all.end(), nearer)) <= size(*std::max_element(all.begin(), half, nearer)) * 1.01;
}

/// Runs at .98, .999, 1.001 and 1.02 of the exact limits; `worst_run` keeps the worst share of error of the long ones.
void check_both_sides(const Method& method, Findings& findings, const Setup& setup, double& worst_run) {
  std::vector<double> ratios{0.1, 0.02, 0.4, 0.9, 1.5};
  if (method.undamped > 0.0) ratios.push_back(0.0);
  if (setup.coarse) ratios.resize(1);
  int wrong = 0;
  double worst = 0.0;
  for (const double xi : ratios) {
    const SqueezedRuns disc{{.frequency = frequency, .damping_ratio = xi}};
    const std::vector<double> limits = reference::limits(method.scheme, xi, 2.0 * method.scale + 0.5);
    const double limit = xi == 0.0 ? method.undamped : limits.empty() ? std::nan("") : limits.front();
    for (const double share : {0.98, 0.999, 1.001, 1.02}) {
      const double eta = share * limit, exact = reference::ln_growth(method.scheme, eta, xi);
      const double fitted = ln_multiplier(disc, method, eta, setup);
      if (xi > 0.0 || share > 1.0) keep_worst(worst, fitted / exact - 1.0);
      if (share < 1.0) {
        wrong += stays(disc, made(method, setup), run_as(eta, setup)) ? 0 : 1;
        continue;
      }
      if (std::log(most_mark / 1e-12) > 0.9 * exact * longest_run) {  // too slow for a run
        wrong += fitted > 0.0 ? 0 : 1;
        continue;
      }
      // What grows of Adams' pair is none of the motion: the start holds little of it, and the rest dies first.
      const bool adams = method.dimension > 3;
      const double run = long_growth(disc, method, made(method, setup), run_as(eta, setup), adams ? 1e-6 : 1e-9);
      wrong += run > 0.0 ? 0 : 1;
      keep_worst(worst_run, run / exact - 1.0);
    }
    findings.count(40000);
  }
  const std::string name = method.name;
  findings.expect(name + ": runs on the wrong side of the limit", wrong, 0.0,
                  Tolerance::exact(
                      "a count: .98 and .999 of the limit must not grow in 4000 steps, 1.001 and 1.02 "
                      "must grow from 1e-9 (Adams': 1e-6) to 9e-3; by the fit where that takes more than 45000 steps"));
  findings.expect(name + ": ln growth at .98, .999, 1.001, 1.02 of the limit, largest share of error", worst, 0.0,
                  Tolerance::round_off(method.dimension > 3 ? 0.05 : 1e-3,
                                       "the error of the map over the smallest growth here, a thousandth of its slope "
                                       "at the limit: 1e-6 over 1e-3; what is asked of all is 5 %"));
}

/// eta at which the solver's growth passes nought, between .9 and 1.1 of the expected one.
double solver_limit(const SqueezedRuns& disc, const Method& method, double expected, const Setup& setup) {
  double low = 0.9 * expected, high = 1.1 * expected;
  for (int i = 0; i < 30; ++i) {
    const double middle = 0.5 * (low + high);
    (ln_multiplier(disc, method, middle, setup) > 0.0 ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

/// The limit of Eq. 25, 2/w, against those of a contact with a dashpot.
void check_common_limit(Findings& findings, const Setup& setup) {
  Table table = common_formula(
      "lagged_limits",
      "**Limit of the step $2/\\omega$ (Eq. 25) where a dashpot acts,** as $\\omega h$. A dashpot that sees the "
      "velocity "
      "of half a step before lowers it to $2(\\sqrt{1 + \\xi^2} - \\xi)$, one that sees the velocity of one and a half "
      "steps before to $\\sqrt{1 + \\xi^2} - \\xi$, which tends to 1, not 2, as the damping goes. Solver: where the "
      "fitted growth of a disc between two planes passes nought.");
  for (const Method& method : {methods[1], methods[3]}) {
    for (const double xi : {0.1, 0.4, 1.0}) {
      const double exact = (method.scheme == Scheme::late ? 1.0 : 2.0) * (std::sqrt(1.0 + xi * xi) - xi);
      const SqueezedRuns disc{{.frequency = frequency, .damping_ratio = xi}};
      const double found = solver_limit(disc, method, exact, setup);
      findings.expect(fmt::format("limit of the step of {}, xi = {:g}", method.name, xi), found, exact,
                      Tolerance::round_off(1e-6, "the growth is off by 1e-6 at most, and rises by more than the step"));
      table.rows.push_back({fmt::format("`{}`, $\\xi$ = {:g}", method.name, xi), "2", fmt::format("{:.4f}", exact),
                            fmt::format("{:+.0f} %", 100.0 * (2.0 / exact - 1.0)), fmt::format("{:.4f}", found)});
    }
  }
  findings.table(table);
  double deviation = 0.0;
  for (const double xi : {0.0, 0.1, 0.2, 0.4, 1.0, 2.0}) {
    const double advised = linear_limit("velocity_verlet", xi).value_or(std::nan(""));
    keep_worst(deviation, advised - 2.0 * (std::sqrt(1.0 + xi * xi) - xi));
  }
  findings.expect("step advice: linear limit of velocity_verlet", deviation, 0.0,
                  Tolerance::round_off(
                      1.8e-15, "two evaluations of 2 (sqrt(1 + xi^2) - xi): 2 half units of a number below 4 each"));
}

/// Limits against damping by the moment of the dashpot's velocity, exact.
Figure time_levels() {
  Figure figure{.name = "time_levels",
                .title = "What the dashpot sees decides",
                .caption =
                    "Exact limits of leapfrogs and of velocity Verlet by the velocity that their dashpots see. "
                    "Half a step old (velocity Verlet, central difference, Euler-Cromer) and one and a half "
                    "(lagged central difference) are run in the maps.",
                .x = {.label = "damping ratio"},
                .y = {.label = "largest stable w h", .min = 0.0},
                .series = {}};
  struct Level {
    Scheme scheme;
    const char* words;
  };
  for (const Level level :
       {Level{Scheme::half_step, "half a step old"}, Level{Scheme::late, "one and a half steps old"},
        Level{Scheme::average, "mean of old and new"}, Level{Scheme::implicit, "new"},
        Level{Scheme::verlet_old, "Verlet, v(n)"}, Level{Scheme::verlet_predicted, "Verlet, v(n) + h a(n)"}}) {
    Series series{.label = level.words, .x = {}, .y = {}, .style = Style::lines};
    for (double xi = 0.005; xi < 1.5; xi += 0.02) {
      series.x.push_back(xi);
      series.y.push_back(reference::limits(level.scheme, xi, 8.0).front());
    }
    figure.series.push_back(series);
  }
  return figure;
}

void run(Findings& findings, const Setup& setup) {
  Figure figure{.name = "maps",
                .title = "Growth per step of nine methods",
                .caption =
                    "Measured ln of the growth per step, blue where the motion dies, red where it grows, and "
                    "the exact limit (black). Each panel's $\\omega h$ is in units of the number above it.",
                .x = {.label = "damping ratio", .min = -0.0125, .max = 0.9925},
                .y = {.label = "w h over scale", .min = 0.0, .max = 1.25},
                .series = {},
                .scale = Scale{"ln growth per step", -0.5, 0.5}};
  double worst_run = 0.0;
  for (const Method& method : methods) {
    check_map(method, findings, setup, figure);
    check_both_sides(method, findings, setup, worst_run);
    if (setup.coarse) break;
  }
  check_bilateral_systems(findings, setup);
  if (setup.coarse) return;
  findings.expect("all methods: ln growth at the end of long runs, largest share of error", worst_run, 0.0,
                  Tolerance::round_off(1e-5, "rounding is 3e-9 of the smallest state, and the smallest growth 5e-4"));
  check_common_limit(findings, setup);
  figure.columns = (static_cast<int>(figure.panels.size()) + 1) / 2;  // two rows
  findings.figure(figure);
  findings.figure(time_levels());
}

}  // namespace

Case stability_maps() {
  return {.id = "stability_maps",
          .title = "Maps of stability: growth per step against damping and step",
          .family = "speed and accuracy",
          .requirements = {{"Eq. 25", {"runs on the wrong side", "step advice", "limit of the step"}},
                           {"integrator.velocity_verlet", {"velocity_verlet: "}},
                           {"integrator.central_difference", {"central_difference: "}},
                           {"integrator.lagged_central_difference", {"lagged_central_difference: "}},
                           {"integrator.euler_cromer", {"euler_cromer: "}},
                           {"integrator.rk4", {"rk4: "}},
                           {"integrator.odeint_dopri5", {"odeint_dopri5: "}},
                           {"integrator.odeint_cash_karp54", {"odeint_cash_karp54: "}},
                           {"integrator.odeint_fehlberg78", {"odeint_fehlberg78: "}},
                           {"integrator.odeint_abm8", {"odeint_abm8: "}},
                           {"law.linear_spring_dashpot", {"ln growth over the map"}},
                           {"end_rule.attractive", {"ln growth over the map"}},
                           {"pair.circle.half_plane", {"ln growth over the map"}}},
          .main_checks = {"velocity_verlet: ln growth over the map, largest error",
                          "lagged_central_difference: ln growth over the map, largest error",
                          "odeint_fehlberg78: ln growth over the map, largest error",
                          "velocity_verlet: runs on the wrong side of the limit",
                          "fence held at 0.02 s: ln growth per step at 1.001 and 1.02 of the limit, largest share of "
                          "error"},
          .source = "Mustoe & Huttelmaier 1993, Eq. 25; Dormand & Prince 1980; Cash & Karp 1990; Fehlberg 1968",
          .page = page,
          .faults = {{"dashpot_lags", "the lagged central difference under velocity Verlet's name",
                      "velocity_verlet: ln growth over the map, largest error"},
                     {"step_too_long", "steps 3 % longer than said",
                      "velocity_verlet: runs on the wrong side of the limit"},
                     {"stiffness_halved", "contacts of half the stiffness",
                      "velocity_verlet: points of the map on the wrong side of the exact curve"},
                     {"kt_ignored", "the step of a disc that sticks chosen by its normal contact alone",
                      "disc that sticks, kt = .4 kn: runs on the wrong side of w h = 2"},
                     {"fence_by_rule", "the fence's step chosen by the frequency of the 1993 rule",
                      "fence held at 0.02 s: ln growth per step at 1.001 and 1.02 of the limit, largest share of "
                      "error"}},
          .tier = Tier::quick,
          .time_limit = 60.0,
          .run = run};
}

}  // namespace talus::verification::problems
