#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <sstream>

#include "solver/app/cell_files.hpp"
#include "solver/app/cell_summary.hpp"
#include "solver/app/command.hpp"
#include "solver/app/ended_run.hpp"
#include "solver/app/interruption.hpp"
#include "solver/base/error.hpp"
#include "solver/base/progress.hpp"
#include "solver/integrate/euler.hpp"
#include "solver/io/cell/cell_restart.hpp"
#include "solver/io/file/atomic_file.hpp"
#include "solver/io/file/toml_document.hpp"
#include "solver/io/output/checkpoint.hpp"

namespace talus::app {
namespace {

namespace fs = std::filesystem;

struct CellOptions {
  std::string scene;
  std::string folder;
  std::string resume;
  std::string integrator;
  std::string units;
  std::optional<std::uint64_t> seed;
  bool historical{false};
  bool jump{false};
  bool virtual_discs{false};
  bool json{false};
};

/// A cell to be run, and what of it comes from where.
struct CellOrder {
  fs::path file;
  std::string text;
  CellScene scene;
  CellChoices choices;
  fs::path folder;                 ///< empty: nothing is written
  std::optional<Checkpoint> left;  ///< of the run that is taken on
  std::vector<std::string> warnings;
};

/// Names what the command line said, which a run that is taken on keeps to, and what was warned of.
void remember(Memory& memory, CellOrder& order) {
  CellChoices& choices = order.choices;
  std::string integrator = choices.integrator.value_or(""), units{choices.units ? choices.units->name : ""};
  bool seeded = choices.seed.has_value();
  long seed = static_cast<long>(choices.seed.value_or(0));
  memory.text("integrator", integrator), memory.text("units", units);
  memory.flag("seeded", seeded), memory.count("seed", seed);
  memory.flag("historical", choices.historical), memory.flag("jump", choices.jump);
  memory.flag("virtual", choices.virtual_discs);
  std::string warnings = fmt::format("{}", fmt::join(order.warnings, "\n"));
  memory.text("warnings", warnings);
  if (!memory.puts_back()) return;
  if (!integrator.empty()) choices.integrator = integrator;
  if (!units.empty()) choices.units = unit_system(units);
  if (seeded) choices.seed = static_cast<std::uint64_t>(seed);
  order.warnings.clear();
  std::istringstream lines{warnings};
  for (std::string line; std::getline(lines, line);)
    order.warnings.push_back(line);
}

CellOrder new_order(const CellOptions& options) {
  if (options.scene.empty()) throw InputError{"CNTRL.DAT is required, or --resume DIR\nhelp: talus cell --help"};
  CellOrder order{.file = options.scene,
                  .text = read_text(options.scene),
                  .scene = {},
                  .choices = {},
                  .folder = options.folder,
                  .left = {},
                  .warnings = {}};
  if (!options.integrator.empty()) order.choices.integrator = options.integrator;
  if (!options.units.empty()) order.choices.units = unit_system(options.units);
  order.choices.seed = options.seed;
  order.choices.historical = options.historical;
  if (options.historical && options.integrator.empty()) order.choices.integrator = Euler::name;
  order.choices.jump = options.jump;
  order.choices.virtual_discs = options.virtual_discs;
  order.scene = read_cell(order.file, order.choices);
  return order;
}

/// A resumed run keeps its options. Errors: InputError if any is given.
void refuse_options_of_resumed(const CellOptions& options) {
  if (!options.scene.empty() || !options.integrator.empty() || !options.units.empty() || options.seed ||
      options.historical || options.jump || options.virtual_discs || !options.folder.empty()) {
    throw InputError{
        "--resume: a run is taken on as it was begun and where it was left; no file and no other option "
        "but --json goes with it"};
  }
}

CellOrder left_order(const CellOptions& options) {
  CellOrder order{
      .file = {}, .text = {}, .scene = {}, .choices = {}, .folder = options.resume, .left = {}, .warnings = {}};
  const fs::path checkpoint = order.folder / "checkpoint.json";
  order.left = read_checkpoint(checkpoint, TALUS_VERSION);
  if (!order.left->memory.contains("choices.integrator"))
    throw InputError{checkpoint.string() + ": it is of no cell; `talus run --resume` takes on what `talus run` left"};
  order.file = order.left->scene_file;
  order.text = read_text(order.file);
  if (fnv1a(order.text) != order.left->scene_fnv1a) {
    throw InputError{fmt::format("{}: scene_fnv1a: {} was changed since the run was left; it cannot be taken on",
                                 checkpoint.string(), order.file.string())};
  }
  try {
    Memory memory{order.left->memory};
    memory.part("choices", [&] { remember(memory, order); });
  } catch (const InputError& error) {
    throw InputError{fmt::format("{}: memory: {}", checkpoint.string(), error.what())};
  }
  order.scene = read_cell(order.file, order.choices);
  return order;
}

/// The run at its start, or where it was left.
std::unique_ptr<CellRun> standing_run(CellOrder& order, CellFiles* files) {
  const CellScene& scene = order.scene;
  if (order.left) {
    auto run = std::make_unique<CellRun>(scene.cell, scene.plan);
    try {
      Memory memory{order.left->memory};
      memory.part("choices", [&] { remember(memory, order); });
      memory.part("run", [&] { run->remember(memory); });
      memory.part("files", [&] { files->remember(memory); });
      if (const auto names = memory.left_over(); !names.empty())
        throw InputError{fmt::format("found {}; a run of this cell has no such part", names.front())};
    } catch (const InputError& error) {
      throw InputError{fmt::format("{}: memory: {}", files->checkpoint().string(), error.what())};
    }
    return run;
  }
  if (!scene.restart) return std::make_unique<CellRun>(scene.cell, scene.plan);
  const fs::path file = order.file.parent_path() / "RESTART.DAT";
  CellRestart restart = read_cell_restart(file, scene.cell);
  order.warnings.push_back(fmt::format(
      "{}: it holds neither the block, which was set down on the discs without speed, nor what contacts remember: {} "
      "contacts begin anew. The run goes on from it, not as it would have gone on (talus cell --resume does)",
      file.string(), restart.forgotten));
  if (files != nullptr) files->count_on(restart.cycles);
  return std::make_unique<CellRun>(scene.cell, scene.plan, std::move(restart.start));
}

std::string checkpoint_of(CellOrder& order, CellRun& run, CellFiles& files) {
  Memory memory;
  memory.part("choices", [&] { remember(memory, order); });
  memory.part("run", [&] { run.remember(memory); });
  memory.part("files", [&] { files.remember(memory); });
  return checkpoint_text({.scene_file = fs::absolute(order.file).string(),
                          .scene_fnv1a = fnv1a(order.text),
                          .integrator = order.scene.plan.integrator,
                          .tolerance = 0.0,
                          .step = order.scene.plan.step,
                          .end = order.scene.plan.end,
                          .steps = run.steps(),
                          .memory = memory.items()},
                         TALUS_VERSION);
}

/// How far, how fast, how much longer.
class CellProgress {
 public:
  explicit CellProgress(const CellRun& run) : first_{run.steps()}, start_{Clock::now()} {}
  void show(const CellRun& run) {
    if (!line_.due()) return;
    const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    const double rate = static_cast<double>(run.steps() - first_) / seconds;
    line_.show(fmt::format("t {:.4g} of {:.4g}, {:.3g} steps/s, {} left",
                           static_cast<double>(run.steps()) * run.plan().step, run.plan().end, rate,
                           duration_text(static_cast<double>(run.last_step() - run.steps()) / rate)));
  }

