#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <thread>

#include "solver/app/capacity/capacity_results.hpp"
#include "solver/app/command.hpp"
#include "solver/app/interruption.hpp"
#include "solver/base/error.hpp"
#include "solver/base/progress.hpp"
#include "solver/command_line/usage_error.hpp"
#include "solver/io/fence_file.hpp"
#include "solver/io/file/atomic_file.hpp"
#include "solver/io/file/folder_lock.hpp"

namespace talus::app {
namespace {

namespace fs = std::filesystem;

struct CapacityOptions {
  std::string file;
  std::string folder;
  unsigned threads{std::max(1U, std::thread::hardware_concurrency())};
  bool json{false};
  bool draws{true};
  bool sheet{false};
};

int capacity(const CapacityOptions& options, const DrawingSink& sink) {
  const fs::path name{options.file};
  const CapacityFile file = read_capacity(read_text(name), name);
  // Its page consists of figures, and its runs take minutes.
  if (options.sheet) find_sheet_tools();
  SweepFolder folder;
  folder.folder = options.folder.empty() ? name.stem() : fs::path{options.folder};
  folder.title = file.title, folder.limits = file.limits;
  folder.base_text = base_text(file.base, name.string() + ": base");
  folder.outputs.assign(capacity_outputs.begin(), capacity_outputs.end());
  const std::string base_name = is_deck(file.base) ? "base.toml" : file.base.string();
  SweepBase base{parse_toml(folder.base_text, base_name), base_name};
  const RockRuns rocks{base.document(), base_name, file};
  base.choose(folder.outputs);
  make_folder(folder.folder);
  const FolderLock lock{folder.folder};
  CapacityStudy study{file, folder, base, rocks, options.threads};
  // Those of an earlier question.
  for (const char* const result : {"capacity.csv", "capacity.json", "capacity.pdf", "capacity.html"})
    fs::remove(folder.folder / result);
  remove_figures(folder.folder / "plots", {"envelope_", "cable_force_", "boundary_"});
  int signal = 0;
  std::string signal_name;
  bool is_complete = false;
  {
    Interruption interruption;
    Progress line;
    is_complete = study.run([&] { return interruption.signal() != 0; },
                            [&](std::size_t runs) {
                              if (line.due()) line.show(fmt::format("{} runs", runs));
                            });
    if (!is_complete) signal = interruption.signal(), signal_name = interruption.name();
  }
  // For `talus sweep status` and `collect`, which writes each run as a row.
  folder.runs = study.runs();
  write_sweep_folder(folder);
  if (!is_complete) {
    print_failure(fmt::format("{}: the same command continues", signal_name));
    return 128 + signal;
  }
  write_whole(folder.folder / "capacity.csv", capacity_csv(study));
  const std::string json = capacity_json(study, rocks);
  write_whole(folder.folder / "capacity.json", json);
  fmt::print("{}", options.json ? json : capacity_text(study));
  if (!options.json) {
    for (const char* const result : {"capacity.csv", "capacity.json"})
      fmt::print("{}\n", (folder.folder / result).string());
  }
  if (options.draws)
    sink({.pictures = {.figures = capacity_figures(study)},
          .target = folder.folder / "plots",
          .formats = {"svg", "pdf"},
          .lists_files = !options.json});
  if (options.sheet) draw_sheet(folder.folder / "capacity.json");
  std::size_t failed = 0, all = 0;
  const auto count = [&](const RockTrials& trials) {
    all += trials.trials.size();
    failed += trials.ends()[static_cast<std::size_t>(RockEnd::failed)];
  };
  for (const RockMap& map : study.maps()) {
    std::ranges::for_each(map.nodes, count);
    count(map.audit);
  }
  count(study.hazard());
  return exit_of_runs(failed, all);
}

}  // namespace

Command add_capacity(CLI::App& talus, const DrawingSink& sink) {
  CLI::App* const app = talus.add_subcommand("capacity", "Find the rocks that a fence stops, with intervals");
  const auto options = std::make_shared<CapacityOptions>();
  app->add_option("FILE", options->file, "the question (.toml): base, mass, speed, height")->required();
  app->add_option("--out", options->folder,
                  "folder of the results; default: the name of FILE without .toml, in the present folder");
  app->add_option("--threads", options->threads, "default: all; results do not depend on it")
      ->check(whole_between(1, 1024));
  app->add_flag("--json", options->json, "print JSON");
  CLI::Option* const no_plots = app->add_flag("!--no-plots", options->draws, "draw no figures");
  app->add_flag("--sheet", options->sheet, "also a page to print: capacity.pdf and capacity.html")->excludes(no_plots);
  app->footer(
      "Examples:\n"
      "  talus capacity cases/capacity/table_2.toml --out capacity --sheet\n"
      "  talus sweep collect capacity                 each run as a row\n"
      "It can be stopped at any time and started again. Exit statuses: 6 some runs failed, 3 all did.");
  return {app, [=] { return capacity(*options, sink); }};
}

}  // namespace talus::app
