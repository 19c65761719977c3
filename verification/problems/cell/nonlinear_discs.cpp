#include "solver/granular/fast_disc_system.hpp"
#include "solver/integrate/euler_cromer.hpp"
#include "solver/io/cell/read_cell.hpp"
#include "verification/problems/cell/cell_runs.hpp"
#include "verification/problems/cell/disc_row.hpp"
#include "verification/reference/impacts/hertz_impact.hpp"
#include "verification/reference/impacts/power_law_impact.hpp"
#include "verification/study/impacts/followed_impact.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::nonlinear_discs {
namespace {

// --- impacts of two discs ------------------------------------------------------------------------------------------

constexpr double disc_mass = 1.7, pair_mass = 0.5 * disc_mass, speed = 0.6, disc_radius = 8.0;
constexpr double modulus = 0.9, radius = 2.5, stiffness = 1.3, reference_overlap = 0.4;
const double hertz_factor = 4.0 / 3.0 * modulus * std::sqrt(radius);

/// A law, and what an impact of the two discs is by a reference.
template <class L>
struct Impact {
  std::string name;
  L law;
  reference::ScaledEvents exact;  ///< in units of the discs
};

/// Length (m v^2/K)^(1/(n+1)) of the impact, from the force K x^n.
double impact_length(double factor, double n) { return std::pow(pair_mass * speed * speed / factor, 1.0 / (n + 1.0)); }
reference::ScaledEvents scaled(const reference::ScaledEvents& events, double length) {
  return {events.restitution, events.contact_time * length / speed, events.largest_depth * length};
}

Impact<Hertz> tsuji_impact(double xi, EndRule rule) {
  const auto exact = reference::hertz_events({hertz_factor, xi, pair_mass, speed}, same(rule));
  return {fmt::format("hertz, tsuji, {}", name_of(rule)),
          {modulus, radius, xi * std::sqrt(20.0 / 3.0 * modulus * radius * pair_mass), rule, HertzDashpot::tsuji},
          {exact.restitution, exact.contact_time, exact.largest_depth}};
}
Impact<Hertz> constant_impact(double g, EndRule rule) {
  const double length = impact_length(hertz_factor, 1.5);
  return {fmt::format("hertz, constant, {}", name_of(rule)),
          {modulus, radius, g * pair_mass * speed / length, rule, HertzDashpot::constant},
          scaled(reference::constant_dashpot_events(g, same(rule)), length)};
}
/// For n = 1, 1.5 and 2 by integration, else in closed form: the work of the spring, X^(n+1)/(n+1) up to the largest
/// overlap, is the integral of u du/(1 + a u) over the speeds u. The contact time sets the steps only; it is that of n
/// = 2.
Impact<HuntCrossley> hunt_crossley_impact_of(double a, double n) {
  const double length = impact_length(stiffness * std::pow(reference_overlap, 1.0 - n), n);
  const bool is_integrated = n == 1.0 || n == 1.5 || n == 2.0;
  reference::ScaledEvents events = reference::hunt_crossley_events(a, is_integrated ? n : 2.0);
  if (!is_integrated) {
    events.restitution = reference::hunt_crossley_restitution(a);
    events.largest_depth = std::pow((n + 1.0) * (a - std::log1p(a)) / (a * a), 1.0 / (n + 1.0));
  }
  return {
      fmt::format("hunt_crossley, n = {:g}", n), {stiffness, reference_overlap, n, a / speed}, scaled(events, length)};
}

template <class Visit>
void for_each_impact(Visit&& visit) {
  for (const EndRule rule : {EndRule::attractive, EndRule::clamped})
    visit(tsuji_impact(0.2, rule)), visit(constant_impact(0.4, rule));
  for (const double n : {1.0, 1.5, 2.0, 2.3})
    visit(hunt_crossley_impact_of(0.6, n));
}

/// The law with an injected fault.
template <class L>
L given(L law, const Setup& setup) {
  if constexpr (std::same_as<L, Hertz>) {
    if (setup.has("dashpot_factor")) law.damping *= 1.02;
  } else {
    if (setup.has("hysteresis_factor")) law.hysteresis *= 1.001;
    if (setup.has("exponent") && law.exponent == 1.5) law.exponent = 1.6;
  }
  return law;
}

FilledRow approaching(double gap) {
  return fill({.radius = disc_radius, .mass = disc_mass, .velocity = {0.5 * speed, -0.5 * speed}, .gap = {gap}});
}

/// Errors of an impact in the disc engine, relative to the reference.
struct ImpactErrors {
  double restitution{}, depth{};
};
template <class L>
ImpactErrors errors_of(const Impact<L>& impact, const L& law, double step, double gap, Findings& findings) {
  FilledRow row = approaching(gap);
  DiscSystem system{row.shapes, {}, law, 0.25 * disc_radius};
  double deepest = 0.0;
  const bool ended = run_row(system, row, make_disc_method("velocity_verlet"), step, 100000, [&](const auto& seen) {
    seen.for_each_contact(row.discs, [&](const DiscContact& contact) { deepest = std::max(deepest, contact.depth); });
  });
  findings.count(system.evaluations());
  if (!ended) return {NAN, NAN};
  return {(row.discs.vx[1] - row.discs.vx[0]) / speed / impact.exact.restitution - 1.0,
          deepest / impact.exact.largest_depth - 1.0};
}

void check_impacts(Findings& findings, const Setup& setup) {
  const std::vector<double> counts = doublings(setup.coarse ? 100.0 : 50.0, setup.coarse ? 3 : 5);
  Figure figure{.name = "impacts",
                .title = "Error of the restitution of two discs",
                .caption = "Velocity Verlet, root mean square over 64 phases, each with a different step.",
                .x = {.label = "step / contact time", .log = true},
                .y = {.label = "relative error of e", .log = true},
                .slopes = {{1.0, 1.0 / 200.0, 2e-3, "h"}}};
  double hertz = 0.0, hunt_crossley = 0.0, depth = 0.0;
  for_each_impact([&](const auto& impact) {
    const auto law = given(impact.law, setup);
    PhaseError last_depth;
    const Convergence found = convergence(counts, [&](double count) {
      PhaseError error, deepest;
      for (const Phase& phase : offset_phases(impact.exact.contact_time, count)) {
        const ImpactErrors one = errors_of(impact, law, phase.step, phase.lead() * speed, findings);
        error.add(one.restitution), deepest.add(one.depth);
      }
      last_depth = deepest;
      return std::pair{1.0 / count, error.rms()};
    });
    if constexpr (std::same_as<decltype(law), const Hertz>) {
      findings.expect_order({"orders", "order of the error of e, " + impact.name}, found, 0.85, 1.15,
                            "a dashpot's force is evaluated with the velocity before the kick");
      keep_worst(hertz, found.errors().back());
    } else {
      const double order = impact.law.exponent + 1.0;
      findings.expect_order(
          {"orders", "order of the error of e, " + impact.name}, found, order - 0.15, order + 0.15,
          "with the velocity before the kick the force is, to first order, (1 + a v) times another spring, and e does "
          "not depend on the spring; what is left is the onset of the force, like x^n");
      keep_worst(hunt_crossley, found.errors().back());
    }
    figure.series.push_back({impact.name, found.steps(), found.errors(), Style::linespoints});
    keep_worst(depth, last_depth.rms());
  });
  findings.figure(figure);
  const double finest = 1.0 / counts.back();
  findings.expect_truncation({"restitution/hertz", "restitution of two discs, hertz, largest relative error"}, hertz,
                             0.0, 2.25 * finest, 1.0,
                             "three times the measured constant of the first-order error, 0.75");
  findings.expect_truncation(
      {"restitution/hunt_crossley", "restitution of two discs, hunt_crossley, largest relative error"}, hunt_crossley,
      0.0, 1.4 * finest * finest, 1.0, "three times the measured constant of n = 1, 0.47 (step/T)^2");
  findings.expect_truncation("largest overlap of two discs, largest relative error", depth, 0.0, 1.6 * finest, 1.0,
                             "three times the measured constant of the first-order error, 0.52: the velocity of the "
                             "dashpot is that of half a step before");
}

// --- the rigid-body engine and the fast engine -----------------------------------------------------------------------

/// Largest difference of the motion of two discs between the engines, over the distance and the speed.
template <class L>
std::array<double, 2> apart(const Impact<L>& impact, const Setup& setup, Findings& findings) {
  const double step = impact.exact.contact_time / 60.382, gap = 0.37 * step * speed;
  FilledRow row = approaching(gap);
  SceneBuilder builder{si};
  const auto disc = [&](std::size_t i) {
    return builder.add_particle(fmt::format("disc{}", i), disc_mass, {row.discs.x[i], row.discs.y[i]},
                                Circle{disc_radius});
  };
  const BodyId a = disc(0), b = disc(1);
  builder.add_contact("touch", a, b, given(impact.law, setup));
  const Model model = builder.build();
  State state = rest_state(model);
  set_velocity(model, state, a, {row.discs.vx[0], 0.0}, 0.0),
      set_velocity(model, state, b, {row.discs.vx[1], 0.0}, 0.0);
  const Dynamics dynamics{model};
  RigidBodySystem rigid{dynamics};
  rigid.begin(state);
  FastDiscSystem fast{row.shapes, {}, impact.law, 0.25 * disc_radius};
  fast.keep_work();
  Discs discs = row.discs;
  fast.begin(discs);
  const EulerCromer method;
  std::array<double, 2> maximum{};
  for (long n = 0; n < 150; ++n) {
    method.step(rigid, state, step);
    fast.kick(discs, step), fast.drift(discs, step);
    for (std::size_t i = 0; i < 2; ++i) {
      keep_worst(maximum[0], (discs.x[i] - state.q[2 * i]) / disc_radius);
      keep_worst(maximum[0], (discs.vx[i] - state.v[2 * i]) / speed);
    }
  }
  findings.count(300);
  const double initial_energy = 0.5 * pair_mass * speed * speed;
  for (std::size_t k = 0; k < mechanism_count; ++k)
    keep_worst(maximum[1], (discs.work[k] - state.work[k]) / initial_energy);
  if (discs.dissipated() < 0.1 * initial_energy) maximum[1] = NAN;  // nothing to compare
  return maximum;
}

void check_engines(Findings& findings, const Setup& setup) {
  double motion = 0.0, work = 0.0;
  for_each_impact([&](const auto& impact) {
    const auto found = apart(impact, setup, findings);
    keep_worst(motion, found[0]), keep_worst(work, found[1]);
  });
  const char* const why =
      "both round positions of 8 to 1e-15, a hundredth of which is the overlap; the forces of some sixty steps differ "
      "by 1e-13 of themselves, and their sums by no more";
  findings.expect_round_off("motion of two discs, fast disc engine less rigid bodies", motion, 0.0, 1e-12, why);
  findings.expect_round_off("energy dissipated and released, fast disc engine less rigid bodies", work, 0.0, 1e-12,
                            why);
}

// --- a sheared cell --------------------------------------------------------------------------------------------------

constexpr double cell_modulus = 7e8, cell_radius = 2.5e-4;

/// The cell of `talus cell`, with this law.
ShearCell cell_of(const std::string& law) {
  const std::string text = "units = \"SI\"\n[cell]\n" + law +
                           "diameter = \"1 mm\"\nmass = \"7.2e-7 kg\"\ngravity = \"9.81 m/s^2\"\noverburden = \"8 "
                           "kPa\"\nrows = 8\ncolumns = 10\nwall_discs = 11\nblock_speed = \"5 m/s\"\nseed = "
                           "1\n[run]\nstep = \"0.1 us\"\nevery = \"1 ms\"\nend = \"10 ms\"\n";
  return read_cell(text, "cell.toml", {}).cell;
}
const std::string hertz_text = "law = \"hertz\"\nmodulus = \"700 MPa\"\nradius = \"0.25 mm\"\n";
const std::string hunt_text = "law = \"hunt_crossley\"\nstiffness = \"45 kN/m\"\nreference_overlap = \"0.01 mm\"\n";

/// Energy of the springs at the present overlaps, of contacts that act [F L].
double stored_energy(const ShearCell& cell, const CellRun& run, const Setup& setup) {
  double sum = 0.0;
  for (const CellRun::ActingContact& contact : run.acting_contacts()) {
    const double d = contact.depth;
    if (std::holds_alternative<Hertz>(cell.law)) {
      const double force = 4.0 / 3.0 * cell_modulus * std::sqrt(cell_radius) * std::pow(d, 1.5);
      sum += (setup.has("energy_of_a_linear_spring") ? 0.5 : 0.4) * force * d;
    } else {
      sum += 4.5e4 * d * std::sqrt(d / 1e-5) * d / 2.5;
    }
  }
  return sum;
}

void check_cells(Findings& findings, const Setup& setup) {
  struct Of {
    std::string name, text;
  };
  const std::array laws{Of{"hertz, tsuji", hertz_text + "restitution = 0.7\n"},
                        Of{"hertz, constant", hertz_text + "dashpot = \"constant\"\nrestitution = 0.7\n"},
                        Of{"hunt_crossley", hunt_text + "exponent = 1.5\nrestitution = 0.7\n"}};
  for (const Of& of : laws) {
    const ShearCell cell = cell_of(of.text);
    double stored = 0.0, largest = 0.0;
    Convergence balance;
    for (const double steps : doublings(60.0, setup.coarse ? 2 : 3)) {
      CellPlan plan = cell_plan(cell, 4e-3, steps, 20);
      plan.integrator = "velocity_verlet";  // contacts and ledger are at the same positions
      CellRun run{cell, plan};
      while (!run.finished() && run.failure().empty()) {
        run.advance();
        const double now = run.ledger().stored, exact = stored_energy(cell, run, setup);
        largest = std::max(largest, exact);
        keep_worst(stored, now - exact);
      }
      findings.count(run.evaluations());
      const CellRun::Ledger ledger = run.ledger();
      double missing = ledger.spurious_gain;
      if (setup.has("dissipation_not_booked")) missing -= 0.1 * ledger.dissipated;
      balance.add(1.0 / steps, std::abs(missing) / ledger.dissipated);
    }
    std::visit([](const auto& law) { record_use(law); }, cell.law);
    findings.expect_round_off(
        {"cells", "energy stored in contacts of a cell, " + of.name + ", less that of the formula"}, stored / largest,
        0.0, 1e-12, "the same overlaps; powers and products of a few roundings each");
    findings.expect_truncation(
        {"cells", "energy balance error of a cell over the energy dissipated, " + of.name}, balance.errors().back(),
        0.0, 0.6 / (setup.coarse ? 120.0 : 240.0), 1.0,
        "powers are evaluated with the velocities before a kick: (w h)/10 of the energy of an impact, w h = pi/n with "
        "n steps in a contact, times two for contacts that are shorter than that at the nominal speed");
  }
}

/// Restitution of a cell by the reference, at the speed of neighbouring rows at the start or at the one that it names.
void check_speeds(Findings& findings, const Setup& setup) {
  const double m = 3.6e-7, rows_apart = 5.0 / 9.0;
  double worst = 0.0;
  for (const double named : {0.0, 0.8}) {
    const std::string at = named > 0.0 ? fmt::format("impact_speed = \"{} m/s\"\n", named) : "";
    double v = named > 0.0 ? named : rows_apart;
    if (setup.has("speed_of_the_block")) v = 5.0;
    for (const double e : {0.8, 0.5}) {
      const std::string wanted = fmt::format("restitution = {}\n", e) + at;
      const ShearCell constant = cell_of(hertz_text + "dashpot = \"constant\"\n" + wanted);
      const double factor = 4.0 / 3.0 * cell_modulus * std::sqrt(cell_radius);
      const double length = std::pow(m * v * v / factor, 0.4);
      const double g = std::get<Hertz>(constant.law).damping * length / (m * v);
      keep_worst(worst, reference::constant_dashpot_events(g, reference::EndRule::clamped).restitution / e - 1.0);
      keep_worst(worst, constant.restitution() / e - 1.0);
      const ShearCell hunt = cell_of(hunt_text + "exponent = 1.5\n" + wanted);
      const double a = std::get<HuntCrossley>(hunt.law).hysteresis * v;
      keep_worst(worst, reference::hunt_crossley_restitution(a) / e - 1.0);
      const auto events = reference::hunt_crossley_events(a, 1.5);
      const double own = std::pow(m * v * v / (4.5e4 / std::sqrt(1e-5)), 0.4);
      keep_worst(worst, hunt.contact_time() / (events.contact_time * own / v) - 1.0);
    }
  }
  findings.expect_model(
      {"nominal_speed", "restitution and contact time of a cell at its nominal speed, largest relative error"}, worst,
      0.0, 5e-14,
      "accuracy to which solver and references integrate, and to which the solver finds the dashpot of a restitution");
}

/// Stiffnesses of a cell by Hertz and Mindlin at the larger of two overlaps: of an impact at the nominal speed, which
/// stores m v^2/2 = 8/15 E sqrt(R) d^(5/2), and of a disc below the block, 8 kPa on the square of its diameter.
void check_stiffnesses(Findings& findings, const Setup& setup) {
  constexpr double shear_modulus = 3e8, m = 3.6e-7, load = 8e3 * 1e-6;
  double secant = 0.0, tangent = 0.0;
  for (const double speed : {0.8, 0.02}) {
    const ShearCell cell =
        cell_of(hertz_text + fmt::format("damping = \"0 N s/m\"\nimpact_speed = \"{} m/s\"\nfriction = 0.5\n"
                                         "shear_law = \"mindlin\"\nshear_modulus = \"{} Pa\"\n",
                                         speed, shear_modulus));
    const double by_weight = std::pow(0.75 * load / (cell_modulus * std::sqrt(cell_radius)), 2.0 / 3.0),
                 by_impact = std::pow(15.0 / 16.0 * m * speed * speed / (cell_modulus * std::sqrt(cell_radius)), 0.4);
    const double overlap = setup.has("weight_alone") ? by_weight : std::max(by_weight, by_impact);
    const double root = std::sqrt(cell_radius * overlap);
    keep_worst(secant, cell.stiffness() / (4.0 / 3.0 * cell_modulus * root) - 1.0);
    keep_worst(secant, cell.shear_stiffness() / (8.0 * shear_modulus * root) - 1.0);
    keep_worst(tangent, cell.largest_stiffness() / (2.0 * cell_modulus * root) - 1.0);
  }
  findings.expect_round_off(
      {"stiffnesses/secant",
       "stiffness of a cell by weight and by impact, normal and tangential, largest relative error"},
      secant, 0.0, 1e-13, "powers of some ten roundings; the overlap of the weight is found by bisection to 1e-21 m");
  findings.expect_truncation(
      {"stiffnesses/tangent", "largest stiffness of a cell by weight and by impact, relative error"}, tangent, 0.0,
      std::pow(0.5, 28) / 24.0, 1.5,
      "a difference quotient of d^(3/2) over 2^-14 of d on both sides: the third derivative");
}

void run(Findings& findings, const Setup& setup) {
  if (setup.needs("restitution of two discs") || setup.needs("largest overlap") || setup.needs("order of"))
    check_impacts(findings, setup);
  if (setup.needs("less rigid bodies")) check_engines(findings, setup);
  if (setup.needs("of a cell, ") || setup.needs("of a cell over")) check_cells(findings, setup);
  if (setup.needs("nominal speed")) check_speeds(findings, setup);
  if (setup.needs("by weight and by impact")) check_stiffnesses(findings, setup);
}

}  // namespace

