#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "solver/app/command.hpp"
#include "solver/app/interruption.hpp"
#include "solver/app/run_summary.hpp"
#include "solver/app/scene_run.hpp"
#include "solver/base/error.hpp"
#include "solver/calibrate/step_advice.hpp"
#include "solver/io/atomic_file.hpp"
#include "solver/io/checkpoint.hpp"
#include "solver/io/json.hpp"
#include "solver/io/toml_document.hpp"
#include "solver/io/toml_scene.hpp"

namespace talus::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* checkpoint_name = "checkpoint.json";

struct RunOptions {
  std::string scene;
  std::string folder;
  std::string until;
  std::string resume;
  std::string end;
  std::string step;
  std::string integrator;
  double tolerance{};
  bool json{false};
  long frames{};  ///< states of the geometry; 0: as the scene says
};

/// A run as the command line asks for it.
struct Order {
  fs::path scene;      ///< its file
  std::string text;    ///< of that file
  SceneFile file;      ///< with what the command line changes of it
  fs::path folder;     ///< empty: nothing is written
  fs::path from;       ///< folder in which the run stood that is taken on; empty for a new one
  fs::path name;       ///< of the scene when the run began: names its files
  long steps{};        ///< done where the run stands
  MemoryItems memory;  ///< of the run that is taken on

  fs::path checkpoint() const { return folder / checkpoint_name; }
};

/// A new run, with what the command line changes of its scene.
Order new_order(const RunOptions& options) {
  if (options.scene.empty()) throw InputError{"SCENE is required, or --resume DIR\nhelp: talus run --help"};
  if (options.tolerance != 0.0 && options.integrator.empty()) {
    throw InputError{"--tolerance: it goes with --integrator; name both"};
  }
  if (!options.until.empty() && options.folder.empty()) {
    throw InputError{"--until: it goes with --out, the folder in which the run is left to be taken on"};
  }
  const fs::path file{options.scene};
  Order order{.scene = file,
              .text = read_text(file),
              .file = read_scene_file(file),
              .folder = options.folder,
              .from = {},
              .name = file,
              .memory = {}};
  Scene& scene = order.file.scene;
  const UnitSystem& units = scene.model.units;
  if (!options.end.empty()) scene.plan.end = option_quantity("--end", options.end, dimension::time, units);
  if (!options.step.empty()) scene.plan.step = option_quantity("--step", options.step, dimension::time, units);
  if (!options.integrator.empty()) scene.integrator = make_integrator(options.integrator, options.tolerance);
  return order;
}

/// A run that stands, as its checkpoint says.
Order resumed_order(const RunOptions& options) {
  for (const auto& [name, given] : {std::pair{"--end", !options.end.empty()},
                                    {"--step", !options.step.empty()},
                                    {"--integrator", !options.integrator.empty()},
                                    {"--tolerance", options.tolerance != 0.0},
                                    {"--frames", options.frames != 0}}) {
    if (given) throw InputError{fmt::format("{}: a run that is taken on (--resume) keeps what it began with", name)};
  }
  const fs::path file = fs::path{options.resume} / checkpoint_name;
  Checkpoint checkpoint = read_checkpoint(file, TALUS_VERSION);
  const fs::path scene = options.scene.empty() ? fs::path{checkpoint.scene_file} : fs::path{options.scene};
  Order order{.scene = scene,
              .text = read_text(scene),
              .file = {},
              .folder = options.folder.empty() ? options.resume : options.folder,
              .from = options.resume,
              .name = checkpoint.scene_file,
              .steps = checkpoint.steps,
              .memory = std::move(checkpoint.memory)};
  if (fnv1a(order.text) != checkpoint.scene_fnv1a) {
    throw InputError{
        fmt::format("{}: scene_fnv1a: found {}, but {} has {}; it must be the scene as it was when the run "
                    "was stopped",
                    file.string(), checkpoint.scene_fnv1a, scene.string(), fnv1a(order.text))};
  }
  order.file = read_scene_file(scene);
  order.file.scene.integrator = make_integrator(checkpoint.integrator, checkpoint.tolerance);
  order.file.scene.plan.step = checkpoint.step;
  order.file.scene.plan.end = checkpoint.end;
  return order;
}

