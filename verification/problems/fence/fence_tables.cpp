#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "verification/check/case.hpp"
#include "verification/problems/fence/fence_choice_findings.hpp"
#include "verification/problems/fence/fence_ensemble.hpp"
#include "verification/problems/fence/fence_pair_findings.hpp"
#include "verification/problems/fence/fence_snapshots.hpp"
#include "verification/problems/fence/fence_table_figures.hpp"
#include "verification/study/expectations.hpp"

namespace talus::verification::problems {

Case fence_tables();

namespace {

/// Mean distance of run and twin over all rows, as the full tier measures it: joint, top, bottom [%], speed [ft/s].
struct GroupTwins {
  bool bottom_cable;
  std::array<double, 4> distance;  ///< 0 where nothing is printed
};
constexpr std::array<GroupTwins, 2> measured_twins{
    {{false, {5.28, 3.02, 0.0, 0.98}}, {true, {4.65, 2.39, 2.04, 1.88}}}};

std::string group_name(bool bottom_cable) { return bottom_cable ? "with bottom cable" : "no bottom cable"; }

/// Without the bottom cable the print is a twin of ours; with it, it is not, and by how much is told.
void check_distance(Findings& findings, const std::string& name, const FenceDistance& d, double twins,
                    bool bottom_cable, const std::string& unit) {
  if (bottom_cable) {
    findings.expect_between(name + ": distance to the print over that of twins", d.mean / twins, 1.0, 3.4,
                            "two to three times the distance of twins: a program that shifted all four kinds of things "
                            "would come to two, so something of the bottom cable of 1993 is not as here and not told "
                            "in the report; one wrap instead of two comes to 6.6 in its force");
  } else {
    findings.expect(name + ": mean distance to the print", d.mean, 0.0,
                    Tolerance::model(2.0 * twins,
                                     "a twin has one of four kinds of things shifted (spin, height, nodes, step); a "
                                     "program that differs in all of them is twice as far if they add like "
                                     "independent errors"),
                    unit);
  }
}

void check_distances(Findings& findings, const std::vector<RowRun>& rows, const Setup& setup) {
  const bool all = setup.tier == Tier::full && !setup.coarse;
  Table table{.name = "distances",
              .caption =
                  "Mean distance between our runs and the print, beside that between our runs and their twins "
                  "(all twins: full tier).",
              .columns = {"quantity", "rows", "printed numbers", "mean distance to print", "mean distance to twins",
                          "inside the spread"}};
  for (const auto& [bottom_cable, twins] : measured_twins) {
    for (std::size_t q = 0; q < twins.size(); ++q) {
      const FenceQuantity& quantity = fence_quantities()[q];
      if (twins[q] == 0.0) continue;
      const FenceDistance d = distance_of(rows, quantity, bottom_cable);
      const std::string name = fmt::format("{}, {}", quantity.name, group_name(bottom_cable));
      check_distance(findings, name, d, twins[q], bottom_cable, quantity.distance_unit());
      if (all) {
        findings.expect(name + ": mean distance of twins, as the quick tier takes it", d.twins, twins[q],
                        Tolerance::model(0.005, "half a unit of its last digit"), quantity.distance_unit());
      }
      table.rows.push_back({quantity.name, group_name(bottom_cable), fmt::format("{}", d.count),
                            fmt::format("{:.2f} {}", d.mean, quantity.distance_unit()),
                            fmt::format("{:.2f} {}", twins[q], quantity.distance_unit()),
                            d.spread > 0 ? fmt::format("{} of {}", d.inside, d.spread) : "full tier"});
    }
  }
  findings.table(table);
}

/// Every printed number of one quantity beside ours.
Table row_table(const std::vector<RowRun>& rows, const FenceQuantity& quantity, const std::string& name) {
  const auto text = [&](double value) { return fmt::format("{:.{}f}", value, quantity.relative ? 0 : 1); };
  Table table{.name = name,
              .caption = fmt::format("Every printed {} beside ours [{}].", quantity.name, quantity.unit),
              .columns = {"row", "printed", "ours", "difference", "least twin", "largest twin", "verdict"}};
  for (const RowRun& row : rows) {
    const auto print = quantity.printed(row.printed);
    if (!print) continue;
    const double ours = row.run.peaks.*quantity.ours;
    const bool spread = !row.twins.empty();
    table.rows.push_back({name_of(row.printed), text(print->value), text(ours),
                          fmt::format("{:+.1f} {}", quantity.distance(ours, print->value), quantity.distance_unit()),
                          spread ? text(row.low(quantity)) : "", spread ? text(row.high(quantity)) : "",
                          !spread                ? ""
                          : row.inside(quantity) ? "inside the spread"
                                                 : "outside"});
  }
  return table;
}

/// The caps of the plastic rows, and that the last bottom segment, of which nothing is known, never acts.
void check_cables(Findings& findings, const std::vector<RowRun>& rows) {
  double top = 0.0, bottom = 0.0;
  for (const RowRun& row : rows) {
    if (!row.printed.plastic) continue;
    top = std::max(top, row.run.top_any), bottom = std::max(bottom, row.run.bottom_any);
  }
  const std::string why = "the cap is held, not passed: only the rounding of k (e - p) separates them";
  findings.expect("largest top cable force of the elastic-plastic rows", top, 2e5, Tolerance::round_off(1e-4, why),
                  "lb");
  findings.expect("largest bottom cable force of the elastic-plastic rows", bottom, 1e5,
                  Tolerance::round_off(1e-4, why), "lb");
}

/// What was found, in words.
void tell(Findings& findings, const std::vector<RowRun>& rows) {
  double any = 0.0;
  int count = 0;
  for (const RowRun& row : rows) {
    if (!row.printed.bottom) continue;
    any += std::abs(100.0 * (row.run.bottom_any / row.printed.bottom->value - 1.0));
    ++count;
  }
  findings.note(
      "**What agrees.** Without the bottom cable the print lies no further from our runs than their twins do in "
      "forces, "
      "and as far in exit velocity; all 14 printed velocities lie inside the spread (full tier).");
  findings.note(fmt::format(
      "**What does not.** With the bottom cable the print lies two to three times as far away as the twins, and 12 of "
      "20 "
      "printed velocities lie outside the spread (full tier). No single choice of those tried brings all four "
      "quantities "
      "near (table of choices). Worst: 1200 lb at yc = -3, where our joint force is 24 % low and the rock 13 ft/s "
      "faster. With the largest tension of any bottom segment instead of the one beside the centre the mean distance "
      "of the bottom force is {:.1f} %. Whether its last segment is anchored changes no bit: it never becomes taut. "
      "Nothing was fitted to close the gap.",
      any / count));
}

void run(Findings& findings, const Setup& setup) {
  const std::vector<RowRun> rows = run_rows(setup, setup.coarse ? 4.0 : 1.0);
  for (const RowRun& row : rows)
    findings.count(row.run.evaluations);
  check_distances(findings, rows, setup);
  check_pairs(findings, rows, setup);
  check_cables(findings, rows);
  if (setup.coarse) return;
  for (std::size_t q = 0; q < fence_quantities().size(); ++q) {
    static constexpr std::array names{"joint_force", "top_cable_force", "bottom_cable_force", "exit_velocity"};
    findings.table(row_table(rows, fence_quantities()[q], names[q]));
  }
  tell(findings, rows);
  check_choices(findings, rows, setup);
  draw_tables(findings, rows);
  for (const PrintedRow& row : printed_rows()) {
    if (row.table != 2 || row.height != 0.0 || row.plastic) continue;
    const int number = row.bottom_cable ? 12 : 13;
    findings.figure(snapshots(
        fmt::format("fig_{}_snapshots", number),
        fmt::format("Fig. {}: rock of 600 lb, {} bottom cable", number, row.bottom_cable ? "with" : "without"),
        fmt::format("Central column and rock at five times, for Fig. {} of the report; the rock "
                    "comes from the right.",
                    number),
        fence_of(row), {0.0, 0.03, 0.06, 0.1, 0.16}));
  }
  draw_histories(findings);
}

}  // namespace

Case fence_tables() {
  return {
      .id = "fence_tables",
      .title = "Rock impact studies: Tables 2 and 3",
      .family = "the fence",
      .requirements = {{"Eq. 12", {"joint = 2 T sin"}},
                       {"Eq. 14", {"joint = 2 T sin", "elastic-plastic rows"}},
                       {"Eq. 16", {"joint = 2 T sin"}},
                       {"law.elastic_plastic", {"elastic-plastic rows"}},
                       {"method.nodes", {"mean distance to the print"}},
                       {"shape.superquadric", {"mean distance to the print"}},
                       {"end_rule.attractive", {"mean distance to the print"}},
                       {"integrator.lagged_central_difference", {"mean distance to the print"}}},
      .main_checks = {"joint force, no bottom cable: mean distance to the print",
                      "top cable force, no bottom cable: mean distance to the print",
                      "exit velocity, no bottom cable: mean distance to the print",
                      "joint force, with bottom cable: distance to the print over that of twins",
                      "printed elastic pairs within their digits of joint = 2 T sin, of 21"},
      .source = "Mustoe & Huttelmaier 1993, section 6, Tables 1-3, Figs. 12-15",
      .faults = {{"mass_doubled", "columns of 29.85 slug, as in sample2.DAT",
                  "joint force, no bottom cable: mean distance to the print"},
                 {"limits_ignored", "cables that never yield", "largest top cable force of the elastic-plastic rows"},
                 {"height_downwards", "yc counted downwards",
                  "exit velocity, no bottom cable: mean distance to the print"},
                 {"bottom_wrapped_once", "a bottom cable of one strand",
                  "bottom cable force, with bottom cable: distance to the print over that of twins"}},
      .time_limit = 300.0,
      .run = run};
}

}  // namespace talus::verification::problems
