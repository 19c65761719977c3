#include "verification/problems/speed_accuracy/limit_findings.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "solver/stability/step_advice.hpp"
#include "verification/study/common_formula.hpp"

namespace talus::verification::problems {
namespace {

constexpr double nought = 1e-10;  // ln growth that counts as none

/// What runs on both sides of limits have done.
struct BothSides {
  int wrong = 0;           ///< runs that grow where they must not, or do not where they must
  double worst = 0.0;      ///< share of error of the growth of first steps
  double worst_run = 0.0;  ///< the same of the end of long runs
};

void run_both_sides(const FixedStepMethod& method, double limit, double xi, const Setup& setup, BothSides& seen) {
  const SqueezedRuns disc = squeezed_runs(xi);
  const bool one = method.doubles && xi == 1.0;  // the fit parts them by a root of rounding: the count alone
  for (const double share : {0.98, 0.999, 1.001, 1.02}) {
    const double eta = share * limit, exact = reference::ln_growth(method.scheme, eta, xi);
    const double fitted = first_growth(disc, method, eta, setup);
    if (!one && (xi > 0.0 || exact > nought)) keep_worst(seen.worst, fitted / exact - 1.0);
    if (exact <= nought) {
      seen.wrong += stays(disc, method, eta, setup) ? 0 : 1;
      continue;
    }
    if (std::log(most_mark / 1e-12) > 0.9 * exact * longest_run) {  // too slow for a run
      seen.wrong += fitted > 0.0 ? 0 : 1;
      continue;
    }
    // What grows of Adams' pair is none of the motion: the start holds little of it, and the rest dies first.
    const double run = long_growth(disc, method, eta, method.dimension > 3 ? 1e-6 : 1e-9, setup);
    seen.wrong += run > 0.0 ? 0 : 1;
    if (!one) keep_worst(seen.worst_run, run / exact - 1.0);
  }
}

/// eta at which the solver's growth passes nought, within a thousandth of the expected one; NaN if it does not. Where
/// nothing damps, it is nought below a limit and rises from there as a root.
double measured_limit(const FixedStepMethod& method, double expected, double xi, const Setup& setup) {
  const SqueezedRuns disc = squeezed_runs(xi);
  const auto grows = [&](double eta) { return first_growth(disc, method, eta, setup) > (xi > 0.0 ? 0.0 : 1e-6); };
  double low = 0.999 * expected, high = 1.001 * expected;
  if (grows(low) || !grows(high)) return std::numeric_limits<double>::quiet_NaN();
  for (int i = 0; i < 24; ++i) {
    const double middle = 0.5 * (low + high);
    (grows(middle) ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

Tolerance limits_found(const FixedStepMethod& method) {
  return method.dimension > 3 ? Tolerance::round_off(1e-6,
                                                     "rounding in the fit of sixteen eigenvalues, 1e-7, over a "
                                                     "slope of ln growth near one")
                              : Tolerance::round_off(1e-8,
                                                     "the exact limit is where ln growth is 1e-10, and its slope "
                                                     "over a share of the step is at least .02, Euler's");
}

Tolerance limits_found_between_doubles(const FixedStepMethod& method) {
  return method.dimension > 3
             ? Tolerance::round_off(1e-3,
                                    "two of sixteen eigenvalues are one: what is shown is that growth has the "
                                    "right sign a thousandth of the limit to both sides")
             : Tolerance::round_off(3e-6,
                                    "two eigenvalues are one, or ln growth counts from 1e-6 on: the root of a "
                                    "rounding, 2.5e-7, times what the map is larger than they, over a slope "
                                    "above 2");
}

/// The limits of one method at six dampings: its row of the table.
std::vector<std::string> check_limits_of(const FixedStepMethod& method, Findings& findings, const Setup& setup) {
  const std::string name = method.name;
  const bool advised = linear_limit(name, 1.0).has_value();
  double worst = 0.0, worst_between_doubles = 0.0, worst_advice = 0.0;
  std::vector<std::string> row{"`" + name + "`"};
  for (const double xi : {0.0, 0.1, 0.4, 1.0, 1.5, 2.0}) {
    if (xi == 0.0 && !method.undamped) {
      row.emplace_back("");
      continue;
    }
    const double exact = exact_limits(method, xi).front(), found = measured_limit(method, exact, xi, setup);
    keep_worst(xi == 0.0 || (method.doubles && xi == 1.0) ? worst_between_doubles : worst, found / exact - 1.0);
    if (advised) keep_worst(worst_advice, *linear_limit(name, xi) / found - 1.0);
    row.push_back(fmt::format("{:.4f}", found));
  }
  row.emplace_back(advised ? "yes" : "");
  findings.expect(name + ": measured limits, largest share of error", worst, 0.0, limits_found(method));
  if (method.undamped || method.doubles) {
    findings.expect(name + ": measured limits where two eigenvalues are one, largest share of error",
                    worst_between_doubles, 0.0, limits_found_between_doubles(method));
  }
  if (advised) {
    findings.expect("step advice: linear limit of " + name + " against the measured one, largest share of error",
                    worst_advice, 0.0, limits_found_between_doubles(method));
  }
  return row;
}

}  // namespace

void check_both_sides(const FixedStepMethod& method, Findings& findings, const Setup& setup, double& worst_run) {
  std::vector<double> ratios{0.1, 0.02, 0.4, 0.9, 1.0, 1.5, 2.0};
  if (method.undamped) ratios.push_back(0.0);
  if (setup.coarse) ratios.resize(1);
  BothSides seen{.worst_run = worst_run};
  for (const double xi : ratios) {
    for (const double limit : exact_limits(method, xi)) {
      if (limit < 1.25 * method.scale) run_both_sides(method, limit, xi, setup, seen);
    }
    findings.count(40000);
  }
  worst_run = seen.worst_run;
  const std::string name = method.name;
  findings.expect(name + ": runs on the wrong side of the limit", seen.wrong, 0.0,
                  Tolerance::exact("a count: at .98, .999, 1.001 and 1.02 of each limit runs must, as the exact growth "
                                   "says, not grow in 4000 steps or grow from 1e-9 (Adams': 1e-6) to 9e-3; by the fit "
                                   "where that takes more than 45000 steps"));
  findings.expect(name + ": ln growth at .98, .999, 1.001, 1.02 of the limit, largest share of error", seen.worst, 0.0,
                  method.dimension > 3 ? Tolerance::round_off(1e-3,
                                                              "rounding in the fit of sixteen eigenvalues, 1e-7, "
                                                              "over the smallest growth here, 1e-4")
                                       : Tolerance::round_off(1e-7,
                                                              "a rounding of the largest start, 6e-14, over the "
                                                              "smallest growth here, 8e-7, Euler's"));
}

void check_limits(Findings& findings, const Setup& setup) {
  Table table{.name = "limits",
              .caption =
                  "Steps $\\omega h$ at which the solver's runs begin to grow, by damping ratio $\\xi$; Euler's "
                  "and Taylor's methods grow at any step where nothing damps, odeint's too slowly to be told. "
                  "The watch of a run knows the limits of some.",
              .columns = {"method", "0", "0.1", "0.4", "1", "1.5", "2", "watched"}};
  int advised = 0;
  for (const FixedStepMethod& method : fixed_step_methods) {
    table.rows.push_back(check_limits_of(method, findings, setup));
    advised += table.rows.back().back().empty() ? 0 : 1;
  }
  findings.expect("step advice: methods with a linear limit", advised, 8.0,
                  Tolerance::exact("a count: all of the map but odeint's"));
  findings.table(table);
}

void check_growth_undamped(Findings& findings, const Setup& setup) {
  const SqueezedRuns disc = squeezed_runs(0.0);
  for (const FixedStepMethod& method : fixed_step_methods) {
    const bool euler = method.scheme == reference::Scheme::euler;
    if (!euler && method.scheme != reference::Scheme::taylor) continue;
    constexpr double eta = 0.02;
    findings.expect(fmt::format("{}: ln growth of an undamped run of w h = {:g}, share of error", method.name, eta),
                    long_growth(disc, method, eta, 1e-4, setup) / (0.5 * std::log1p(eta * eta / (euler ? 1.0 : 2.0))),
                    1.0,
                    Tolerance::round_off(1e-6,
                                         "sixty states of 9e-3, with roundings of 3e-14 of them, over a growth "
                                         "of 1e-4 and a turn of .02 a step"));
    findings.expect(fmt::format("step advice: linear limit of {} where nothing damps", method.name),
                    linear_limit(method.name, 0.0).value_or(std::nan("")), 0.0,
                    Tolerance::exact("it grows at any step"));
  }
}

void check_common_limit(Findings& findings, const Setup& setup) {
  Table table = common_formula(
      "lagged_limits",
      "**Limit of the step $2/\\omega$ (Eq. 25) where a dashpot acts,** as $\\omega h$. A dashpot that sees the "
      "velocity of half a step before lowers it to $2(\\sqrt{1 + \\xi^2} - \\xi)$, one that sees the velocity of one "
      "and a half steps before to $\\sqrt{1 + \\xi^2} - \\xi$, which tends to 1, not 2, as the damping goes. Solver: "
      "where the fitted growth of a disc between two planes passes nought.");
  for (const FixedStepMethod& method : {fixed_step_methods[1], fixed_step_methods[3]}) {
    for (const double xi : {0.1, 0.4, 1.0}) {
      const double exact = (method.scheme == reference::Scheme::late ? 1.0 : 2.0) * (std::sqrt(1.0 + xi * xi) - xi);
      const double found = measured_limit(method, exact, xi, setup);
      findings.expect(
          fmt::format("limit of the step of {}, xi = {:g}", method.name, xi), found, exact,
          Tolerance::round_off(1e-9,
                               "twenty-four halvings of two thousandths of it, and a rounding of 6e-14 over "
                               "a slope of ln growth near .1"));
      table.rows.push_back({fmt::format("`{}`, $\\xi$ = {:g}", method.name, xi), "2", fmt::format("{:.4f}", exact),
                            fmt::format("{:+.0f} %", 100.0 * (2.0 / exact - 1.0)), fmt::format("{:.4f}", found)});
    }
  }
  findings.table(table);
}

}  // namespace talus::verification::problems
