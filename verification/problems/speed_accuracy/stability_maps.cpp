#include <cstdint>

#include "solver/stability/step_advice.hpp"
#include "verification/problems/speed_accuracy/bilateral_findings.hpp"
#include "verification/problems/speed_accuracy/measured_growth.hpp"
#include "verification/reference/integration/amplification.hpp"
#include "verification/study/findings/common_formula.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::stability_maps {
namespace {

constexpr double negligible = 1e-10;  // ln growth that counts as zero

/// Results of runs on both sides of limits.
struct BothSides {
  int wrong = 0;           ///< number of runs that grow where they must not, or do not where they must
  double worst = 0.0;      ///< relative error of the growth in the first steps
  double worst_run = 0.0;  ///< relative error of the growth at the end of long runs
};

void run_both_sides(const FixedStepMethod& method, double limit, double xi, const Setup& setup, BothSides& seen) {
  const SqueezedRuns disc = squeezed_runs(xi);
  const bool one = method.doubles && xi == 1.0;  // rounding splits the double eigenvalue: only the count is checked
  for (const double ratio : {0.98, 0.999, 1.001, 1.02}) {
    const double eta = ratio * limit, exact = reference::ln_growth(method.scheme, eta, xi);
    const double fitted = first_growth(disc, method, eta, setup);
    if (!one && (xi > 0.0 || exact > negligible)) keep_worst(seen.worst, fitted / exact - 1.0);
    if (exact <= negligible) {
      seen.wrong += stays(disc, method, eta, setup) ? 0 : 1;
      continue;
    }
    if (std::log(maximum_mark / 1e-12) > 0.9 * exact * longest_run) {  // too slow for a run
      seen.wrong += fitted > 0.0 ? 0 : 1;
      continue;
    }
    // The growing mode of Adams' pair is a parasitic one: the start contains little of it, and the rest decays first.
    const double run = long_growth(disc, method, eta, method.dimension > 3 ? 1e-6 : 1e-9, setup);
    seen.wrong += run > 0.0 ? 0 : 1;
    if (!one) keep_worst(seen.worst_run, run / exact - 1.0);
  }
}

/// eta at which the solver's growth passes zero, within a thousandth of the expected one; NaN if it does not. Without
/// damping the growth is zero below a limit and rises above it as a square root.
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
  return method.dimension > 3
             ? Tolerance::round_off(
                   1e-6, "rounding in the fit of sixteen eigenvalues, 1e-7, over a slope of ln growth near one")
             : Tolerance::round_off(1e-8,
                                    "the exact limit is where ln growth is 1e-10, and its slope against the relative "
                                    "step is at least 0.02 (Euler)");
}

Tolerance limits_found_between_doubles(const FixedStepMethod& method) {
  return method.dimension > 3
             ? Tolerance::round_off(1e-3,
                                    "two of sixteen eigenvalues coincide: the check shows that growth has the right "
                                    "sign a thousandth of the limit on both sides")
             : Tolerance::round_off(
                   3e-6,
                   "two eigenvalues coincide, or ln growth counts from 1e-6 on: the root of a rounding, 2.5e-7, times "
                   "the ratio of the map to the eigenvalues, over a slope above 2");
}

/// Checks the limits of one method at six damping ratios; returns its row of the table.
std::vector<std::string> check_limits_of(const FixedStepMethod& method, Findings& findings, const Setup& setup) {
  const std::string name = method.name;
  const auto claim = findings.in("integrator." + name);
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
  findings.expect(name + ": measured limits, largest relative error", worst, 0.0, limits_found(method));
  if (method.undamped || method.doubles) {
    findings.expect(name + ": measured limits where two eigenvalues coincide, largest relative error",
                    worst_between_doubles, 0.0, limits_found_between_doubles(method));
  }
  if (advised) {
    findings.expect(
        {"advice", "step advice: linear limit of " + name + " against the measured one, largest relative error"},
        worst_advice, 0.0, limits_found_between_doubles(method));
  }
  return row;
}

