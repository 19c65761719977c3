#include "verification/problems/many_bodies/dense_runs.hpp"
#include "verification/reference/mathematics/power_fit.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::dense_rheology {
namespace {

struct Step {
  double fraction, shear_rate;
};

/// Flows to be run. Those of `smooth` and the stiffer one have the same number of discs.
struct Plan {
  DensePlan smooth_base, rough_base;
  std::vector<Step> smooth, rough;
  Step stiffer;  ///< one of `smooth`
};

Plan plan_of(const Setup& setup) {
  const bool full = setup.tier == Tier::full && !setup.coarse;
  Plan plan;
  DensePlan& base = plan.smooth_base;
  base.discs = full ? 400 : 200;
  base.starts = setup.coarse ? 1 : full ? 3 : 2;
  base.strain = setup.coarse ? 2.0 : 3.0;
  base.still_box = setup.has("still_box");
  plan.rough_base = base;
  plan.rough_base.discs = 200;
  plan.rough_base.friction = setup.has("smooth_discs") ? 0.0 : 0.5;
  if (setup.coarse) {
    plan.smooth = {{0.75, 2e-3}, {0.80, 6e-4}, {0.82, 4e-4}};
    plan.rough = {{0.77, 1e-3}};
  } else if (full) {
    plan.smooth = {{0.76, 1e-3},    {0.78, 1e-3}, {0.80, 6e-4},  {0.81, 4e-4},  {0.82, 2.5e-4},
                   {0.825, 1.5e-4}, {0.83, 1e-4}, {0.835, 5e-5}, {0.8375, 4e-5}};
    plan.rough = {{0.70, 2e-3}, {0.75, 1e-3}, {0.77, 5e-4}, {0.785, 2.5e-4}, {0.795, 1.2e-4}, {0.80, 1e-4}};
  } else {
    plan.smooth = {{0.78, 1e-3}, {0.80, 6e-4}, {0.82, 2.5e-4}, {0.83, 1.5e-4}, {0.8425, 1e-4}};
    plan.rough = {{0.75, 1e-3}, {0.785, 4e-4}};
  }
  plan.stiffer = full ? plan.smooth[4] : plan.smooth[1];
  return plan;
}

std::vector<DenseFlow> run_all(DensePlan base, const std::vector<Step>& steps, Findings& findings) {
  std::vector<DenseFlow> all;
  for (const Step& step : steps) {
    base.fraction = step.fraction, base.shear_rate = step.shear_rate;
    all.push_back(run_dense(base));
    findings.count(all.back().steps);
  }
  return all;
}

double over_error(double difference, double error_a, double error_b) {
  return difference / std::hypot(error_a, error_b);
}

/// Properties of any mu(I) and phi(I): mu grows with I, and phi falls. As phi is given, I must fall as phi grows.
void check_slopes(Findings& findings, const std::vector<DenseFlow>& flows) {
  double minimum_rise = 1e9, minimum_fall = 1e9;
  for (std::size_t i = 1; i < flows.size(); ++i) {
    const DenseFlow &loose = flows[i - 1], &dense = flows[i];
    minimum_rise = std::min(minimum_rise, over_error(loose.friction.value - dense.friction.value, loose.friction.error,
                                                     dense.friction.error));
    minimum_fall = std::min(minimum_fall, over_error(loose.inertial.value - dense.inertial.value, loose.inertial.error,
                                                     dense.inertial.error));
  }
  findings.expect_between(
      {"friction_increase", "increase of friction with the inertial number, smallest step over its error"},
      minimum_rise, 3.0, 100.0,
      "three standard errors between any two neighbouring flows; above 100 the errors would be too small for flows of "
      "this length");
  findings.expect_between(
      {"fraction_decrease", "decrease of solid fraction with the inertial number, smallest step over its error"},
      minimum_fall, 3.0, 100.0, "as for friction: each denser flow has a smaller I by three standard errors");
}

/// Stiffer discs: only p/K1 changes.
void check_stiffness(Findings& findings, const Plan& plan, const std::vector<DenseFlow>& flows, const Setup& setup) {
  const auto known = std::find_if(flows.begin(), flows.end(),
                                  [&](const DenseFlow& flow) { return flow.fraction == plan.stiffer.fraction; });
  // The rate is in units of the discs' sqrt(K1/m): half the rate is equivalent to four times the stiffness.
  const double rate = plan.stiffer.shear_rate * (setup.has("soft_discs") ? 16.0 : 0.5);
  const DenseFlow other = run_all(plan.smooth_base, {{plan.stiffer.fraction, rate}}, findings).front();
  const double error = std::hypot(known->inertial.error, other.inertial.error);
  findings.expect_model(
      {"stiffer_inertial_number", "inertial number of discs four times as stiff"}, other.inertial.value,
      known->inertial.value, 3.0 * error,
      "three standard errors of the difference; overlaps of 3e-4 d or less shift phi by 5e-4 and I by about 2e-3");
  findings.expect_model({"stiffer_friction", "friction of discs four times as stiff"}, other.friction.value,
                        known->friction.value, 3.0 * std::hypot(known->friction.error, other.friction.error),
                        "three standard errors of the difference");
}

/// The densest smooth flow that is at least as fast as this one: its friction is not below that at the same I, and its
/// solid fraction not above.
const DenseFlow& faster(const std::vector<DenseFlow>& smooth, double inertial) {
  const DenseFlow* found = &smooth.front();
  for (const DenseFlow& flow : smooth)
    if (flow.inertial.value >= inertial) found = &flow;
  return *found;
}

void check_rough(Findings& findings, const std::vector<DenseFlow>& smooth, const std::vector<DenseFlow>& rough) {
  std::vector<double> excess, loss;
  for (const DenseFlow& flow : rough) {
    const DenseFlow& beside = faster(smooth, flow.inertial.value);
    if (beside.inertial.value < flow.inertial.value) continue;  // faster than all smooth flows
    excess.push_back(
        over_error(flow.friction.value - beside.friction.value, flow.friction.error, beside.friction.error));
    loss.push_back(beside.fraction - flow.fraction);
  }
  const auto minimum = [](const std::vector<double>& all) {
    return all.empty() ? 0.0 : *std::min_element(all.begin(), all.end());
  };
  findings.expect_between({"rough_excess", "excess friction of rough discs over its error"}, minimum(excess), 3.0,
                          100.0,
                          "three standard errors above the next faster smooth flow, whose friction is above that of "
                          "smooth discs at the same I");
  findings.expect_between("lower solid fraction of rough discs at the same inertial number", minimum(loss), 0.005, 0.1,
                          "the next faster smooth flow is looser than smooth discs at the same I, and still denser "
                          "than the rough flow; solid fractions are chosen in steps of 0.005");
}

using Points = std::vector<reference::FitPoint>;

Points frictions(const std::vector<DenseFlow>& flows) {
  constexpr double fastest = 0.25;  // beyond, mu bends: discs collide and separate
  Points points;
  for (const auto& flow : flows) {
    if (flow.inertial.value < fastest)
      points.push_back({flow.inertial.value, flow.inertial.error, flow.friction.value, flow.friction.error});
  }
  return points;
}

/// phi is given, but overlapping discs act as somewhat smaller ones, which shifts phi by no more than the error
/// assigned to it here.
Points fractions(const std::vector<DenseFlow>& flows) {
  constexpr double fastest = 0.15;  // where one correction to the published power is enough
  Points points;
  for (const auto& flow : flows) {
    if (flow.inertial.value < fastest)
      points.push_back({flow.inertial.value, flow.inertial.error, flow.fraction, 2.0 * flow.fraction * flow.overlap});
  }
  return points;
}

constexpr double fraction_power = 0.4;        ///< 2/beta of Vagberg et al.
constexpr double rough_friction_power = 0.6;  ///< 1 - 2 b of DeGiuli et al., of spheres

void check_slow_friction(Findings& findings, const std::vector<DenseFlow>& smooth) {
  const auto fit = reference::fit_power(frictions(smooth));
  findings.expect_model(
      {"slow_limit", "friction of an infinitely slow flow"}, fit.limit, 0.11, 0.005 + 2.0 * fit.limit_error,
      fmt::format(
          "half a unit of the last printed digit of 0.11, and two standard errors of {:.4f} of the fitted limit",
          fit.limit_error));
  findings.note(
      fmt::format("Smooth discs with $I < 0.25$: $\\mu = {:.3f} + {:.3f}\\,I^{{{:.2f}}}$; limit {:.3f} $\\pm$ {:.3f}, "
                  "exponent {:.2f} $\\pm$ {:.2f}.",
                  fit.limit, fit.factor, fit.power, fit.limit, fit.limit_error, fit.power, fit.power_error));
}

/// Too few points are slow enough to fit the power as well.
void check_slow_rough_friction(Findings& findings, const std::vector<DenseFlow>& smooth,
                               const std::vector<DenseFlow>& rough) {
  const Points points = frictions(rough);
  const auto without = reference::fit_power(frictions(smooth));
  const auto fit = reference::fit_given_power(points, rough_friction_power);
  const int freedom = static_cast<int>(points.size()) - 2;
  findings.expect_between("excess friction of an infinitely slow rough flow over its error",
                          over_error(fit.limit - without.limit, fit.limit_error, without.limit_error), 3.0, 100.0,
                          "three standard errors above that of smooth discs, with the exponent 0.6 given");
  findings.expect_between("chi squared of the published exponent, friction of rough discs", fit.chi_squared, 0.0,
                          reference::rare_chi_squared(freedom, 1e-3),
                          fmt::format("mu - mu(0) = c I^0.6, as published for spheres; with {} degrees of freedom the "
                                      "upper bound is exceeded once in a thousand",
                                      freedom));
  findings.note(
      fmt::format("Rough discs with $I < 0.25$: $\\mu = {:.3f} + {:.3f}\\,I^{{{:.1f}}}$ with the exponent given; limit "
                  "{:.3f} $\\pm$ {:.3f}, $\\chi^2 = {:.1f}$. A fitted exponent would be {:.2f} $\\pm$ {:.2f}: these "
                  "points hardly determine it.",
                  fit.limit, fit.factor, fit.power, fit.limit, fit.limit_error, fit.chi_squared,
                  reference::fit_power(points).power, reference::fit_power(points).power_error));
}

/// The published power of phi, and whether these points distinguish it from a parabola with as many coefficients.
void check_fraction_power(Findings& findings, const std::vector<DenseFlow>& smooth) {
  const Points points = fractions(smooth);
  const auto fit = reference::fit_corrected_power(points, fraction_power);
  const auto parabola = reference::fit_corrected_power(points, 2.0);
  const int freedom = static_cast<int>(points.size()) - 3;
  findings.expect_between("chi squared of the published exponent, solid fraction", fit.chi_squared, 0.0,
                          reference::rare_chi_squared(freedom, 1e-3),
                          fmt::format("phi_J - phi = c I^(2/beta) + c' I with beta = 5.0; with {} degrees of freedom "
                                      "the upper bound is exceeded once in a thousand",
                                      freedom));
  findings.expect_between("increase of chi squared by a parabola, solid fraction",
                          parabola.chi_squared - fit.chi_squared, 9.0, 1e3,
                          "the same number of coefficients without the published exponent; an increase of 9 "
                          "corresponds to three standard errors of one coefficient");
  findings.note(
      fmt::format("Smooth discs with $I < 0.15$: $\\phi = {:.4f} - {:.4f}\\,I^{{{:.2f}}} - {:.4f}\\,I$, $\\chi^2 = "
                  "{:.1f}$; a parabola has {:.1f}. The exponent is that of Vagberg et al.; the correction linear in "
                  "$I$ is a choice made here. The points alone do not determine the exponent.",
                  fit.limit, -fit.factor, fit.power, -fit.linear, fit.chi_squared, parabola.chi_squared));
}

void add_rows(Table& table, const char* kind, const std::vector<DenseFlow>& flows) {
  for (const DenseFlow& flow : flows)
    table.rows.push_back(cells("{} | {:.4f} | {:.4f} | {:.4f} | {:.4f} | {:.4f} | {:.1e} | {:.2f} | {:.1e}", kind,
                               flow.fraction, flow.inertial.value, flow.inertial.error, flow.friction.value,
                               flow.friction.error, flow.pressure.value, flow.coordination, flow.overlap));
}

Series friction_points(const char* label, const std::vector<DenseFlow>& flows) {
  Series out{label, {}, {}, Style::errorbars};
  for (const DenseFlow& flow : flows) {
    const auto [mu, error] = flow.friction;
    out.add(flow.inertial.value, mu);
    out.y_low.push_back(mu - 3.0 * error), out.y_high.push_back(mu + 3.0 * error);
  }
  return out;
}

/// I is the measured quantity here: its error is drawn as an error of phi, by the slope to the neighbours.
Series fraction_points(const char* label, const std::vector<DenseFlow>& flows) {
  Series out{label, {}, {}, Style::errorbars};
  for (std::size_t i = 0; i < flows.size(); ++i) {
    const DenseFlow &left = flows[i > 0 ? i - 1 : i], &right = flows[std::min(i + 1, flows.size() - 1)];
    const double slope = (right.fraction - left.fraction) / (right.inertial.value - left.inertial.value);
    const double error = std::abs(slope) * flows[i].inertial.error, phi = flows[i].fraction;
    out.add(flows[i].inertial.value, phi);
    out.y_low.push_back(phi - 3.0 * error), out.y_high.push_back(phi + 3.0 * error);
  }
  return out;
}

/// Curve of a fit over the range of its points.
Series curve(const char* label, const reference::PowerFit& fit, const Points& points) {
  Series out{label, {}, {}, Style::lines};
  const double slowest = points.back().x, fastest = points.front().x;
  for (int k = 0; k <= 60; ++k) {
    const double x = slowest * std::pow(fastest / slowest, k / 60.0);
    out.add(x, fit.at(x));
  }
  return out;
}

void draw(Findings& findings, const std::vector<DenseFlow>& smooth, const std::vector<DenseFlow>& rough, bool full) {
  Table table{.name = "flows",
              .caption =
                  "Discs without friction (smooth) and with $\\mu_p = 0.5$ (rough): values measured at each solid "
                  "fraction, with standard errors; contacts per disc; mean overlap of a contact over $d$.",
              .columns = {"discs", "phi", "I", "error", "mu", "error", "p/K1", "contacts", "overlap"}};
  add_rows(table, "smooth", smooth), add_rows(table, "rough", rough);
  findings.table(table);
  const Points slow = frictions(smooth);
  Figure friction{.name = "friction",
                  .title = "Friction of dense flows",
                  .caption =
                      "Bars: three standard errors. Horizontal line: 0.11, above which no packing of many smooth "
                      "grains bears shear (Clark et al. 2017). Curve through smooth discs: fitted power law.",
                  .x = {.label = "I", .log = true},
                  .y = {.label = "mu", .min = 0.0},
                  .series = {friction_points("smooth discs", smooth), friction_points("rough discs", rough),
                             curve("smooth, fitted power law", reference::fit_power(slow), slow)},
                  .lines = {{'y', 0.11, "Clark et al."}}};
  Figure fraction{.name = "solid_fraction",
                  .title = "Solid fraction of dense flows",
                  .caption = "Bars: three standard errors of I, converted to solid fraction.",
                  .x = {.label = "I", .log = true},
                  .y = {.label = "phi"},
                  .series = {fraction_points("smooth discs", smooth), fraction_points("rough discs", rough)}};
  if (full) {
    const Points rough_slow = frictions(rough), dense = fractions(smooth);
    friction.series.push_back(
        curve("rough, exponent 0.6", reference::fit_given_power(rough_slow, rough_friction_power), rough_slow));
    friction.caption +=
        " Curve through rough discs: exponent that DeGiuli et al. 2015 found for spheres, limit and factor fitted.";
    fraction.series.push_back(
        curve("smooth, exponent 0.4", reference::fit_corrected_power(dense, fraction_power), dense));
    fraction.caption +=
        " Curve: exponent of Vagberg et al. 2015 and a correction linear in I, limit and factors fitted.";
  }
  findings.figure(friction), findings.figure(fraction);
}

void run(Findings& findings, const Setup& setup) {
  const bool full = setup.tier == Tier::full && !setup.coarse;
  const Plan plan = plan_of(setup);
  const auto smooth = run_all(plan.smooth_base, plan.smooth, findings);
  const auto rough =
      setup.needs("rough discs") ? run_all(plan.rough_base, plan.rough, findings) : std::vector<DenseFlow>{};
  check_slopes(findings, smooth);
  check_stiffness(findings, plan, smooth, setup);
  if (setup.needs("rough discs")) check_rough(findings, smooth, rough);
  if (setup.coarse) return;
  const BothStresses both = stress_by_both({.fraction = 0.83, .shear_rate = 1e-3, .discs = 200}, 3000);
  findings.expect_exact("shear stress, fast system against plain system", both.fast.xy, both.plain.xy,
                        "the same pairs in the same order, by the same expressions");
  findings.expect_exact("pressure, fast system against plain system", both.fast.pressure(), both.plain.pressure(),
                        "the same pairs in the same order, by the same expressions");
  check_slow_friction(findings, smooth);
  if (full) {
    check_slow_rough_friction(findings, smooth, rough);
    check_fraction_power(findings, smooth);
  }
  draw(findings, smooth, rough, full);
}

}  // namespace

Case definition() {
  return {
      .id = "dense_rheology",
      .title = "Rheology of dense flows: friction and solid fraction",
      .requirements = {{"F7",
                        {"friction_increase", "fraction_decrease", "stiffer_inertial_number", "stiffer_friction",
                         "rough_excess", "lower solid fraction of rough discs at the same inertial number",
                         "slow_limit"}}},
      .main_checks = {"slow_limit", "friction_increase", "fraction_decrease", "stiffer_friction", "rough_excess"},
      .source = "da Cruz et al. 2005; Clark et al. 2017; Vagberg et al. 2015; Peyneau & Roux 2008; DeGiuli et al. 2015",
      .faults = {{"still_box", "periodic images that do not slide", "friction_increase"},
                 {"soft_discs", "discs 256 times softer instead of four times stiffer", "stiffer_inertial_number"},
                 {"smooth_discs", "no friction between the rough discs", "rough_excess"}},
      .seconds = 6.0,
      .full_seconds = 45.0,
      .run = run};
}

}  // namespace talus::verification::problems::dense_rheology
