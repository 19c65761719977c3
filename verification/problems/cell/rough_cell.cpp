#include <sstream>

#include "solver/io/cell/lammps.hpp"
#include "verification/problems/cell/cell_runs.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::rough_cell {
namespace {

constexpr double coefficient = 0.5;  ///< of friction

ShearCell cell_with(const Setup& setup) {
  ShearCell cell = ice_cell(8e3, 5e3);
  cell.law = LinearSpringDashpot{20305.0, 0.0208981};
  cell.friction = CoulombFriction{setup.has("smooth_discs") ? 0.0 : coefficient, 14214.0};
  return cell;
}

/// The discs of the sheared cell as written for LAMMPS: number, velocity, and spin about the third axis. The export
/// of a cell by the program cannot check this, because a cell begins without spin.
void expect_export(Findings& findings, const ShearCell& cell, const FilledCell& start, const Discs& discs,
                   const Setup& setup) {
  const LammpsScene scene{start.shapes, discs, start.box, std::get<LinearSpringDashpot>(cell.law)};
  const std::string data = lammps_data(scene), heading = "Velocities\n";
  std::istringstream lines{data.substr(data.find(heading) + heading.size())};
  double differing = 0.0, turning = 0.0;
  for (std::size_t i = 0; i < discs.size(); ++i) {
    const double spin = setup.has("spin_reversed") ? -discs.spin[i] : discs.spin[i];
    for (const double exact : {static_cast<double>(i + 1), discs.vx[i], discs.vy[i], 0.0, 0.0, 0.0, spin}) {
      std::string found;
      lines >> found;
      differing += !found.empty() && std::stod(found) == exact ? 0.0 : 1.0;
    }
    turning += spin != 0.0 && spin != discs.vy[i] ? 1.0 : 0.0;
  }
  findings.expect_exact(
      {"export", "velocities and spins written for LAMMPS that differ from those of the sheared discs"},
      turning >= static_cast<double>(cell.free_discs()) ? differing : std::nan(""), 0.0,
      "17 digits restore the same double; every free disc turns");
}

void expect_balances(Findings& findings, const Setup& setup) {
  const ShearCell cell = cell_with(setup);
  constexpr double steps = 240.0;
  CellRun run{cell, cell_plan(cell, 1.5e-2, steps)};
  const Discs before = run.discs();
  run_to_end(run);
  findings.count(run.evaluations());
  const Discs after = run.discs();
  expect_export(findings, cell, run.start(), after, setup);
  Vec2 gained;
  double spin_energy = 0.0;
  for (std::size_t i = 0; i < cell.free_discs(); ++i) {
    gained += cell.mass * Vec2{after.vx[i] - before.vx[i], after.vy[i] - before.vy[i]};
    spin_energy += cell.mass * cell.diameter * cell.diameter / 16.0 * after.spin[i] * after.spin[i];
  }
  Vec2 walls = run.impulse_on_block() + run.impulse_on_base();
  if (setup.has("friction_off_the_base")) walls.x -= 1e-6 * run.impulse_on_base().x;
  findings.expect_round_off(
      {"momentum", "momentum balance error of the free discs"},
      norm(gained + walls) / (static_cast<double>(cell.free_discs()) * cell.mass * cell.block_speed), 0.0, 3e-13,
      "as in case shear_cell: 2.9e5 steps round the impulses on the walls, up to 4.5 in this unit: sqrt(2.9e5) x 4.5 x "
      "1.1e-16");
  const CellRun::Ledger ledger = run.ledger();
  if (ledger.friction_work > 0.0) record_use("mechanism.friction");
  if (ledger.dissipated > ledger.friction_work) record_use("mechanism.contact_damping");
  double missing = ledger.spurious_gain;
  if (setup.has("spin_without_energy")) missing -= spin_energy;
  if (setup.has("friction_not_booked")) missing -= ledger.friction_work;
  // 2 xi w0 h with w0 = sqrt(2 k/m), xi = c/(2 sqrt(k m/2)): 2 c h/m.
  const double off = 2.0 * std::get<LinearSpringDashpot>(cell.law).damping * run.plan().step / cell.mass;
  findings.expect_truncation({"balance_error", "energy balance error over the energy dissipated by contacts"},
                             missing / ledger.dissipated, 0.0, off, 1.0,
                             "2 xi w0 h of the energy dissipated by dashpots; friction work and the spring energy "
                             "released at the end of contacts have errors of the same order and the opposite sign");
}

/// The limit of the step by sticking contacts, for a friction spring so stiff that no other limit is shorter. The slip
/// rate of two solid discs that stick changes by 6 T/m, and w_s h = 1 is allowed.
void expect_step_limit(Findings& findings) {
  ShearCell cell = cell_with({});
  cell.friction = CoulombFriction{0.5, 142140.0};
  const double limit = std::sqrt(cell.mass / (6.0 * 142140.0));
  const auto errors = [&](double step) {
    CellPlan plan;
    plan.step = step, plan.every = 0.01, plan.end = 0.1;
    return static_cast<double>(validation_errors(cell, plan).size());
  };
  findings.expect_exact("errors of a step of 0.999 sqrt(m/(6 k_s))", errors(0.999 * limit), 0.0,
                        "0.7 of the limit of ten steps in a contact, the next one");
  findings.expect_exact("errors of a step of 1.001 sqrt(m/(6 k_s))", errors(1.001 * limit), 1.0,
                        "that of contacts that stick");
}

/// Means after the start-up. `torque` is that of friction on the free discs, over its value if all contacts turned them
/// the same way.
struct Flow {
  double torque{};
  double spin{}, rate{};  ///< mean [1/T]
  double layers{};        ///< spin over half the shear rate, inner layers
  double ratio{}, sliding{}, friction_work{};
  double at_limit{};  ///< contacts whose friction is within 1e-6 of its limit, over all contacts
};

/// Accumulated energy balance, in units of the kinetic energy of all free discs at the block's speed: work of the
/// drive, dissipation, and increase of the present energy.
class Accounts {
 public:
  explicit Accounts(const ShearCell& cell)
      : unit_{0.5 * cell.mass * cell.block_speed * cell.block_speed * static_cast<double>(cell.free_discs())} {}

