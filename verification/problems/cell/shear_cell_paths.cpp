#include "solver/io/cell/cell_restart.hpp"
#include "solver/io/cell/write_cell.hpp"
#include "verification/problems/cell/cell_runs.hpp"
#include "verification/reference/many_bodies/virtual_discs.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::shear_cell_paths {
namespace {

/// Filled cell in which discs meet from the first steps on: its random velocities are multiplied by `times`; with 60
/// they are as large as the drive.
FilledCell lively(const ShearCell& cell, double times = 60.0) {
  FilledCell filled = fill(cell);
  for (std::size_t i = 0; i < cell.free_discs(); ++i)
    filled.discs.vy[i] *= times, filled.discs.vx[i] += 20.0 * filled.discs.vy[(i + 7) % cell.free_discs()] / 60.0;
  return filled;
}

double apart(const Discs& one, const std::vector<double>& x, const std::vector<double>& y, double width) {
  double maximum = 0.0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    const double across = one.x[i] - x[i];
    keep_largest(maximum, across - width * std::round(across / width)), keep_largest(maximum, one.y[i] - y[i]);
  }
  return maximum;
}

/// Number of contacts that act across the border of the field, which is wider than two discs.
long across_border(CellRun& run) {
  const Discs now = run.discs();
  const std::vector<CellRun::ActingContact> contacts = run.acting_contacts();
  return std::count_if(contacts.begin(), contacts.end(), [&](const CellRun::ActingContact& contact) {
    return std::abs(now.x[contact.a] - now.x[contact.b]) > 2.0 * run.cell().diameter;
  });
}

/// The solver compared with the reference, which uses virtual discs and all pairs.
void expect_virtual(Findings& findings, const Setup& setup) {
  const ShearCell cell = ice_cell(8e3, 5e3, 4);
  const FilledCell start = lively(cell, 5.0);
  CellPlan plan = cell_plan(cell, 1.0);
  plan.integrator = "euler_cromer";
  plan.step *= 0.5;
  const long steps = setup.coarse ? 16000 : 20000;
  plan.end = static_cast<double>(steps) * plan.step, plan.every = plan.end;
  CellRun run{cell, plan, start};
  const auto& law = std::get<LatchingSpring>(cell.law);
  reference::VirtualDiscs discs{.k1 = law.stiffness,
                                .k2 = law.unloading_stiffness,
                                .diameter = cell.diameter,
                                .mass = cell.mass,
                                .left = -0.5 * cell.width(),
                                .width = cell.width() * (setup.has("field_too_wide") ? 1.0 + 1e-7 : 1.0),
                                .gravity = cell.gravity,
                                .block_mass = cell.block_mass,
                                .free = cell.free_discs(),
                                .wall = static_cast<std::size_t>(cell.wall_discs),
                                .x = start.discs.x,
                                .y = start.discs.y,
                                .vx = start.discs.vx,
                                .vy = start.discs.vy};
  if (setup.has("latch_weaker")) discs.k2 *= 1.0 - 1e-9;
  Series difference{.label = "positions", .style = Style::lines};
  double maximum = 0.0, early = 0.0;  // `early`: over the first half
  long across = 0;
  for (long n = 0; !run.finished();) {
    run.advance();
    for (; n < run.steps(); ++n)
      discs.step(plan.step);
    if (2 * n <= steps) across += across_border(run);
    if (n % 100 != 0) continue;
    const double now = apart(run.discs(), discs.x, discs.y, cell.width()) / cell.diameter;
    maximum = std::max(maximum, now);
    if (2 * n <= steps) early = maximum;
    difference.add(static_cast<double>(n), std::max(now, 1e-17));
  }
  findings.count(run.evaluations());
  findings.expect_true(
      "contacts across the border in the first half of the run", across >= 10,
      fmt::format("without them no virtual disc acts; seen {} times, each contact about twice", across));
  findings.expect_round_off(
      {"virtual_discs", "positions against virtual discs and all pairs, largest difference over a diameter"}, early,
      0.0, 1e-12,
      "positions of some diameters are rounded to 1e-15 of a diameter at each of thousands of steps, in boxes whose "
      "borders discs cross at different times; contacts amplify this by an amount that depends on the trajectories: to "
      "1.6e-13 with this seed, and to 2e-16 ... 1.8e-11 with eleven others. Other roundings of the same trajectories "
      "change the errors, but hardly their amplification: six times the measured error");
  findings.expect_round_off(
      "positions after twice as many steps, largest difference over a diameter", maximum, 0.0, 3e-9,
      "neighbouring trajectories diverge: 1.6e-13 grows to 2.9e-10, and ten times that is allowed");
  findings.figure({.name = "difference",
                   .title = "Minimum image against virtual discs",
                   .caption = "Largest difference of positions over a diameter between the solver (neighbour list, "
                              "nearest image) and the reference (all pairs, a virtual disc beside the field for each "
                              "disc); dashed: bound for the first half of the steps.",
                   .x = {"step", "1"},
                   .y = {.label = "difference over D", .log = true, .min = 1e-16, .max = 1e-8},
                   .series = {difference},
                   .lines = {{'y', 1e-12, "bound"}}});
}