/// Checks runs at 0.98, 0.999, 1.001 and 1.02 of the exact limits of a method; `worst_run` stores the largest relative
/// error of the growth of long runs.
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
  const auto claim = findings.in("integrator." + name);
  findings.expect_exact(
      {"sides_of_limit", name + ": runs on the wrong side of the limit"}, seen.wrong, 0.0,
      "count: at 0.98, 0.999, 1.001 and 1.02 of each limit runs must, according to the exact growth, either not grow "
      "in 4000 steps or grow from 1e-9 (Adams': 1e-6) to 9e-3; where that takes more than 45000 steps the fit decides");
  findings.expect(
      name + ": ln growth at 0.98, 0.999, 1.001, 1.02 of the limit, largest relative error", seen.worst, 0.0,
      method.dimension > 3
          ? Tolerance::round_off(
                1e-3, "rounding in the fit of sixteen eigenvalues, 1e-7, over the smallest growth here, 1e-4")
          : Tolerance::round_off(
                1e-7, "a rounding of the largest start, 6e-14, over the smallest growth here, 8e-7 (Euler)"));
}

/// Checks the steps at which runs begin to grow, for all methods at six damping ratios, against the exact limits, and
/// the solver's step advice against them.
void check_limits(Findings& findings, const Setup& setup) {
  Table table{.name = "limits",
              .caption =
                  "Steps $\\omega h$ at which the solver's runs begin to grow, by damping ratio $\\xi$; without "
                  "damping Euler's and Taylor's methods grow at any step, and odeint's too slowly to be detected. The "
                  "monitor of a run uses the limits of some methods.",
              .columns = {"method", "0", "0.1", "0.4", "1", "1.5", "2", "monitored"}};
  int advised = 0;
  for (const FixedStepMethod& method : fixed_step_methods) {
    table.rows.push_back(check_limits_of(method, findings, setup));
    advised += table.rows.back().back().empty() ? 0 : 1;
  }
  findings.expect_exact("step advice: methods with a linear limit", advised, 8.0,
                        "count: all methods of the map except odeint's");
  findings.table(table);
}

/// Checks the growth of Euler's and Taylor's methods without damping, where they grow at any step.
void check_growth_undamped(Findings& findings, const Setup& setup) {
  const SqueezedRuns disc = squeezed_runs(0.0);
  for (const FixedStepMethod& method : fixed_step_methods) {
    const bool euler = method.scheme == reference::Scheme::euler;
    if (!euler && method.scheme != reference::Scheme::taylor) continue;
    const auto claim = findings.in(fmt::format("integrator.{}", method.name));
    constexpr double eta = 0.02;
    findings.expect_round_off(
        fmt::format("{}: ln growth of an undamped run at w h = {:g} over the exact one", method.name, eta),
        long_growth(disc, method, eta, 1e-4, setup) / (0.5 * std::log1p(eta * eta / (euler ? 1.0 : 2.0))), 1.0, 3e-8,
        "sixty states of 9e-3, with relative roundings of 3e-14, over a growth of 1e-4 and a rotation of 0.02 per "
        "step: 1.5e-8, twice that");
    findings.expect_exact(
        {"advice_undamped", fmt::format("step advice: linear limit of {} without damping", method.name)},
        linear_limit(method.name, 0.0).value_or(std::nan("")), 0.0, "it grows at any step");
  }
}

/// Compares the limit 2/w of Eq. 25 with the limits of a contact with a dashpot.
void check_common_limit(Findings& findings, const Setup& setup) {
  Table table = common_formula(
      "lagged_limits",
      "**Limit of the step $2/\\omega$ (Eq. 25) with a dashpot,** as $\\omega h$. A dashpot that uses the velocity of "
      "half a step before lowers it to $2(\\sqrt{1 + \\xi^2} - \\xi)$, one that uses the velocity of one and a half "
      "steps before to $\\sqrt{1 + \\xi^2} - \\xi$, which tends to 1, not 2, as the damping vanishes. Solver: the step "
      "at which the fitted growth of a disc between two planes passes zero.");
  for (const FixedStepMethod& method : {fixed_step_methods[1], fixed_step_methods[3]}) {
    const auto claim = findings.in(fmt::format("integrator.{}", method.name));
    for (const double xi : {0.1, 0.4, 1.0}) {
      const double exact = (method.scheme == reference::Scheme::late ? 1.0 : 2.0) * (std::sqrt(1.0 + xi * xi) - xi);
      const double found = measured_limit(method, exact, xi, setup);
      findings.expect_round_off({"limits", fmt::format("limit of the step of {}, xi = {:g}", method.name, xi)}, found,
                                exact, 1e-9,
                                "twenty-four halvings of an interval of 2e-3 of the limit, and a rounding of 6e-14 "
                                "over a slope of ln growth near 0.1");
      table.rows.push_back(cells("`{}`, $\\xi$ = {:g} | 2 | {:.4f} | {:+.0f} % | {:.4f}", method.name, xi, exact,
                                 100.0 * (2.0 / exact - 1.0), found));
    }
  }
  findings.table(table);
}

