#include <concepts>
#include <type_traits>

#include "solver/granular/disc_system.hpp"
#include "solver/granular/fast_disc_system.hpp"
#include "verification/problems/cell/cell_runs.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::shear_cell_failures {
namespace {

/// Mistakes of a latching spring; a wrong law makes one of them.
enum class Wrong { flag_cleared, d0_forgotten };

template <Wrong wrong>
struct WrongLatch : LatchingSpring {
  constexpr double guard(Kinematics x, std::span<const double> memory, Mode mode) const {
    if (mode == slack && wrong == Wrong::flag_cleared) return x.deformation;
    if (mode == slack && wrong == Wrong::d0_forgotten) return -1.0;
    return LatchingSpring::guard(x, memory, mode);
  }
  constexpr Reset reset(Kinematics x, std::span<double> memory, Mode mode) const {
    if (mode == slack && wrong == Wrong::d0_forgotten && x.deformation > 0.0) {
      memory[0] = x.deformation;
      return {loading, 0.0};
    }
    return LatchingSpring::reset(x, memory, mode);
  }
  friend constexpr bool operator==(const WrongLatch&, const WrongLatch&) = default;
};

struct Flow {
  double ratio{};            ///< S/N on the block
  double fullest{};          ///< largest solid fraction after the start
  double fraction{};         ///< mean
  double largest_overlap{};  ///< over a diameter
  double motion{};           ///< kinetic energy of a disc across the field, relative to the mean, over m VXT^2
  double unaccounted{};      ///< present and dissipated energy beyond initial energy and input, over the input
  bool burst{};              ///< solid fraction outside (0.02, 5): the run was stopped
};

struct FlowPlan {
  double time{0.4};
  double steps_in_contact{20.0};
  std::string integrator{"velocity_verlet"};
  double forget_every{};  ///< interval after which contact memories are cleared [T]; 0: never
};

/// Kinetic, potential and stored energy, plus the energy dissipated by contacts.
template <class System>
double account(const ShearCell& cell, const System& system, const Discs& discs) {
  double energy = 0.5 * cell.block_mass * discs.vy.back() * discs.vy.back() +
                  cell.block_mass * cell.gravity * discs.y[first_block_disc(cell)] + discs.dissipated();
  for (std::size_t i = 0; i < cell.free_discs(); ++i)
    energy += 0.5 * cell.mass * (discs.vx[i] * discs.vx[i] + discs.vy[i] * discs.vy[i]);
  system.for_each_contact(discs, [&](const DiscContact& contact) { energy += contact.stored; });
  if constexpr (requires { system.lost(); }) energy += system.lost();
  return energy;
}

/// Runs the cell without the refusals and limits of CellRun.
template <class L>
Flow flow(const ShearCell& cell, const L& law, const FlowPlan& plan, Findings& findings) {
  const FilledCell filled = fill(cell);
  using System = std::conditional_t<std::same_as<L, LatchingSpring>, FastDiscSystem<LatchingSpring>, DiscSystem<L>>;
  System system{filled.shapes, filled.box, law, cell_skin(cell)};
  if constexpr (requires { system.keep_work(); }) system.keep_work();
  Discs discs = filled.discs;
  DiscMethod method = make_disc_method(plan.integrator);
  const double h = cell.contact_time() / plan.steps_in_contact;
  const long steps = std::lround(plan.time / h), start = steps / 4;
  record_use(law);
  record_use(method);
  system.begin(discs);
  Flow found;
  std::visit(
      [&](auto& stepper) {
        stepper.start(system, discs, h);
        const long forgetful = std::lround(plan.forget_every / h);
        double shear = 0.0, normal = 0.0, driven = 0.0, lost = 0.0;
        const double held = account(cell, system, discs);
        long looks = 0;
        for (long n = 0; n < steps && !found.burst; ++n) {
          if (forgetful > 0 && n > 0 && n % forgetful == 0) {
            if constexpr (requires { system.lost(); }) lost += system.lost();  // begin() clears it, too
            system.begin(discs), stepper.start(system, discs, h);
          }
          stepper.step(system, discs, h);
          driven -= h * system.wall_force(block_wall).x * cell.block_speed;
          if (n < start) continue;
          shear -= system.wall_force(block_wall).x, normal += system.wall_force(block_wall).y;
          if (n % 8 != 0) continue;
          ++looks;
          const double fraction = solid_fraction(cell, discs);
          found.fraction += fraction;
          found.fullest = std::max(found.fullest, fraction);
          // Relative to the mean, because the discs rise and fall with the block.
          double sum = 0.0, squares = 0.0;
          const auto count = static_cast<double>(cell.free_discs());
          for (std::size_t i = 0; i < cell.free_discs(); ++i)
            sum += discs.vy[i], squares += discs.vy[i] * discs.vy[i];
          found.motion += 0.5 * (squares - sum * sum / count);
          system.for_each_contact(discs, [&](const auto& contact) {
            found.largest_overlap = std::max(found.largest_overlap, contact.depth / cell.diameter);
          });
          found.burst = !(fraction > 0.02) || !(fraction < 5.0);
        }
        found.unaccounted = (account(cell, system, discs) + lost - held - driven) / driven;
        if (normal != 0.0) found.ratio = shear / normal;
        found.fraction /= static_cast<double>(std::max(1L, looks));
        found.motion /= static_cast<double>(std::max(1L, looks)) * static_cast<double>(cell.free_discs()) *
                        cell.block_speed * cell.block_speed;
      },
      method);
  findings.count(system.evaluations());
  return found;
}

struct Row {
  std::string what;
  Flow flow;
};

bool within_limits(const Flow& flow) {
  return !flow.burst && flow.fullest <= CellRun::fullest && flow.largest_overlap < CellRun::deepest;
}

void add_rows(Findings& findings, const std::vector<Row>& rows) {
  Table table{.name = "failures",
              .caption =
                  "The correct cell and faulty ones: the stress ratio, which reveals little, and quantities that "
                  "reveal more. A run is stopped (diverged) when its solid fraction leaves 0.02 to 5. Unaccounted: "
                  "increase of energy beyond the work of the drive, over this work.",
              .columns = {"cell", "S/N", "mean solid fraction", "largest solid fraction", "largest overlap/D",
                          "transverse kinetic energy/(m VXT^2)", "unaccounted", "limits"}};
  for (const Row& row : rows) {
    const Flow& flow = row.flow;
    table.rows.push_back(cells("{} | {:.3f} | {:.3f} | {:.3f} | {:.3f} | {:.4f} | {} | {}", row.what, flow.ratio,
                               flow.fraction, flow.fullest, flow.largest_overlap, flow.motion,
                               flow.burst ? "" : fmt::format("{:.2g}", flow.unaccounted),
                               within_limits(flow) ? "met"
                               : flow.burst        ? "diverged"
                                                   : "exceeded"));
  }
  findings.table(table);
}

Figure figure_of(const std::vector<Row>& rows) {
  Figure figure{.name = "seen",
                .title = "Stress ratio and largest solid fraction of correct and faulty cells",
                .caption =
                    "Cells whose discs pass through each other may have the stress ratio of the correct cell. Dashed: "
                    "largest solid fraction that equal discs can fill.",
                .x = {.label = "S/N", .min = 0.0, .max = 0.4},
                .y = {.label = "largest solid fraction", .log = true}};
  for (const Row& row : rows)
    if (row.flow.ratio != 0.0)
      figure.series.push_back(
          {.label = row.what, .x = {row.flow.ratio}, .y = {row.flow.fullest}, .style = Style::points});
  figure.lines = {{'y', CellRun::fullest, ""}};
  return figure;
}

/// Leapfrogs with few steps in a contact, and the range of their unaccounted energy.
struct Long {
  double steps;
  double minimum, maximum;  ///< unaccounted energy: smallest and largest value
  const char* why;
  std::uint64_t seeds{1};
};
constexpr std::array longs{
    Long{6.0, -0.01, 0.01, "w2 h = 0.64: the steps are short enough, also by the energy balance"},
    Long{3.6, 0.003, 0.1, "just above 3.3 steps: some impacts of a disc among several gain energy"},
    Long{2.9, 0.03, 0.4, "below 3.3 steps discs among six gain energy; most discs touch fewer"},
    Long{2.45, 0.2, 1.5,
         "closer to the limit of 1.91 steps of any pair; nearly all impacts of a disc among others gain energy", 8},
    Long{2.0, 1.0, 10.0,
         "at the limit of pairs: contacts add more energy than the drive does, also in cells that do not diverge", 8}};

/// Flow with the cell's law, and with a wrong one.
Flow right_flow(const ShearCell& cell, const FlowPlan& plan, Findings& findings) {
  return flow(cell, std::get<LatchingSpring>(cell.law), plan, findings);
}
template <Wrong wrong>
Flow wrong_flow(const ShearCell& cell, const FlowPlan& plan, Findings& findings) {
  return flow(cell, WrongLatch<wrong>{std::get<LatchingSpring>(cell.law)}, plan, findings);
}

/// Laws and restarts that lose contact memory.
void expect_laws(Findings& findings, const Setup& setup, const ShearCell& cell, std::vector<Row>& rows) {
  FlowPlan plan;
  if (setup.coarse) plan.time = 0.1;
  FlowPlan brief = plan;
  brief.time = 0.1;
  const bool swapped = setup.has("right_law_for_the_wrong");
  const Flow right = setup.has("wrong_law_for_the_right") ? wrong_flow<Wrong::flag_cleared>(cell, plan, findings)
                                                          : right_flow(cell, plan, findings);
  const Flow cleared = swapped ? right : wrong_flow<Wrong::flag_cleared>(cell, brief, findings);
  const Flow forgotten = setup.has("d0_remembered") ? right : wrong_flow<Wrong::d0_forgotten>(cell, brief, findings);
  rows.push_back({"correct law", right}), rows.push_back({"(a) flag cleared at F = 0", cleared});
  rows.push_back({"(b) d0 forgotten at F = 0", forgotten});
  findings.expect_true({"within_limits", "solid fraction and overlap within the limits, correct law"},
                       within_limits(right), "equal discs with small overlaps");
  findings.expect_true({"limits_exceeded", "limits exceeded, contacts cleared at zero force"}, !within_limits(cleared),
                       "discs that are pressed again feel no force and pass through each other");
  findings.expect_between(
      {"transverse_energy",
       "transverse kinetic energy of contacts that forget d0 at zero force, over that of the correct cell"},
      forgotten.motion / right.motion, 1.1, 3.0,
      "such a contact returns at least K1 d0^2/2 more: e^2 = 0.49 + 0.26 in a single impact, and the kinetic energy is "
      "larger by that much or, as impacts follow each other, by several times that");
  findings.expect_between(
      "stress ratio with contacts cleared at zero force", cleared.ratio, 0.15, 0.4,
      "the ratio is plausible although the cell is wrong: between half and one and a half times the correct one");
  brief.forget_every = setup.has("restarts_remember") ? 0.0 : 1e-4;
  const Flow restarted = right_flow(cell, brief, findings);
  rows.push_back({"d0 forgotten every 0.1 ms", restarted});
  findings.expect_between({"unaccounted", "energy unaccounted for when contacts forget d0 every 0.1 ms"},
                          restarted.unaccounted, 0.1, 1.0,
                          "every eight contact times or so most existing contacts restart with K1 d and return more "
                          "energy than they received; the drive supplies as much in some ms");
}

/// Leapfrogs with long steps, over a longer time, because the ratio has a standard error.
void expect_long_steps(Findings& findings, const Setup& setup, const ShearCell& cell, std::vector<Row>& rows) {
  FlowPlan plan;
  plan.time = setup.coarse ? 0.15 : 2.4;
  ShearCell other = cell;
  // Elastic discs have a different stress ratio.
  if (setup.has("elastic_discs")) other.law = LatchingSpring{1.7e4, 1.7e4, 0.0};
  const Flow right = right_flow(cell, plan, findings);
  rows.push_back({"Verlet, 20 steps in a contact", right});
  Series unaccounted{.label = "energy unaccounted for", .style = Style::points};
  Series ratio{.label = "S/N over that with 20 steps, minus 1", .style = Style::points};
  const auto draw = [&](double steps, const Flow& found) {
    unaccounted.add(steps, std::max(std::abs(found.unaccounted), 1e-7));
    if (steps == plan.steps_in_contact) return;
    ratio.add(steps, std::max(std::abs(found.ratio / right.ratio - 1.0), 1e-7));
  };
  draw(plan.steps_in_contact, right);
  for (const Long& by : longs) {
    const std::string name = fmt::format("velocity Verlet, {} steps in a contact", by.steps);
    if (!setup.needs(name)) continue;
    // These are sixteen of the twenty cells with long steps, and a fifth of the quick tier's time.
    if (by.seeds > 1 && setup.tier != Tier::full) continue;
    FlowPlan steps = plan;
    steps.steps_in_contact = setup.has("shorter_steps") ? 20.0 : by.steps;
    std::vector<Flow> cells;
    for (std::uint64_t seed = cell.seed;
         seed < cell.seed + (setup.coarse ? std::min<std::uint64_t>(by.seeds, 3) : by.seeds); ++seed) {
      other.seed = seed;
      cells.push_back(right_flow(other, steps, findings));
    }
    other.seed = cell.seed;
    rows.push_back({fmt::format("Verlet, {}", by.steps), cells.front()});
    const auto burst = std::count_if(cells.begin(), cells.end(), [](const Flow& flow) { return flow.burst; });
    const auto minimum = std::min_element(cells.begin(), cells.end(), [](const Flow& one, const Flow& another) {
      return one.unaccounted < another.unaccounted;
    });
    findings.expect_between(fmt::format("energy unaccounted for, {}{}", name, by.seeds > 1 ? ", minimum of eight" : ""),
                            minimum->unaccounted, by.minimum, by.maximum, by.why);
    double mean = 0.0;
    for (const Flow& flow : cells)
      mean += flow.ratio / static_cast<double>(cells.size());
    draw(by.steps, {.ratio = mean, .unaccounted = minimum->unaccounted});
    if (by.steps >= 2.9) {
      findings.expect_model("stress ratio, " + name, mean, right.ratio, setup.coarse ? 0.04 : 0.01,
                            "the ratio hardly depends on the step: both have a standard error of 0.003 to 0.004");
    } else if (by.steps > 2.0) {
      findings.expect_between("stress ratio, mean of eight cells minus that with 20 steps, " + name, mean - right.ratio,
                              0.002, 0.02,
                              "the ratio has changed, but little: by 0.010 with a standard error of 0.004");
    } else {
      findings.expect_between("cells out of eight that diverge, " + name, static_cast<double>(burst), 1.0,
                              static_cast<double>(cells.size()),
                              "which of them do depends on the trajectories; sooner or later all diverge");
    }
  }
  findings.figure({.name = "long_steps",
                   .title = "Energy balance and stress ratio with too long steps",
                   .caption = "Unaccounted fraction of the work, and relative deviation of the stress ratio from that "
                              "with 20 steps, against steps in a contact: the energy balance reveals too long steps, "
                              "the stress ratio does not. Dashed: 1 % of the work, above which `talus cell` warns; "
                              "vertical: 3.3 steps, below which a disc among six is unstable.",
                   .x = {.label = "steps in a contact", .log = true, .min = 1.5, .max = 25.0},
                   .y = {.label = "fraction", .log = true, .min = 1e-7, .max = 10.0},
                   .series = {unaccounted, ratio},
                   .lines = {{'y', CellRun::maximum_balance_error, ""}, {'x', 3.3, ""}}});
}

/// Euler and Taylor steps, which add energy in every impact.
void expect_first_order(Findings& findings, const Setup& setup, const ShearCell& cell, std::vector<Row>& rows) {
  struct By {
    const char *method, *label;
    double few, many;
    const char *gains, *stays;
  };
  constexpr std::array all{By{"euler", "Euler", 10.0, 120.0,
                              "each contact returns more energy than it received: e is above 1", "e is 0.73 there"},
                           By{"taylor", "Taylor", 5.0, 60.0, "e is 1.15", "e is 0.73 there"}};
  for (const By& by : all) {
    if (!setup.needs(by.label)) continue;
    FlowPlan plan;
    if (setup.coarse) plan.time = 0.03;
    plan.integrator = by.method;
    plan.steps_in_contact = setup.has("first_order_finer") ? by.many : by.few;
    const Flow heated = right_flow(cell, plan, findings);
    rows.push_back({fmt::format("{}, {} steps", by.label, by.few), heated});
    findings.expect_true(fmt::format("limits exceeded, {} with {} steps in a contact", by.label, by.few),
                         !within_limits(heated), by.gains);
    // Euler with 120 steps takes as long as all other first-order runs together; Taylor with 60 shows the same.
    if (by.many > 100.0 && setup.tier != Tier::full) continue;
    plan.steps_in_contact = setup.has("first_order_coarser") ? by.few : by.many;
    plan.time *= 0.5;
    const Flow fine = right_flow(cell, plan, findings);
    rows.push_back({fmt::format("{}, {} steps", by.label, by.many), fine});
    findings.expect_true(fmt::format("limits met, {} with {} steps in a contact", by.label, by.many),
                         within_limits(fine), by.stays);
  }
}

void run(Findings& findings, const Setup& setup) {
  const ShearCell cell = ice_cell(8e3, 5e3);
  std::vector<Row> rows;
  if (setup.concerns({"wrong_law_for_the_right", "right_law_for_the_wrong", "d0_remembered", "restarts_remember"}))
    expect_laws(findings, setup, cell, rows);
  if (setup.concerns({"elastic_discs", "shorter_steps"})) expect_long_steps(findings, setup, cell, rows);
  if (setup.concerns({"first_order_finer", "first_order_coarser"})) expect_first_order(findings, setup, cell, rows);
  findings.figure(figure_of(rows));
  add_rows(findings, rows);
}

}  // namespace