/// The solver's neighbour list compared with its virtual discs, for rough discs with dashpots.
void expect_own_virtual(Findings& findings, const Setup& setup) {
  ShearCell cell = ice_cell(8e3, 5e3);
  cell.law = LinearSpringDashpot{2e4, 0.02};
  cell.friction = CoulombFriction{0.5, 1.4e4};
  const FilledCell start = lively(cell);
  CellPlan plan = cell_plan(cell, 200.0 * cell.contact_time(), 20.0, 1);
  CellRun nearest{cell, plan, start};
  plan.images = Images::virtual_discs;
  if (setup.has("friction_less")) cell.friction = CoulombFriction{0.5 * (1.0 - 1e-8), 1.4e4};
  CellRun virtual_discs{cell, plan, start};
  run_to_end(nearest);
  long across = 0;
  while (!virtual_discs.finished()) {
    virtual_discs.advance();
    across += across_border(virtual_discs);
  }
  findings.count(nearest.evaluations() + virtual_discs.evaluations());
  const Discs end = virtual_discs.discs();
  findings.expect_round_off(
      {"rough_virtual_discs",
       "positions of rough discs, neighbour list against virtual discs, largest difference over a diameter"},
      apart(nearest.discs(), end.x, end.y, cell.width()) / cell.diameter, 0.0, 1e-12,
      "as against the reference, in 200 instead of 250 contact times: zero until wrapping a disc back into the field "
      "first rounds its position, by 1e-15 of a diameter");
  findings.expect_true("sliding of rough discs and contacts across the border",
                       nearest.ledger().friction_work > 0.0 && across > 20,
                       "otherwise neither friction nor virtual discs would be compared");
}

/// Dimensionless groups and results of a cell run.
std::vector<double> numbers_of(CellRun& run, const CellPlan& plan) {
  const CellScene scene{.title = "", .units = {}, .cell = run.cell(), .plan = plan};
  std::vector<double> values;
  for (const auto& numbers : {cell_groups(scene, run), cell_results(run)})
    for (const CellNumber& number : numbers)
      values.push_back(number.estimate.value);
  return values;
}