Case definition() {
  const std::string hertz = "restitution/hertz", hunt_crossley = "restitution/hunt_crossley",
                    motion = "motion of two discs, fast disc engine less rigid bodies",
                    stored = "energy stored in contacts of a cell, hertz, tsuji, less that of the formula",
                    balance = "energy balance error of a cell over the energy dissipated, hertz, tsuji",
                    at_speed = "nominal_speed", at_overlap = "stiffnesses/secant";
  return {.id = "nonlinear_discs",
          .title = "Hertz and Hunt-Crossley contacts of discs",
          .family = "the shear cell",
          .requirements = {{"law.hertz", {hertz, "orders", motion, "cells", at_speed, "stiffnesses"}},
                           {"law.hunt_crossley", {hunt_crossley, "orders", motion, "cells", at_speed}}},
          .main_checks = {hertz, hunt_crossley, motion, stored, balance, at_speed},
          .source = "Hertz 1882; Hunt & Crossley 1975; Tsuji, Tanaka & Ishida 1992; Antypov & Elliott 2011",
          .faults = {{"dashpot_factor", "dashpots stronger by a fiftieth", hertz},
                     {"hysteresis_factor", "hysteresis larger by a thousandth", hunt_crossley},
                     {"exponent", "exponent 1.6 for 1.5 in rigid bodies", motion},
                     {"energy_of_a_linear_spring", "stored energy of half the force times the overlap", stored},
                     {"dissipation_not_booked", "a tenth of the dissipation omitted", balance},
                     {"speed_of_the_block", "impacts at the speed of the block", at_speed},
                     {"weight_alone", "the overlap of the weight where an impact overlaps further", at_overlap}},
          .run = run};
}

}  // namespace talus::verification::problems::nonlinear_discs