using reference::Scheme;

/// The exact limits on a panel: each line is continued from the nearest limit at the previous damping ratio.
std::vector<Series> limit_lines(const FixedStepMethod& method, int panel) {
  constexpr double between = 0.025;
  std::vector<Series> lines;
  std::size_t before = 0;
  for (int i = 0; i <= 80; ++i) {
    const double xi = between * i;
    const std::vector<double> limits = reference::limits(method.scheme, xi, 1.25 * method.scale, 60);
    for (const double limit : limits) {
      const double y = limit / method.scale;
      const bool alone = limits.size() == 1 && before == 1;  // then the line may have any slope
      auto line = std::find_if(lines.begin(), lines.end(), [&](const Series& known) {
        return std::abs(known.x.back() - (xi - between)) < 1e-9 && (alone || std::abs(known.y.back() - y) < 0.08);
      });
      if (line == lines.end()) {
        line = lines.insert(line, {.label = fmt::format("{}, exact limit", method.name)});
        line->style = Style::lines;
        line->panel = panel;
      }
      line->add(xi, y);
    }
    before = limits.size();
  }
  return lines;
}

/// Measured map of one method, and its errors.
struct Map {
  Series growth;
  double worst = 0.0;      ///< error of ln growth without double eigenvalues: in roundings, absolute for Adams' pair
  double worst_one = 0.0;  ///< error of ln growth where two eigenvalues coincide
  int wrong = 0;           ///< number of points on the wrong side
};

Map map_of(const FixedStepMethod& method, Findings& findings, const Setup& setup) {
  const int across = setup.coarse ? 7 : 41, up = setup.coarse ? 10 : 40;
  Map map{.growth = {.label = fmt::format("{}, ln growth", method.name), .style = Style::heat}};
  for (int i = 0; i < across; ++i) {
    const double xi = 2.0 * i / (across - 1);
    const SqueezedRuns disc = squeezed_runs(xi);
    for (int j = 0; j < up; ++j) {
      const double part = 1.25 * (j + 0.5) / up, eta = part * method.scale;
      const double measured = first_growth(disc, method, eta, setup);
      const double exact = reference::ln_growth(method.scheme, eta, xi), error = measured - exact;
      if (method.doubles && xi == 1.0) {
        keep_worst(map.worst_one, error);
      } else {
        keep_worst(map.worst, method.dimension > 3 ? error : in_roundings(method, error, exact));
      }
      if (std::abs(exact) > 1e-5 && !((measured > 0.0) == (exact > 0.0))) ++map.wrong;
      map.growth.add(xi, part);
      map.growth.values.push_back(measured);
    }
    findings.count(up * 16);
  }
  return map;
}

