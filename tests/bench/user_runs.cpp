#include "tests/bench/user_runs.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "solver/app/run/scene_run.hpp"
#include "solver/app/sweep/sweep_base.hpp"
#include "solver/base/error.hpp"
#include "solver/io/read_scene_file.hpp"
#include "solver/run/simulate.hpp"
#include "tests/bench/timing.hpp"
#include "tests/temporary_folder.hpp"

namespace talus::bench {
namespace {

namespace fs = std::filesystem;

constexpr int repetitions = 9;

/// The loop that a benchmark of forces measures: without observers.
void bare(const SceneFile& file, const Dynamics& dynamics, bool ledger) {
  RigidBodySystem system{dynamics, ledger};
  Integrator method = file.scene.integrator;
  State state = file.scene.initial;
  const Outcome outcome = simulate(system, method, state, file.scene.plan);
  TALUS_DEMAND(static_cast<bool>(outcome));
  benchmark::DoNotOptimize(state);
}

/// The work of `talus run` between reading the scene and printing the summary.
void observed(const SceneFile& file, const fs::path& folder, bool sheet) {
  app::SceneRun run{file, folder, "scene.toml", {.sheet = sheet}};
  Progress progress;
  const Outcome outcome = run.proceed({}, &progress);
  TALUS_DEMAND(static_cast<bool>(outcome));
  const RunRecord record = run.record(outcome);
  if (!folder.empty()) run.write(record);
  benchmark::DoNotOptimize(record);
}

struct Row {
  std::string scene, what;
  long steps{};
  std::function<void()> work;
};

}  // namespace

void print_user_run_costs() {
  const Folder folder;
  std::vector<Row> rows;
  std::vector<std::unique_ptr<SceneFile>> files;
  std::vector<std::unique_ptr<Dynamics>> compiled;
  std::vector<std::unique_ptr<app::SweepBase>> bases;
  for (const char* const name : {"fence/table_2.toml", "two_cable.toml"}) {
    files.push_back(std::make_unique<SceneFile>(read_scene_file(fs::path{TALUS_CASES} / name)));
    const SceneFile& file = *files.back();
    const Dynamics& dynamics = *compiled.emplace_back(std::make_unique<Dynamics>(file.scene.model));
    const long steps = step_count(file.scene.plan);
    rows.push_back({name, "bare loop", steps, [&] { bare(file, dynamics, false); }});
    rows.push_back({name, "bare loop with ledger", steps, [&] { bare(file, dynamics, true); }});
    rows.push_back({name, "run, no folder", steps, [&] { observed(file, {}, false); }});
    const app::SweepBase& base = *bases.emplace_back(
        std::make_unique<app::SweepBase>(parse_toml(read_text(fs::path{TALUS_CASES} / name), name), name));
    rows.push_back({name, "a run of a sweep", steps, [&] {
                      const app::SweepResult result = base.result({}, {}, [] { return false; });
                      TALUS_DEMAND(result.end == app::SweepEnd::finished);
                    }});
    rows.push_back({name, "run --out", steps, [&] { observed(file, folder.path, false); }});
    if (file.fence) rows.push_back({name, "run --sheet --out", steps, [&] { observed(file, folder.path, true); }});
  }
  const std::string command = fmt::format("{} run {}/fence/table_2.toml --out {} > /dev/null", TALUS_EXECUTABLE,
                                          TALUS_CASES, (folder.path / "process").string());
  const auto process = [&command] { TALUS_DEMAND(std::system(command.c_str()) == 0); };
  std::vector<Task> tasks;
  for (const Row& row : rows)
    tasks.push_back({row.scene + "/" + row.what, row.work});
  tasks.push_back({"process", process});
  const std::vector<Timing> timings = time_tasks(tasks, repetitions);
  fmt::print("\nWhat a user's run costs: microseconds a step (median of {} interleaved runs)\n", repetitions);
  fmt::print("{:20} {:24} {:>9} {:>24} {:>8}\n", "scene", "", "median", "least .. largest", "to bare");
  double bare_time = 0.0, observed_time = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double per_step = 1e6 / static_cast<double>(rows[i].steps);
    if (rows[i].what == "bare loop") bare_time = timings[i].median;
    if (rows[i].what == "run, no folder") observed_time = timings[i].median;
    fmt::print("{:20} {:24} {:>9.3f} {:>11.3f} .. {:>9.3f} {:>7.2f}x\n", rows[i].scene, rows[i].what,
               timings[i].median * per_step, timings[i].smallest * per_step, timings[i].largest * per_step,
               timings[i].median / bare_time);
    if (rows[i].what == "a run of a sweep")
      fmt::print("{:20} {:24} {:>9.3f}\n", rows[i].scene, "  its ratio to the run", timings[i].median / observed_time);
  }
  fmt::print("the whole program, table_2 with --out: {:.3f} s ({:.3f} .. {:.3f})\n", timings.back().median,
             timings.back().smallest, timings.back().largest);
}

}  // namespace talus::bench
