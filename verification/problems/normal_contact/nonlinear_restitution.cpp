#include <cmath>
#include <numbers>
#include <variant>

#include "solver/base/error.hpp"
#include "solver/laws/hertz_impact.hpp"
#include "solver/laws/hunt_crossley_impact.hpp"
#include "solver/scenes/bouncing_disc.hpp"
#include "verification/reference/impacts/hertz_impact.hpp"
#include "verification/reference/impacts/power_law_impact.hpp"
#include "verification/reference/impacts/restitution.hpp"
#include "verification/study/findings/common_formula.hpp"
#include "verification/study/impacts/followed_impact.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::nonlinear_restitution {
namespace {

constexpr double mass = 1.7, speed = 0.6, modulus = 0.9, radius = 2.5, stiffness = 1.3, reference_overlap = 0.4;
constexpr std::array targets{0.9, 0.7, 0.5, 0.3, 0.1};
constexpr std::array rules{EndRule::attractive, EndRule::clamped};
constexpr double tight = 1e-12;

Hertz hertz(HertzDashpot dashpot, EndRule rule) {
  Hertz law;
  law.modulus = modulus, law.radius = radius, law.dashpot = dashpot, law.end_rule = rule;
  return law;
}
HuntCrossley hunt_crossley(double exponent) { return {stiffness, reference_overlap, exponent, 0.0}; }

/// Length (m v^2/K)^(1/(n+1)) of an impact at this speed, from the force K x^n.
double impact_length(double factor, double n, double v) { return std::pow(mass * v * v / factor, 1.0 / (n + 1.0)); }
const double hertz_factor = 4.0 / 3.0 * modulus * std::sqrt(radius);
double hunt_crossley_factor(double n) { return stiffness * std::pow(reference_overlap, 1.0 - n); }

/// A disc that hits a plane.
Scene impact(const ContactLaw& law, double v, double gap) {
  return scenes::bouncing_disc({.mass = mass, .radius = 1e3, .gap = gap, .speed = v, .gravity = 0.0, .contact = law});
}

/// Speed after over speed before the impact, with steps chosen by a tight tolerance and located events.
double rebound(const ContactLaw& law, double v, Findings& findings) {
  const double length = std::max(impact_length(hertz_factor, 1.5, v), reference_overlap);
  // The longest contact, e = 0.1, lasts 30 lengths over the speed.
  const RunPlan plan{0.1 * length / v, 60.0 * length / v, length / v, false, MonitorRules::off()};
  const RunEnd end = run_scene(impact(law, v, length), make_integrator("odeint_dopri5", tight), plan, findings);
  return end.state.v[1] / v;
}

/// Bound of the restitution of runs whose slowest rebound has this speed.
Tolerance by_tolerance(double slowest) {
  return Tolerance::truncation(3e-10 / slowest, 1.0,
                               fmt::format("local errors of at most 1e-12 in some 700 steps, of which signs cancel "
                                           "half, relative to speeds after the impact from {:.2g} on",
                                           slowest));
}

// --- the dashpot for a restitution ----------------------------------------------------------------------------------

void check_targets(Findings& findings, const Setup& setup) {
  Table table{.name = "targets",
              .caption = "Damping for a restitution, by the solver, and the restitution of a run with it.",
              .columns = {"law", "end rule", "e", "damping", "run, e - wanted"}};
  const double at = setup.has("speed_forgotten") ? 1.0 : speed, of_mass = setup.has("mass_forgotten") ? 1.0 : mass;
  const auto add = [&](const std::string& law, const char* rule, double e, double damping, double found,
                       double& worst) {
    keep_worst(worst, found / e - 1.0);
    table.rows.push_back(
        {law, rule, fmt::format("{:g}", e), fmt::format("{:.8g}", damping), fmt::format("{:+.1e}", found - e)});
  };
  const auto expect = [&](const std::string& law, double worst) {
    findings.expect({"targets", fmt::format("restitution of {}, largest relative error", law)}, worst, 0.0,
                    by_tolerance(0.1 * speed));
  };
  for (const HertzDashpot dashpot : {HertzDashpot::tsuji, HertzDashpot::constant}) {
    double worst = 0.0;
    const std::string name = fmt::format("hertz, {}", name_of(dashpot));
    for (const EndRule rule : rules) {
      for (const double e : targets) {
        Hertz law = hertz(dashpot, setup.has("pulling_formula") ? EndRule::attractive : rule);
        // By the coefficient, and by the ratio from which each impact sets its coefficient.
        if (e > 0.4) {
          law.set_restitution(e, of_mass, at);
        } else {
          law.set_every_restitution(e, at);
          if (setup.has("mass_forgotten")) law.set_restitution(e, of_mass, at);
        }
        law.end_rule = rule;
        add(name, name_of(rule).data(), e, law.tangent(mass).damping, rebound(law, speed, findings), worst);
      }
    }
    expect(name, worst);
  }
  double worst = 0.0;
  for (const double n : {1.0, 1.5, 2.0, 2.3}) {
    for (const double e : targets) {
      HuntCrossley law = hunt_crossley(n);
      law.set_restitution(e, mass, at);
      if (setup.has("hysteresis_of_1975")) law.hysteresis = 1.5 * (1.0 - e) / speed;
      add(fmt::format("hunt_crossley, n = {:g}", n), "-", e, law.hysteresis, rebound(law, speed, findings), worst);
    }
  }
  expect("hunt_crossley", worst);
  findings.table(table);
}

/// Numbers of the laws in closed form against the references.
void check_closed_forms(Findings& findings) {
  double e = 0.0, time = 0.0, depth = 0.0;
  const auto compare = [&](const auto& law, double exact_e, double exact_time, double exact_depth) {
    keep_worst(e, law.restitution(mass, speed) / exact_e - 1.0);
    keep_worst(time, law.contact_time(mass, speed) / exact_time - 1.0);
    keep_worst(depth, law.largest_overlap(mass, speed) / exact_depth - 1.0);
  };
  const double length = impact_length(hertz_factor, 1.5, speed);
  for (const EndRule rule : rules) {
    // 0.95 with the attractive rule: e = 7.1e-5, after 25 L/v.
    for (const double xi : {0.0, 0.05, 0.3, 0.8, 0.95}) {
      Hertz law = hertz(HertzDashpot::tsuji, rule);
      law.damping = xi * std::sqrt(20.0 / 3.0 * modulus * radius * mass);
      const auto exact = reference::hertz_events({hertz_factor, xi, mass, speed}, same(rule));
      compare(law, exact.restitution, exact.contact_time, exact.largest_depth);
    }
    // 1.1 with the attractive rule: shortly before the contact does not end any more.
    for (const double g : {0.0, 0.02, 0.3, 0.9, 1.1}) {
      Hertz law = hertz(HertzDashpot::constant, rule);
      law.damping = g * mass * speed / length;
      const auto exact = reference::constant_dashpot_events(g, same(rule));
      compare(law, exact.restitution, exact.contact_time * length / speed, exact.largest_depth * length);
    }
  }
  for (const double n : {1.0, 1.5, 2.0}) {
    const double own = impact_length(hunt_crossley_factor(n), n, speed);
    for (const double a : {0.0, 0.1, 0.9, 5.0}) {
      HuntCrossley law = hunt_crossley(n);
      law.hysteresis = a / speed;
      const auto exact = reference::hunt_crossley_events(a, n);
      compare(law, exact.restitution, exact.contact_time * own / speed, exact.largest_depth * own);
    }
  }
  // Without a dashpot for every n: v dt = dx/sqrt(1 - (x/d)^(n+1)), a beta function.
  for (const double n : {5.0, 20.0, 100.0}) {
    const double p = 1.0 / (n + 1.0), own = impact_length(hunt_crossley_factor(n), n, speed);
    const double overlap = own * std::pow(0.5 * (n + 1.0), p);
    compare(hunt_crossley(n), 1.0,
            2.0 * overlap / speed * std::sqrt(std::numbers::pi) * std::tgamma(1.0 + p) / std::tgamma(0.5 + p), overlap);
  }
  const Tolerance bound = Tolerance::model(
      1e-13,
      "accuracy to which solver and references integrate: steps and nodes are such that a hundred roundings are left");
  findings.expect("restitution in closed form, largest relative difference", e, 0.0, bound);
  findings.expect("contact time in closed form, largest relative difference", time, 0.0, bound);
  findings.expect("largest overlap in closed form, largest relative difference", depth, 0.0, bound);

  Hertz overdamped = hertz(HertzDashpot::tsuji, EndRule::attractive);
  overdamped.damping = std::sqrt(20.0 / 3.0 * modulus * radius * mass);
  Hertz creeping = hertz(HertzDashpot::constant, EndRule::attractive);
  creeping.damping = 1.13 * mass * speed / length;
  const auto lasts = [](const Hertz& law) {
    return std::isinf(law.contact_time(mass, speed)) && law.restitution(mass, speed) == 0.0;
  };
  findings.expect_true("attractive contacts that do not end have an infinite contact time and no restitution",
                       lasts(overdamped) && lasts(creeping),
                       "damping ratio 1 (tsuji) and g = 1.13 (constant), beyond the last that end");
  // y = sqrt(4 K/(5 m)) x^(5/4) follows a linear spring with a dashpot, which leaves the speed v exp(-xi A) for the
  // turning point: K x^(5/2) 2/5 = m y^2/2.
  double turn = 0.0;
  for (const double xi : {1.0, 2.0, 10.0}) {
    overdamped.damping = xi * std::sqrt(20.0 / 3.0 * modulus * radius * mass);
    const double y = speed * std::exp(-xi * reference::contact_angle(xi));
    keep_worst(turn, overdamped.largest_overlap(mass, speed) / std::pow(1.25 * mass * y * y / hertz_factor, 0.4) - 1.0);
  }
  findings.expect_round_off("largest overlap in closed form of attractive contacts that do not end, relative error",
                            turn, 0.0, 4.5e-15,
                            "four roundings of the damping ratio in the exponent 2 xi A of up to 6.02, times 2/5, and "
                            "ten more operations, 1.1e-16 each: 2.2e-15; twice that");
}

// --- formulas in use ------------------------------------------------------------------------------------------------

/// The formula of contacts that may pull, used with a contact that may not.
void check_pulling_formula(Findings& findings) {
  Table table = common_formula("pulling",
                               "Tsuji's dashpot by the formula of contacts that may pull, in a contact that may not. "
                               "Common formula: the restitution that it promises.");
  double worst = 0.0, miss = 0.0;
  for (const double e : {0.9, 0.7, 0.5, 0.3}) {
    Hertz law = hertz(HertzDashpot::tsuji, EndRule::attractive);
    law.set_restitution(e, mass, speed);
    law.end_rule = EndRule::clamped;
    const double exact = reference::restitution(reference::damping_ratio(e, reference::EndRule::attractive),
                                                reference::EndRule::clamped);
    const double found = rebound(law, speed, findings);
    keep_worst(worst, found / exact - 1.0);
    keep_worst(miss, found - e);
    table.rows.push_back({fmt::format("e = {:g}", e), fmt::format("{:g}", e), fmt::format("{:.4f}", exact),
                          fmt::format("{:+.1f} %", 100.0 * (e / exact - 1.0)), fmt::format("{:.4f}", found)});
  }
  findings.table(table);
  findings.expect("restitution by the pulling formula in a clamped contact, largest relative error", worst, 0.0,
                  by_tolerance(0.39 * speed));
  findings.in("missed_by_end_rule")
      ->expect_between("largest error of e by the pulling formula in a clamped contact, wanted 0.3 to 0.9", miss, 0.09,
                       0.105,
                       "0.0971 at e = 0.3, where the closed forms of the two end rules differ most: a damping ratio "
                       "that gives 0.3 with "
                       "one of them gives 0.3971 with the other");
}

/// Numbers a(e) that were published for Hunt & Crossley's law.
void check_published_numbers(Findings& findings) {
  struct Formula {
    const char* name;
    double (*number)(double);
  };
  constexpr std::array formulas{Formula{"Hunt & Crossley 1975", [](double e) { return 1.5 * (1.0 - e); }},
                                Formula{"Lankarani & Nikravesh 1990", [](double e) { return 0.75 * (1.0 - e * e); }},
                                Formula{"Gonthier et al. 2004", [](double e) { return (1.0 - e * e) / e; }},
                                Formula{"Flores et al. 2011", [](double e) { return 1.6 * (1.0 - e) / e; }}};
  Table table = common_formula("hysteresis",
                               "Restitution of Hunt & Crossley's law with published damping numbers. Common formula: "
                               "the restitution that each promises.");
  Figure figure{.name = "published_numbers",
                .title = "Restitution that published damping numbers give",
                .caption =
                    "Restitution of Hunt & Crossley's law with the damping number of each formula, against the "
                    "restitution for which it is meant. Points: the solver; lines: exact.",
                .x = {.label = "wanted restitution"},
                .y = {.label = "restitution obtained"}};
  double worst = 0.0, smallest_miss = 1.0, largest_miss = 0.0;
  Series points{"solver", {}, {}, Style::points};
  for (const Formula& formula : formulas) {
    double miss = 0.0;
    Series line{formula.name, {}, {}, Style::lines};
    for (const double e : targets) {
      HuntCrossley law = hunt_crossley(1.5);
      law.hysteresis = formula.number(e) / speed;
      const double found = rebound(law, speed, findings),
                   exact = reference::hunt_crossley_restitution(formula.number(e));
      keep_worst(worst, found / exact - 1.0);
      keep_largest(miss, found - e);
      points.add(e, found);
      table.rows.push_back(cells("{}, e = {:g} | {:g} | {:.3f} | {:+.0f} % | {:.3f}", formula.name, e, e, exact,
                                 100.0 * (e / exact - 1.0), found));
    }
    for (int i = 5; i < 100; ++i)
      line.add(0.01 * i, reference::hunt_crossley_restitution(formula.number(0.01 * i)));
    keep_smallest(smallest_miss, miss), keep_largest(largest_miss, miss);
    figure.series.push_back(line);
  }
  figure.series.push_back({"as wanted", {0.05, 1.0}, {0.05, 1.0}, Style::lines});
  figure.series.push_back(points);
  findings.table(table);
  findings.figure(figure);
  findings.expect("restitution with published damping numbers, largest relative error", worst, 0.0,
                  by_tolerance(0.06 * speed));
  const auto group = findings.in("missed_by_numbers");
  group->expect_between(
      "largest error of e by the best of the published damping numbers, wanted 0.1 to 0.9", smallest_miss, 0.029, 0.032,
      "the equation of the page, solved separately by bisection: Gonthier et al. 2004 give 0.6696 for 0.7");
  group->expect_between(
      "largest error of e by the worst of the published damping numbers, wanted 0.1 to 0.9", largest_miss, 0.55, 0.575,
      "the equation of the page, solved separately by bisection: Lankarani & Nikravesh 1990 give 0.6653 for 0.1");
}

/// The polynomial for Tsuji's dashpot (Marshall 2009, as LAMMPS evaluates it) beside the exact relation.
double polynomial(double e) {
  return std::sqrt(2.0) *
         (1.2728 + e * (-4.2783 + e * (11.087 + e * (-22.348 + e * (27.467 + e * (-18.022 + e * 4.8218))))));
}

void check_polynomial(Findings& findings) {
  Figure figure{.name = "polynomial",
                .title = "Error of the polynomial for Tsuji's dashpot",
                .caption = "Restitution with the polynomial of Marshall 2009, less the wanted one, for both end rules.",
                .x = {.label = "wanted restitution"},
                .y = {.label = "error of the restitution"}};
  for (const EndRule rule : rules) {
    Series line{std::string{name_of(rule)}, {}, {}, Style::lines};
    double largest = 0.0, at = 0.0;
    for (int i = 10; i <= 100; ++i) {
      const double e = 0.01 * i;
      const double error = reference::restitution(std::max(0.0, polynomial(e) / std::sqrt(5.0)), same(rule)) - e;
      line.add(e, error);
      if (std::abs(error) > std::abs(largest)) largest = error, at = e;
    }
    figure.series.push_back(line);
    Hertz law = hertz(HertzDashpot::tsuji, rule);
    law.damping = polynomial(at) * std::sqrt(4.0 / 3.0 * modulus * radius * mass);
    findings.expect(fmt::format("largest error of e by the polynomial, run less exact, {}", name_of(rule)),
                    rebound(law, speed, findings) - (at + largest), 0.0, by_tolerance(speed));
    findings.note(fmt::format("The polynomial's largest error of $e$ with the {} end rule is {:+.3f}, at $e$ = {:.2f}.",
                              name_of(rule), largest, at));
  }
  findings.figure(figure);
}

// --- speed ----------------------------------------------------------------------------------------------------------

void check_speeds(Findings& findings) {
  Figure figure{.name = "speeds",
                .title = "Restitution against the speed",
                .caption = "Dashpots set for e = 0.6 at the speed 0.6. Points: the solver; lines: references.",
                .x = {.label = "speed of approach", .log = true},
                .y = {.label = "restitution"}};
  Hertz tsuji = hertz(HertzDashpot::tsuji, EndRule::clamped),
        constant = hertz(HertzDashpot::constant, EndRule::clamped);
  HuntCrossley hysteresis = hunt_crossley(1.5);
  tsuji.set_restitution(0.6, mass, speed), constant.set_restitution(0.6, mass, speed);
  hysteresis.set_restitution(0.6, mass, speed);
  const auto exact_constant = [&](double v) {
    const double g = constant.damping * impact_length(hertz_factor, 1.5, v) / (mass * v);
    return reference::constant_dashpot_events(g, reference::EndRule::clamped).restitution;
  };
  const auto exact_hysteresis = [&](double v) {
    return reference::hunt_crossley_restitution(hysteresis.hysteresis * v);
  };
  const auto compare = [&](const std::string& name, const ContactLaw& law, const auto& exact) {
    Series points{name, {}, {}, Style::points}, line{name + ", exact", {}, {}, Style::lines};
    double worst = 0.0;
    for (const double v : {0.02, 0.1, 0.6, 3.0, 15.0}) {
      const double found = rebound(law, v, findings);
      points.add(v, found);
      keep_worst(worst, found / exact(v) - 1.0);
    }
    for (int i = 0; i <= 60; ++i) {
      const double v = 0.02 * std::pow(750.0, i / 60.0);
      line.add(v, exact(v));
    }
    figure.series.push_back(points), figure.series.push_back(line);
    findings.expect({"speeds", fmt::format("restitution at five speeds, {}, largest relative error", name)}, worst, 0.0,
                    by_tolerance(0.4 * 0.02));
  };
  compare("hertz, tsuji", tsuji, [](double) { return 0.6; });
  compare("hertz, constant", constant, exact_constant);
  compare("hunt_crossley", hysteresis, exact_hysteresis);
  findings.figure(figure);
}

// --- the onset of the force, and a contact that is torn apart -------------------------------------------------------

/// Root mean square over 64 phases of the error of e with fixed steps of rk4.
Convergence fixed_steps(const ContactLaw& law, double exact, double time, const std::vector<double>& counts,
                        Findings& findings) {
  return convergence(counts, [&](double count) {
    const PhaseError error = phase_error(time, count, [&](const Phase& phase) {
      Scene scene = impact(law, speed, phase.lead() * speed);
      const RunPlan plan{phase.step, 3.0 * time, phase.step, false, MonitorRules::off()};
      return run_scene(scene, RungeKutta4{}, plan, findings).state.v[1] / speed / exact - 1.0;
    });
    return std::pair{1.0 / count, error.rms()};
  });
}

void check_orders(Findings& findings, const Setup& setup) {
  const std::vector<double> counts = doublings(16.0, setup.coarse ? 3 : 5);
  Figure figure{
      .name = "orders",
      .title = "Error of the restitution of fixed steps",
      .caption =
          "Error of rk4 at e = 0.6, root mean square over 64 phases, each with a different step. The linear dashpot's "
          "force jumps at touch; Hunt & Crossley's begins like $x^n$.",
      .x = {.label = "step / contact time", .log = true},
      .y = {.label = "relative error of e", .log = true},
      .slopes = {{1.0, 1.0 / 64.0, 6e-3, "h"}, {2.0, 1.0 / 64.0, 6e-5, "h^2"}, {2.5, 1.0 / 64.0, 3e-6, "h^(5/2)"}}};
  const auto expect = [&](const std::string& name, const ContactLaw& law, double time, double low, double high,
                          const char* why) {
    const Convergence found = fixed_steps(law, 0.6, time, counts, findings);
    findings.expect_order({"integrator.rk4", "order of the error of e, rk4, " + name}, found, low, high, why);
    figure.series.push_back({name, found.steps(), found.errors(), Style::points});
  };
  LinearSpringDashpot linear{stiffness, 0.0, EndRule::clamped};
  linear.set_restitution(0.6, mass, speed);
  expect("linear dashpot", linear, linear.contact_time(mass, speed), 0.93, 1.07, "the force jumps at touch");
  for (const double n : {1.0, 1.5}) {
    HuntCrossley law = hunt_crossley(n);
    law.set_restitution(0.6, mass, speed);
    const double time = law.contact_time(mass, speed);
    expect(fmt::format("hunt_crossley, n = {:g}", n),
           setup.has("linear_dashpot") ? ContactLaw{linear} : ContactLaw{law}, time, n + 0.85, n + 1.15,
           "the force begins like x^n at touch and ends so: an error of h^(n+1), averaged over 64 uneven phases");
  }
  findings.figure(figure);
}

/// A contact that the body leaves faster than 1/a: the force is zero, so that the speed stays.
void check_torn_contact(Findings& findings, const Setup& setup) {
  const double away = 4.0;
  HuntCrossley law = hunt_crossley(1.5);
  law.hysteresis = (setup.has("weak_hysteresis") ? 0.5 : 2.0) / away;
  const RunPlan plan{0.01, 1.0, 0.1, true, MonitorRules::off()};
  const RunEnd end = run_scene(impact(law, -away, -0.3), make_integrator("odeint_dopri5", tight), plan, findings);
  findings.expect_exact({"torn", "speed of a disc that leaves an overlap faster than 1/a, change"},
                        end.state.v[1] - away, 0.0, "no force acts: sums of zeros");
  const double energy = stiffness * std::pow(reference_overlap, -0.5) * std::pow(0.3, 2.5) / 2.5;
  findings.expect_round_off({"torn", "energy released by it over that of the spring, deviation from 1"},
                            end.state.work[static_cast<std::size_t>(Mechanism::contact_release)] / energy - 1.0, 0.0,
                            1e-11,
                            "the overlap is a difference of positions of 1e3, rounded by 1e-13, of which the energy "
                            "takes 5/2 relative to 0.3");
}

/// A restitution is accepted up to 1, and above 0.
void check_limits(Findings& findings) {
  double wrong = 0.0;
  for (const auto& [e, accepted] : {std::pair{1.0, true}, {1e-3, true}, {0.0, false}, {-0.1, false}, {1.001, false}}) {
    for (const bool hertz : {true, false}) {
      bool refused = false;
      try {
        if (hertz) {
          (void)hertz_damping_ratio(e, HertzDashpot::tsuji, EndRule::clamped);
        } else {
          (void)hunt_crossley_damping_number(e);
        }
      } catch (const InputError&) {
        refused = true;
      }
      wrong += refused == accepted ? 1.0 : 0.0;
    }
  }
  findings.expect_exact("dashpots for a restitution at the limits that are wrongly accepted or refused", wrong, 0.0,
                        "0.001 and 1 are accepted; 0, -0.1 and 1.001 are not");
}

void run(Findings& findings, const Setup& setup) {
  if (setup.needs("at the limits")) check_limits(findings);
  if (setup.needs("restitution of")) check_targets(findings, setup);
  if (setup.needs("closed form")) check_closed_forms(findings);
  if (setup.needs("pulling formula")) check_pulling_formula(findings);
  if (setup.needs("published")) check_published_numbers(findings);
  if (setup.needs("polynomial")) check_polynomial(findings);
  if (setup.needs("five speeds")) check_speeds(findings);
  if (setup.needs("order")) check_orders(findings, setup);
  if (setup.needs("leaves") || setup.needs("released")) check_torn_contact(findings, setup);
}

}  // namespace

