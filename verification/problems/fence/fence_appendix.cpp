#include "verification/problems/fence/fence_impact.hpp"
#include "verification/problems/fence/fence_snapshots.hpp"
#include "verification/study/scenes/fence_table.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::fence_appendix {
namespace {

/// One simulation and its twins, the runs with perturbed settings.
struct Simulation {
  std::string name;
  FenceRun run;                    ///< with its history, every step
  std::vector<FenceSample> twins;  ///< peaks of the twins; empty in coarse setups

  /// Minimum and maximum of a quantity over the run and its twins.
  [[nodiscard]] double low(double FenceSample::*quantity) const;
  [[nodiscard]] double high(double FenceSample::*quantity) const;
};

/// The paper's four simulations, and one layer with the top cable only.
struct Simulations {
  Simulation one, two, nine, top_only, one_top_only;
};

/// A change of settings that the paper does not state.
struct AppendixTwin {
  double spin{};    ///< added to each rock's angular velocity [rad/s]
  double height{};  ///< added to each rock's height [ft]
  double angle{};   ///< added to each rock's orientation [deg]
  int finer{1};     ///< number of steps that replace one
};

constexpr std::array declared{AppendixTwin{.spin = 2.0},     AppendixTwin{.spin = -2.0}, AppendixTwin{.height = 0.02},
                              AppendixTwin{.height = -0.02}, AppendixTwin{.angle = 7.5}, AppendixTwin{.angle = 15.0},
                              AppendixTwin{.angle = 22.5},   AppendixTwin{.finer = 2},   AppendixTwin{.finer = 10}};

scenes::Fence shifted(scenes::Fence fence, const AppendixTwin& twin) {
  for (scenes::FenceElement& rock : fence.rocks) {
    rock.spin += twin.spin;
    rock.position.y += twin.height;
    rock.angle += twin.angle * std::numbers::pi / 180.0;
  }
  fence.step_factor /= twin.finer;
  fence.steps *= twin.finer;
  return fence;
}

Simulation simulation(std::string name, const scenes::Fence& fence, const Setup& setup, Findings& findings) {
  Simulation made{std::move(name), run_fence(fence, 1), {}};
  findings.count(made.run.evaluations);
  if (setup.coarse) return made;
  for (const AppendixTwin& twin : declared)
    made.twins.push_back(run_fence(shifted(fence, twin)).peaks);
  return made;
}

double Simulation::low(double FenceSample::*quantity) const {
  double minimum = run.peaks.*quantity;
  for (const FenceSample& twin : twins)
    minimum = std::min(minimum, twin.*quantity);
  return minimum;
}

double Simulation::high(double FenceSample::*quantity) const {
  double largest = run.peaks.*quantity;
  for (const FenceSample& twin : twins)
    largest = std::max(largest, twin.*quantity);
  return largest;
}

/// The fence of a deck with the faults of `setup`: `mass_doubled`, `bottom_cable_left_out`, `one_layer`.
scenes::Fence appendix_fence(const std::string& deck, const Setup& setup) {
  scenes::Fence fence = published_fence(deck);
  if (setup.has("mass_doubled")) fence.column.density *= 2.0;
  if (setup.has("bottom_cable_left_out")) fence.connections = 1;
  if (setup.has("one_layer")) fence.layers = 1;
  return fence;
}

Simulations simulations(const Setup& setup, Findings& findings) {
  scenes::Fence one_top_only = appendix_fence("appendix_one_layer.DAT", setup);
  one_top_only.connections = 1;
  return {
      simulation("one layer", appendix_fence("appendix_one_layer.DAT", setup), setup, findings),
      simulation("two layers", appendix_fence("appendix_two_layers.DAT", setup), setup, findings),
      simulation("two layers, nine rocks", appendix_fence("appendix_nine_rocks.DAT", setup), setup, findings),
      simulation("two layers, top cable only", appendix_fence("appendix_top_cable_only.DAT", setup), setup, findings),
      simulation("one layer, top cable only", one_top_only, setup, findings)};
}

/// Largest joint force after a time [lb].
double joint_after(const FenceRun& run, double time) {
  double largest = 0.0;
  for (const FenceSample& sample : run.history) {
    if (sample.time > time) largest = std::max(largest, sample.joint);
  }
  return largest;
}

/// First time at which the bottom cable beside the central column pulls [s].
double first_pull(const FenceRun& run) {
  const auto taut = std::find_if(run.history.begin(), run.history.end(), [](const auto& s) { return s.bottom > 0.0; });
  return taut == run.history.end() ? std::nan("") : taut->time;
}

/// Root mean square difference of the rocks' velocities, divided by the impact velocity.
double apart(const FenceRun& a, const FenceRun& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.history.size(); ++i)
    sum += std::pow(a.history[i].speed - b.history[i].speed, 2);
  return std::sqrt(sum / static_cast<double>(a.history.size())) / 53.0;
}