void expect_mirror(Findings& findings, const Setup& setup) {
  ShearCell cell = ice_cell(8e3, 5e3);
  const FilledCell start = lively(cell);
  const CellPlan plan = cell_plan(cell, setup.coarse ? 2e-3 : 6e-3, 20.0, 1);
  CellRun one{cell, plan, start};
  FilledCell mirrored = start;
  for (std::size_t i = 0; i < mirrored.discs.size(); ++i)
    mirrored.discs.x[i] = -mirrored.discs.x[i], mirrored.discs.vx[i] = -mirrored.discs.vx[i];
  if (setup.has("one_disc_off")) mirrored.discs.y[17] = std::nextafter(mirrored.discs.y[17], 1.0);
  cell.block_speed = -cell.block_speed;
  CellRun other{cell, plan, mirrored};
  run_to_end(one), run_to_end(other);
  const double shear = one.impulse_on_block().x, mirror = other.impulse_on_block().x;
  findings.expect_exact({"mirrored_impulse", "impulse along x on the block, mirrored cell over original cell"},
                        mirror / shear, -1.0, "only signs change, no digit does");
  findings.expect_true({"mirrored_heights", "bit-identical heights of all discs in the mirrored cell"},
                       one.discs().y == other.discs().y, "no sum along y depends on the mirror image");
  const std::vector<double> numbers = numbers_of(one, plan);
  findings.expect_true("bit-identical groups and results of the mirrored cell",
                       !numbers.empty() && numbers == numbers_of(other, plan),
                       "shear and rates count along the motion of the block; none of these discs has a spin");
}

/// Restores the saved state of the first run into a second one; runs both to their ends.
void resume(CellRun& whole, CellRun& rest) {
  Archive saved;
  whole.serialize(saved);
  Archive putting_back{saved.items()};
  rest.serialize(putting_back);
  run_to_end(whole), run_to_end(rest);
}

/// Rough discs also have spins and stretches of friction springs.
void expect_rough_restart(Findings& findings, ShearCell cell, CellPlan plan) {
  cell.friction = CoulombFriction{0.5, 14214.0};
  plan.end = 0.5 * plan.end, plan.every = plan.end;
  CellRun whole{cell, plan, lively(cell)};
  while (2 * whole.steps() < whole.last_step())
    whole.advance();
  CellRun rest{cell, plan};
  resume(whole, rest);
  const std::vector<double> spins = whole.discs().spin;
  findings.expect_true(
      "bit-identical final state of a resumed run of rough discs",
      whole.discs() == rest.discs() && std::any_of(spins.begin(), spins.end(), [](double spin) { return spin != 0.0; }),
      "spins and friction memory are restored, too");
}

void expect_restart(Findings& findings, const Setup& setup) {
  const ShearCell cell = ice_cell(8e3, 5e3);
  const CellPlan plan = cell_plan(cell, setup.coarse ? 2e-3 : 6e-3, 20.0, 1);
  CellRun whole{cell, plan, lively(cell)};
  while (3 * whole.steps() < whole.last_step())
    whole.advance();
  if (setup.has("restart_of_1989")) {
    // The file of 1989 contains the discs alone; the block is restored, too, so that only contact memory is missing.
    FilledCell discs =
        read_cell_restart(cell_restart_text(cell, whole.discs(), whole.steps()), "RESTART.DAT", cell).start;
    discs.discs = whole.discs();
    CellPlan less = plan;
    less.end -= static_cast<double>(whole.steps()) * plan.step, less.every = less.end;
    CellRun forgetful{cell, less, discs};
    run_to_end(forgetful), run_to_end(whole);
    findings.expect_true("bit-identical final state of a resumed run", forgetful.discs().x == whole.discs().x,
                         "injected fault");
    return;
  }
  CellRun rest{cell, plan};
  resume(whole, rest);
  findings.expect_true("bit-identical final state of a resumed run",
                       whole.discs() == rest.discs() &&
                           whole.mean(CellQuantity::top_shear).value == rest.mean(CellQuantity::top_shear).value,
                       "everything that a step reads is saved");
  expect_rough_restart(findings, cell, plan);
  const CellScene scene{.title = "", .units = {}, .cell = cell, .plan = plan};
  const CellOutcome outcome{whole.outcome(), {}};
  double differ = cell_csv(scene, cell_history(scene, whole)) == cell_csv(scene, cell_history(scene, rest)) ? 0.0 : 1.0;
  differ += cell_csv(scene, cell_profile(scene, whole)) == cell_csv(scene, cell_profile(scene, rest)) ? 0.0 : 1.0;
  differ += cell_summary_json(scene, whole, outcome, "") == cell_summary_json(scene, rest, outcome, "") ? 0.0 : 1.0;
  findings.expect_exact("output files of a resumed run that differ", differ, 0.0,
                        "history, profile and summary: all accumulated sums are saved, also those that wait for the "
                        "next sample of the layers");
}

