#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

#include "solver/app/command.hpp"
#include "solver/app/run_summary.hpp"
#include "solver/app/scene_files.hpp"
#include "solver/base/error.hpp"
#include "solver/calibrate/step_advice.hpp"
#include "solver/io/atomic_file.hpp"
#include "solver/io/csv.hpp"
#include "solver/io/json.hpp"
#include "solver/io/plot_record.hpp"
#include "solver/io/scene_file.hpp"
#include "solver/io/toml_scene.hpp"

namespace talus::app {
namespace {

namespace fs = std::filesystem;

struct RunOptions {
  std::string scene;
  std::string folder;
  std::string end;
  std::string step;
  std::string integrator;
  double tolerance{};
  bool json{false};
  long frames{};  ///< states of the geometry; 0: as the scene says
};

/// The scene with what the command line changes of it.
SceneFile changed_scene(const RunOptions& options) {
  SceneFile file = read_scene_file(fs::path{options.scene});
  Scene& scene = file.scene;
  const UnitSystem& units = scene.model.units;
  if (!options.end.empty()) scene.plan.end = option_quantity("--end", options.end, dimension::time, units);
  if (!options.step.empty()) scene.plan.step = option_quantity("--step", options.step, dimension::time, units);
  if (!options.integrator.empty()) scene.integrator = make_integrator(options.integrator, options.tolerance);
  check_step_count(scene.plan);
  return file;
}

/// Shows on a terminal how far a run has come, once it takes longer than a second.
class Progress {
 public:
  explicit Progress(double end) : end_{end}, shown_to_terminal_{::isatty(STDERR_FILENO) == 1} {}
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress() {
    if (written_) fmt::print(stderr, "\r{:40}\r", "");
  }

  void operator()(double time, long step) {
    if (!shown_to_terminal_ || step % 256 != 0) return;
    const auto now = std::chrono::steady_clock::now();
    if (now < next_) return;
    next_ = now + std::chrono::milliseconds{200};
    written_ = true;
    fmt::print(stderr, "\rt = {:.5g} of {:.5g}  ({:3.0f} %)", time, end_, 100.0 * time / end_);
    std::fflush(stderr);
  }

