#include "solver/io/scene/read_scene.hpp"
#include "solver/scenes/fence_summary.hpp"
#include "solver/stability/step_advice.hpp"
#include "verification/study/runs/recorded_run.hpp"
#include "verification/study/scenes/varied_scenes.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems::defaults {
namespace {

/// Result and cost of a run.
struct Found {
  double value{std::numeric_limits<double>::quiet_NaN()};  ///< the named result
  double balance{};                                        ///< largest error over the largest energy
  long evaluations{};
};

/// Selects the method of the reference: velocity Verlet with steps short enough to be converged.
void converge(Scene& scene, double step) {
  scene.integrator = VelocityVerlet{};
  scene.plan.step = step;
  scene.plan.ledger = false;
}

double converged_step(Scene scene) {
  scene.integrator = VelocityVerlet{};
  return 0.2 * automatic_step(scene);
}

Found found_by(const Scene& scene, const Quantity& quantity, Findings& findings) {
  const RecordedRun run{scene, findings};
  Found found;
  found.evaluations = run.end().evaluations;
  if (!run.end().finished) return found;
  found.value = run.value(quantity);
  if (const auto& ledger = run.recorder().ledger())
    found.balance = ledger->largest_energy_balance_error() / ledger->energy_scale();
  return found;
}

/// Injects the fault of the setup into the default run.
void plant(Scene& scene, const Setup& setup) {
  if (setup.has("loose_tolerance")) scene.integrator = make_integrator("stormer_cowell", 3e-2);
  if (setup.has("outputs_far_apart")) scene.plan.step = scene.plan.end / 200.0;
}

/// Largest magnitude of several errors, and the name of its scene.
struct Worst {
  double error{};
  std::string where;
  void take(double value, const std::string& name) {
    if (!std::isnan(error) && !(std::abs(value) <= error)) error = std::abs(value), where = name;
  }
};

void check_scenes(Findings& findings, const Setup& setup) {
  Table table{.name = "scenes",
              .caption = "Thirty scenes with all defaults, compared with converged runs.",
              .columns = {"scene", "result", "default", "converged", "difference", "energy balance", "evaluations"}};
  Series errors{"named result", {}, {}, Style::points}, balances{"energy balance", {}, {}, Style::points};
  Worst error, balance;
  const std::vector<VariedScene> all = varied_scenes();
  for (const VariedScene& varied : all) {
    // Scenes in which the faults are detected.
    const bool seen = varied.name == "Hertzian bounce" || varied.name == "stone that tumbles";
    if (setup.coarse && !seen) continue;
    Scene scene = read_scene(varied.text, varied.name);
    const Quantity quantity = quantity_named(scene.model, varied.quantity);
    Scene reference = scene;
    converge(reference, converged_step(scene));
    plant(scene, setup);
    const Found found = found_by(scene, quantity, findings), truth = found_by(reference, quantity, findings);
    const double difference = found.value / truth.value - 1.0;
    error.take(difference, varied.name);
    balance.take(found.balance, varied.name);
    errors.add(static_cast<double>(errors.x.size()) + 1.0, std::max(std::abs(difference), 1e-12));
    balances.add(errors.x.back(), std::max(found.balance, 1e-12));
    table.rows.push_back(cells("{} | {} | {:.6g} | {:.6g} | {:+.1e} | {:.1e} | {}", varied.name, varied.quantity,
                               found.value, truth.value, difference, found.balance, found.evaluations));
  }
  if (!setup.coarse) {
    findings.expect_exact("number of scenes", static_cast<double>(table.rows.size()), 30.0, "all scenes of the list");
  }
  findings.expect_model(
      {"scenes", "scenes: largest difference of a named result from its converged value"}, error.error, 0.0, 0.01,
      "1 % is noticeable to an engineer; the converged runs have errors of 0.1 %; worst: " + error.where);
  findings.expect_truncation({"scenes_balance", "scenes: largest error of the energy balance over the largest energy"},
                             balance.error, 0.0, 1e-9, 3.0,
                             "ten times the tolerance of a step, over some thousand steps; worst: " + balance.where);
  if (setup.coarse) return;
  findings.table(table);
  findings.figure({.name = "scenes",
                   .title = "Defaults on thirty scenes",
                   .caption = "Difference of the named result from its converged value, and largest error of the "
                              "energy balance, of each scene in the order of the table.",
                   .x = {.label = "scene"},
                   .y = {.label = "relative error", .log = true, .min = 1e-12, .max = 0.1},
                   .series = {errors, balances},
                   .lines = {{'y', 0.01, "bound of results"}, {'y', 3e-9, "bound of balances"}}});
}

/// Results of the run of a fence.
struct FenceFound {
  scenes::FenceSummary summary;
  Vec2 position;   ///< of the rock at the end [m]
  double width{};  ///< of its path along x [m]
  double balance{};
  long evaluations{};
};

FenceFound run_fence(const SceneFile& file, Findings& findings) {
  const Scene& scene = file.scene;
  const Dynamics dynamics{scene.model};
  const Layout layout{scene.model};
  scenes::FenceMonitor fence_watch{file.fence->fence, file.fence->made, dynamics};
  std::optional<RunLedger> ledger;
  if (scene.plan.ledger) ledger.emplace(scene.model, first_state(scene));
  const BodyId rock = *file.fence->made.members[1].body;
  double smallest = std::numeric_limits<double>::infinity(), largest = -smallest;
  const Watcher watch = [&](const Snapshot& seen, const StepInfo& info) {
    fence_watch(seen, info);
    const double x = pose(scene.model, layout, seen.state(), rock).p_WB.x;
    smallest = std::min(smallest, x), largest = std::max(largest, x);
    if (ledger) static_cast<void>((*ledger)(seen));
  };
  const RunEnd end = run_scene(scene, findings, watch);
  FenceFound found{fence_watch.summary(), pose(scene.model, layout, end.state, rock).p_WB, largest - smallest, 0.0,
                   end.evaluations};
  if (ledger) found.balance = ledger->energy().largest_energy_balance_error() / ledger->energy().energy_scale();
  return found;
}

/// Differences of fences from converged runs of one kind.
class FenceDifferences {
 public:
  explicit FenceDifferences(const char* reference) : reference_{reference} {}