Case definition() {
  const std::string tsuji = "restitution of hertz, tsuji, largest relative error",
                    constant = "restitution of hertz, constant, largest relative error",
                    hysteresis = "restitution of hunt_crossley, largest relative error",
                    order = "order of the error of e, rk4, hunt_crossley, n = 1.5",
                    torn = "speed of a disc that leaves an overlap faster than 1/a, change";
  return {.id = "nonlinear_restitution",
          .title = "Restitution of Hertz and Hunt-Crossley contacts",
          .family = "B: normal contact",
          .requirements = {{"law.hertz", {tsuji, constant, "speeds", "missed_by_end_rule"}},
                           {"law.hunt_crossley", {hysteresis, "speeds", order, "torn", "missed_by_numbers"}},
                           {"regime.hunt_crossley.touching", {hysteresis, order}},
                           {"regime.hunt_crossley.released", {"torn"}},
                           {"regime.hertz.released", {tsuji}},
                           {"integrator.odeint_dopri5", {tsuji, constant, hysteresis}},
                           {"integrator.rk4", {"integrator.rk4"}}},
          .main_checks = {tsuji, constant, hysteresis, order},
          .source =
              "Hunt & Crossley 1975; Tsuji, Tanaka & Ishida 1992; Antypov & Elliott 2011; Marshall 2009; Lankarani & "
              "Nikravesh 1990; Gonthier et al. 2004; Flores et al. 2011",
          .faults = {{"pulling_formula", "damping of contacts that may pull in contacts that may not", tsuji},
                     {"mass_forgotten", "dashpot for another effective mass", tsuji},
                     {"speed_forgotten", "dashpot for another speed", constant},
                     {"hysteresis_of_1975", "first-order damping number a = 3/2 (1 - e)", hysteresis},
                     {"linear_dashpot", "a dashpot whose force jumps at touch", order},
                     {"weak_hysteresis", "a hysteresis with which the force does not vanish", torn}},
          .seconds = 3.0,
          .run = run};
}

}  // namespace talus::verification::problems::nonlinear_restitution
