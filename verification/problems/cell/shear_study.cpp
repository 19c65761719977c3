#include <thread>

#include "solver/base/error.hpp"
#include "solver/cell/cell_run.hpp"
#include "solver/study/shear_study.hpp"
#include "verification/problems/cell/cell_runs.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::shear_study {
namespace {

using Q = StudyQuantity;

const StudyMean* find(const std::vector<StudyMean>& study, const std::string& series, double kilopascals, double speed,
                      double stiffness = 1.0) {
  for (const StudyMean& point : study) {
    if (point.point.series == series && point.point.overburden == 1e3 * kilopascals && point.point.speed == speed &&
        point.point.stiffness == stiffness)
      return &point;
  }
  throw std::logic_error{"no such point of the study: " + series};
}

enum class Over { load, speed };

Series curve(const std::vector<StudyMean>& study, const std::string& series, Q quantity, Over over,
             const std::string& label, int panel = 0) {
  Series made{.label = label, .style = Style::errorbars, .panel = panel};
  for (const StudyMean& point : study) {
    if (point.point.series != series || point.seeds < 2) continue;
    const Estimate of = point.of(quantity);
    made.add(over == Over::load ? point.point.overburden / 1e3 : point.point.speed, of.value);
    made.y_low.push_back(of.value - of.error), made.y_high.push_back(of.value + of.error);
  }
  return made;
}

void add_figures(Findings& findings, const std::vector<StudyMean>& study) {
  Figure ratio{.name = "ratio",
               .title = "Stress ratio against load and against speed",
               .caption =
                   "S/N on the block, means over five seeds with standard errors; d/s: diameters per second. Left: at "
                   "5000 d/s (blue) the load does not lower S/N, at 1000 d/s (orange) it does. Right: 2 kPa (blue), 15 "
                   "kPa (orange), 32 kPa (green).",
               .x = {.label = "overburden [kPa]; speed [100 d/s]", .log = true},
               .y = {.label = "S/N", .min = 0.0, .max = 0.35},
               .series = {curve(study, "5000 d/s", Q::stress_ratio, Over::load, "5000 d/s"),
                          curve(study, "1000 d/s", Q::stress_ratio, Over::load, "1000 d/s")}};
  for (const char* load : {"2 kPa", "15 kPa", "32 kPa"}) {
    Series speeds = curve(study, load, Q::stress_ratio, Over::speed, load, 1);
    for (double& x : speeds.x)
      x /= 100.0;
    ratio.series.push_back(std::move(speeds));
  }
  ratio.panels = {"against load", "against speed"};
  ratio.columns = 2;
  findings.figure(std::move(ratio));
  Figure fractions{.name = "shares",
                   .title = "Contact statistics and depth against load",
                   .caption =
                       "At 5000 d/s: fraction of time with contacts, fraction of contact time in multiple contacts, "
                       "fraction of the contact shear carried by multiple contacts (M/S), depth over ten diameters.",
                   .x = {.label = "overburden", .unit = "kPa", .log = true},
                   .y = {.label = "fraction; depth/(10 D)", .min = 0.3, .max = 1.05},
                   .series = {curve(study, "5000 d/s", Q::touching, Over::load, "time with contacts"),
                              curve(study, "5000 d/s", Q::multiple_fraction, Over::load, "multiple"),
                              curve(study, "5000 d/s", Q::multiple_shear_fraction, Over::load, "M/S"),
                              curve(study, "5000 d/s", Q::depth, Over::load, "depth/(10 D)")}};
  for (std::vector<double>* values : {&fractions.series[3].y, &fractions.series[3].y_low, &fractions.series[3].y_high})
    for (double& value : *values)
      value /= 10.0;
  findings.figure(std::move(fractions));
}

/// Outlines of the discs at the end of a run.
Series outlines(double kilopascals, double speed, double time, int panel, const std::string& label) {
  const ShearCell cell = study_cell({"", 1e3 * kilopascals, speed, 1.0}, 1);
  CellRun run{cell, cell_plan(cell, time)};
  run_to_end(run);
  const Discs discs = run.discs();
  Series made{.label = label, .style = Style::outlines, .panel = panel};
  constexpr int corners = 24;
  for (std::size_t i = 0; i < discs.size(); ++i) {
    for (int k = 0; k <= corners; ++k) {
      const double angle = 2.0 * std::numbers::pi * (k % corners) / corners;
      made.add((discs.x[i] / cell.diameter) + 0.5 * std::cos(angle),
               (discs.y[i] / cell.diameter) + 0.5 * std::sin(angle));
    }
  }
  return made;
}

void add_picture(Findings& findings, double time) {
  findings.figure({.name = "order",
                   .title = "Order of the discs under the same load at two speeds",
                   .caption = "Discs at the end of a run under 32 kPa. At 1000 d/s they form rows, and the block's "
                              "discs slip along one of them; at 5000 d/s the rows are broken up.",
                   .x = {"x/D", "1"},
                   .y = {"y/D", "1"},
                   .series = {outlines(32.0, 1000.0, time, 0, "1000 d/s"), outlines(32.0, 5000.0, time, 1, "5000 d/s")},
                   .panels = {"1000 d/s", "5000 d/s"},
                   .columns = 2});
}

void add_verdicts(Findings& findings, const std::vector<Verdict>& found) {
  Table table{.name = "verdicts",
              .caption =
                  "Predictions of the hypothesis and results of the cells: Student's t of the difference, and "
                  "probability of a t at least as large without a difference.",
              .columns = {"prediction", "measured", "t", "probability", "verdict"}};
  for (const Verdict& verdict : found)
    table.rows.push_back(cells("{} | {} | {:+.1f} | {:.1g} | {}", verdict.prediction, verdict.measured,
                               verdict.significance, verdict.chance, std::string{text_of(verdict.outturn)}));
  findings.table(std::move(table));
  std::string note = "Results of the cells:";
  for (const Verdict& verdict : found) {
    note += fmt::format(" *{}* This {}: {}.", verdict.prediction, talus::text_of(verdict.outturn), verdict.measured);
  }
  findings.note(note);
}

void add_numbers(Findings& findings, const std::vector<StudyMean>& study) {
  Table table{
      .name = "study",
      .caption =
          "All cells: means over seeds with standard errors. I: inertial number; order: six-fold order, 1 in a "
          "triangular array; overlap: largest of each run, mean over seeds (0.1 and above: discs are not hard).",
      .columns = {"P [kPa]", "d/s", "k", "S/N", "multiple", "M/S", "S/N multiple", "S/N binary", "I", "order",
                  "overlap/D"}};
  std::vector<std::array<double, 3>> seen;
  for (const StudyMean& point : study) {
    const std::array key{point.point.overburden, point.point.speed, point.point.stiffness};
    if (std::find(seen.begin(), seen.end(), key) != seen.end()) continue;
    seen.push_back(key);
    const auto of = [&](Q quantity) {
      const Estimate estimate = point.of(quantity);
      return point.seeds == 0 ? std::string{"failed"}
                              : fmt::format("{:.3f}({:.0f})", estimate.value, 1e3 * estimate.error);
    };
    const auto bare = [&](Q quantity) {
      return point.seeds == 0 ? std::string{"-"} : fmt::format("{:.3f}", point.of(quantity).value);
    };
    table.rows.push_back(cells(
        "{:g} | {:g} | {:g} | {} | {} | {} | {} | {} | {} | {} | {}", key[0] / 1e3, key[1], key[2], of(Q::stress_ratio),
        bare(Q::multiple_fraction), bare(Q::multiple_shear_fraction), of(Q::multiple_stress_ratio),
        of(Q::binary_stress_ratio), bare(Q::inertial_number), bare(Q::order), bare(Q::largest_overlap)));
  }
  findings.table(std::move(table));
}

void run(Findings& findings, const Setup& setup) {
  StudyPlan plan{.time = setup.coarse ? 0.15 : 0.3, .seeds = setup.coarse ? 3 : 5, .threads = 1};
  if (!setup.coarse) plan.threads = std::clamp(std::thread::hardware_concurrency(), 1U, 2U);
  std::vector<StudyPoint> points = shear_study_points(setup.coarse);
  for (StudyPoint& point : points)
    if (setup.has("one_speed") && point.series == "1000 d/s") point.speed = 5000.0;
  std::vector<StudyMean> study = talus::shear_study(points, plan);
  for (StudyMean& point : study) {
    if (setup.has("one_speed") && point.point.series == "1000 d/s") point.point.speed = 1000.0;
    // Exchanges 2 and 32 kPa.
    if (setup.has("loads_exchanged")) point.point.overburden = 1e3 * std::round(64e3 / point.point.overburden);
  }
  const std::vector<Verdict> found = verdicts(study);
  findings.expect_true("prediction 1, compression of the field", found[0].outturn == Outturn::holds,
                       "probability that the difference is accidental: 1 % at most");
  findings.expect_true({"prediction_2", "prediction 2, formation of multiple contacts"},
                       found[1].outturn == Outturn::holds,
                       "probability that the difference is accidental: 1 % at most");
  const auto ratio = [&](const char* series, double load, double speed) {
    return find(study, series, load, speed)->of(Q::stress_ratio).value;
  };
  const double fast = ratio("5000 d/s", 32.0, 5000.0) / ratio("5000 d/s", 2.0, 5000.0);
  const double slow = ratio("1000 d/s", 32.0, 1000.0) / ratio("1000 d/s", 2.0, 1000.0);
  findings.expect_between({"load_fast", "S/N at 32 kPa over that at 2 kPa, 5000 d/s"}, fast, 0.85, 1.15,
                          "sixteen times the load changes the ratio by less than a seventh; by prediction 4 it would "
                          "fall as multiple contacts grow to nine tenths");
  findings.expect_between({"load_slow", "S/N at 32 kPa over that at 2 kPa, 1000 d/s"}, slow, 0.3, 0.8,
                          "it falls to about a half: discs in rows slip along them");
  if (setup.coarse) return;
  double overlap = 0.0;
  for (const StudyMean& point : study) {
    if (point.point.overburden > 15e3 || point.point.speed > 5000.0 || point.point.stiffness < 1.0) continue;
    for (const StudyMean::Run& run : point.runs)
      overlap = std::max(overlap, run.numbers[static_cast<std::size_t>(Q::largest_overlap)]);
  }
  findings.expect_between("largest overlap over D, all runs up to 15 kPa and 5000 d/s", overlap, 0.03, 0.1,
                          "the discs are hard: overlaps below a tenth; the table shows where they are not (32 kPa with "
                          "some seeds, 64 kPa, 10,000 d/s and more)");
  const auto stiff = [&](double k, Q quantity) {
    return find(study, "stiffness", 15.0, 5000.0, k)->of(quantity).value;
  };
  findings.expect_between(
      {"stiffer_multiples", "fraction of multiple contacts at four times the stiffness over that at the original one"},
      stiff(4.0, Q::multiple_fraction) / stiff(1.0, Q::multiple_fraction), 0.6, 0.97,
      "contacts last half as long, so fewer are multiple");
  findings.expect_between("S/N at four times the stiffness over that at the original one",
                          stiff(4.0, Q::stress_ratio) / stiff(1.0, Q::stress_ratio), 0.92, 1.1,
                          "fewer multiple contacts at the same load and speed change the ratio by less than a tenth");
  add_figures(findings, study);
  add_picture(findings, plan.time);
  add_verdicts(findings, found);
  add_numbers(findings, study);
}

}  // namespace

Case definition() {
  return {.id = "shear_study",
          .title = "Sheared cell: stress ratio and multiple contacts",
          .family = "the shear cell",
          .requirements = {{"law.latching_spring", {"load_fast"}}},
          .main_checks = {"prediction 1, compression of the field", "prediction_2", "load_fast", "load_slow",
                          "stiffer_multiples", "S/N at four times the stiffness over that at the original one"},
          .source = "Lacy 1989, The Problem; Welch 1947 for the test",
          .faults = {{"one_speed", "series at 1000 d/s run at 5000 d/s", "load_slow"},
                     {"loads_exchanged", "lightest and heaviest load exchanged", "prediction_2"}},
          .tier = Tier::full,
          .full_seconds = 80.0,
          .time_limit = 900.0,
          .run = run};
}

}  // namespace talus::verification::problems::shear_study
