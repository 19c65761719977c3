#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>
#include <vector>

#include "solver/granular/disc_method.hpp"
#include "solver/granular/disc_system.hpp"
#include "solver/granular/fast_disc_system.hpp"
#include "solver/io/cell/read_cell.hpp"
#include "solver/io/cell/write_cell.hpp"
#include "verification/check/case.hpp"
#include "verification/check/convergence.hpp"
#include "verification/reference/friction/mindlin_impact.hpp"
#include "verification/study/findings/expectations.hpp"
#include "verification/study/findings/predicted_errors.hpp"
#include "verification/study/runs/phases.hpp"
#include "verification/study/runs/usage.hpp"

namespace talus::verification::problems::mindlin_discs {
namespace {

/// Discs of mass 2 that meet at the speed 1, with K = 1: lengths, times and forces are those of the reference. R is not
/// 1, so that a lost radius shows.
constexpr double disc_mass = 2.0, mu = 0.3, contact_radius = 2.5;
/// 1 + m r^2/I of a solid disc.
constexpr double mobility = 3.0;
/// Radius of the discs [L]. The overlap shortens the arms of friction by d/2 and the normal turns by u t/2r: results
/// are extrapolated from this radius and twice this radius.
constexpr double disc_radius = 1e4;

const Hertz hertz{0.75 / std::sqrt(contact_radius), contact_radius};

/// A law of friction without rescaling: the force stays while its stiffness falls.
struct Unrescaled : Mindlin {
  double stretch_after(double stretch, double slip_rate, Kinematics x, double h) const {
    const double before = x.deformation - 0.5 * h * x.deformation_rate, after = before + h * x.deformation_rate;
    if (!(before > 0.0 && after > 0.0) || x.deformation_rate > 0.0)
      return Mindlin::stretch_after(stretch, slip_rate, x, h);
    return stretch * std::sqrt(before / after) + h * slip_rate;
  }
};

Mindlin friction(double kappa, const Setup& setup) {
  const double modulus = kappa / (8.0 * std::sqrt(contact_radius));
  return {setup.has("friction_factor") ? 1.01 * mu : mu, setup.has("modulus_factor") ? 1.01 * modulus : modulus,
          contact_radius};
}

reference::MindlinImpact impact_of(double kappa, double ratio) {
  reference::MindlinImpact impact{kappa, mu, mobility, 0.0};
  impact.slip_rate = ratio * reference::first_stick_ratio(impact);
  return impact;
}

// --- impacts --------------------------------------------------------------------------------------------------------

/// Result of an impact of two discs.
struct Impact {
  double slip_rate{};
  double gained{};  ///< energy dissipated by friction, less that of the slip rates
  Discs end;
};

template <class System>
Impact run_impact(System system, const reference::MindlinImpact& impact, double time, const Phase& phase, double radius,
                  DiscMethod method, Findings& findings) {
  Discs discs;
  const double apart = radius + 0.5 * phase.lead();
  discs.add(-apart, 0.0, 0.5, -0.5 * impact.slip_rate), discs.add(apart, 0.0, -0.5, 0.5 * impact.slip_rate);
  std::visit(
      [&](auto& steps) {
        system.begin(discs);
        steps.start(system, discs, phase.step);
        for (double t = 0.0; t < phase.lead() + 1.1 * time; t += phase.step)
          steps.step(system, discs, phase.step);
      },
      method);
  findings.count(system.evaluations());
  const double slip = discs.vy[1] - discs.vy[0] - radius * (discs.spin[0] + discs.spin[1]);
  const double slip_energy = 0.5 * (impact.slip_rate * impact.slip_rate - slip * slip) / impact.mobility;
  return {slip, discs.work[static_cast<std::size_t>(Mechanism::friction)] - slip_energy, discs};
}

DiscShapes shapes(double radius) {
  DiscShapes both;
  both.add(radius, 1.0 / disc_mass), both.add(radius, 1.0 / disc_mass);
  return both;
}

/// The same by one engine, extrapolated to discs of any radius.
template <class System, class F>
Impact far_impact(const reference::MindlinImpact& impact, const F& law, double time, const Phase& phase,
                  const std::string& method, bool keeps, Findings& findings) {
  const auto run = [&](double radius) {
    System system{shapes(radius), {}, hertz, 1.0, law};
    if constexpr (requires { system.keep_work(); }) {
      if (keeps) system.keep_work();
    }
    return run_impact(std::move(system), impact, time, phase, radius, make_disc_method(method), findings);
  };
  const Impact one = run(disc_radius), two = run(2.0 * disc_radius);
  return {2.0 * two.slip_rate - one.slip_rate, 2.0 * two.gained - one.gained, two.end};
}

using Fast = FastDiscSystem<Hertz, Mindlin>;
using Plain = DiscSystem<Hertz, Mindlin>;

void check_impacts(Findings& findings, const Setup& setup) {
  record_use("shear_law.mindlin"), record_use(hertz);
  Figure figure{.name = "errors",
                .title = "Errors of an oblique impact of two discs",
                .caption =
                    "Error of the slip rate after the impact and of the energy that friction dissipates, root mean "
                    "square over 64 phases, for a contact that sticks until shortly before its end and one that slips "
                    "first; velocity Verlet.",
                .x = {.label = "step / contact time", .log = true},
                .y = {.label = "error", .log = true},
                .slopes = {{2.0, 1.0 / 100.0, 1e-5, "h^2"}}};
  double unlike = 0.0;
  for (const auto& [label, kappa, ratio] :
       {std::tuple{"a contact that sticks", 1.286, 0.5}, std::tuple{"a contact that slips first", 2.0, 1.5}}) {
    const reference::MindlinImpact impact = impact_of(kappa, ratio);
    const reference::MindlinRebound exact = reference::rebound(impact);
    const Mindlin law = friction(kappa, setup);
    Convergence energies;
    const Convergence slips = convergence(doublings(50.0, setup.coarse ? 3 : 5), [&](double count) {
      PhaseError slip, energy;
      for (const Phase& phase : offset_phases(exact.contact_time, count)) {
        const auto method = phase.index % 2 == 0 ? "velocity_verlet" : "central_difference";
        const Impact found = setup.has("not_rescaled")
                                 ? far_impact<DiscSystem<Hertz, Unrescaled>>(
                                       impact, Unrescaled{law}, exact.contact_time, phase, method, true, findings)
                                 : far_impact<Fast>(impact, law, exact.contact_time, phase, method,
                                                    !setup.has("work_not_kept"), findings);
        if (phase.index < 4 && !setup.has("not_rescaled")) {
          const Impact same = far_impact<Plain>(impact, law, exact.contact_time, phase, method, true, findings);
          keep_worst(unlike, worst_error(found.end.vy, same.end.vy));
          keep_worst(unlike, worst_error(found.end.spin, same.end.spin));
        }
        slip.add(found.slip_rate - exact.slip_rate);
        energy.add(found.gained);
      }
      energies.add(1.0 / count, energy.rms());
      return std::pair{1.0 / count, slip.rms()};
    });
    findings.in("impacts")->expect_order(fmt::format("order of the slip rate after an impact, {}", label), slips, 1.8,
                                         2.3, "second order, and h^(5/2) from the onset and the end of a slip");
    findings.in("energy")->expect_order(
        fmt::format("order of the energy that friction dissipates, less that of the slip rates, {}", label), energies,
        0.9, 1.2, "first order: powers are evaluated before the kick");
    figure.series.push_back({fmt::format("slip rate, {}", label), slips.steps(), slips.errors(), Style::points});
    figure.series.push_back({fmt::format("energy, {}", label), energies.steps(), energies.errors(), Style::points});
  }
  findings.in("impacts")->expect("lateral speeds and spins after impacts, plain less fast engine, largest", unlike, 0.0,
                                 Tolerance::exact("both engines give the same bits"));
  if (!setup.coarse) findings.figure(figure);
}

// --- a closed loop of load and slip ---------------------------------------------------------------------------------

constexpr double near_overlap = 0.04, far_overlap = 0.01, loop_slip = 0.001, loop_radius = 8.0;
constexpr int loop_steps = 2000;

/// Two discs so heavy that no force moves them, drawn along a path of overlap and slip. The work of friction on the
/// slip is measured from the spin that its torque would give the second disc.
template <class System>
class DrawnDiscs {
 public:
  explicit DrawnDiscs(System system) : system_{std::move(system)} {
    const double apart = loop_radius - 0.5 * near_overlap;
    discs_.add(-apart, 0.0, 0.0, 0.0), discs_.add(apart, 0.0, 0.0, 0.0);
    system_.begin(discs_);
  }
  void move(double overlap, double slip) {
    const double arm = loop_radius - 0.5 * overlap_;
    const double h = 1.0 / loop_steps, rate = overlap - overlap_, turn = (slip_ - slip) / arm;
    for (int i = 0; i < loop_steps; ++i) {
      const double before = push(rate, turn);
      system_.kick(discs_, h);
      set(rate, turn);
      system_.drift(discs_, h);
      work_ += 0.5 * h * (before + push(rate, turn)) * (slip - slip_);
    }
    overlap_ = overlap, slip_ = slip;
  }
  double work() const { return work_; }
  double dissipated() const { return discs_.work[static_cast<std::size_t>(Mechanism::friction)]; }

