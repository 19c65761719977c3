#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <memory>
#include <optional>
#include <sstream>

#include "solver/app/cell/cell_files.hpp"
#include "solver/app/cell/cell_summary.hpp"
#include "solver/app/command.hpp"
#include "solver/app/life_cycle.hpp"
#include "solver/command_line/completion.hpp"
#include "solver/integrate/euler.hpp"
#include "solver/io/cell/cell_restart.hpp"

namespace talus::app {
namespace {

struct CellOptions : RunOptions {
  std::string integrator;
  std::string units;
  std::optional<std::uint64_t> seed;
  bool historical{false};
  bool jump{false};
  bool virtual_discs{false};

  /// The options that a resumed run keeps from its start.
  GivenOptions kept() const {
    return {{"--out", !folder.empty()},   {"--integrator", !integrator.empty()}, {"--units", !units.empty()},
            {"--seed", seed.has_value()}, {"--historical", historical},          {"--jump", jump},
            {"--virtual", virtual_discs}};
  }
};

/// A cell's run as the command line requests it.
struct CellRequest {
  RunRequest run;
  CellChoices choices;
  CellScene scene;
  std::optional<CellRestart> restart;  ///< RESTART.DAT, from which a new run starts
  std::vector<std::string> warnings;   ///< of the start
};

/// Serializes the choices of the command line, which a resumed run keeps, and the warnings.
void serialize(Archive& archive, CellRequest& request) {
  CellChoices& choices = request.choices;
  std::string integrator = choices.integrator.value_or(""), units{choices.units ? choices.units->name : ""};
  bool seeded = choices.seed.has_value();
  long seed = static_cast<long>(choices.seed.value_or(0));
  archive.text("integrator", integrator), archive.text("units", units);
  archive.flag("seeded", seeded), archive.count("seed", seed);
  archive.flag("historical", choices.historical), archive.flag("jump", choices.jump);
  archive.flag("virtual", choices.virtual_discs);
  std::string warnings = fmt::format("{}", fmt::join(request.warnings, "\n"));
  archive.text("warnings", warnings);
  if (!archive.is_loading()) return;
  if (!integrator.empty()) choices.integrator = integrator;
  if (!units.empty()) choices.units = unit_system(units);
  if (seeded) choices.seed = static_cast<std::uint64_t>(seed);
  request.warnings.clear();
  std::istringstream lines{warnings};
  for (std::string line; std::getline(lines, line);)
    request.warnings.push_back(line);
}

CellRequest cell_request(const CellOptions& options) {
  CellRequest request{
      .run = run_request("cell", options, options.kept()), .choices = {}, .scene = {}, .restart = {}, .warnings = {}};
  CellChoices& choices = request.choices;
  if (request.run.resumes()) {
    restore(request.run, [&](Archive& archive) { archive.scope("choices", [&] { serialize(archive, request); }); });
  } else {
    if (!options.integrator.empty()) choices.integrator = options.integrator;
    if (!options.units.empty()) choices.units = unit_system(options.units);
    choices.seed = options.seed;
    choices.historical = options.historical;
    if (options.historical && options.integrator.empty()) choices.integrator = Euler::name;
    choices.jump = options.jump;
    choices.virtual_discs = options.virtual_discs;
  }
  request.scene = read_cell(request.run.text, request.run.scene.string(), choices);
  if (request.run.resumes() || !request.scene.restart) return request;
  const std::filesystem::path file = request.run.scene.parent_path() / "RESTART.DAT";
  request.restart = read_cell_restart(file, request.scene.cell);
  request.warnings.push_back(fmt::format(
      "{}: it contains neither the block, which was placed on the discs at rest, nor the contact history: {} contacts "
      "start without history. The run continues from it, but not as an uninterrupted run would (talus cell --resume "
      "does)",
      file.string(), request.restart->forgotten));
  return request;
}

/// The run of a cell, as `talus cell` requests it.
class RequestedCell final : public ResumableRun {
 public:
  explicit RequestedCell(CellRequest& request)
      : request_{&request},
        run_{request.restart ? CellRun{request.scene.cell, request.scene.plan, std::move(request.restart->start)}
                             : CellRun{request.scene.cell, request.scene.plan}},
        first_{run_.steps()} {
    if (request.run.folder.empty()) return;
    files_.emplace(request.run.folder, request.scene);
    if (request.restart) files_->count_on(request.restart->cycles);
  }

  void serialize(Archive& archive) override {
    archive.scope("choices", [&] { app::serialize(archive, *request_); });
    archive.scope("run", [&] { run_.serialize(archive); });
    archive.scope("files", [&] { files_->serialize(archive); });
    if (archive.is_loading()) first_ = run_.steps();
  }
  std::string time_text(double time) const override {
    const std::optional<UnitSystem>& units = request_->scene.units;
    return fmt::format("{:.10g}{}", time, units ? " " + symbol(*units, dimension::time) : "");
  }
  void describe(Checkpoint& checkpoint) const override {
    checkpoint.integrator = run_.plan().integrator;
    checkpoint.step = run_.plan().step, checkpoint.end = run_.plan().end;
    checkpoint.steps = run_.steps();
  }
  /// The first LOOP overwrites RESTART.DAT.
  bool needs_checkpoint_at_start() const override { return true; }