  long looks() const { return static_cast<long>(series_[0].x.size()); }
  void look(CellRun& run) {
    const CellRun::Ledger ledger = run.ledger();
    if (looks() == 0) held_ = ledger.held();
    const double kept = ledger.dissipated - ledger.friction_work;
    const std::array<double, 4> numbers{ledger.input, kept, ledger.friction_work, ledger.held() - held_};
    for (std::size_t i = 0; i < series_.size(); ++i)
      series_[i].add(1e3 * static_cast<double>(run.steps()) * run.plan().step, numbers[i] / unit_);
  }
  void draw(Findings& findings) const {
    findings.figure({.name = "accounts",
                     .title = "Energy balance of the cell",
                     .caption = "Accumulated work of the drive, energy dissipated by dashpots and by friction, and "
                                "increase of the kinetic, potential and stored energy since the first sample; over the "
                                "kinetic energy of all free discs at the block's speed.",
                     .x = {"time", "ms"},
                     .y = {.label = "energy", .unit = "1"},
                     .series = {series_.begin(), series_.end()}});
  }

 private:
  double unit_{}, held_{};
  std::array<Series, 4> series_{
      Series{.label = "drive", .style = Style::lines}, Series{.label = "dashpots", .style = Style::lines},
      Series{.label = "friction", .style = Style::lines}, Series{.label = "present energy", .style = Style::lines}};
};

/// Draws spin and half the shear rate over the height. Returns their ratio in the layers that are at least two
/// diameters from both walls; above them the block rises and falls through layers of few discs.
double spins_over_rates(Findings& findings, const CellRun& run, double depth) {
  Series spins{.label = "-spin"}, rates{.label = "half the shear rate"};
  const std::vector<CellProfile::Layer> layers = run.profile().layers();
  const double d = run.cell().diameter, unit = run.cell().block_speed / d;
  double spin = 0.0, turning = 0.0;
  for (std::size_t k = 1; k + 1 < layers.size() && layers[k].y < depth; ++k) {
    const double rate =
        0.5 * (layers[k + 1].velocity.value - layers[k - 1].velocity.value) / (layers[k + 1].y - layers[k - 1].y);
    spins.add(layers[k].y / d, -layers[k].spin.value / unit);
    rates.add(layers[k].y / d, rate / unit);
    if (layers[k].y > 2.0 * d && layers[k].y < depth - 2.0 * d) spin -= layers[k].spin.value, turning += rate;
  }
  findings.figure(
      {.name = "spins",
       .title = "Spin of the discs and half the local shear rate",
       .caption = "Mean spin, clockwise, and half the shear rate between layers of half a diameter, against the height "
                  "above the base up to the mean height of the block; after the start-up.",
       .x = {"height", "d"},
       .y = {.label = "rate", .unit = "speed of the block / d"},
       .series = {spins, rates}});
  return spin / turning;
}

Flow flow(Findings& findings, const Setup& setup, bool rough) {
  ShearCell cell = cell_with(setup);
  if (!rough) cell.friction.reset();
  CellRun run{cell, cell_plan(cell, setup.coarse ? 0.1 : 0.2)};
  std::array<double, 2> turning{}, all{};  // in each half of the averaging time
  double contacts = 0.0, at_limit = 0.0;
  Accounts accounts{cell};
  while (!run.finished() && run.failure().empty()) {
    run.advance();
    if (100 * run.steps() >= accounts.looks() * run.last_step()) accounts.look(run);
    if (4 * run.steps() < run.last_step()) continue;
    const std::size_t half = 8 * run.steps() < 5 * run.last_step() ? 0 : 1;
    for (const CellRun::ActingContact& contact : run.acting_contacts()) {
      contacts += 1.0;
      at_limit += std::abs(contact.friction) > (1.0 - 1e-6) * coefficient * contact.force ? 1.0 : 0.0;
      for (const std::size_t disc : {contact.a, contact.b}) {
        if (disc >= cell.free_discs() && !setup.has("walls_turn")) continue;
        const double sign = setup.has("one_way_torque") && disc == contact.b ? -1.0 : 1.0;
        turning[half] += sign * 0.5 * contact.distance * contact.friction;
        all[half] += 0.5 * contact.distance * std::abs(contact.friction);
      }
    }
  }
  if (rough) accounts.draw(findings);
  findings.count(run.evaluations());
  using Q = CellQuantity;
  const CellRun::Ledger ledger = run.ledger();
  const double apart = run.mean(Q::depth).value + cell.diameter;
  const auto torque = [&](std::size_t half) { return all[half] > 0.0 ? turning[half] / all[half] : 0.0; };
  return {std::abs(torque(0)) > std::abs(torque(1)) ? torque(0) : torque(1),
          run.mean(Q::spin).value,
          cell.block_speed / apart,
          rough ? spins_over_rates(findings, run, run.mean(Q::depth).value) : 0.0,
          run.ratio(Q::top_shear, Q::top_normal).value,
          run.ratio(Q::sliding, Q::contacts).value,
          ledger.friction_work / ledger.dissipated,
          at_limit / contacts};
}

void run(Findings& findings, const Setup& setup) {
  // Checks that the injected fault does not affect are not run again.
  const bool of_flow = setup.has("one_way_torque") || setup.has("walls_turn") || setup.has("smooth_discs");
  if (!of_flow) expect_balances(findings, setup);
  if (setup.fault.empty()) expect_step_limit(findings);
  if (!of_flow && !setup.fault.empty()) return;
  const Flow rough = flow(findings, setup, true);
  findings.expect_model({"net_torque", "net torque of friction on the free discs, over the sum of its magnitudes"},
                        rough.torque, 0.0, 0.005,
                        "the larger of two halves of the averaging time, each with 12,000 samples of about 25 "
                        "contacts, each contact seen about twice: a random sum is 1/sqrt(1.5e5) = 0.0026 of the sum of "
                        "magnitudes, and twice that is allowed; the change of spin from start to end contributes less");
  findings.expect_between(
      {"mean_spin", "mean spin over half the shear rate between the walls"}, -2.0 * rough.spin / rough.rate, 0.8, 1.5,
      "1 if contact directions are isotropic, 2 <n_y^2> otherwise: discs in rows touch neighbours above and below more "
      "often than those beside, at most three times as often; slip at the walls takes part of the shear rate");
  findings.expect_model("mean spin over half the local shear rate, inner layers", rough.layers, 1.0, 0.2,
                        "inside, a disc has contacts in all directions and turns as if it rolled between its "
                        "neighbours; the ratios of single layers scatter by that much in this time");
  findings.expect_between("fraction of contact time in sliding contacts", rough.sliding, 0.15, 0.65,
                          "impacts at all angles: a contact slides from its start if the impact angle exceeds about "
                          "atan(2 mu (1 + 1/e)), and every contact slides at its end, where the normal force falls to "
                          "zero; so neither none nor most of the time");
  findings.expect_model(
      {"at_limit", "fraction of contact time in sliding contacts, less that of friction at its limit"},
      rough.sliding - rough.at_limit, 0.0, 1e-3,
      "the same samples, and some 40 states at ends of LOOPs beside 12,000 samples or more: 0.003 times the deviation "
      "of their fraction from the mean, which is below 0.1. Of contacts that slide one in 20 lacks the last bit of mu "
      "N, since the stretch of its spring is rounded");
  findings.expect_between(
      "friction work over the energy dissipated by contacts", rough.friction_work, 0.35, 0.75,
      "dashpots dissipate 1 - e^2, half of the normal energy of an impact; friction dissipates at most a third of the "
      "tangential energy (sticking discs retain the rest as spin), of which a sheared cell has more");
  const Flow smooth = flow(findings, setup, false);
  findings.expect_between(
      "stress ratio of rough discs over that of smooth ones", rough.ratio / smooth.ratio, 1.0, 1.4,
      "friction adds to the shear carried by contacts, but walls made of discs also grip smooth discs");
}

}  // namespace

Case definition() {
  return {
      .id = "rough_cell",
      .title = "Sheared cell of rough discs: momentum, energy and spin",
      .family = "the shear cell",
      .requirements = {{"mechanism.contact_damping", {"balance_error"}},
                       {"mechanism.friction", {"friction work over the energy dissipated by contacts"}}},
      .main_checks = {"momentum", "balance_error", "net_torque", "mean_spin",
                      "mean spin over half the local shear rate, inner layers"},
      .source = "Cundall & Strack 1979; balances and spin, derived here",
      .faults = {{"friction_off_the_base", "a millionth of the shear impulse on the base omitted", "momentum"},
                 {"spin_without_energy", "rotational kinetic energy omitted", "balance_error"},
                 {"friction_not_booked", "friction work omitted", "balance_error"},
                 {"spin_reversed", "spins with the opposite sign in the export", "export"},
                 {"one_way_torque", "friction torque on the second disc of a pair with the wrong sign", "net_torque"},
                 {"walls_turn", "torques on the wall discs, which do not turn, included", "net_torque"},
                 {"smooth_discs", "no friction", "mean_spin"}},
      .run = run};
}

}  // namespace talus::verification::problems::rough_cell