/// Checks the measured against the exact growth on a grid, and adds both to the figure as a panel.
void check_map(const FixedStepMethod& method, Findings& findings, const Setup& setup, Figure& figure) {
  Map map = map_of(method, findings, setup);
  const std::string name = method.name;
  const auto claim = findings.in("integrator." + name);
  if (method.dimension > 3) {
    findings.expect_round_off(
        {"growth", name + ": ln growth over the map, largest error"}, map.worst, 0.0, 1e-3,
        "sixteen eigenvalues, fitted to states in which rounding is up to 3e-7 of the smallest: eigenvalues smaller "
        "than that are taken as zero, and the largest one is off by as much over their distance from it");
  } else {
    findings.expect_round_off({"growth", name + ": ln growth over the map, largest error in roundings"}, map.worst, 0.0,
                              400.0,
                              "runs begin up to twenty times closer to rest than necessary, and where eigenvalues "
                              "nearly coincide, as Fehlberg's at xi = 1.1, the fit amplifies a rounding by twenty");
  }
  if (method.doubles && !setup.coarse) {
    findings.expect(name + ": ln growth at xi = 1, where two eigenvalues coincide, largest error", map.worst_one, 0.0,
                    method.dimension > 3
                        ? Tolerance::round_off(1e-2, "the root of the error elsewhere, 1e-4")
                        : Tolerance::round_off(3e-5,
                                               "a rounding of the largest start, 6e-14, separates them by its root, "
                                               "2.5e-7, times the ratio of the map to the eigenvalues, up to 1e2"));
  }
  findings.expect_exact(name + ": points of the map on the wrong side of the exact curve", map.wrong, 0.0,
                        "count of all points at which ln growth differs from zero by more than 1e-5");
  if (setup.coarse) return;
  map.growth.panel = static_cast<int>(figure.panels.size());
  const std::string_view word = method.scheme == Scheme::late ? "lagged" : method.name;
  figure.panels.push_back(fmt::format("{} {:g}", word.substr(word.starts_with("odeint_") ? 7 : 0), method.scale));
  figure.series.push_back(map.growth);
  const std::vector<Series> lines = limit_lines(method, map.growth.panel);
  figure.series.insert(figure.series.end(), lines.begin(), lines.end());
}

/// Checks that each integrator of the solver has its map, or is listed as one without a limit because it has no fixed
/// step.
void check_list(Findings& findings, const Setup& setup) {
  const std::vector<std::string> all = integrator_names();
  int strangers = 0;
  for (const std::string& name : all) {
    const auto is_it = [&](std::string_view known) { return known == name; };
    const bool mapped = std::any_of(fixed_step_methods.begin(), fixed_step_methods.end(),
                                    [&](const FixedStepMethod& method) { return is_it(method.name); }) &&
                        !(setup.has("method_forgotten") && name == "taylor");
    const bool named = std::any_of(methods_without_limit.begin(), methods_without_limit.end(), is_it);
    const bool fixed = !needs_tolerance(name) && !needs_closed_form(name);
    strangers += mapped == fixed && named != fixed ? 0 : 1;
  }
  findings.expect_exact(
      {"unmapped", "fixed-step integrators without a map, or other integrators not named on this page"}, strangers, 0.0,
      "count over the solver's closed list");
}

/// Figure of the exact limits against damping, for velocities in the dashpot of different times.
Figure time_levels() {
  Figure figure{.name = "time_levels",
                .title = "Stability limit by the velocity in the dashpot",
                .caption =
                    "Exact limits of leapfrogs and of velocity Verlet by the velocity that their dashpots use. The "
                    "maps contain the methods with a velocity half a step old (velocity Verlet, central difference, "
                    "Euler-Cromer) and one and a half steps old (lagged central difference).",
                .x = {.label = "damping ratio"},
                .y = {.label = "largest stable w h", .min = 0.0}};
  struct Level {
    Scheme scheme;
    const char* label;
  };
  for (const Level level :
       {Level{Scheme::half_step, "half a step old"}, Level{Scheme::late, "one and a half steps old"},
        Level{Scheme::average, "mean of old and new"}, Level{Scheme::implicit, "new"},
        Level{Scheme::verlet_old, "Verlet, v(n)"}, Level{Scheme::verlet_predicted, "Verlet, v(n) + h a(n)"}}) {
    Series series{.label = level.label, .style = Style::lines};
    for (double xi = 0.005; xi < 1.5; xi += 0.02)
      series.add(xi, reference::limits(level.scheme, xi, 8.0).front());
    figure.series.push_back(series);
  }
  return figure;
}