/// The step after which --until stops the run; the plan's last without it.
long last_step(const RunOptions& options, const Order& order) {
  const Scene& scene = order.file.scene;
  const RunPlan& plan = scene.plan;
  const double start = scene.initial.t;
  const auto steps_to = [&](double time) {
    return step_count({.step = plan.step, .end = time - start, .interval = plan.interval, .ledger = plan.ledger});
  };
  const long all = steps_to(plan.end);
  if (options.until.empty()) return all;
  const UnitSystem& units = scene.model.units;
  const std::string unit = symbol(units, dimension::time);
  const double time = option_quantity("--until", options.until, dimension::time, units);
  const double stands = start + static_cast<double>(order.steps) * plan.step;
  // Not by steps: a time far beyond the end may be more of them than can be counted.
  if (time > plan.end && (time > 2.0 * plan.end || steps_to(time) > all)) {
    throw InputError{fmt::format("--until: found \"{}\"; it must be at most {:.10g} {}, where the run ends",
                                 options.until, plan.end, unit)};
  }
  if (time <= stands || steps_to(time) <= order.steps) {
    throw InputError{fmt::format("--until: found \"{}\"; it must be beyond {:.10g} {}, where the run stands",
                                 options.until, stands, unit)};
  }
  return steps_to(time);
}

/// Makes the folder before the run: a wrong one must not cost a run.
void prepare(const Order& order) {
  if (order.folder.empty()) return;
  make_folder(order.folder);
  // An earlier run's summary would vouch for a mixture if this one cannot finish; its checkpoint is not this run's.
  std::error_code none;
  fs::remove(order.folder / "summary.json", none);
  if (order.from.empty() || !fs::equivalent(order.from, order.folder)) fs::remove(order.checkpoint(), none);
}

/// The run, brought to where it stands. What is wrong names the file that it is wrong in.
std::unique_ptr<SceneRun> standing_run(const Order& order, long frames) {
  auto run = std::make_unique<SceneRun>(order.file, order.folder, order.name, frames);
  if (order.from.empty()) return run;
  try {
    Memory memory{order.memory};
    run->remember(memory);
    if (const auto names = memory.left_over(); !names.empty())
      throw InputError{fmt::format("found {}; a run of this scene has no such part", names.front())};
  } catch (const InputError& error) {
    throw InputError{fmt::format("{}: memory: {}", (order.from / checkpoint_name).string(), error.what())};
  }
  run->bring_files(order.from);
  return run;
}

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

/// Red on a terminal, unless NO_COLOR is set (no-color.org).
void print_failure(std::string_view words) {
  const char* no_color = std::getenv("NO_COLOR");
  const bool red = ::isatty(STDERR_FILENO) == 1 && (no_color == nullptr || *no_color == '\0');
  fmt::print(stderr, "{}talus: {}{}\n", red ? "\033[31m" : "", words, red ? "\033[0m" : "");
}

void write_checkpoint(const Order& order, SceneRun& run) {
  Memory memory;
  run.remember(memory);
  const Scene& scene = order.file.scene;
  write_whole(order.checkpoint(), checkpoint_text({.scene_file = fs::absolute(order.scene).string(),
                                                   .scene_fnv1a = fnv1a(order.text),
                                                   .integrator = std::string{name(scene.integrator)},
                                                   .tolerance = tolerance(scene.integrator),
                                                   .step = scene.plan.step,
                                                   .end = scene.plan.end,
                                                   .steps = run.standing().step,
                                                   .memory = memory.items()},
                                                  TALUS_VERSION));
}