void check_statements(Findings& findings, const Simulations& s) {
  const auto joint = [](const Simulation& x) { return x.run.peaks.joint; };
  findings.expect_between(
      {"final_energy", "final over initial kinetic energy of the rocks, maximum of the runs with bottom cable"},
      std::max({s.one.run.energy, s.two.run.energy, s.nine.run.energy}), 0.0, 0.1,
      "the paper says that the fences \"essentially absorb all the kinetic energy\", taken as at most a tenth "
      "remaining");
  findings.expect_between({"joint_two_layers", "peak joint force, two layers over one layer"},
                          joint(s.two) / joint(s.one), 0.3, 0.9,
                          "the paper says \"significantly less\", taken as at least a tenth less; a fence without a "
                          "second layer would give 1");
  findings.expect_between({"joint_nine_rocks", "peak joint force, nine rocks over one rock"},
                          joint(s.nine) / joint(s.two), 0.9, 1.1,
                          "the paper says \"similar in magnitude\", taken as within a tenth");
  findings.expect_between(
      {"exit_bottom", "exit speed, two layers, with bottom cable over top cable only"},
      s.two.run.peaks.speed / s.top_only.run.peaks.speed, 0.0, 0.5,
      "the paper says that the bottom cable \"decreases the rock velocity more\", taken as to less than half");
  findings.expect_model({"exit_one_layer", "exit speed, one layer with top cable only"},
                        -s.one_top_only.run.peaks.speed, 32.0, 0.5,
                        "half a unit of the last digit of the 32 ft/s that the paper gives for two layers", "ft/s");
}

void check_mismatch(Findings& findings, const Simulations& s) {
  findings.expect_between(
      {"exit_two_layers", "exit speed, two layers with top cable only: shortfall from the paper's 32 ft/s"},
      32.0 + s.top_only.run.peaks.speed, 10.0, 13.0,
      "not reproduced: 20.9 ft/s at the paper's step, 20.8 ft/s at a tenth of it; the limits include the spread of the "
      "perturbed runs (twins)",
      "ft/s");
  findings.expect_between(
      {"joint_time", "peak joint force, two layers: time before the paper's 0.05 s"}, 0.05 - s.two.run.peaks.time,
      0.005, 0.02, "not reproduced: 0.038 s; \"0.05 seconds\", read from a graph, may mean 0.045 to 0.055 s", "s");
  const scenes::Fence fence = published_fence("appendix_two_layers.DAT");
  findings.expect_model("the paper's step, 2e-4 s, over the step by the program's rule", fence.step_factor, 3.4185583,
                        5e-6, "rounding of the deck's digits; 2e-4 s over T/100, T = 2 pi sqrt(m/(2 k)), k = E A/l");
}

Table statement_table(const Simulations& s) {
  const auto row = [](std::string said, std::string ours, std::string verdict) {
    return std::vector<std::string>{std::move(said), std::move(ours), std::move(verdict)};
  };
  const auto kip = [](const Simulation& x) { return x.run.peaks.joint / 1000.0; };
  const auto speed = [](const Simulation& x) { return -x.run.peaks.speed; };
  return {.name = "statements",
          .caption = "Statements of Appendix I compared with the runs.",
          .columns = {"statement of the paper", "runs", "verdict"},
          .rows = {
              row("One and two layers: similar motion of the rock",
                  fmt::format("velocities differ by {:.1f} % of 53 ft/s (rms)", 100.0 * apart(s.one.run, s.two.run)),
                  "holds"),
              row("Response of two layers significantly less than that of one",
                  fmt::format("peak joint force {:.1f} instead of {:.1f} kip, {:.0f} % less", kip(s.two), kip(s.one),
                              100.0 * (1.0 - kip(s.two) / kip(s.one))),
                  "holds"),
              row("The bottom cable decreases the rock's velocity more",
                  fmt::format("exit speed {:.1f} ft/s with it, {:.1f} ft/s without", speed(s.two), speed(s.top_only)),
                  "holds"),
              row("With both cables essentially all kinetic energy is absorbed",
                  fmt::format("remaining: {:.1f} %, {:.1f} %, {:.1f} %", 100.0 * s.one.run.energy,
                              100.0 * s.two.run.energy, 100.0 * s.nine.run.energy),
                  "holds within a tenth"),
              row("Top cable only, two layers: 53 to 32 ft/s",
                  fmt::format("53 to {:.1f} ft/s (with twins {:.1f} to {:.1f} ft/s); one layer: {:.1f} ft/s",
                              speed(s.top_only), -s.top_only.high(&FenceSample::speed),
                              -s.top_only.low(&FenceSample::speed), speed(s.one_top_only)),
                  fmt::format("does not hold, by {:.1f} ft/s", 32.0 - speed(s.top_only))),
              row("High peak at 0.05 s with two cables, as the bottom cable becomes taut",
                  fmt::format("taut at {:.4f} s, peak at {:.4f} s (two layers); {:.4f} and {:.4f} s (one)",
                              first_pull(s.two.run), s.two.run.peaks.time, first_pull(s.one.run), s.one.run.peaks.time),
                  fmt::format("cause holds; peak {:.0f} ms too early", 1e3 * (0.05 - s.two.run.peaks.time))),
              row("The single fence has the highest peak",
                  fmt::format("{:.1f} kip; others {:.1f}, {:.1f}, {:.1f} kip", kip(s.one), kip(s.two), kip(s.nine),
                              kip(s.top_only)),
                  "holds"),
              row("Nine rocks: largest force similar to that of one rock",
                  fmt::format("{:.1f} instead of {:.1f} kip", kip(s.nine), kip(s.two)), "holds"),
              row("Nine rocks: smaller peaks after 0.08 s from multiple impacts",
                  fmt::format("largest joint force after 0.08 s: {:.1f} kip, with one rock {:.1f} kip",
                              joint_after(s.nine.run, 0.08) / 1e3, joint_after(s.two.run, 0.08) / 1e3),
                  joint_after(s.nine.run, 0.08) > joint_after(s.two.run, 0.08) ? "holds" : "does not hold")}};
}