 private:
  void set(double rate, double turn) {
    discs_.vx = {0.5 * rate, -0.5 * rate}, discs_.vy = {0.0, 0.0}, discs_.spin = {0.0, turn};
  }
  /// Friction force on the second disc [F].
  double push(double rate, double turn) {
    set(rate, turn);
    DiscRates rates{discs_};
    const auto kept = discs_.work;
    system_.evaluate(discs_, rates);
    discs_.work = kept;
    const double overlap = 2.0 * loop_radius - (discs_.x[1] - discs_.x[0]);
    const double arm = loop_radius - 0.5 * overlap;
    return rates.spin[1] * heavy / (2.0 / (loop_radius * loop_radius) * arm);
  }

 public:
  static constexpr double heavy = 1e100;

 private:
  System system_;
  Discs discs_;
  double overlap_{near_overlap}, slip_{}, work_{};
};

template <class System, class F>
DrawnDiscs<System> loop(const F& law) {
  DiscShapes heavy;
  for (int i = 0; i < 2; ++i)
    heavy.add(loop_radius, 1.0 / DrawnDiscs<System>::heavy);
  System system{heavy, {}, hertz, 1.0, law};
  if constexpr (requires { system.keep_work(); }) system.keep_work();
  DrawnDiscs<System> drawn{std::move(system)};
  drawn.move(near_overlap, loop_slip);
  drawn.move(far_overlap, loop_slip);
  drawn.move(far_overlap, 0.0);
  drawn.move(near_overlap, 0.0);
  return drawn;
}

void check_loop(Findings& findings, const Setup& setup) {
  // So much friction that the discs never slide.
  Mindlin law = friction(1.286, setup);
  law.coefficient = 1e6;
  const double near = 1.286 * std::sqrt(near_overlap), far = 1.286 * std::sqrt(far_overlap);
  const double exact = 0.5 * (near - far) * loop_slip * loop_slip;
  const DrawnDiscs<Fast> fast = loop<Fast>(law);
  const DrawnDiscs<Plain> plain = loop<Plain>(law);
  const double unrescaled = loop<DiscSystem<Hertz, Unrescaled>>(Unrescaled{law}).work();
  const double work = setup.has("not_rescaled") ? unrescaled : fast.work();
  findings.in("loop")->expect("work of a loop of load, slip, unload, slip back, of discs, over (k_1 - k_2) s^2/2",
                              work / exact, 1.0,
                              Tolerance::round_off(5e-10,
                                                   "positions of 8 rounded to 2e-15 in 2,000 steps, for overlaps of "
                                                   "0.01 and a difference of the work of two parts"));
  findings.in("loop")->expect("work of this loop, plain less fast engine", plain.work() - fast.work(), 0.0,
                              Tolerance::exact("both engines give the same bits"));
  findings.in("loop")->expect("the same without rescaling, of discs: the loop creates this energy", unrescaled / exact,
                              -1.0, Tolerance::round_off(5e-10, "as above: its stretch is exact, too"));
  // The power (k_1/2) s^2 dd/dt/(2 sqrt(d d_1)) is summed at the beginning of each step.
  const auto power = [&](double overlap) {
    return 0.25 * 1.286 * (near_overlap - far_overlap) / std::sqrt(overlap) * loop_slip * loop_slip;
  };
  const double first_order = 0.5 / loop_steps * (power(far_overlap) - power(near_overlap)) / exact;
  findings.in("energy")->expect(
      "energy that a changing contact area dissipates in this loop, over its work", fast.dissipated() / exact, 1.0,
      Tolerance::truncation(first_order, 1.2,
                            "a sum of powers at the beginning of steps: half the difference of the "
                            "last and the first, over the number of steps"));
}

// --- a cell read from a file ----------------------------------------------------------------------------------------

/// Ten soft spheres under a block that falls on them within 0.1 ms.
std::string cell_text(bool linear, double modulus, double shear) {
  return fmt::format(R"(title = "cell"
units = "SI"
[cell]
law = "hertz"
modulus = "{} Pa"
radius = "0.25 mm"
restitution = 0.8
friction = 0.5
{}
diameter = "1 mm"
mass = "7.2e-7 kg"
gravity = "10000 m/s^2"
block_mass = "2e-5 kg"
rows = 2
columns = 5
wall_discs = 5
block_speed = "5 m/s"
seed = 3
[run]
step = "0.2 us"
every = "0.1 ms"
end = "0.4 ms"
)",
                     modulus, linear ? "" : fmt::format("shear_law = \"mindlin\"\nshear_modulus = \"{} Pa\"", shear));
}

void check_cell(Findings& findings, const Setup& setup) {
  constexpr double modulus = 1e6, shear = 4e5;
  const CellScene scene = read_cell(cell_text(setup.has("linear_friction"), modulus, shear), "cell.toml", {});
  CellRun nearest{scene.cell, scene.plan};
  CellPlan plan = scene.plan;
  plan.images = Images::virtual_discs;
  CellRun virtual_discs{scene.cell, plan};
  for (CellRun* const run : {&nearest, &virtual_discs})
    while (!run->finished())
      run->advance();
  double ratio = 0.0;
  for (const CellNumber& number : cell_groups(scene, nearest))
    if (number.name == std::string{"shear_over_normal_stiffness"}) ratio = number.estimate.value;
  findings.in("cell")->expect("k_s over F/d of a cell with Mindlin's stiffness", ratio, 6.0 * shear / modulus,
                              Tolerance::round_off(1e-14, "a quotient of two products of five factors").relative());
  const CellRun::Ledger ledger = nearest.ledger();
  findings.in("cell")->expect_between("friction work of this cell over its work", ledger.friction_work / ledger.work(),
                                      0.1, 0.9, "the discs stick and slip in many contacts");
  findings.in("cell")->expect(
      "energy balance error of this cell over its work", ledger.relative_balance_error(), 0.0,
      Tolerance::truncation(3e-4, 3.0, "first order in the step, 2.9e-4 with some 500 steps in a contact"));
  const Discs one = nearest.discs(), other = virtual_discs.discs();
  findings.in("cell")->expect(
      "spins of the discs, neighbour list less virtual discs, largest", worst_error(one.spin, other.spin), 0.0,
      Tolerance::round_off(1e-10,
                           "spins of some 1e4 rad/s rounded by 2e-12 and, through the positions "
                           "of images, in 2,000 steps"),
      "rad/s");
}

void run(Findings& findings, const Setup& setup) {
  if (setup.needs("impact") || setup.needs("order")) check_impacts(findings, setup);
  if (setup.needs("loop")) check_loop(findings, setup);
  if (setup.needs("cell")) check_cell(findings, setup);
}

}  // namespace

