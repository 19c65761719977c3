#include <span>

#include "solver/laws/latching_spring.hpp"
#include "verification/problems/cell/disc_row.hpp"
#include "verification/reference/many_bodies/latching_chain.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::recontact_history {
namespace {

/// Resets the largest overlap when the force falls to zero, not when the discs separate: the soft branch restarts in
/// the middle of the overlap, with a sudden force.
struct ForgettingLatch : LatchingSpring {
  explicit ForgettingLatch(const LatchingSpring& law) : LatchingSpring{law} {}
  constexpr Reset reset(Kinematics x, std::span<double> memory, Mode mode) const {
    const Reset next = LatchingSpring::reset(x, memory, mode);
    if (next.mode == slack) memory[0] = 0.0;
    return next;
  }
};

/// Ends the contact when the force falls to zero: no force acts until the discs have separated.
struct ClearedLatch : LatchingSpring {
  explicit ClearedLatch(const LatchingSpring& law) : LatchingSpring{law} {}
  constexpr Reset reset(Kinematics x, std::span<double> memory, Mode mode) const {
    if (mode == slack && x.deformation > 0.0) return {slack, 0.0};
    return LatchingSpring::reset(x, memory, mode);
  }
};

/// Never resets the largest overlap: when separated discs meet again, the force restarts at the overlap where it
/// vanished.
struct RetentiveLatch : LatchingSpring {
  explicit RetentiveLatch(const LatchingSpring& law) : LatchingSpring{law} {}
  constexpr Reset reset(Kinematics x, std::span<double> memory, Mode mode) const {
    const double left_off = memory[0] * (1.0 - stiffness / unloading_stiffness);
    if (mode == slack && x.deformation <= left_off) return {slack, 0.0};
    return LatchingSpring::reset(x, memory, mode);
  }
};

const LatchingSpring law{0.5, 0.5 / 0.49, 0.0};
constexpr std::array<double, 3> speeds{3.0, 1.0, 0.0};
constexpr std::size_t gaps_of_each = 24;

/// Branch on which the second blow falls, with its range of gaps.
struct Moment {
  const char* name;
  double first, last;  ///< gaps
};
constexpr std::array moments{Moment{"unloading", 2.6, 4.2}, Moment{"slack", 4.5, 6.4}, Moment{"separated", 6.9, 10.0}};

double gap_of(const Moment& moment, std::size_t k) {
  return moment.first + (moment.last - moment.first) * (static_cast<double>(k) + 0.5) / gaps_of_each;
}

double contact_time() { return 0.5 * std::numbers::pi * 1.7; }

reference::ChainRebound exact_of(double gap) {
  return reference::chain_rebound(
      {law.stiffness, law.unloading_stiffness, 1.0, {speeds.begin(), speeds.end()}, {gap, 0.0}});
}

/// Row in which disc 2 touches disc 3 after the time `lead`, with the gap `gap` between 1 and 2 at that time.
FilledRow row_of(double gap, double lead) {
  return fill({.radius = 8.0,
               .velocity = {speeds.begin(), speeds.end()},
               .gap = {gap + lead * (speeds[0] - speeds[1]), lead * speeds[1]}});
}

struct Watched {
  std::array<double, 3> velocity{};
  std::vector<double> depth, force;  ///< of the contact of the second and third disc
};

template <class L>
Watched run_by(const L& by, double gap, double step, double phase, Findings& findings, double skin = row_skin) {
  FilledRow row = row_of(gap, phase * step);
  DiscSystem<L> system{row.shapes, {}, by, skin};
  Watched watched;
  const auto maximum = static_cast<long>(30.0 * contact_time() / step);
  (void)run_row(system, row, make_disc_method("velocity_verlet"), step, maximum, [&](const auto& seen) {
    seen.for_each_contact(row.discs, [&](const auto& contact) {
      if (contact.a != 1 || contact.depth < 0.0) return;
      watched.depth.push_back(contact.depth), watched.force.push_back(contact.force);
    });
  });
  findings.count(system.evaluations());
  std::copy(row.discs.vx.begin(), row.discs.vx.end(), watched.velocity.begin());
  return watched;
}

Watched run_right_or_wrong(double gap, double step, double phase, Findings& findings, const Setup& setup) {
  if (setup.has("forgotten_at_zero_force")) return run_by(ForgettingLatch{law}, gap, step, phase, findings);
  if (setup.has("ended_at_zero_force")) return run_by(ClearedLatch{law}, gap, step, phase, findings);
  if (setup.has("never_forgotten")) return run_by(RetentiveLatch{law}, gap, step, phase, findings);
  LatchingSpring given = law;
  if (setup.has("way_back_softer")) given.unloading_stiffness *= 0.99;
  return run_by(given, gap, step, phase, findings);
}

/// Exact results by moment and gap.
using Exact = std::array<std::array<reference::ChainRebound, gaps_of_each>, moments.size()>;

Exact exact_of_all() {
  Exact exact;
  for (std::size_t m = 0; m < moments.size(); ++m) {
    for (std::size_t k = 0; k < gaps_of_each; ++k)
      exact[m][k] = exact_of(gap_of(moments[m], k));
  }
  return exact;
}

/// Largest error of the three speeds for each gap of a moment; each gap has a different phase.
PhaseError errors_of(const Exact& exact, std::size_t m, double steps, Findings& findings, const Setup& setup) {
  PhaseError found;
  for (std::size_t k = 0; k < gaps_of_each; ++k) {
    const Watched seen = run_right_or_wrong(gap_of(moments[m], k), offset_step(contact_time(), steps, k),
                                            golden_phases(gaps_of_each)[k], findings, setup);
    double worst = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double error = std::abs(seen.velocity[i] - exact[m][k].velocity[i]);
      keep_worst(worst, error);
    }
    found.add(worst);
  }
  return found;
}

