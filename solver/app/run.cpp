#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <utility>

#include "solver/app/command.hpp"
#include "solver/app/life_cycle.hpp"
#include "solver/app/run/run_summary.hpp"
#include "solver/app/run/scene_run.hpp"
#include "solver/app/run/second_run.hpp"
#include "solver/app/run/start_warnings.hpp"
#include "solver/app/scene_request.hpp"
#include "solver/command_line/completion.hpp"
#include "solver/command_line/shell_word.hpp"
#include "solver/command_line/usage_error.hpp"
#include "solver/draw/drawing.hpp"
#include "solver/io/output/write_summary.hpp"
#include "solver/stability/step_advice.hpp"

namespace talus::app {
namespace {

/// Maximum number of force evaluations of a fence's run for which it is repeated even without --sheet: some tenths of a
/// second. New fences take 5,000 to 25,000, a deck of 1993 as many as it has steps.
constexpr long maximum_repeated = 50'000;

/// The command for the same run with the integrator "auto", which has step control.
std::string repair_command(const SceneOptions& options) {
  const std::string scene = options.scene.empty() ? "SCENE" : shell_word(options.scene);
  const std::string end = options.end.empty() ? "" : fmt::format(" --end \"{}\"", options.end);
  return fmt::format("talus run {} --integrator auto{}", scene, end);
}

/// The run of a scene requested by `talus run`.
class RequestedScene final : public ResumableRun {
 public:
  RequestedScene(const SceneOptions& options, const SceneRequest& request, long last_step)
      : options_{&options},
        request_{&request},
        run_{request.file, request.run.folder, request.name(), {options.frames, request.sheet, request.impacts}},
        last_step_{last_step} {}

  void serialize(Archive& archive) override {
    run_.serialize(archive);
    if (archive.is_loading()) beyond_at_start_ = run_.watch().step_is_beyond();
  }
  void bring_files(const std::filesystem::path& from) override { run_.bring_files(from); }
  std::string time_text(double time) const override {
    return fmt::format("{:.10g} {}", time, symbol(scene().model.units, dimension::time));
  }
  void describe(Checkpoint& checkpoint) const override {
    checkpoint.integrator = name(scene().integrator);
    checkpoint.tolerance = tolerance(scene().integrator);
    checkpoint.step = scene().plan.step, checkpoint.end = scene().plan.end;
    checkpoint.steps = run_.run_state().step;
  }

  Outcome advance(const Condition& pause, Progress& progress) override {
    const double until = run_.run_state().start + static_cast<double>(last_step_) * scene().plan.step;
    const auto stop = [&](const Snapshot& seen) { return seen.state().t >= until || (pause && pause()); };
    return run_.proceed(stop, &progress);
  }
  bool finish(Outcome& outcome, const Condition& interrupted) override {
    outcome = run_.explained(std::move(outcome));
    record_ = run_.record(outcome);
    const bool stopped = outcome.kind == Outcome::Kind::stopped;
    const bool resumable = !run_.ends_early() && (stopped || (outcome && !options_->until.empty()));
    if (record_.fence && !resumable) run_again([&](const Snapshot&) { return interrupted(); });
    return resumable;
  }
  bool is_usable() const override { return record_.quality.flaw.empty() || !record_.quality.enforced; }
  std::vector<std::string> warnings() const override {
    std::vector<std::string> all;
    if (beyond_at_start_) all.push_back(step_warning(run_.watch().step_ratio(), repair_command(*options_)));
    const std::vector<std::string> found = record_.warnings.empty() ? run_.start_warnings() : record_.warnings;
    all.insert(all.end(), found.begin(), found.end());
    return all;
  }

  void write() override { run_.write(record_); }
  void draw() const override {
    if (request_->sheet) draw_sheet(request_->run.folder / "sheet.json");
  }
  std::vector<std::string> file_names() const override { return run_.file_names(); }
  std::string files_of_out() const override {
    const std::string_view sheet = request_->file.fence ? "; with --sheet also the engineer's sheet" : "";
    return fmt::format("histories, geometry and summary{}", sheet);
  }
  std::string summary_json(const std::string& resume) override { return talus::summary_json(record_, resume); }
  std::string summary_text() override { return run_summary(record_, run_.parts(), options_->all); }

 private:
  const Scene& scene() const { return request_->file.scene; }