Table run_table(const Simulations& s) {
  Table table{
      .name = "runs",
      .caption = "The five simulations at the paper's step, and the ranges of run and perturbed copies (twins).",
      .columns = {"simulation", "joint force [lb]", "run and twins", "peak at [s]", "top cable [lb]",
                  "bottom cable [lb]", "exit speed [ft/s]", "run and twins", "remaining energy [%]"}};
  for (const Simulation* x : {&s.one, &s.two, &s.nine, &s.top_only, &s.one_top_only}) {
    const FenceSample& p = x->run.peaks;
    table.rows.push_back(
        cells("{} | {:.0f} | {:.0f} to {:.0f} | {:.4f} | {:.0f} | {:.0f} | {:.2f} | {:.1f} to {:.1f} | {:.1f}", x->name,
              p.joint, x->low(&FenceSample::joint), x->high(&FenceSample::joint), p.time, p.top, p.bottom, -p.speed,
              -x->high(&FenceSample::speed), -x->low(&FenceSample::speed), 100.0 * x->run.energy));
  }
  return table;
}

/// Effect of each choice that the paper leaves open on the exit speed that is not reproduced.
Table choice_table(const Setup& setup) {
  struct Choice {
    const char* name;
    void (*make)(scenes::Fence&);
  };
  static constexpr std::array choices{
      Choice{"as assumed", [](scenes::Fence&) {}},
      Choice{"layers 3 ft apart instead of 2.6", [](scenes::Fence& f) { f.layer_spacing = 3.0; }},
      Choice{"layers 4 ft apart", [](scenes::Fence& f) { f.layer_spacing = 4.0; }},
      Choice{"layers 6 ft apart", [](scenes::Fence& f) { f.layer_spacing = 6.0; }},
      Choice{"layers 50 ft apart (no contact)", [](scenes::Fence& f) { f.layer_spacing = 50.0; }},
      Choice{"omega0 = 34 rad/s instead of 0", [](scenes::Fence& f) { f.rocks.front().spin = 34.0; }},
      Choice{"overlap of rock and column 0.06 ft", [](scenes::Fence& f) { f.rock_overlap = 0.06; }},
      Choice{"overlap of two columns 0.06 ft", [](scenes::Fence& f) { f.layer_overlap = 0.06; }},
      Choice{"clamped contacts", [](scenes::Fence& f) { f.options.end_rule = EndRule::clamped; }},
      Choice{"one resultant per pair", [](scenes::Fence& f) { f.options.contact = scenes::FenceContact::resultant; }}};
  Table table{.name = "choices",
              .caption = "Two layers with the top cable only: exit speed with each unstated choice changed in turn.",
              .columns = {"choice", "exit speed [ft/s]", "joint force [lb]"}};
  for (const Choice& choice : choices) {
    scenes::Fence fence = appendix_fence("appendix_top_cable_only.DAT", setup);
    choice.make(fence);
    // A tenth of the paper's step: some choices make the contact stiffer.
    const FenceRun run = run_fence(shifted(fence, {.finer = 10}));
    table.rows.push_back(
        {choice.name, fmt::format("{:.1f}", -run.peaks.speed), fmt::format("{:.0f}", run.peaks.joint)});
  }
  return table;
}