Case definition() {
  const std::string sticks = "order of the slip rate after an impact, a contact that sticks",
                    slips = "order of the slip rate after an impact, a contact that slips first",
                    loop = "work of a loop of load, slip, unload, slip back, of discs, over (k_1 - k_2) s^2/2",
                    energy =
                        "order of the energy that friction dissipates, less that of the slip rates, a contact that "
                        "sticks";
  return {.id = "mindlin_discs",
          .title = "Friction with Mindlin's stiffness between discs",
          .family = "C: friction and rotation",
          .requirements = {{"shear_law.mindlin", {"impacts", "energy", "loop", "cell"}}, {"law.hertz", {"impacts"}}},
          .main_checks = {sticks, loop, "energy that a changing contact area dissipates in this loop, over its work"},
          .source = "Mindlin 1949; Thornton, Cummins & Cleary 2011",
          .faults = {{"modulus_factor", "a shear modulus larger by 1 %", sticks},
                     {"friction_factor", "friction larger by 1 %", slips},
                     {"not_rescaled", "the force stays while its stiffness falls", loop},
                     {"work_not_kept", "the fast engine does not record the work", energy},
                     {"linear_friction", "a cell with a constant stiffness",
                      "k_s over F/d of a cell with Mindlin's stiffness"}},
          .seconds = 3.0,
          .run = run};
}

}  // namespace talus::verification::problems::mindlin_discs