Case definition() {
  return {
      .id = "shear_cell_failures",
      .title = "Sheared cell: failures and their detection",
      .family = "the shear cell",
      .requirements = {{"law.latching_spring", {"within_limits"}}},
      .main_checks = {"within_limits", "limits_exceeded", "transverse_energy",
                      "stress ratio with contacts cleared at zero force", "unaccounted",
                      "energy unaccounted for, velocity Verlet, 6 steps in a contact",
                      "energy unaccounted for, velocity Verlet, 2.9 steps in a contact",
                      "stress ratio, velocity Verlet, 2.9 steps in a contact",
                      "limits exceeded, Euler with 10 steps in a contact",
                      "limits exceeded, Taylor with 5 steps in a contact"},
      .source = "Talus; law of Walton & Braun 1986",
      .faults = {{"wrong_law_for_the_right", "law with cleared contacts in place of the correct law", "within_limits"},
                 {"right_law_for_the_wrong", "correct law in place of the law with cleared contacts",
                  "limits_exceeded"},
                 {"d0_remembered", "correct law in place of the law that forgets d0", "transverse_energy"},
                 {"restarts_remember", "contacts that do not forget d0 every 0.1 ms", "unaccounted"},
                 {"elastic_discs", "elastic discs in the cells with long steps",
                  "stress ratio, velocity Verlet, 2.9 steps in a contact"},
                 {"shorter_steps", "20 steps in a contact in all cells with long steps",
                  "energy unaccounted for, velocity Verlet, 2.9 steps in a contact"},
                 {"first_order_finer", "Euler and Taylor steps twelve times shorter than intended",
                  "limits exceeded, Taylor with 5 steps in a contact"},
                 {"first_order_coarser", "Euler and Taylor steps twelve times longer than intended",
                  "limits met, Taylor with 60 steps in a contact"}},
      .seconds = 20.0,
      .full_seconds = 42.0,
      .run = run};
}

}  // namespace talus::verification::problems::shear_cell_failures