/// Whether the second blow of the reference falls on the branch that the moment is named after, for all of its gaps.
bool strikes(const Exact& exact, std::size_t m) {
  return std::all_of(exact[m].begin(), exact[m].end(), [&](const reference::ChainRebound& one) {
    const std::string line = one.reloads_from_slack > 0 ? "slack" : one.reloads > 0 ? "unloading" : "separated";
    return line == moments[m].name;
  });
}

void check_moments(const Exact& exact, Findings& findings, const Setup& setup) {
  bool all = true;
  for (std::size_t m = 0; m < moments.size(); ++m) {
    all = all && strikes(exact, m);
    findings.expect_truncation(
        {fmt::format("speeds/{}", moments[m].name),
         fmt::format("final speeds of three discs, second impact while {}, largest error over 24 gaps",
                     moments[m].name)},
        errors_of(exact, m, 60.0, findings, setup).max(), 0.0, 16.0 * 3.3e-5, 1.5,
        "steps a quarter as long had errors of 2.5e-5 to 3.3e-5, which second order scales by 16; half as much again "
        "is allowed for the position of the kinks within a step");
  }
  findings.expect_true("second impact on the intended branch at every gap", all,
                       "the reference counts reloadings, and reloadings from slack, for each of the 72 gaps");
}

void check_order(const Exact& exact, Findings& findings, const Setup& setup) {
  Convergence found;
  for (const double n : doublings(30.0, 4)) {
    double squares = 0.0;
    for (std::size_t m = 0; m < moments.size(); ++m)
      squares += std::pow(errors_of(exact, m, n, findings, setup).rms(), 2) / moments.size();
    found.add(1.0 / n, std::sqrt(squares));
  }
  findings.expect_order("order of the final speeds, 72 gaps", found, 1.85, 2.15,
                        "forces are continuous, but their slopes jump where the branch changes, an error of order h^2");
}

/// Final speeds for one gap, in a run that is saved and restored into another system every `every` steps. `dropped`:
/// the restored system restarts without memory.
std::array<double, 3> restarted(double gap, double step, long every, bool dropped) {
  FilledRow row = row_of(gap, 0.3 * step);
  using Method = VelocityVerletOf<Discs>;
  Method method;
  DiscSystem system{row.shapes, {}, law, row_skin};
  system.begin(row.discs);
  method.start(system, row.discs, step);
  const auto maximum = static_cast<long>(30.0 * contact_time() / step);
  for (long n = 1; n <= maximum && !over(system, row.discs); ++n) {
    method.step(system, row.discs, step);
    if (n % every != 0) continue;
    Archive saved;
    const auto name_all = [](Archive& archive, Discs& discs, auto& of, Method& by) {
      archive.scope("discs", [&] { serialize(archive, discs); });
      archive.scope("system", [&] { of.serialize(archive, discs); });
      archive.scope("method", [&] { by.serialize(archive, discs); });
    };
    name_all(saved, row.discs, system, method);
    FilledRow next = row_of(gap, 0.0);
    DiscSystem other{row.shapes, {}, law, row_skin};
    Method again;
    Archive put_back{saved.items()};
    name_all(put_back, next.discs, other, again);
    if (dropped) other.begin(next.discs), again.start(other, next.discs, step);
    row.discs = next.discs, system = other, method = again;
  }
  return {row.discs.vx[0], row.discs.vx[1], row.discs.vx[2]};
}

