#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "solver/app/command.hpp"
#include "solver/base/progress.hpp"
#include "solver/command_line/usage_error.hpp"
#include "solver/io/file/atomic_file.hpp"
#include "solver/io/file/folder_lock.hpp"
#include "solver/io/output/write_study.hpp"
#include "solver/study/shear_study.hpp"

namespace talus::app {
namespace {

namespace fs = std::filesystem;

struct StudyOptions {
  std::string name;
  StudyPlan plan;
  std::string folder;
};

int study(const StudyOptions& options) {
  StudyPlan plan = options.plan;
  // Create and lock the folder first, so that no results of the long study are lost for lack of a folder.
  std::optional<FolderLock> folder;
  if (!options.folder.empty()) make_folder(options.folder), folder.emplace(options.folder);
  std::vector<StudyMean> means;
  {
    using Clock = std::chrono::steady_clock;
    Progress line;
    std::mutex one_at_a_time;
    const Clock::time_point start = Clock::now();
    plan.progress = [&](const StudyProgress& seen) {
      const std::lock_guard lock{one_at_a_time};
      if (!line.due()) return;
      const double elapsed = std::chrono::duration<double>(Clock::now() - start).count();
      line.show(fmt::format("{} of {} runs, {:.0f} %, {}", seen.runs, seen.all_runs, 100.0 * seen.fraction,
                            time_left_text(elapsed, seen.fraction)));
    };
    means = shear_study(shear_study_points(false), plan);
  }
  const fs::path file = fs::path{options.folder} / "shear_study.csv";
  if (folder) write_whole(file, study_csv(means));
  fmt::print("{}", study_text(means, verdicts(means), plan.seeds));
  if (folder) fmt::print("file: {}\n", file.string());
  return ok;
}

}  // namespace

Command add_study(CLI::App& talus) {
  CLI::App* app = talus.add_subcommand("study", "Run a parameter study and print its results");
  const auto options = std::make_shared<StudyOptions>();
  options->plan.threads = std::max(1U, std::thread::hardware_concurrency());
  app->add_option("NAME", options->name, "shear: the hypothesis of Lacy 1989, cells of discs under load and drive")
      ->required()
      ->check(CLI::IsMember({"shear"}));
  app->add_option("--time", options->plan.time, "of each run, in seconds of flow; default 0.8")
      ->check(number_between(0.01, 1000.0));
  app->add_option("--seeds", options->plan.seeds, "runs of each point; default 5")->check(whole_between(2, 1000));
  app->add_option("--threads", options->plan.threads, "default: all; the numbers do not depend on it")
      ->check(whole_between(1, 1024));
  app->add_option("--out", options->folder, "folder for shear_study.csv, every run of it");
  app->footer(
      "The default, 110 runs of 0.8 s, takes about three minutes of processor time, divided among the threads.\n"
      "The time is proportional to --time and --seeds. On a terminal a line shows the progress and the time left.\n"
      "Friction and density of discs of different sizes against the inertial number are in the report of `make "
      "verify`,\n"
      "case dense_rheology.\n"
      "Example:\n  talus study shear --seeds 8 --time 2 --out study");
  return {app, [options] { return study(*options); }};
}

}  // namespace talus::app
