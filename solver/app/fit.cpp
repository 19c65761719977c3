#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <thread>

#include "solver/app/command.hpp"
#include "solver/app/fit/fit_results.hpp"
#include "solver/app/fit/fit_study.hpp"
#include "solver/app/interruption.hpp"
#include "solver/base/error.hpp"
#include "solver/base/progress.hpp"
#include "solver/command_line/usage_error.hpp"
#include "solver/io/file/atomic_file.hpp"
#include "solver/io/file/folder_lock.hpp"
#include "solver/io/file/toml_document.hpp"

namespace talus::app {
namespace {

namespace fs = std::filesystem;

struct FitOptions {
  std::string file;
  std::string folder;
  unsigned threads{std::max(1U, std::thread::hardware_concurrency())};
  bool json{false};
  bool draws{true};
};

int fit_command(const FitOptions& options, const DrawingSink& sink) {
  const fs::path name{options.file};
  const FitFile file = read_fit(read_text(name), name);
  FitStudy study{file, options.threads};
  const fs::path folder{options.folder};
  std::optional<FolderLock> lock;
  if (!options.folder.empty()) {
    make_folder(folder);
    lock.emplace(folder);
  }
  Fit fit;
  std::vector<double> results;
  {
    Interruption interruption;
    Progress line;
    try {
      fit = study.fitted([&] { return interruption.signal() != 0; },
                         [&](std::size_t runs) {
                           if (line.due()) line.show(fmt::format("{} runs", runs));
                         });
      results = study.results(fit.values);
    } catch (const FitStudy::Interrupted&) {
      print_failure(fmt::format("{}: nothing is written", interruption.name()));
      return 128 + interruption.signal();
    }
  }
  const std::string json = fit_json(file, fit, results);
  fmt::print("{}", options.json ? json : fit_text(file, fit));
  std::fflush(stdout);
  for (const std::string& warning : fit_warnings(file, fit))
    print_failure(fmt::format("warning: {}", warning));
  if (options.folder.empty()) return ok;
  // Those of an earlier fit.
  fs::remove(folder / "bootstrap.csv");
  remove_figures(folder / "plots", {"quantity_", "parameters_"});
  const auto write = [&](const char* result, const std::string& text) {
    write_whole(folder / result, text);
    if (!options.json) fmt::print("{}\n", (folder / result).string());
  };
  write("fit.json", json);
  write("fit.csv", fit_csv(file, results));
  if (!fit.samples.empty()) write("bootstrap.csv", bootstrap_csv(file, fit));
  if (options.draws)
    sink({.pictures = {.figures = fit_figures(file, fit, results)},
          .target = folder / "plots",
          .formats = {"svg", "pdf"},
          .lists_files = !options.json});
  return ok;
}

}  // namespace

Command add_fit(CLI::App& talus, const DrawingSink& sink) {
  CLI::App* const app = talus.add_subcommand("fit", "Fit parameters of a scene to measurements, with intervals");
  const auto options = std::make_shared<FitOptions>();
  app->add_option("FILE", options->file, "the fit (.toml): scene, data, inputs, quantities, parameters")->required();
  app->add_option("--out", options->folder, "folder for fit.json, fit.csv, bootstrap.csv and figures");
  app->add_option("--threads", options->threads, "default: all; results do not depend on it")
      ->check(whole_between(1, 1024));
  app->add_flag("--json", options->json, "print JSON");
  app->add_flag("!--no-plots", options->draws, "draw no figures");
  app->footer(
      "Example:\n"
      "  talus fit cases/measured/rebound.fit.toml --out fit\n"
      "The data are a table (CSV) with a row for each experiment, or for each time of a trajectory.");
  return {app, [=] { return fit_command(*options, sink); }};
}

}  // namespace talus::app