  Outcome advance(const Condition& pause, Progress& progress) override {
    const Clock::time_point began = Clock::now();
    bool paused = false;
    while (!paused && !run_.finished() && run_.failure().empty()) {
      run_.advance();
      if (progress.due()) show(progress, seconds_ + seconds_since(began));
      if (files_ && run_.due()) files_->write_loop(run_);
      paused = pause && pause();
    }
    seconds_ += seconds_since(began);
    return run_.outcome();
  }
  bool finish(Outcome& outcome, const Condition&) override {
    outcome_ = {outcome, request_->warnings};
    std::ranges::move(cell_warnings(request_->scene, run_), std::back_inserter(outcome_.warnings));
    return outcome.kind == Outcome::Kind::stopped;
  }
  std::vector<std::string> warnings() const override {
    return outcome_.warnings.empty() ? request_->warnings : outcome_.warnings;
  }

  void write() override { files_->write_end(run_); }
  std::vector<std::string> file_names() const override { return files_->names(); }
  std::string files_of_out() const override { return "histories, profiles, states and summary"; }
  std::string summary_json(const std::string& resume) override {
    return cell_summary_json(request_->scene, run_, outcome_, resume);
  }
  std::string summary_text() override {
    return fmt::format("{}{}\n", cell_summary(request_->scene, run_, outcome_), cost());
  }

 private:
  using Clock = std::chrono::steady_clock;
  static double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  }

  /// Shows the time reached, the step rate and the remaining computing time.
  void show(Progress& progress, double seconds) const {
    const double rate = static_cast<double>(run_.steps() - first_) / seconds;
    progress.show(fmt::format("t {:.4g} of {:.4g}, {:.3g} steps/s, {} left",
                              static_cast<double>(run_.steps()) * run_.plan().step, run_.plan().end, rate,
                              duration_text(static_cast<double>(run_.last_step() - run_.steps()) / rate)));
  }

  /// Computing time of the steps of this process. It is not written to files, so that these are reproducible.
  std::string cost() const {
    const long steps = run_.steps() - first_;
    if (steps == 0) return "took no step";
    return fmt::format("took {:.3g} s for {} steps, {:.3g} s for a unit of time of the flow", seconds_, steps,
                       seconds_ / (static_cast<double>(steps) * run_.plan().step));
  }

  CellRequest* request_;
  CellRun run_;
  std::optional<CellFiles> files_;
  long first_;        ///< steps before this process
  double seconds_{};  ///< computing time of this process's steps [s]
  CellOutcome outcome_;
};

int cell(const CellOptions& options) {
  if (const auto code = report_ended_run(options, options.kept())) return *code;
  CellRequest request = cell_request(options);
  return live(request.run, [&] { return std::make_unique<RequestedCell>(request); });
}

}  // namespace

Command add_cell(CLI::App& talus) {
  CLI::App* app = talus.add_subcommand("cell", "Run a sheared cell of discs, as the program SNOFLO of 1989 did");
  const auto options = std::make_shared<CellOptions>();
  app->add_option(
      "SCENE", options->scene,
      "CNTRL.DAT of 1989 (any .DAT), or a scene file (.toml) with [cell]; with --resume only if it was moved");
  app->add_option(
      "--out", options->folder,
      "folder for RESTART.DAT at each LOOP, with GRAPH = 1 PIC.DAT and the states of cell.pvd, for a checkpoint "
      "at the start and about every second, at the end history.csv, profile.csv, plot.json and summary.json; "
      "without it nothing is written");
  app->add_option(
      "--resume", options->resume,
      "folder of an interrupted run: resume it as if it had never stopped; of a run that has ended it says so "
      "and returns its exit status");
  const std::vector<std::string> methods = disc_method_names();
  offer(app->add_option("--integrator", options->integrator,
                        fmt::format("{}; default {}", fmt::join(methods, ", "), CellPlan{}.integrator)),
        methods);
  offer(app->add_option("--units", options->units, "unit system of CNTRL.DAT, which names none: SI or US"),
        unit_system_names());
  app->add_option("--seed", options->seed, "of the first velocities across the field; default the scene's, or 0")
      ->check(number_between(0, static_cast<double>(maximum_seed)));
  app->add_flag("--historical", options->historical,
                "as the runs of 1989 may have been: Euler's steps; K1/K2 must be 0.45 and STEP 1e-7");
  app->add_flag("--jump", options->jump, "pass time in which nothing can touch at once");
  app->add_flag(
      "--virtual", options->virtual_discs,
      "discs act across the borders by virtual ones, of which all pairs are tried, as in 1989: slow, a check");
  app->add_flag("--json", options->json, "print the summary as JSON");
  app->footer(
      "Examples:\n"
      "  talus cell cases/cell/CNTRL.DAT --units SI --out out\n"
      "  talus cell cases/cell/ice.toml --out out --seed 3 --json\n"
      "  talus cell --resume out\n"
      "SIGINT, SIGTERM and SIGHUP stop a run that has a folder after its present step; --resume\n"
      "continues it, after kill -9 from its last checkpoint.");
  return {app, [options] { return cell(*options); }};
}

}  // namespace talus::app
