#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "solver/app/command.hpp"
#include "solver/app/ended_run.hpp"
#include "solver/app/interruption.hpp"
#include "solver/app/run_order.hpp"
#include "solver/app/run_summary.hpp"
#include "solver/app/scene_run.hpp"
#include "solver/app/second_run.hpp"
#include "solver/app/start_warnings.hpp"
#include "solver/base/error.hpp"
#include "solver/draw/drawing.hpp"
#include "solver/io/file/atomic_file.hpp"
#include "solver/io/file/folder_lock.hpp"
#include "solver/io/output/checkpoint.hpp"
#include "solver/io/output/run_folder.hpp"
#include "solver/io/output/write_summary.hpp"
#include "solver/stability/step_advice.hpp"

namespace talus::app {
namespace {

namespace fs = std::filesystem;

/// Force evaluations of a fence's run up to which it is repeated without --sheet, too: some tenths of a second. (New
/// fences take 5,000 to 25,000, a deck of 1993 as many as it has steps.)
constexpr long most_repeated = 50'000;

/// Makes the folder and finds the tools of the sheet before the run: what is wrong with them must not cost a run. The folder is kept
/// for this run by what is returned.
std::unique_ptr<FolderLock> prepare(const RunOrder& order) {
  if (order.sheet) find_sheet_tools();
  if (order.folder.empty()) return {};
  make_folder(order.folder);
  auto lock = std::make_unique<FolderLock>(order.folder);
  // What an earlier run left would vouch for a mixture; its checkpoint is not this run's.
  if (order.from.empty() || !fs::equivalent(order.from, order.folder)) {
    remove_run(order.folder);
  } else {
    std::error_code none;
    fs::remove(order.folder / "summary.json", none);
  }
  return lock;
}

/// The run, brought to where it stands. What is wrong names the file that it is wrong in.
std::unique_ptr<SceneRun> standing_run(const RunOrder& order, long frames) {
  auto run = std::make_unique<SceneRun>(order.file, order.folder, order.name, frames, order.sheet);
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

/// Leaves the run in its folder, to be resumed.
void write_checkpoint(const RunOrder& order, SceneRun& run) {
  Memory memory;
  run.remember(memory);
  const Scene& scene = order.file.scene;
  sync_folder(order.folder);  // the states of the geometry that it counts on
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
void write_files(const RunOrder& order, SceneRun& run, const RunRecord& record, bool leave) {
  run.write(record);
  if (leave) write_checkpoint(order, run);
  write_whole(order.folder / "summary.json", summary_json(record));  // last: its presence says that all is there
  // What is left of an earlier checkpoint is needed until then.
  std::error_code none;
  if (!leave) fs::remove(order.checkpoint(), none);
}

/// The command that takes the same run by steps chosen to a tolerance.
std::string repair_command(const RunOptions& options) {
  const std::string scene = options.scene.empty() ? "SCENE" : options.scene;
  const std::string end = options.end.empty() ? "" : fmt::format(" --end \"{}\"", options.end);
  return fmt::format("talus run {} --integrator auto{}", scene, end);
}

/// Takes the run on until `stop`; with a folder it is left there every second, so that a crash loses no more.
Outcome followed(const RunOrder& order, SceneRun& run, const StopCondition& stop) {
  using Clock = std::chrono::steady_clock;
  Progress progress;
  if (order.folder.empty()) return run.go_on(stop, progress);
  for (;;) {
    const Clock::time_point due = Clock::now() + std::chrono::seconds{1};
    bool stops = false;
    long asked = 0;
    const auto pauses = [&](const Snapshot& seen) {
      stops = stop(seen);
      return stops || (++asked % 64 == 0 && Clock::now() >= due);
    };
    Outcome outcome = run.go_on(pauses, progress);
    if (stops || outcome.kind != Outcome::Kind::stopped) return outcome;
    write_checkpoint(order, run);
  }
}

void print_result(const RunOptions& options, const RunOrder& order, const SceneRun& run, const RunRecord& record,
                  bool left) {
  const std::string resume = left ? fmt::format("talus run --resume {}", order.folder.string()) : "";
  fmt::print("{}", options.json ? summary_json(record, resume) : run_summary(record, run.parts(), options.all));
  if (options.json) return;
  if (order.folder.empty()) {
    const std::string_view sheet = order.file.fence ? "; with --sheet also the engineer's sheet" : "";
    return fmt::print("files: none; --out DIR writes histories, geometry and summary{}\n", sheet);
  }
  fmt::print("files: {}: {}{}\n", order.folder.string(), fmt::join(run.file_names(), ", "),
             left ? fmt::format(", {}", checkpoint_name) : "");
  if (left) fmt::print("go on: {}\n", resume);
}

/// Of a run that has ended only the outcome is left to report. Errors: InputError for options that ask for more.
int report_ended(const RunOptions& options, const EndedRun& ended) {
  for (const auto& [name, given] : {std::pair{"--until", !options.until.empty()},
                                    {"--out", !options.folder.empty()},
                                    {"--end", !options.end.empty()},
                                    {"--step", !options.step.empty()},
                                    {"--integrator", !options.integrator.empty()},
                                    {"--tolerance", options.tolerance != 0.0},
                                    {"--frames", options.frames != 0},
                                    {"--sheet", options.sheet}}) {
    if (given)
      throw InputError{
          fmt::format("{}: the run in {} has ended; only an interrupted run can be resumed", name, options.resume)};
  }
  return report_ended_run(options.resume, ended, options.json);
}

int run(const RunOptions& options) {
  if (!options.resume.empty())
    if (const auto ended = ended_run(options.resume)) return report_ended(options, *ended);
  const RunOrder order = run_order(options);
  const long last = last_step(options, order);
  const std::unique_ptr<FolderLock> lock = prepare(order);
  const std::unique_ptr<SceneRun> run = standing_run(order, options.frames);
  if (run->watch().step_is_beyond()) {
    print_failure(fmt::format("warning: {}", step_warning(run->watch().step_ratio(), repair_command(options))));
  }
  for (const std::string& warning : run->start_warnings())
    print_failure(fmt::format("warning: {}", warning));

  // Without a folder there is nowhere to leave the run: a signal then ends the program as usual.
  std::optional<Interruption> interruption;
  if (!order.folder.empty()) interruption.emplace();
  const StopCondition interrupted = [&](const Snapshot&) { return interruption && interruption->signal() != 0; };
  const Scene& scene = order.file.scene;
  const double until = run->standing().start + static_cast<double>(last) * scene.plan.step;
  bool there = false;
  Outcome outcome = followed(order, *run, [&](const Snapshot& seen) {
    there = scene.early_end && reached(*scene.early_end, scene.model, seen.state());
    return there || seen.state().t >= until || interrupted(seen);
  });
  if (there) outcome.kind = Outcome::Kind::finished;
  if (!outcome && run->watch().breach().empty() && !run->watch().step_ratio().empty())
    outcome.words += fmt::format("; {}", run->watch().step_ratio());

  const bool left = !there && (outcome.kind == Outcome::Kind::stopped || (outcome && !options.until.empty()));
  RunRecord record = run->record(outcome);
  if (record.fence && !left) {
    if (!record.quality.flaw.empty() && !chooses_steps(scene.integrator)) {
      record.quality.repair = repair_run(order.file, record, interrupted);
    } else if (outcome && (order.sheet || record.evaluations <= most_repeated)) {
      record.quality.repeat = repeat_run(order.file, record, interrupted);
    }
  }
  if (!order.folder.empty()) write_files(order, *run, record, left);
  if (order.sheet) draw_sheet(order.folder);
  print_result(options, order, *run, record, left);
  // The first of them have been printed at the start.
  for (std::size_t i = run->start_warnings().size(); i < record.warnings.size(); ++i)
    print_failure(fmt::format("warning: {}", record.warnings[i]));
  if (!outcome) {
    print_failure(outcome.words);
    return diverged;
  }
  const int signal = interruption ? interruption->signal() : 0;
  if (signal == 0) return ok;
  if (outcome.kind == Outcome::Kind::finished) {
    // In time for the repeat of a fence's run, which its summary then says.
    print_failure(fmt::format("{} came when the run had finished", signal == SIGINT ? "SIGINT" : "SIGTERM"));
    return 128 + signal;
  }
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
                  "the files go to --out, or else the same folder; of a run that has ended it says so and returns its "
                  "exit code");
  app->add_flag("--sheet", options->sheet,
                "of a fence: the engineer's sheet, one page as sheet.pdf and sheet.html, its numbers in sheet.json");
  app->add_flag("--json", options->json, "print the summary as JSON");
  app->add_flag("--all", options->all, "print all tables: extremes of every quantity, all bodies, what a step costs");
  app->add_option("--end", options->end, "time at which the run ends instead of the scene's, e.g. \"5 s\"");
  app->add_option(
      "--step", options->step,
      "step instead of the scene's, e.g. \"10 us\"; \"auto\": 1/20 of the method's linear limit, 1/200 of the "
      "shortest contact at most");
  app->add_option(
      "--integrator", options->integrator,
      "integrator instead of the scene's (talus list integrators); one of fixed step takes --step auto in place of the "
      "output times of one that chooses its steps");
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
      "  talus run cases/fence/table_2.toml --sheet --out out\n"
      "SIGINT and SIGTERM stop a run that has a folder after its present step; it can be taken on with --resume.\n"
      "A run that diverges keeps its history up to there; its summary says why, and the exit code is 3.");
  return {app, [options] { return run(*options); }};
}

}  // namespace talus::app