  /// Adds the differences of one fence; returns them as cells of a table.
  std::vector<std::string> take(const std::string& name, const FenceFound& found, const FenceFound& truth) {
    const scenes::RockPassage &rock = found.summary.rocks[0], &same = truth.summary.rocks[0];
    const double off = norm(found.position - truth.position) / truth.width;
    const double left = (rock.end_energy - same.end_energy) / same.approach_energy;
    const double pull = found.summary.largest_segment()->peak / truth.summary.largest_segment()->peak - 1.0;
    position_.take(off, name), energy_.take(left, name), tension_.take(pull, name);
    verdicts_ += found.summary.verdict() == truth.summary.verdict() ? 1 : 0;
    return cells("{:.1e} | {:+.1e} | {:+.1e}", off, left, pull);
  }

  /// `bound`: of position and energy; the largest tension occurs before the paths diverge.
  void check(Findings& findings, double bound, double tension_bound, const std::string& why) const {
    const auto within = [&](const Worst& worst, const char* of, double maximum) {
      findings.expect_model({"fences", fmt::format("fences: largest difference of {} from {}", of, reference_)},
                            worst.error, 0.0, maximum, why + "; worst: " + worst.where);
    };
    within(position_, "the rock's final position", bound);
    within(energy_, "the rock's final energy", bound);
    within(tension_, "the largest tension", tension_bound);
    findings.expect_exact(fmt::format("fences: verdicts equal to those of {}", reference_), verdicts_, 20.0,
                          "no verdict may depend on the method");
  }

