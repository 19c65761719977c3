#include "verification/problems/founding/commensurate_findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "verification/problems/founding/struck_scenes.hpp"
#include "verification/study/common_formula.hpp"
#include "verification/study/curves.hpp"
#include "verification/study/expectations.hpp"

namespace talus::verification::problems {
namespace {

constexpr double pi = std::numbers::pi;

/// Speed after the contact over that before it, by the exact map of the leapfrog: eta = w h, the touch at the share
/// `phase` of a step.
double leapfrog_exit(double eta, double phase) {
  const double turn = 2.0 * std::asin(0.5 * eta);  // rotation of the leapfrog a step
  const double theta = 1.0 - phase;
  // Angle of the state at its first point in contact.
  const double start = std::atan2(eta * theta * std::sqrt(1.0 - 0.25 * eta * eta), 1.0 - 0.5 * eta * eta * theta);
  const double inside = std::floor((pi - start) / turn);  // steps after the first point, the depth still positive
  const double q = std::sin(start + inside * turn);       // last depth in contact over the amplitude
  const double p = std::cos(start + inside * turn);       // velocity there, over the amplitude, < 0
  const double amplitude = std::sqrt(1.0 - eta * eta * theta * (1.0 - theta));
  const double depth = q * amplitude / std::sqrt(1.0 - 0.25 * eta * eta);
  return -(p * amplitude - 0.5 * eta * depth);
}

}  // namespace

void check_commensurate(Findings& findings) {
  const PhasedImpact elastic = struck_disc({});
  Table common = common_formula(
      "order",
      "**Order of a method, from steps that divide the contact time.** The orders fitted to $t_c/h = N$ = 16, 32, ... "
      "are not those of any other step: the errors of onset and release cancel. Exact: 2 for a force with a kink, "
      "whatever the method. Solver: the same fit with $t_c/h = N + .382$.");
  Figure figure{.name = "commensurate",
                .title = "How a commensurate step hides the order",
                .caption =
                    "The same undamped disc with t_c/h a whole number N, and with N + 0.382. The errors of onset "
                    "and release then cancel for every phase, and Verlet seems of order 3, RK4 of order 4.",
                .x = {"step / contact time", "1", true},
                .y = {"rms relative error", "1", true}};
  for (const char* method : {"velocity_verlet", "rk4"}) {
    const bool rk4 = std::string_view{method} == "rk4";
    const std::vector<double> counts = doublings(16.0, rk4 ? 6 : 8);
    const Sweep hidden = sweep(elastic, make_integrator(method), counts, Offset::none);
    const Sweep honest = sweep(elastic, make_integrator(method), counts, Offset::common);
    const int seen = rk4 ? 4 : 3;
    findings.expect_order(fmt::format("commensurate steps: false order of {}", method), hidden.rms, seen - 0.1,
                          seen + 0.1,
                          "onset and release errors of second order are equal and opposite for every phase; "
                          "what is left is of the next order");
    const double fitted = hidden.rms.fit().order;
    common.rows.push_back({fmt::format("`{}`, undamped disc on a wall", method), fmt::format("{:.3f}", fitted), "2",
                           fmt::format("{:+.3f}", fitted - 2.0), fmt::format("{:.3f}", honest.rms.fit().order)});
    figure.series.push_back({fmt::format("{}, t_c/h = N", method), hidden.rms.steps(), hidden.rms.errors()});
    figure.series.push_back({fmt::format("{}, t_c/h = N + 0.382", method), honest.rms.steps(), honest.rms.errors()});
    figure.slopes.push_back(
        {static_cast<double>(seen), hidden.rms.steps()[3], 0.5 * hidden.rms.errors()[3], fmt::format("h^{}", seen)});
    if (rk4) continue;
    findings.expect("commensurate steps: rms constant of velocity_verlet",
                    hidden.rms.errors().back() * std::pow(hidden.steps.back(), 3.0),
                    std::pow(pi, 4.0) / (48.0 * std::numbers::sqrt3),
                    Tolerance::model(1e-3,
                                     "the leapfrog's period, short by eta^2/24, is an offset of -pi^2/(24 N) "
                                     "steps; the next order is below 1e-3 at the finest step")
                        .relative());
    figure.slopes.push_back({2.0, honest.rms.steps()[3], 2.0 * honest.rms.errors()[3], "h^2"});
  }
  findings.table(common);
  findings.figure(figure);
}

void check_gain(Findings& findings) {
  Table table = common_formula(
      "gain",
      "**Stable below $h = 2/\\omega$.** That is the limit of a spring that always acts. A contact acts on one side "
      "only: each impact begins and ends within a step, and an undamped disc leaves the wall faster or slower than it "
      "came, far below the limit. $|v'/v|$, the largest of 64 phases; exact: the leapfrog's map.");
  table.columns.insert(table.columns.begin() + 3, "least exact");
  const PhasedImpact elastic = struck_disc({});
  double worst = 0.0;
  for (const double eta : {0.3, 0.7, 1.2, 1.6, 1.9}) {
    const std::vector<double> counts{pi / eta - common_offset};
    const Sweep swept = sweep(elastic, make_integrator("velocity_verlet"), counts, Offset::common);
    const std::vector<double> phases = even_phases(fewest_phases);
    double largest = 0.0, least = 1.0, seen = 0.0;
    for (std::size_t i = 0; i < phases.size(); ++i) {
      const double exact = leapfrog_exit(eta, phases[i]), solver = 1.0 + swept.by_phase.front()[i];
      largest = std::max(largest, exact);
      least = std::min(least, exact);
      seen = std::max(seen, solver);
      worst = std::max(worst, std::abs(solver - exact));
    }
    table.rows.push_back({fmt::format("$\\omega h$ = {:g}", eta), "1", fmt::format("{:.3f}", largest),
                          fmt::format("{:.3f}", least), fmt::format("{:+.1f} %", 100.0 * (1.0 / largest - 1.0)),
                          fmt::format("{:.3f}", seen)});
  }
  findings.expect("exit speed of each of 64 phases at w h = .3 ... 1.9 from the exact map", worst, 0.0,
                  Tolerance::round_off(64.0 * 2.2e-16,
                                       "the map is exact: at most 20 steps, each with three roundings of numbers up to "
                                       "2.6; the depth is a difference of lengths a few times larger"));
  findings.table(table);
}

void check_phases(Findings& findings) {
  const double count = 16.0;
  const std::vector<double> counts{count};
  const Sweep swept = sweep(struck_disc({}), make_integrator("velocity_verlet"), counts, Offset::common);
  const double eta = pi / (count + common_offset);
  Series solver{
      .label = "solver", .x = even_phases(fewest_phases), .y = swept.by_phase.front(), .style = Style::points};
  const Series theory =
      curve("exact map of the leapfrog", solver.x, [&](double phase) { return leapfrog_exit(eta, phase) - 1.0; });
  const double worst = std::abs(worst_error(theory.y, solver.y));
  findings.expect("error of each of 64 phases at 16.4 steps per contact", worst, 0.0,
                  Tolerance::round_off(64.0 * 2.2e-16,
                                       "the map is exact: 20 steps, each with three roundings of a number below 1"));
  findings.figure({.name = "phases",
                   .title = "Error against onset phase",
                   .caption = "Relative error of the exit speed for each onset phase at 16.4 steps per contact, and "
                              "the closed form of the leapfrog's map. One run can show any of these, zero included.",
                   .x = {"onset phase", "1"},
                   .y = {"relative error of the exit speed", "1"},
                   .series = {theory, solver}});
}

}  // namespace talus::verification::problems