/// Writes all files of the run; with `leave` its checkpoint, else none stays in the folder.
void write_files(const Order& order, SceneRun& run, const RunRecord& record, bool leave) {
  run.write(record);
  if (leave) {
    write_checkpoint(order, run);
  } else {
    std::error_code none;
    fs::remove(order.checkpoint(), none);
  }
  write_whole(order.folder / "summary.json", summary_json(record));  // last: its presence says that all is there
}

void print_result(const RunOptions& options, const Order& order, const SceneRun& run, const RunRecord& record,
                  bool left) {
  fmt::print("{}", options.json ? summary_json(record) : run_summary(record));
  if (options.json || order.folder.empty()) return;
  fmt::print("files: {}: {}{}\n", order.folder.string(), fmt::join(run.file_names(), ", "),
             left ? fmt::format(", {}", checkpoint_name) : "");
  if (left) fmt::print("go on: talus run --resume {}\n", order.folder.string());
}

int run(const RunOptions& options) {
  const Order order = options.resume.empty() ? new_order(options) : resumed_order(options);
  check_step_count(order.file.scene.plan);
  const long last = last_step(options, order);
  prepare(order);
  const std::unique_ptr<SceneRun> run = standing_run(order, options.frames);
  const StepRatio ratio = step_ratio(order.file.scene);
  if (ratio.beyond) print_failure(fmt::format("warning: {}; the answer may grow without bound", ratio.words));

  // Without a folder there is nowhere to leave the run: a signal then ends the program as usual.
  std::optional<Interruption> interruption;
  if (!order.folder.empty()) interruption.emplace();
  const double until = run->standing().start + static_cast<double>(last) * order.file.scene.plan.step;
  Outcome outcome =
      run->go_on([&](const State& seen) { return seen.t >= until || (interruption && interruption->signal() != 0); });
  if (!outcome && !ratio.words.empty()) outcome.words += fmt::format("; {}", ratio.words);

  const bool left = outcome.kind == Outcome::Kind::stopped || (outcome && !options.until.empty());
  const RunRecord record = run->record(outcome);
  if (!order.folder.empty()) write_files(order, *run, record, left);
  print_result(options, order, *run, record, left);
  if (!outcome) {
    print_failure(outcome.words);
    return diverged;
  }
  const int signal = interruption ? interruption->signal() : 0;
  if (signal == 0 || outcome.kind == Outcome::Kind::finished) return ok;
  print_failure(fmt::format("{} came; the run was left at t = {:.10g} in {}; talus run --resume {} takes it on",
                            signal == SIGINT ? "SIGINT" : "SIGTERM", outcome.time, order.checkpoint().string(),
                            order.folder.string()));
  return 128 + signal;
}

}  // namespace

Command add_run(CLI::App& talus) {
  CLI::App* app = talus.add_subcommand("run", "Run a scene; print its summary, write its histories");
  const auto options = std::make_shared<RunOptions>();
  app->add_option("SCENE", options->scene,
                  "scene file (.toml) or deck of 1993 (.DAT); with --resume only if it was moved");
  app->add_option(
      "--out", options->folder,
      "folder for history.csv, final_state.json, summary.json, plot.json and the geometry NAME.pvd, and for a fence "
      "its listing NAME.OUT and the deck's histories NAME.history.csv and .json; without it nothing is written");
  app->add_option("--until", options->until,
                  "stop there and leave the run in the folder of --out, to be taken on, e.g. \"20 ms\"");
  app->add_option("--resume", options->resume,
                  "folder in which a run was left: take it on, to its end or to --until, as if it had never stopped; "
                  "the files go to --out, or else the same folder");
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
      "  talus run cases/fence/sample2.DAT --until \"10 ms\" --out out && talus run --resume out\n"
      "SIGINT and SIGTERM stop a run that has a folder after its present step; it can be taken on with --resume.\n"
      "A run that diverges keeps its history up to there; its summary says why, and the exit code is 3.");
  return {app, [options] { return run(*options); }};
}

}  // namespace talus::app