constexpr double step_of_restarts() { return 0.5 * std::numbers::pi * 1.7 / 60.382; }
constexpr std::array gaps_of_restarts{3.4, 5.5, 8.0};

void check_restarts(Findings& findings, const Setup& setup) {
  double differ = 0.0;
  for (const double gap : gaps_of_restarts) {
    const auto through = restarted(gap, step_of_restarts(), 1000000, false);
    for (const long every : {1L, 7L, 20L}) {
      const auto seen = restarted(gap, step_of_restarts(), every, setup.has("memory_dropped_at_restart"));
      for (std::size_t i = 0; i < 3; ++i)
        differ += seen[i] == through[i] ? 0.0 : 1.0;
    }
  }
  findings.expect_exact({"restarts", "final speeds that differ after restarts every 1, 7 or 20 steps, out of 27"},
                        differ, 0.0, "the restored state is bit-identical to the saved one");
}

/// Final speeds of two discs, the first of which hits the second, by a law or a mistaken one.
template <class L>
std::array<double, 2> single_impact(const L& by, Findings& findings) {
  const double step = step_of_restarts();
  FilledRow row = fill({.radius = 8.0, .velocity = {1.0, 0.0}, .gap = {0.3 * step}});
  DiscSystem<L> system{row.shapes, {}, by, row_skin};
  const auto maximum = static_cast<long>(30.0 * contact_time() / step);
  (void)run_row(system, row, make_disc_method("velocity_verlet"), step, maximum, [](const auto&) {});
  findings.count(system.evaluations());
  return {row.discs.vx[0], row.discs.vx[1]};
}

/// The mistakes that only a second impact reveals, and for comparison one that a single impact reveals.
void check_single_impacts(Findings& findings) {
  const auto right = single_impact(law, findings);
  double differ = 0.0;
  for (const auto& wrong : {single_impact(ClearedLatch{law}, findings), single_impact(RetentiveLatch{law}, findings)}) {
    for (std::size_t i = 0; i < 2; ++i)
      differ += wrong[i] == right[i] ? 0.0 : 1.0;
  }
  const auto group = findings.in("single_impacts");
  group->expect("single impact: final speeds that differ if the contact ends at F = 0 or M is never reset, out of 4",
                differ, 0.0,
                Tolerance::exact("both mistakes change the force only after it has vanished, and discs that separate "
                                 "do not meet again"));
  group->expect_between(
      "single impact: change of the second speed if M is reset at F = 0",
      single_impact(ForgettingLatch{law}, findings)[1] - right[1], 0.04, 0.06,
      "each reset returns the fraction 0.49 of the energy of K1 at the overlap where the force vanished, 0.51 of "
      "the one before: e^2 = 0.49/(1 - 0.51^2), and (1 + e)/2 grows from 0.85 by 0.057; each restart is late by up to "
      "a step, with a force of 0.255 and less, which reduces this by up to 0.011 in all");
}

/// Skin so wide that discs do not leave it: a list that drops a pair would also drop its memory.
constexpr double wide = 8.0;

void show_mistakes(Findings& findings) {
  Table table{.name = "mistakes",
              .caption =
                  "Final speed of the third disc at 60 steps in a contact, with the second impact while unloading, "
                  "slack and separated. M: largest overlap.",
              .columns = {"g", "exact", "solver", "M reset at F = 0", "contact ended at F = 0", "M never reset",
                          "M lost every 20 steps"}};
  const auto third = [](const Watched& seen) { return fmt::format("{:.4f}", seen.velocity[2]); };
  for (const double gap : gaps_of_restarts) {
    const double h = step_of_restarts();
    table.rows.push_back(
        cells("{} | {:.4f} | {} | {} | {} | {} | {:.4f}", gap, exact_of(gap).velocity[2],
              third(run_by(law, gap, h, 0.3, findings)), third(run_by(ForgettingLatch{law}, gap, h, 0.3, findings)),
              third(run_by(ClearedLatch{law}, gap, h, 0.3, findings)),
              third(run_by(RetentiveLatch{law}, gap, h, 0.3, findings, wide)), restarted(gap, h, 20, true)[2]));
  }
  findings.table(table);
}

