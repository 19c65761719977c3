#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/scenes/fence_scene.hpp"
#include "verification/check/case.hpp"
#include "verification/problems/speed_accuracy/left_out_findings.hpp"
#include "verification/study/fence_table.hpp"
#include "verification/study/scene_run.hpp"

namespace talus::verification::problems {

Case left_out();

namespace {

constexpr long steps = 25000;

enum class Sag { as_tight, share_of_span };

/// Table 2's fence with another number of columns, the spacing and the end segments as they are.
scenes::FenceScene long_fence(int columns, Sag sag, Sleep sleep) {
  scenes::Fence fence = published_fence("table_2.DAT");
  const double ratio = 1.0 + (columns - fence.columns) * fence.spacing / fence.span;
  fence.sag *= sag == Sag::as_tight ? ratio * ratio : ratio;
  fence.span *= ratio;
  fence.columns = columns;
  fence.options.sleep = sleep;
  return scenes::fence_scene(fence);
}

struct LongRun {
  State state;
  double pull{};   ///< largest tension of a cable [lb]
  double awake{};  ///< columns, mean over the steps
  double horizontal_tension{};
  Series columns;  ///< awake, against time
};

LongRun run_long(const scenes::FenceScene& made, Findings& findings) {
  const Scene& scene = made.scene;
  Probe probe{scene.model};
  LongRun found{{}, 0.0, 0.0, made.horizontal_tension, {.label = "", .style = Style::lines}};
  const std::size_t sleeper = Layout{scene.model}.first_sleeper;
  const auto columns = static_cast<double>(scene.model.bodies.size() - 2);  // without ground and rock
  const Watcher watch = [&](const State& state, const StepInfo& info) {
    const auto first = state.mode.begin() + static_cast<std::ptrdiff_t>(sleeper);
    const double awake =
        sleeper == state.mode.size() ? columns : static_cast<double>(std::count(first, state.mode.end(), Mode{1}));
    found.awake += awake / steps;
    if (!info.due) return;
    found.columns.add(1e3 * state.t, awake);
    probe.look(state);
    const std::vector<double>& tensions = probe.forces().tensions;
    found.pull = std::max(found.pull, *std::max_element(tensions.begin(), tensions.end()));
  };
  const double step = scene.plan.step;
  const RunEnd end = run_scene(scene, scene.integrator, {step, step * steps, 100.0 * step, false}, findings, watch);
  found.state = end.state;
  if (!end.finished) found.pull = std::nan("");
  return found;
}

void check_sleep(Findings& findings, const Setup& setup, Table& table) {
  const auto with = [&](Sleep sleep) { return run_long(long_fence(101, Sag::share_of_span, sleep), findings); };
  const LongRun off = with(Sleep::off), exact = with(setup.has("default_for_exact") ? Sleep::on : Sleep::exact);
  findings.expect("101 columns, sleep exact: state at .05 s from that without sleep, largest difference",
                  change(exact.state, off.state), 0.0,
                  Tolerance::exact("what sleeps is at rest in balance, and no pull on it has changed by a bit"));
  if (setup.coarse) return;
  const LongRun on = with(Sleep::on);
  const char* why =
      "a column stays asleep while the pull on it changes by less than 1e-13 of a tension of 65 600 lb: 6.6e-9 lb for "
      "a "
      "thousandth of a second, in which the motion of the next one doubles many times, on 14.9 slug are 4.4e-13 ft/s "
      "at "
      "the border, 8e-14 of the rock's 5.5 ft/s, and in the middle less; round-off of the 25 000 steps is as much";
  findings.expect("101 columns, sleep by default: speed of the rock, from that without", on.state.v[0], off.state.v[0],
                  Tolerance::model(2e-13, why).relative(), "ft/s");
  findings.expect("101 columns, sleep by default: largest difference of any coordinate or velocity",
                  change(on.state, off.state), 0.0,
                  Tolerance::model(2.2e-11,
                                   "6.6e-9 lb for all of .05 s on 14.9 slug: a border column that slept through what a "
                                   "waking one would have done"));
  table.rows.push_back({"sleep exact, 101 columns", "51", fmt::format("{:.1f}", exact.awake), "none"});
  table.rows.push_back({"sleep by default, 101 columns", "51", fmt::format("{:.1f}", on.awake),
                        fmt::format("{:.1e} of the speed", std::abs(on.state.v[0] / off.state.v[0] - 1.0))});
}

void check_length(Findings& findings, const Setup& setup, Table& table) {
  const auto with = [&](int columns, Sag sag) {
    return run_long(long_fence(columns, sag, setup.has("never_asleep") ? Sleep::off : Sleep::on), findings);
  };
  Figure figure{.name = "awake",
                .title = "Columns awake",
                .caption = "Half of each fence is modelled: 51 and 501 columns.",
                .x = {.label = "time", .unit = "ms"},
                .y = {.label = "columns awake", .min = 0.0}};
  for (const Sag sag : {Sag::as_tight, Sag::share_of_span}) {
    const LongRun tenth = with(101, sag), whole = with(1001, sag);
    const bool tight = sag == Sag::as_tight;
    const double ratio = whole.awake / tenth.awake;
    if (tight) {
      findings.expect_between("columns awake in .05 s, as tight: with 1,001 over with 101", ratio, 0.9, 1.1,
                              "nothing near the hit knows how long the fence is: the tensions differ by .7 %, and the "
                              "slopes of the cables");
    } else {
      findings.expect_between("columns awake in .05 s, by share of the span: with 1,001 over with 101", ratio, 1.0,
                              std::sqrt(whole.horizontal_tension / tenth.horizontal_tension),
                              "motion runs along a cable with the root of its tension, and has to come that far");
    }
    const char* what = tight ? "as tight" : "share of span";
    for (const auto& [columns, found] : {std::pair{51, &tenth}, std::pair{501, &whole}}) {
      table.rows.push_back({fmt::format("sleep by default, {} columns, {}", 2 * columns - 1, what),
                            fmt::format("{}", columns), fmt::format("{:.1f}", found->awake), ""});
      figure.series.push_back(found->columns);
      figure.series.back().label = fmt::format("{} columns, {}", 2 * columns - 1, what);
    }
    if (setup.coarse) return;
  }
  findings.figure(figure);
}

void run(Findings& findings, const Setup& setup) {
  Table table{.name = "visited",
              .caption =
                  "What a step could visit, and what it does (mean over the steps). Without sleep a fence visits "
                  "all its columns; half of a fence is modelled.",
              .columns = {"what", "in the scene", "visited", "change of the result"}};
  check_sleep(findings, setup, table);
  check_length(findings, setup, table);
  check_contacts(findings, setup, table);
  check_rows(findings, setup, table);
  findings.table(table);
}

}  // namespace

Case left_out() {
  return {
      .id = "left_out",
      .title = "What is left out changes nothing",
      .family = "speed and accuracy",
      .requirements = {{"E10", {"with every pair"}}},
      .main_checks = {"101 columns, sleep exact: state at .05 s from that without sleep, largest difference",
                      "101 columns, sleep by default: speed of the rock, from that without",
                      "columns awake in .05 s, as tight: with 1,001 over with 101",
                      "columns awake in .05 s, by share of the span: with 1,001 over with 101",
                      "yard: state at the end from that with every pair, largest difference",
                      "16 discs: state at the end from that with every pair, largest difference",
                      "fence of two layers: state at the end from that with every pair, largest difference",
                      "yard, located events: state from that with every guard, largest difference",
                      "16 discs, located events: state from that with every guard, largest difference",
                      "fence of two layers, located events: state from that with every guard, largest difference",
                      "tensions of rows of cables from those of the laws, one by one, largest difference over a run",
                      "without ledger, paths not told: state at the end from that with, largest difference"},
      .source = "Verlet 1967 and Baraff 1992 for the contact search",
      .faults = {{"default_for_exact", "the default's threshold where `exact` is asked for",
                  "101 columns, sleep exact: state at .05 s from that without sleep, largest difference"},
                 {"never_asleep", "a fence that never sleeps",
                  "columns awake in .05 s, as tight: with 1,001 over with 101"},
                 {"pair_forgotten", "one of the yard's pairs never found",
                  "yard: state at the end from that with every pair, largest difference"},
                 {"no_time_ahead", "located events without the guards of what does not act yet",
                  "yard, located events: state from that with every guard, largest difference"},
                 {"line_of_another", "one cable's law stiffer by 1e-15",
                  "tensions of rows of cables from those of the laws, one by one, largest difference over a run"},
                 {"paths_of_another", "the run with ledger of a fence one of whose cables is stiffer by 1e-15",
                  "without ledger, paths not told: state at the end from that with, largest difference"}},
      .run = run};
}

}  // namespace talus::verification::problems