/// Figure of the map of the central difference method alone, from the figure of all maps.
Figure map_alone(const Figure& maps) {
  Figure figure{.name = "map_of_central_difference",
                .title = "Central difference: growth per step",
                .caption =
                    "Measured ln of the growth per step of a disc squeezed between two planes, and the exact limit "
                    "(black): $\\omega h = 2$ without a dashpot, less with one.",
                .x = maps.x,
                .y = {.label = "w h over 2", .min = 0.0, .max = 1.25},
                .series = {},
                .panels = {"w h over 2, central difference"},
                .scale = maps.scale};
  for (const Series& series : maps.series) {
    if (!series.label.starts_with("central_difference,")) continue;
    figure.series.push_back(series);
    figure.series.back().panel = 0;
  }
  return figure;
}

void run(Findings& findings, const Setup& setup) {
  Figure figure{.name = "maps",
                .title = "Growth per step of twelve methods",
                .caption =
                    "Measured ln of the growth per step, blue where the motion decays, red where it grows, and the "
                    "exact limit (black). $\\omega h$ of each panel is in units of the number above it.",
                .x = {.label = "damping ratio", .min = -0.025, .max = 2.025},
                .y = {.label = "w h over scale", .min = 0.0, .max = 1.25},
                .series = {},
                .scale = Scale{"ln growth per step", -0.5, 0.5}};
  double worst_run = 0.0;
  check_list(findings, setup);
  for (const FixedStepMethod& method : fixed_step_methods) {
    if (setup.coarse && method.scheme != Scheme::half_step && method.scheme != Scheme::euler) continue;
    check_map(method, findings, setup, figure);
    check_both_sides(method, findings, setup, worst_run);
  }
  check_bilateral_systems(findings, setup);
  if (setup.coarse) return;
  findings.expect_round_off("all methods: ln growth at the end of long runs, largest relative error", worst_run, 0.0,
                            1e-5, "rounding is 3e-9 of the smallest state, and the smallest growth is 5e-4");
  check_limits(findings, setup);
  check_growth_undamped(findings, setup);
  check_common_limit(findings, setup);
  findings.figure(map_alone(figure));
  figure.columns = (static_cast<int>(figure.panels.size()) + 1) / 2;  // two rows
  findings.figure(figure);
  findings.figure(time_levels());
}

}  // namespace

Case definition() {
  return {
      .id = "stability_maps",
      .title = "Stability maps: growth per step against damping and step",
      .family = "speed and accuracy",
      .requirements = {{"Eq. 25",
                        {"sides_of_limit", "sides_of_2", "advice", "step advice: methods with a linear limit",
                         "advice_undamped", "limits"}},
                       {"law.linear_spring_dashpot, end_rule.attractive, pair.circle.half_plane", {"growth"}}},
      .main_checks =
          {"velocity_verlet: ln growth over the map, largest error in roundings",
           "blanes_moan4: ln growth over the map, largest error in roundings",
           "odeint_fehlberg78: ln growth over the map, largest error in roundings",
           "velocity_verlet: runs on the wrong side of the limit",
           "fence held at 0.02 s: ln growth per step at 1.001 and 1.02 of the limit, largest relative error"},
      .source =
          "Mustoe & Huttelmaier 1993, Eq. 25; Dormand & Prince 1980; Cash & Karp 1990; Fehlberg 1968; Blanes & Moan "
          "2002",
      .faults = {{"dashpot_lags", "the lagged central difference under the name of velocity Verlet",
                  "velocity_verlet: ln growth over the map, largest error in roundings"},
                 {"step_too_long", "steps 3 % longer than stated",
                  "velocity_verlet: runs on the wrong side of the limit"},
                 {"stiffness_halved", "contacts with half the stiffness",
                  "velocity_verlet: points of the map on the wrong side of the exact curve"},
                 {"drift_after_kick", "Euler-Cromer's method under the name of Euler's",
                  "euler: ln growth over the map, largest error in roundings"},
                 {"method_forgotten", "Taylor's method missing from the maps", "unmapped"},
                 {"kt_ignored", "the step of a sticking disc chosen by its normal contact alone",
                  "sticking disc, kt = 0.4 kn: runs on the wrong side of w h = 2"},
                 {"fence_by_rule", "the fence's step chosen by the frequency of the 1993 rule",
                  "fence held at 0.02 s: ln growth per step at 1.001 and 1.02 of the limit, largest relative error"}},
      .seconds = 4.0,
      .run = run};
}

}  // namespace talus::verification::problems::stability_maps