void draw_speeds(Findings& findings) {
  Series line{"exact", {}, {}, Style::lines}, solver{"solver", {}, {}, Style::points};
  Series forgotten{"M reset at F = 0", {}, {}, Style::lines};
  Series kept{"M never reset", {}, {}, Style::lines};
  const double h = step_of_restarts();
  int i = 0;
  for (double gap = 2.0; gap < 10.0; gap += 0.05, ++i) {
    const auto add = [&](Series& to, double speed) { to.add(gap, speed); };
    add(line, exact_of(gap).velocity[2]);
    add(forgotten, run_by(ForgettingLatch{law}, gap, h, 0.3, findings).velocity[2]);
    add(kept, run_by(RetentiveLatch{law}, gap, h, 0.3, findings, wide).velocity[2]);
    if (i % 4 == 0) add(solver, run_by(law, gap, h, 0.3, findings).velocity[2]);
  }
  findings.figure({.name = "speed_of_the_third",
                   .title = "Final speed of the third disc against the gap",
                   .caption = "Exact solution, solver, and two faulty treatments of the largest overlap $M$. Ending "
                              "the contact at $F = 0$ is exact except for impacts while slack, which then give 0.85.",
                   .x = {.label = "gap between discs 1 and 2 when 2 touches 3"},
                   .y = {.label = "final speed of the third disc", .min = 2.2, .max = 2.65},
                   .series = {line, forgotten, kept, solver}});
}

void draw_loops(Findings& findings) {
  std::vector<Series> all;
  for (const double gap : gaps_of_restarts) {
    const Watched seen = run_by(law, gap, step_of_restarts() / 4.0, 0.3, findings);
    all.push_back({fmt::format("g = {}", gap), seen.depth, seen.force, Style::lines});
  }
  findings.figure({.name = "force_against_overlap",
                   .title = "Contact between the second and third disc",
                   .caption = "Force against overlap, with the second impact while unloading, slack and separated.",
                   .x = {.label = "overlap"},
                   .y = {.label = "force"},
                   .series = all});
}

void run(Findings& findings, const Setup& setup) {
  const Exact exact = exact_of_all();
  check_moments(exact, findings, setup);
  check_restarts(findings, setup);
  if (setup.coarse) return;
  check_order(exact, findings, setup);
  check_single_impacts(findings);
  show_mistakes(findings);
  draw_speeds(findings);
  draw_loops(findings);
}

}  // namespace

Case definition() {
  return {
      .id = "recontact_history",
      .title = "Repeated impacts of latching discs",
      .family = "the shear cell",
      .requirements = {{"B16",
                        {"speeds", "single_impacts",
                         "final speeds that differ after restarts every 1, 7 or 20 steps, out of 27"}},
                       {"F5", {"final speeds that differ after restarts every 1, 7 or 20 steps, out of 27"}},
                       {"law.latching_spring", {"speeds"}},
                       {"regime.latching_spring.unloading", {"speeds/unloading"}},
                       {"regime.latching_spring.slack", {"speeds/slack"}},
                       {"regime.latching_spring.loading", {"speeds/separated"}}},
      .main_checks = {"speeds/unloading", "speeds/slack", "speeds/separated", "restarts"},
      .source = "Walton & Braun 1986",
      .faults = {{"forgotten_at_zero_force", "largest overlap M reset when the force vanishes", "speeds/slack"},
                 {"ended_at_zero_force", "contact ended when the force vanishes", "speeds/slack"},
                 {"never_forgotten", "largest overlap M retained after the discs have separated", "speeds/separated"},
                 {"way_back_softer", "K2 1 % smaller", "speeds/unloading"},
                 {"memory_dropped_at_restart", "contact memory lost at each restart", "restarts"}},
      .run = run};
}

}  // namespace talus::verification::problems::recontact_history