  /// Repeats the run: with located events if its results are unusable, else with slightly changed initial velocities,
  /// to test whether the verdict changes.
  void run_again(const StopCondition& stop) {
    if (!record_.quality.flaw.empty() && !chooses_steps(scene().integrator)) {
      record_.quality.repair = repair_run(request_->file, record_, stop);
    } else if (record_.outcome && (request_->sheet || record_.evaluations <= maximum_repeated)) {
      record_.quality.repeat = repeat_run(request_->file, record_, stop);
    }
  }

  const SceneOptions* options_;
  const SceneRequest* request_;
  SceneRun run_;
  long last_step_;
  bool beyond_at_start_{run_.watch().step_is_beyond()};  ///< the step is beyond the linear limit at the start
  RunRecord record_;                                     ///< of the finished run
};

int run(const SceneOptions& options) {
  GivenOptions others = options.kept();
  others.insert(others.end(), {{"--sheet", options.sheet},
                               {"--impacts", options.impacts},
                               {"--until", !options.until.empty()},
                               {"--out", !options.folder.empty()}});
  if (const auto code = report_ended_run(options, others)) return *code;
  const SceneRequest request = scene_request(options);
  const long last = last_step(options, request);
  return live(request.run, [&] { return std::make_unique<RequestedScene>(options, request, last); });
}

}  // namespace

Command add_run(CLI::App& talus) {
  CLI::App* app = talus.add_subcommand("run", "Run a scene; print its summary, write its histories");
  const auto options = std::make_shared<SceneOptions>();
  app->add_option("SCENE", options->scene,
                  "scene file (.toml) or deck of 1993 (.DAT); with --resume only if it was moved");
  app->add_option(
      "--out", options->folder,
      "folder for history.csv, final_state.json, summary.json, plot.json and the geometry NAME.pvd, and for a fence "
      "its listing NAME.OUT and, if it requests histories, NAME.history.csv and .json; without it nothing is written");
  app->add_option("--until", options->until,
                  "stop there and save the run in the folder of --out, to be resumed, e.g. \"20 ms\"");
  app->add_option("--resume", options->resume,
                  "folder of an interrupted run: resume it, to its end or to --until, as if it had never stopped; the "
                  "files go to --out, or else the same folder; of a run that has ended it says so and returns its exit "
                  "status");
  app->add_flag("--sheet", options->sheet,
                "of a fence: the engineer's sheet, one page as sheet.pdf and sheet.html, its numbers in sheet.json");
  app->add_flag("--impacts", options->impacts,
                "a row for each impact in impacts.csv: times, speeds before and after, largest force and overlap, "
                "impulses; the largest ones also in the summary");
  app->add_flag("--json", options->json, "print the summary as JSON");
  app->add_flag("--all", options->all, "print all tables: extremes of every quantity, all bodies, the cost per step");
  app->add_option("--end", options->end, "time at which the run ends instead of the scene's, e.g. \"5 s\"");
  app->add_option(
      "--step", options->step,
      "step instead of the scene's, e.g. \"10 us\"; \"auto\": 1/20 of the method's linear limit, 1/200 of the "
      "shortest contact at most; the history has at most one row a step");
  std::vector<std::string> names = integrator_names();
  names.emplace_back(automatic_integrator);
  offer(app->add_option("--integrator", options->integrator,
                        "integrator instead of the scene's (talus list integrators); one of fixed step takes --step "
                        "auto in place of the output times of one that chooses its steps"),
        names);
  app->add_option("--tolerance", options->tolerance, "step control of that integrator, a pure number, e.g. 1e-9");
  app->add_option("--frames", options->frames,
                  "states of the geometry, evenly over the run; default: a fence's every nprint steps, else 100")
      ->check(whole_between(1, 100'000));
  app->footer(
      "Examples:\n"
      "  talus run cases/two_cable.toml --out out\n"
      "  talus run cases/fence/sample2.DAT --out out\n"
      "  talus run cases/two_cable.toml --end \"2 s\" --integrator odeint_dopri5 --tolerance 1e-9 --json\n"
      "  talus run cases/fence/sample2.DAT --until \"10 ms\" --out out && talus run --resume out\n"
      "  talus run cases/fence/table_2.toml --sheet --out out\n"
      "SIGINT, SIGTERM and SIGHUP stop a run that has a folder after its present step; --resume continues it.\n"
      "A run that diverges keeps its history up to there; its summary says why, and the exit status is 3.\n"
      "A run whose results are NOT USABLE writes its files; the exit status is 7, or 0 if the watch of the\n"
      "scene has quality = \"warning\", the default with rules = \"1993\".");
  return {app, [options] { return run(*options); }};
}

}  // namespace talus::app
