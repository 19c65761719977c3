#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "solver/granular/disc_system.hpp"
#include "verification/check/case.hpp"
#include "verification/problems/cell_runs.hpp"

namespace talus::verification::problems {

Case shear_cell_failures();

namespace {

constexpr const char* page = R"(
**Problem.** A stress ratio near .26 is no proof of a right cell: it hardly knows how stiff the discs are, whether they pass
through each other, or how long the steps are. Here the cell is made wrong in the ways in which such codes have gone wrong,
each beside the right one, and what tells them apart is measured.

```
   F |      /  K1           right: after F = 0 the contact is slack until it is      +------------+
     |     /| K2            pressed again past d0, and remembers d0 until d = 0      |  d0     d  |
     |    / |               (a) "flag cleared": no force any more until they part
     +---/--+---- d         (b) "d0 forgotten": it is a new contact then, with the force K1 d
        d0
```

**Equations.** A leapfrog on a spring is stable to $w_2 h = 2$; with $e = .7$ a contact of
$t_c = \frac{\pi}{2}(1/w_1 + 1/w_2)$ takes $t_c/h = \frac{\pi}{4}(1 + 1/e) = 1.91$ steps then; a disc
between others feels several springs, six at most, $w^2 \le 6 K_2/m$ against $2 K_2/m$ of a pair: $\sqrt3$ times as many, 3.3.
Euler's steps make $e$ into $e\,\exp[\frac{\pi}{4}(w_1 + w_2)h]$, which passes 1 at $t_c/h = 14$; Taylor's at 7
(case `latching_restitution`).

**Source.** The list is Talus's own experience with this cell; the law is Walton & Braun's (1986).

| symbol | meaning | value |
|:--|:-----|:-----|
| cell | 80 discs of ice, 5000 diameters a second | 8 kPa |
| time | of each run, the first quarter left out | .4 s; .1 s with wrong laws, .2 s with Euler's steps, .6 s with long ones |
| limits | solid fraction of equal discs, overlap over $D$ | .9069, .1 |

**What would break it.** A solver whose right law fails the limits that the wrong ones break; limits that none would break.
)";

/// A latching spring that is wrong in one way, else the right one.
enum class Wrong { none, flag_cleared, d0_forgotten };

template <Wrong wrong>
struct WrongLatch : LatchingSpring {
  constexpr double guard(Kinematics x, std::span<const double> memory, Mode mode) const {
    if (mode == slack && wrong == Wrong::flag_cleared) return x.extent;
    if (mode == slack && wrong == Wrong::d0_forgotten) return -1.0;
    return LatchingSpring::guard(x, memory, mode);
  }
  constexpr Reset reset(Kinematics x, std::span<double> memory, Mode mode) const {
    if (mode == slack && wrong == Wrong::d0_forgotten && x.extent > 0.0) {
      memory[0] = x.extent;
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
  double motion{};           ///< mean energy of the discs' motion across the field about their mean, over m VXT^2
  bool burst{};              ///< numbers beyond all sense: the run was ended
};

struct FlowPlan {
  double time{0.4};
  double steps_in_contact{20.0};
  std::string integrator{"velocity_verlet"};
};

/// The cell without the run's own refusals and limits.
template <class L>
Flow flow(const ShearCell& cell, const L& law, const FlowPlan& plan, Findings& findings) {
  const FilledCell filled = fill(cell);
  DiscSystem<L> system{filled.shapes, filled.box, law, 0.3 * cell.diameter};
  Discs discs = filled.discs;
  DiscMethod method = make_disc_method(plan.integrator);
  const double h = cell.contact_time() / plan.steps_in_contact;
  const long steps = std::lround(plan.time / h), start = steps / 4;
  system.begin(discs);
  Flow found;
  std::visit(
      [&](auto& stepper) {
        stepper.start(system, discs, h);
        double shear = 0.0, normal = 0.0;
        long looks = 0;
        for (long n = 0; n < steps && !found.burst; ++n) {
          stepper.step(system, discs, h);
          if (n < start) continue;
          shear -= system.wall_force(block_wall).x, normal += system.wall_force(block_wall).y;
          if (n % 8 != 0) continue;
          ++looks;
          const double fraction = solid_fraction(cell, discs);
          found.fraction += fraction;
          found.fullest = std::max(found.fullest, fraction);
          // About their mean: the discs rise and fall with the block.
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
        if (normal != 0.0) found.ratio = shear / normal;
        found.fraction /= static_cast<double>(std::max(1L, looks));
        found.motion /= static_cast<double>(std::max(1L, looks)) * static_cast<double>(cell.free_discs()) *
                        cell.block_speed * cell.block_speed;
      },
      method);
  findings.count(static_cast<std::uint64_t>(system.evaluations()));
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
                  "The cell right and wrong: stress ratio, which tells little, and what tells more. A run is ended "
                  "when its solid fraction leaves .02 to 5.",
              .columns = {"cell", "S/N", "mean fraction", "largest fraction", "largest overlap/D",
                          "motion across/(m VXT^2)", "limits"},
              .rows = {}};
  for (const Row& row : rows) {
    const Flow& flow = row.flow;
    table.rows.push_back({row.what, fmt::format("{:.3f}", flow.ratio), fmt::format("{:.3f}", flow.fraction),
                          fmt::format("{:.3f}", flow.fullest), fmt::format("{:.3f}", flow.largest_overlap),
                          fmt::format("{:.4f}", flow.motion),
                          within_limits(flow) ? "kept"
                          : flow.burst        ? "burst"
                                              : "broken"});
  }
  findings.table(table);
}

Figure figure_of(const std::vector<Row>& rows) {
  Figure figure{.name = "seen",
                .title = "What the stress ratio shows, and what it does not",
                .caption =
                    "Each cell by its stress ratio and its largest solid fraction: cells whose discs pass through each "
                    "other may have the ratio of the right one. Dashed: all that equal discs can fill.",
                .x = {.label = "S/N", .min = 0.0, .max = 0.4},
                .y = {.label = "largest solid fraction", .log = true},
                .series = {}};
  for (const Row& row : rows)
    if (row.flow.ratio != 0.0)
      figure.series.push_back(
          {.label = row.what, .x = {row.flow.ratio}, .y = {row.flow.fullest}, .style = Style::points});
  figure.lines = {{'y', CellRun::fullest, ""}};
  return figure;
}

void run(Findings& findings, const Setup& setup) {
  const ShearCell cell = ice_cell(8e3, 5e3);
  FlowPlan plan;
  if (setup.coarse) plan.time = 0.06;
  std::vector<Row> rows;
  const auto add = [&](const char* what, const Flow& found) { rows.push_back({what, found}); };
  const auto make = [&](auto law, const FlowPlan& how) {
    static_cast<LatchingSpring&>(law) = std::get<LatchingSpring>(cell.law);
    return flow(cell, law, how, findings);
  };
  FlowPlan brief = plan;
  brief.time = 0.1;
  const bool swapped = setup.has("right_law_for_the_wrong");
  const Flow right = setup.has("wrong_law_for_the_right") ? make(WrongLatch<Wrong::flag_cleared>{}, plan)
                                                          : make(WrongLatch<Wrong::none>{}, plan);
  const Flow cleared = swapped ? right : make(WrongLatch<Wrong::flag_cleared>{}, brief);
  const Flow forgotten = swapped ? right : make(WrongLatch<Wrong::d0_forgotten>{}, brief);
  add("right", right), add("(a) flag cleared at F = 0", cleared), add("(b) d0 forgotten at F = 0", forgotten);
  findings.expect_true("the right law keeps within the limits", within_limits(right), "equal discs, hardly pressed");
  findings.expect_true("a contact cleared at no force passes the limits", !within_limits(cleared),
                       "discs that are pressed again feel nothing and pass through each other");
  findings.expect_between(
      "motion across the field of contacts that forget d0 at no force, over the right cell's",
      forgotten.motion / right.motion, 1.1, 3.0,
      "a contact then gives back K1 d0^2/2 more at least: e^2 = .49 + .26 in a lone impact, and more energy "
      "of motion by that much or, as impacts follow each other, by some times");
  findings.expect_between(
      "stress ratio of the cell whose contacts are cleared", cleared.ratio, 0.15, 0.4,
      "the ratio looks right while the cell is not: between half and one and a half times the right one");

  FlowPlan steps = plan;
  if (!setup.coarse) steps.time = 0.6;
  for (const double in_contact : {6.0, 3.6, 2.0}) {
    steps.steps_in_contact = swapped && in_contact == 2.0 ? 20.0 : in_contact;
    const Flow found = make(WrongLatch<Wrong::none>{}, steps);
    add(in_contact == 6.0 ? "Verlet, 6 steps in a contact" : in_contact == 3.6 ? "Verlet, 3.6" : "Verlet, 2", found);
    const std::string name = fmt::format("velocity Verlet, {} steps in a contact", in_contact);
    if (in_contact > 3.0) {
      findings.expect_between(
          "stress ratio, " + name, found.ratio, right.ratio - 0.03, right.ratio + 0.03,
          "above the limit of stability of a disc among six, 3.3 steps, the ratio does not see the step: "
          "within three standard errors, .01 each");
    } else {
      findings.expect_true("limits are passed, " + name, !within_limits(found),
                           "below 3.3 steps a disc among six is unstable, below 1.9 any pair");
    }
  }
  FlowPlan euler = plan;
  euler.integrator = swapped ? "velocity_verlet" : "euler";
  euler.steps_in_contact = 10.0;
  const Flow heated = make(WrongLatch<Wrong::none>{}, euler);
  add("Euler, 10 steps", heated);
  euler.steps_in_contact = 120.0;
  euler.time = 0.5 * plan.time;
  const Flow fine = make(WrongLatch<Wrong::none>{}, euler);
  add("Euler, 120 steps", fine);
  findings.expect_true("limits are passed, Euler with 10 steps in a contact", !within_limits(heated),
                       "each contact gives back more than it took: e is above 1");
  findings.expect_true("limits are kept, Euler with 120 steps in a contact", within_limits(fine), "e is .73 there");

  findings.figure(figure_of(rows));
  add_rows(findings, rows);
}

}  // namespace

Case shear_cell_failures() {
  return {.id = "shear_cell_failures",
          .title = "Sheared cell: where it fails, and what shows it",
          .family = "the shear cell",
          .requirements = {{"law.latching_spring", {"the right law keeps within the limits"}}},
          .main_checks = {"the right law keeps within the limits", "a contact cleared at no force passes the limits",
                          "motion across the field of contacts that forget d0 at no force, over the right cell's",
                          "stress ratio of the cell whose contacts are cleared",
                          "limits are passed, velocity Verlet, 2 steps in a contact",
                          "limits are passed, Euler with 10 steps in a contact"},
          .source = "Talus; law of Walton & Braun 1986",
          .page = page,
          .faults = {{"wrong_law_for_the_right", "the law whose contacts are cleared taken for the right one",
                      "the right law keeps within the limits"},
                     {"right_law_for_the_wrong", "the right law and steps in all wrong cells",
                      "a contact cleared at no force passes the limits"}},
          .time_limit = 150.0,
          .run = run};
}

}  // namespace talus::verification::problems