 private:
  double end_;
  bool shown_to_terminal_;
  bool written_{false};
  std::chrono::steady_clock::time_point next_{std::chrono::steady_clock::now() + std::chrono::seconds{1}};
};

/// The step against the method's linear limit, all contacts closed and all cables taut; empty where no limit is known.
struct StepRatio {
  std::string words;
  bool beyond{false};
};
StepRatio step_ratio(const Scene& scene) {
  const Dynamics dynamics{scene.model};
  // The modes cost n^3: for a large scene `talus check` says what there is to say.
  constexpr std::size_t largest = 150;
  if (scene.initial.q.size() > largest) return {};
  const auto limit = step_limit(advise_step(dynamics, scene.initial), name(scene.integrator));
  if (!limit) return {};
  const double product = scene.plan.step * limit->mode.frequency;
  const bool beyond = product > limit->product;
  return {fmt::format(
              "h omega = {:.4g} {} {:.4g}, the linear limit of {} for the mode of {:.4g} rad a unit of time, xi {:.3g}",
              product, beyond ? ">" : "<", limit->product, name(scene.integrator), limit->mode.frequency,
              limit->mode.damping_ratio),
          beyond};
}

RunRecord run_scene(const Scene& scene, const Dynamics& dynamics, const Observer& also) {
  RigidBodySystem system{dynamics, scene.plan.ledger};
  Integrator integrator = scene.integrator;
  State state = scene.initial;
  system.settle(state);
  Recorder recorder{dynamics, state, scene.plan.ledger};
  FailureLog failures{dynamics};
  Progress progress{scene.plan.end};
  RunRecord record;
  State last = state;
  const Observer observers[] = {[&](const State& seen, const StepInfo& info) {
    recorder(seen, info);
    failures(seen, info);
    also(seen, info);
    progress(seen.t, info.step);
    last = seen;
    record.steps = info.step;
  }};
  record.outcome = simulate(system, integrator, state, scene.plan, observers);
  record.title = scene.title;
  record.units = scene.model.units;
  record.integrator = name(scene.integrator);
  record.plan = scene.plan;
  record.evaluations = system.evaluations();
  record.coordinates = dynamics.layout().coordinates.size();
  record.laws = dynamics.layout().mode_count;
  record.contacts = scene.model.contacts.size();
  record.cables = scene.model.cables.size();
  record.bodies = body_states(scene.model, last);
  record.failures = failures.failures();
  record_history(record, recorder);
  return record;
}

void write_files(const RunRecord& record, const SceneFiles& files, const fs::path& folder) {
  write_whole(folder / "history.csv", csv(record.history, record.units));
  write_whole(folder / "final_state.json", final_state_json(record));
  write_whole(folder / "plot.json", plot_json(record, "history.csv", files.drawn_from()));
  files.write();
  write_whole(folder / "summary.json", summary_json(record));  // last: its presence says that all is there
}

/// Red on a terminal, unless NO_COLOR is set (no-color.org).
void print_failure(std::string_view words) {
  const char* no_color = std::getenv("NO_COLOR");
  const bool red = ::isatty(STDERR_FILENO) == 1 && (no_color == nullptr || *no_color == '\0');
  fmt::print(stderr, "{}talus: {}{}\n", red ? "\033[31m" : "", words, red ? "\033[0m" : "");
}

/// Makes the folder before the run: a wrong one must not cost a run.
void prepare(const fs::path& folder) {
  make_folder(folder);
  // An earlier run's summary would vouch for a mixture if this one cannot finish.
  std::error_code none;
  fs::remove(folder / "summary.json", none);
}

int run(const RunOptions& options) {
  if (options.tolerance != 0.0 && options.integrator.empty()) {
    throw InputError{"--tolerance: it goes with --integrator; name both"};
  }
  const SceneFile file = changed_scene(options);
  if (!options.folder.empty()) prepare(options.folder);
  const Dynamics dynamics{file.scene.model};
  std::optional<SceneFiles> files;
  if (!options.folder.empty()) files.emplace(file, dynamics, options.folder, options.scene, options.frames);
  const StepRatio ratio = step_ratio(file.scene);
  if (ratio.beyond) print_failure(fmt::format("warning: {}; the answer may grow without bound", ratio.words));
  RunRecord record = run_scene(file.scene, dynamics, [&](const State& seen, const StepInfo& info) {
    if (files) (*files)(seen, info);
  });
  if (!record.outcome && !ratio.words.empty()) record.outcome.words += fmt::format("; {}", ratio.words);
  if (files) record.notes = files->left_out();
  if (files) write_files(record, *files, options.folder);
  fmt::print("{}", options.json ? summary_json(record) : run_summary(record));
  if (files && !options.json) {
    fmt::print("files: {}: history.csv, final_state.json, summary.json, plot.json, {}\n", options.folder,
               fmt::join(files->names(), ", "));
  }
  if (record.outcome) return ok;
  print_failure(record.outcome.words);
  return diverged;
}

}  // namespace

Command add_run(CLI::App& talus) {
  CLI::App* app = talus.add_subcommand("run", "Run a scene; print its summary, write its histories");
  const auto options = std::make_shared<RunOptions>();
  app->add_option("SCENE", options->scene, "scene file (.toml) or deck of 1993 (.DAT)")->required();
  app->add_option(
      "--out", options->folder,
      "folder for history.csv, final_state.json, summary.json, plot.json and the geometry NAME.pvd, and for a fence "
      "its "
      "listing NAME.OUT and the deck's histories NAME.history.csv and .json; without it nothing is written");
  app->add_flag("--json", options->json, "print the summary as JSON");
  app->add_option("--end", options->end, "time at which the run ends instead of the scene's, e.g. \"5 s\"");
  app->add_option("--step", options->step, "step instead of the scene's, e.g. \"10 us\"");
  app->add_option("--integrator", options->integrator, "integrator instead of the scene's (talus list integrators)");
  app->add_option("--tolerance", options->tolerance, "step control of that integrator, a pure number, e.g. 1e-9");
  app->add_option("--frames", options->frames,
                  "states of the geometry, evenly over the run; default: a fence's every nprint steps, else 100")
      ->check(CLI::Range(1L, 100'000L));
  app->footer(
      "Examples:\n"
      "  talus run cases/two_cable.toml --out out\n"
      "  talus run cases/fence/sample2.DAT --out out\n"
      "  talus run cases/two_cable.toml --end \"2 s\" --integrator odeint_dopri5 --tolerance 1e-9 --json\n"
      "A run that diverges keeps its history up to there; its summary says why, and the exit code is 3.");
  return {app, [options] { return run(*options); }};
}

}  // namespace talus::app