 private:
  using Clock = std::chrono::steady_clock;
  long first_;
  Clock::time_point start_;
  Progress line_;
};

/// What so many steps took of the clock's time, which is in no file: files are the same each time.
std::string cost(const CellRun& run, long steps, double seconds) {
  if (steps == 0) return "took no step";
  return fmt::format("took {:.3g} s for {} steps, {:.3g} s for a unit of time of the flow", seconds, steps,
                     seconds / (static_cast<double>(steps) * run.plan().step));
}

int cell(const CellOptions& options) {
  if (!options.resume.empty()) {
    refuse_options_of_resumed(options);
    if (const auto ended = ended_run(options.resume)) return report_ended_run(options.resume, *ended, options.json);
  }
  CellOrder order = options.resume.empty() ? new_order(options) : left_order(options);
  std::optional<CellFiles> files;
  if (!order.folder.empty()) files.emplace(order.folder, order.scene);
  const std::unique_ptr<CellRun> run = standing_run(order, files ? &*files : nullptr);
  if (files) files->begin(order.left.has_value());
  // Before the first LOOP: what it writes may be the RESTART.DAT that the run goes on from.
  if (files && !order.left) files->write_checkpoint(checkpoint_of(order, *run, *files));
  for (const std::string& warning : order.warnings)
    print_failure("warning: " + warning);

  // Without a folder there is nowhere to leave the run: a signal then ends the program as usual.
  std::optional<Interruption> interruption;
  if (files) interruption.emplace();
  const auto signal = [&] { return interruption ? interruption->signal() : 0; };
  const long first = run->steps();
  const auto began = std::chrono::steady_clock::now();
  {
    CellProgress progress{*run};
    while (!run->finished() && run->failure().empty() && signal() == 0) {
      run->advance();
      progress.show(*run);
      if (!files) continue;
      if (run->due()) {
        files->begin_loop(run->discs().t);
        files->write_loop(*run);
      }
      if (files->checkpoint_due()) files->write_checkpoint(checkpoint_of(order, *run, *files));
    }
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  std::vector<std::string> warnings = order.warnings;
  if (run->largest_overlap() > CellRun::deepest * order.scene.cell.diameter ||
      run->largest_fraction() > CellRun::fullest) {
    warnings.push_back(
        fmt::format("the largest overlap is {:.3g} diameters, the largest solid fraction {:.4g}; beyond {} and {} "
                    "discs do not behave as "
                    "hard ones: stiffer contacts, or less speed or load",
                    run->largest_overlap() / order.scene.cell.diameter, run->largest_fraction(), CellRun::deepest,
                    CellRun::fullest));
  }
  // At first little work is done beside what is held, and moments count.
  const CellRun::Ledger ledger = run->ledger();
  const double unaccounted = ledger.unaccounted();
  if (!order.scene.plan.historical && run->failure().empty() && ledger.work() > ledger.held() &&
      std::abs(unaccounted) > CellRun::most_unaccounted) {
    warnings.push_back(
        fmt::format("{:.2g} of the work is unaccounted for, more than {}: the step is too long, or the integrator adds "
                    "or takes energy",
                    unaccounted, CellRun::most_unaccounted));
  }
  const CellOutcome outcome{run->finished() && run->failure().empty(), run->failure(), warnings};
  const bool left = !run->finished() && run->failure().empty();
  if (files) {
    if (left) files->write_checkpoint(checkpoint_of(order, *run, *files));
    files->write_end(*run, outcome);
    if (!left) files->remove_checkpoint();
  }
  fmt::print("{}",
             options.json ? cell_summary_json(order.scene, *run, outcome) : cell_summary(order.scene, *run, outcome));
  if (!options.json) fmt::print("{}\n", cost(*run, run->steps() - first, seconds));
  if (!options.json) {
    fmt::print("files: {}\n", files ? fmt::format("{}: {}", files->folder().string(), fmt::join(files->names(), ", "))
                                    : "none; --out DIR writes histories, profiles, states and summary");
  }
  for (std::size_t k = order.warnings.size(); k < warnings.size(); ++k)
    print_failure("warning: " + warnings[k]);
  if (!run->failure().empty()) {
    print_failure(run->failure());
    return diverged;
  }
  if (!left) return ok;
  print_failure(fmt::format("{} came; the run was left in {}; talus cell --resume {} takes it on",
                            signal() == SIGINT ? "SIGINT" : "SIGTERM", files->checkpoint().string(),
                            files->folder().string()));
  return 128 + signal();
}

}  // namespace

Command add_cell(CLI::App& talus) {
  CLI::App* app = talus.add_subcommand("cell", "Run a sheared cell of discs, as the program SNOFLO of 1989 did");
  const auto options = std::make_shared<CellOptions>();
  app->add_option("CNTRL", options->scene, "CNTRL.DAT of 1989 (any .DAT), or a scene file (.toml) with [cell]");
  app->add_option(
      "--out", options->folder,
      "folder for RESTART.DAT at each LOOP, with GRAPH = 1 PIC.DAT and the states of cell.pvd, for a checkpoint "
      "at the start and about every second, at the end history.csv, profile.csv, plot.json and summary.json; "
      "without it nothing is written");
  app->add_option("--resume", options->resume,
                  "folder in which a run was left: take it on as if it had never stopped; of a run that has ended it "
                  "says so and returns its exit code");
  app->add_option("--integrator", options->integrator,
                  fmt::format("{}; default {}", fmt::join(disc_method_names(), ", "), CellPlan{}.integrator));
  app->add_option("--units", options->units, "unit system of CNTRL.DAT, which names none: SI or US");
  app->add_option("--seed", options->seed, "of the first velocities across the field; default the scene's, or 0")
      ->check(number_between(0, static_cast<double>(most_seed)));
  app->add_flag("--historical", options->historical,
                "as the runs of 1989 may have been: Euler's steps; K1/K2 must be .45 and STEP 1e-7");
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
      "SIGINT and SIGTERM stop a run that has a folder after its present step; kill -9 leaves it at its last\n"
      "checkpoint.");
  return {app, [options] { return cell(*options); }};
}

}  // namespace talus::app