Figure history(std::string name, std::string title, std::string caption, const Axis& y, double FenceSample::*quantity,
               const std::vector<const Simulation*>& shown) {
  Figure figure{.name = std::move(name),
                .title = std::move(title),
                .caption = std::move(caption),
                .x = {.label = "time", .unit = "s"},
                .y = y};
  for (const Simulation* x : shown) {
    Series series{.label = x->name, .style = Style::lines};
    for (const FenceSample& sample : x->run.history)
      series.add(sample.time, sample.*quantity);
    figure.series.push_back(std::move(series));
  }
  return figure;
}

void draw(Findings& findings, const Simulations& s) {
  findings.figure(history("fig_4_velocity", "Appendix I, Fig. 4: velocity of the rocks",
                          "x velocity of the rock, or of the nine rocks' centre of mass.",
                          {.label = "x velocity", .unit = "ft/s"}, &FenceSample::speed,
                          {&s.one, &s.two, &s.nine, &s.top_only, &s.one_top_only}));
  const Axis force{.label = "force in the top joint", .unit = "lb"};
  findings.figure(history(
      "fig_5a_joint", "Appendix I, Fig. 5a: force in the top joint",
      "Central column of the first layer: one and two layers with both cables, and two layers with the top cable only.",
      force, &FenceSample::joint, {&s.one, &s.two, &s.top_only}));
  findings.figure(history("fig_5b_joint", "Appendix I, Fig. 5b: force in the top joint, nine rocks",
                          "Central column of the first layer, two layers with both cables: one rock and nine rocks.",
                          force, &FenceSample::joint, {&s.two, &s.nine}));
}

/// Figs. 2 and 3 of the appendix.
void draw_snapshots(Findings& findings, const Setup& setup) {
  struct Shown {
    const char* name;
    const char* title;
    const char* deck;
  };
  for (const Shown& shown : {Shown{"snapshots_1", "one layer", "appendix_one_layer.DAT"},
                             Shown{"snapshots_2", "two layers", "appendix_two_layers.DAT"},
                             Shown{"snapshots_3", "two layers, nine rocks", "appendix_nine_rocks.DAT"},
                             Shown{"snapshots_4", "two layers, top cable only", "appendix_top_cable_only.DAT"}}) {
    findings.figure(snapshots(shown.name, fmt::format("Appendix I, Figs. 2 and 3: {}", shown.title),
                              "Central columns and rocks at three times; the rocks come from the right.",
                              appendix_fence(shown.deck, setup), {0.0, 0.08, 0.2}));
  }
}

void run(Findings& findings, const Setup& setup) {
  const Simulations s = simulations(setup, findings);
  check_statements(findings, s);
  check_mismatch(findings, s);
  if (setup.coarse) return;
  findings.table(statement_table(s));
  findings.table(run_table(s));
  findings.table(choice_table(setup));
  draw_snapshots(findings, setup);
  draw(findings, s);
}

}  // namespace

Case definition() {
  return {.id = "fence_appendix",
          .title = "Appendix I: fences of one and two layers",
          .family = "the fence",
          .requirements = {{"Eq. 3", {"final_energy", "joint_two_layers", "joint_nine_rocks", "joint_time"}},
                           {"Eq. 9, Eq. 10", {"exit_bottom", "exit_one_layer", "exit_two_layers"}},
                           {"law.elastic_plastic", {"joint_two_layers", "joint_nine_rocks", "joint_time"}},
                           {"method.nodes", {"exit_bottom", "exit_one_layer", "exit_two_layers"}},
                           {"shape.superquadric", {"joint_two_layers", "joint_time"}},
                           {"shape.circle", {"exit_bottom", "exit_one_layer", "exit_two_layers"}},
                           {"integrator.lagged_central_difference",
                            {"joint_two_layers", "joint_nine_rocks", "exit_bottom", "exit_one_layer", "exit_two_layers",
                             "joint_time"}}},
          .main_checks = {"final_energy", "joint_two_layers", "joint_nine_rocks", "exit_two_layers", "exit_one_layer"},
          .source = "Mustoe & Huttelmaier 1993, Appendix I, Analysis Results, Figs. 2-5",
          .faults = {{"mass_doubled", "columns of 29.85 slug, as in sample2.DAT", "exit_one_layer"},
                     {"bottom_cable_left_out", "no run has a bottom cable", "final_energy"},
                     {"one_layer", "all fences have one layer", "joint_two_layers"}},
          .run = run};
}

}  // namespace talus::verification::problems::fence_appendix