/// Few discs, a hundred times as stiff, so that most time is free of contacts.
void expect_jump(Findings& findings, const Setup& setup) {
  ShearCell cell = ice_cell(2e3, 5e3);
  cell.rows = 4, cell.columns = 4, cell.wall_discs = 6;
  auto& law = std::get<LatchingSpring>(cell.law);
  law.stiffness *= 100.0, law.unloading_stiffness *= 100.0;
  cell.block_mass = 2e3 * 6e-6 / cell.gravity;
  CellPlan plan = cell_plan(cell, 500.0 * cell.contact_time(), 20.0, 4);
  const FilledCell start = lively(cell);
  CellRun step_by_step{cell, plan, start};
  plan.jump = true;
  if (setup.has("stiffer_discs")) law.stiffness *= 1.0 + 1e-6;
  CellRun jumping{cell, plan, start};
  double fastest = 0.0;  // largest speed of the block
  while (!step_by_step.finished()) {
    step_by_step.advance();
    keep_largest(fastest, step_by_step.discs().vy.back());
  }
  run_to_end(step_by_step);
  while (2 * jumping.steps() < jumping.last_step())
    jumping.advance();
  const long jumped_before = jumping.jumped();
  CellRun resumed{cell, plan};
  resume(jumping, resumed);
  const Discs end = step_by_step.discs();
  findings.expect_round_off(
      {"jumps", "positions with jumps over contact-free time, largest difference over a diameter"},
      apart(jumping.discs(), end.x, end.y, cell.width()) / cell.diameter, 0.0, 1e-9,
      "free flights of thousands of steps, at once and step by step, are rounded to 1e-13, which grows over the "
      "contacts of 500 contact times");
  findings.expect_exact("steps skipped by jumps, resumed run less uninterrupted run",
                        jumped_before > 0 && jumping.jumped() > jumped_before && resumed.discs() == jumping.discs()
                            ? static_cast<double>(resumed.jumped() - jumping.jumped())
                            : NAN,
                        0.0, "the sum of both parts, in each of which there are jumps, with the same motion");
  const double depth = step_by_step.mean(CellQuantity::depth).value;
  findings.expect_truncation("mean depth with jumps over contact-free time, over that with single steps",
                             jumping.mean(CellQuantity::depth).value / depth, 1.0, 0.5 * plan.step * fastest / depth,
                             1.0,
                             "a block in free flight follows a parabola, whose mean Simpson's rule gives exactly; step "
                             "by step, the heights at the ends of the steps are averaged, which are half a step ahead");
  findings.expect_between(
      "fraction of steps skipped by jumps",
      static_cast<double>(jumping.jumped()) / static_cast<double>(jumping.steps()), 0.3, 0.999,
      "16 discs with 100 times the stiffness touch a tenth as long and are in free flight otherwise");
  findings.note(fmt::format(
      "Of {} steps of the small stiff cell {} were skipped by jumps, which reduces the number of steps by a factor of "
      "{}. In a cell of 80 discs like that of the thesis some discs touch nearly always, and jumps gain nothing.",
      jumping.steps(), jumping.jumped(), jumping.steps() / std::max(1L, jumping.steps() - jumping.jumped())));
}