 private:
  std::string reference_;
  Worst position_, energy_, tension_;
  int verdicts_{};
};

void check_fences(Findings& findings, const Setup& setup) {
  Table table{.name = "fences",
              .caption =
                  "Twenty fences with all defaults; differences from runs of tolerance $10^{-13}$: of the rock's final "
                  "position over the width of its path, of its final kinetic energy over that of its approach, and of "
                  "the largest tension.",
              .columns = {"fence", "verdict", "remaining energy", "position", "energy", "tension", "energy balance",
                          "evaluations"}};
  Worst balance;
  FenceDifferences tight{"runs of tolerance 1e-13"}, fixed{"runs of velocity Verlet"};
  for (const VariedScene& varied : varied_fences()) {
    if (setup.coarse && varied.name != "nine columns") continue;
    std::string text = varied.text;
    if (setup.has("rules_of_1993")) text.insert(text.find("[fence]\n") + 8, "rules = \"1993\"\n");
    SceneFile file = read_scene_file(text, varied.name);
    const FenceFound found = run_fence(file, findings);
    balance.take(found.balance, varied.name);
    if (setup.coarse) continue;
    file.scene.integrator = make_integrator("stormer_cowell", 1e-13);
    const std::vector<std::string> differences = tight.take(varied.name, found, run_fence(file, findings));
    if (setup.tier == Tier::full) {
      converge(file.scene, 2e-6);
      static_cast<void>(fixed.take(varied.name, found, run_fence(file, findings)));
    }
    const scenes::RockPassage& rock = found.summary.rocks[0];
    table.rows.push_back(cells("{} | {} | {:.1f} % | {} | {} | {} | {:.1e} | {}", varied.name,
                               std::string{talus::name_of(found.summary.verdict())},
                               100.0 * rock.end_energy / rock.approach_energy, differences[0], differences[1],
                               differences[2], found.balance, found.evaluations));
  }
  findings.expect_truncation({"fences_balance", "fences: largest error of the energy balance over the largest energy"},
                             balance.error, 0.0, 1e-9, 3.0,
                             "ten times the tolerance of a step, over some thousand steps; worst: " + balance.where);
  if (setup.coarse) return;
  tight.check(findings, 0.01, 5e-9,
              "1 % is noticeable to an engineer; the error of a tension is about ten times the default tolerance, "
              "1e-10, and five times that is allowed for the worst of twenty fences");
  if (setup.tier == Tier::full) {
    fixed.check(findings, 0.02, 0.002,
                "steps of 2 microseconds, about 1,000 in a contact, cause errors of 0.1 % of the speed in each of "
                "several impacts, and later impacts amplify these: the rock keeps moving for half a second");
  }
  findings.table(table);
}

/// The rock hits two columns at once, so that each impact stops a part of it: half model against whole.
void check_even(Findings& findings, const Setup& setup) {
  std::array<FenceFound, 2> found;
  for (std::size_t i = 0; i < 2; ++i) {
    const VariedScene varied = even_fences()[i];
    SceneFile file = read_scene_file(varied.text, varied.name);
    if (setup.has("impacts_by_themselves") && i == 1) {
      // Damping that each of the two contacts would have if the rock hit it alone.
      for (Contact& contact : file.scene.model.contacts)
        std::get<LinearSpringDashpot>(contact.law).damping_ratio *= 1.12;
    }
    found[i] = run_fence(file, findings);
  }
  const scenes::RockPassage &half = found[0].summary.rocks[0], &whole = found[1].summary.rocks[0];
  findings.expect_truncation({"even_fence", "even fence: final energy of the rock, half model over full model"},
                             half.end_energy / whole.end_energy, 1.0, 1e-7, 3.0,
                             "the same motion with steps of the same tolerance, 1e-10; differences grow a thousandfold "
                             "in each of two impacts");
  findings.expect_truncation("even fence: largest tension, half model over full model",
                             found[0].summary.largest_segment()->peak / found[1].summary.largest_segment()->peak, 1.0,
                             1e-10, 1.0, "the tolerance: the peak occurs before differences grow");
}

void run(Findings& findings, const Setup& setup) {
  if (setup.concerns({"loose_tolerance", "outputs_far_apart"})) check_scenes(findings, setup);
  if (setup.concerns({"rules_of_1993"})) check_fences(findings, setup);
  if (setup.concerns({"impacts_by_themselves"})) check_even(findings, setup);
}

}  // namespace

Case definition() {
  return {
      .id = "defaults",
      .title = "Accuracy of default settings",
      .family = "speed and accuracy",
      .requirements = {{"integrator.stormer_cowell", {"scenes", "fences"}},
                       {"integrator.exact, law.linear_spring_dashpot, law.hertz, law.latching_spring, law.tension_only",
                        {"scenes"}},
                       {"law.elastic_plastic", {"scenes", "fences"}},
                       {"mechanism.friction", {"scenes_balance", "fences_balance"}}},
      .main_checks = {"scenes: largest difference of a named result from its converged value", "scenes_balance",
                      "fences: largest difference of the rock's final position from runs of tolerance 1e-13",
                      "fences: largest difference of the largest tension from runs of tolerance 1e-13",
                      "fences_balance", "fences: verdicts equal to those of runs of tolerance 1e-13"},
      .source = "Krogh 1974; Kennedy & Carpenter 2003",
      .faults = {{"loose_tolerance", "a default tolerance of 3e-2",
                  "scenes: largest difference of a named result from its converged value"},
                 {"outputs_far_apart", "outputs a 200th of the run apart",
                  "scenes: largest difference of a named result from its converged value"},
                 {"impacts_by_themselves", "dashpots of two simultaneous impacts chosen as if each were alone",
                  "even_fence"},
                 {"rules_of_1993", "fences by the 1993 rules", "fences_balance"}},
      .seconds = 11.0,
      .full_seconds = 26.0,
      .run = run};
}

}  // namespace talus::verification::problems::defaults