/// The block of a cell that is read from RESTART.DAT lies on the disc that it meets first, also on one that it meets
/// across the border of the field: the highest disc is put at positions all over the field.
void expect_laid_block(Findings& findings, const Setup& setup) {
  const ShearCell cell = ice_cell(8e3, 5e3);
  FilledCell filled = fill(cell);
  Discs& discs = filled.discs;
  const double diameter = cell.diameter, width = cell.width(), height = 40.0 * diameter;
  double worst = 0.0, across = 0.0;
  constexpr int positions = 97;
  for (int n = 0; n < positions; ++n) {
    discs.x[0] = width * ((n + 0.5) / positions - 0.5), discs.y[0] = height;
    discs.t = 0.15 * (n % 7) * diameter / std::abs(cell.block_speed);  // the block has moved by a part of a diameter
    const CellRestart read = read_cell_restart(cell_restart_text(cell, discs, 0), "RESTART.DAT", cell);
    const Discs& start = read.start.discs;
    // The nearest disc of the block along x, of which images are in both neighbouring fields.
    double nearest = width;
    bool is_image = false;
    for (std::size_t j = first_block_disc(cell); j < start.size(); ++j) {
      for (const double image : {0.0, -width, width}) {
        const double distance = std::abs(start.x[j] + image - discs.x[0]);
        if (distance < nearest) nearest = distance, is_image = image != 0.0;
      }
    }
    across += is_image ? 1.0 : 0.0;
    const double exact =
        height + (setup.has("block_on_top") ? diameter : std::sqrt(diameter * diameter - nearest * nearest));
    keep_worst(worst, (start.y[first_block_disc(cell)] - exact) / diameter);
  }
  findings.expect({"laid_block", "height of the block on a disc anywhere in the field, worst error over the diameter"},
                  worst, 0.0,
                  Tolerance::round_off(1e-13, "heights of 40 diameters, rounded to 1e-14 of one; ten of them"));
  findings.expect_between("positions at which the block lies on the disc across the border", across, 1.0, 10.0,
                          "a disc of the block is half a diameter away at most, of 11 in the field");
}

void run(Findings& findings, const Setup& setup) {
  if (setup.needs("of the block") || setup.needs("the block lies")) expect_laid_block(findings, setup);
  if (setup.needs("against virtual discs and all pairs")) expect_virtual(findings, setup);
  if (setup.needs("positions of rough discs")) expect_own_virtual(findings, setup);
  if (setup.needs("mirrored cell")) expect_mirror(findings, setup);
  if (setup.needs("of a resumed run")) expect_restart(findings, setup);
  if (setup.needs("positions with jumps")) expect_jump(findings, setup);
}

}  // namespace

Case definition() {
  return {
      .id = "shear_cell_paths",
      .title = "Sheared cell: equivalent formulations",
      .family = "the shear cell",
      .requirements = {{"F3", {"virtual_discs", "rough_virtual_discs"}},
                       {"F5", {"bit-identical final state of a resumed run"}}},
      .main_checks = {"virtual_discs", "rough_virtual_discs", "mirrored_impulse", "mirrored_heights",
                      "bit-identical final state of a resumed run", "jumps"},
      .source = "Lacy 1989, Virtual Elements and Periodic Boundaries",
      .faults = {{"block_on_top", "a block a diameter above the disc, wherever it is", "laid_block"},
                 {"field_too_wide", "virtual discs too far away by 1e-7 of the field width", "virtual_discs"},
                 {"latch_weaker", "K2 of the reference smaller by the fraction 1e-9", "virtual_discs"},
                 {"friction_less", "friction coefficient of the cell with virtual discs smaller by the fraction 1e-8",
                  "rough_virtual_discs"},
                 {"one_disc_off", "one disc of the mirrored cell higher by one unit in the last place",
                  "mirrored_heights"},
                 {"restart_of_1989", "largest overlap of contacts lost at the restart",
                  "bit-identical final state of a resumed run"},
                 {"stiffer_discs", "K1 of the cell with jumps larger by the fraction 1e-6", "jumps"}},
      .seconds = 3.0,
      .run = run};
}

}  // namespace talus::verification::problems::shear_cell_paths
