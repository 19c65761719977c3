#include "solver/app/life_cycle.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>

#include "solver/app/command.hpp"
#include "solver/app/interruption.hpp"
#include "solver/app/outputs/run_outputs.hpp"
#include "solver/command_line/shell_word.hpp"
#include "solver/io/file/atomic_file.hpp"
#include "solver/io/file/folder_lock.hpp"
#include "solver/io/file/json_text.hpp"
#include "solver/io/file/toml_document.hpp"
#include "solver/io/output/run_folder.hpp"
#include "verification/record/utf8.hpp"

namespace talus::app {
namespace {

namespace fs = std::filesystem;

/// Completes the request from the checkpoint of the interrupted run.
void resume(RunRequest& request, const RunOptions& options, const GivenOptions& kept) {
  demand_folder_with(request.from, checkpoint_name,
                     fmt::format("that of an interrupted run, which `talus {} --out` writes", request.command));
  const fs::path file = request.from / checkpoint_name;
  request.saved = read_checkpoint(file, TALUS_VERSION);
  const std::string_view command = request.saved.memory.contains("choices.integrator") ? "cell" : "run";
  if (command != request.command)
    throw InputError{fmt::format("{}: found a run of `talus {}`; resume it by `talus {} --resume {}`", file.string(),
                                 command, command, options.resume)};
  for (const auto& [name, given] : kept)
    if (given) throw kept_option(name);
  if (options.folder.empty()) request.folder = request.from;
  if (options.scene.empty()) request.scene = request.saved.scene_file;
  try {
    request.text = read_text(request.scene);
  } catch (const IoError& error) {
    if (!options.scene.empty()) throw;
    throw IoError{fmt::format("{}: scene_file: {}", file.string(), error.what())};
  }
  if (const std::string hash = fnv1a(request.text); hash != request.saved.scene_fnv1a)
    throw InputError{
        fmt::format("{}: scene_fnv1a: found {}, but {} has {}; the scene must be as it was when the run was "
                    "interrupted",
                    file.string(), request.saved.scene_fnv1a, request.scene.string(), hash)};
}

/// Saves the run in its folder, so that it can be resumed.
void write_checkpoint(const RunRequest& request, ResumableRun& run) {
  Archive archive;
  run.serialize(archive);
  Checkpoint checkpoint;
  run.describe(checkpoint);
  checkpoint.scene_file = fs::absolute(request.scene).string();
  checkpoint.scene_fnv1a = fnv1a(request.text);
  checkpoint.memory = archive.items();
  sync_folder(request.folder);  // the checkpoint relies on the states written so far
  write_whole(request.folder / checkpoint_name, checkpoint_text(checkpoint, TALUS_VERSION));
}

/// Creates and locks the folder of the run, and removes files of an earlier run, which would mix with the new ones.
std::unique_ptr<FolderLock> prepare_folder(const RunRequest& request) {
  if (request.folder.empty()) return {};
  make_folder(request.folder);
  auto lock = std::make_unique<FolderLock>(request.folder);
  const bool same = request.resumes() && fs::equivalent(request.from, request.folder);
  same ? remove_unfinished(request.folder) : remove_run(request.folder, RunOutputs::fixed_files());
  return lock;
}

/// The run at its start, or restored from its checkpoint.
std::unique_ptr<ResumableRun> start_or_resume(const RunRequest& request,
                                              const std::function<std::unique_ptr<ResumableRun>()>& make) {
  std::unique_ptr<ResumableRun> run = make();
  if (!request.resumes()) {
    if (!request.folder.empty() && run->needs_checkpoint_at_start()) write_checkpoint(request, *run);
    return run;
  }
  restore(request, [&](Archive& archive) {
    run->serialize(archive);
    if (const auto names = archive.left_over(); !names.empty())
      throw InputError{fmt::format("found {}; a run of this scene has no such part", names.front())};
  });
  run->bring_files(request.from);
  return run;
}

/// Advances the run to its end or until it is interrupted; with a folder it is saved there every second, so that a
/// crash loses at most a second, or as seldom as saving takes a tenth of the time.
Outcome advance(const RunRequest& request, ResumableRun& run, const std::optional<Interruption>& interruption) {
  using Clock = std::chrono::steady_clock;
  Progress progress;
  if (request.folder.empty()) return run.advance({}, progress);
  Clock::duration pauses = std::chrono::seconds{1};
  for (;;) {
    const Clock::time_point due = Clock::now() + pauses;
    bool saves = false;
    long steps = 0;
    const auto pause = [&] {
      if (interruption->signal() != 0) return true;
      saves = ++steps % 64 == 0 && Clock::now() >= due;
      return saves;
    };
    Outcome outcome = run.advance(pause, progress);
    if (!saves || outcome.kind != Outcome::Kind::stopped) return outcome;
    const Clock::time_point start = Clock::now();
    write_checkpoint(request, run);
    pauses = std::max<Clock::duration>(std::chrono::seconds{1}, 9 * (Clock::now() - start));
  }
}

/// Writes all files of the run, and its checkpoint if it can be resumed.
void write_files(const RunRequest& request, ResumableRun& run, bool resumable) {
  if (resumable) write_checkpoint(request, run);
  run.write();
  // One sync for all files: separate syncs could take longer than the run.
  sync_folder(request.folder);
  write_whole(request.folder / "summary.json", run.summary_json({}));  // last: it marks the output as complete
}

/// Draws the pages made from the run's files, then removes the checkpoint of a run that has ended, which is needed
/// until then. Returns the error message if drawing failed (the run's files are complete all the same), else an empty
/// string.
std::string draw(const RunRequest& request, const ResumableRun& run, bool resumable) {
  try {
    run.draw();
  } catch (const IoError& error) {
    return error.what();
  }
  std::error_code none;
  if (!resumable) fs::remove(request.folder / checkpoint_name, none);
  return {};
}

std::string resume_command(const RunRequest& request) {
  return fmt::format("talus {} --resume {}", request.command, shell_word(request.folder.string()));
}

void print_result(const RunRequest& request, ResumableRun& run, bool resumable) {
  const std::string folder = request.folder.string();
  const std::string resume = resumable ? resume_command(request) : "";
  fmt::print("{}", request.json ? run.summary_json(resume) : run.summary_text());
  if (request.json) return;
  if (folder.empty()) return fmt::print("files: none; --out DIR writes {}\n", run.files_of_out());
  std::vector<std::string> files = run.file_names();
  // Pictures and pages that could not be drawn are not listed.
  std::erase_if(files, [&](const std::string& name) { return !fs::exists(request.folder / name); });
  files.insert(files.begin(), "summary.json");
  if (resumable) files.emplace_back(checkpoint_name);
  fmt::print("files: {}: {}\n", folder, fmt::join(files, ", "));
  if (resumable) fmt::print("resume: {}\n", resume);
}

/// Prints the warnings from index `first` on; returns the number of all warnings.
std::size_t print_warnings(const ResumableRun& run, std::size_t first) {
  const std::vector<std::string> warnings = run.warnings();
  for (std::size_t i = first; i < warnings.size(); ++i)
    print_failure("warning: " + warnings[i]);
  return warnings.size();
}

}  // namespace

std::optional<int> report_ended_run(const RunOptions& options, const GivenOptions& others) {
  const fs::path folder = options.resume;
  std::error_code none;
  if (folder.empty() || fs::exists(folder / checkpoint_name, none)) return {};
  std::string summary, kind, failure;
  bool is_usable = true;
  try {
    summary = read_json_text(folder / "summary.json");
    const auto json = nlohmann::json::parse(summary);
    const auto& outcome = json.at("outcome");
    outcome.at("kind").get_to(kind);
    // Schema 1 names it "words".
    if (kind == "diverged") outcome.at(outcome.contains("message") ? "message" : "words").get_to(failure);
    // The summary of a cell has no quality.
    if (const auto quality = json.find("quality"); quality != json.end())
      is_usable = quality->at("usable").get<bool>() || !quality->value("enforced", false);  // schema 1 has none
  } catch (const IoError&) {
    return {};  // no run ended here; the missing checkpoint is reported where it is read
  } catch (const nlohmann::json::exception&) {
    return {};  // likewise: summary.json of another program
  } catch (const InputError&) {
    return {};  // likewise: JSON nested too deeply
  }
  if (kind != "diverged" && kind != "finished") return {};
  for (const auto& [name, given] : others)
    if (given)
      throw InputError{
          fmt::format("{}: the run in {} has ended; only an interrupted run can be resumed", name, options.resume)};
  if (options.json) fmt::print("{}", summary);
  if (kind == "diverged") {
    print_failure(fmt::format("{}: the run diverged and cannot be resumed: {}", options.resume, failure));
    return diverged;
  }
  if (!options.json) fmt::print("{}: the run is finished; there is nothing to resume\n", options.resume);
  return is_usable ? ok : unusable;
}

RunRequest run_request(std::string_view command, const RunOptions& options, const GivenOptions& kept) {
  RunRequest request{.command = std::string{command},
                     .scene = options.scene,
                     .text = {},
                     .folder = options.folder,
                     .from = options.resume,
                     .saved = {},
                     .json = options.json};
  if (request.resumes()) {
    resume(request, options, kept);
    return request;
  }
  if (options.scene.empty())
    throw InputError{fmt::format("SCENE is required, or --resume DIR\nhelp: talus {} --help", command)};
  if (const std::string whole = fs::absolute(request.scene).string();
      !options.folder.empty() && !records::is_utf8(whole))
    throw InputError{
        fmt::format("{}: the folder of the scene is not UTF-8; the checkpoint names it", records::as_utf8(whole))};
  request.text = read_text(request.scene);
  return request;
}

InputError kept_option(std::string_view option) {
  return InputError{fmt::format("{}: a resumed run (--resume) keeps the options of its start", option)};
}

void restore(const RunRequest& request, const std::function<void(Archive&)>& visit) {
  try {
    Archive archive{request.saved.memory};
    visit(archive);
  } catch (const InputError& error) {
    throw InputError{fmt::format("{}: memory: {}", (request.from / checkpoint_name).string(), error.what())};
  }
}

int live(const RunRequest& request, const std::function<std::unique_ptr<ResumableRun>()>& make) {
  const std::unique_ptr<FolderLock> lock = prepare_folder(request);
  const std::unique_ptr<ResumableRun> run = start_or_resume(request, make);
  std::size_t printed = print_warnings(*run, 0);

  // A run without a folder cannot be saved, so a signal ends the program as usual.
  std::optional<Interruption> interruption;
  if (lock) interruption.emplace();
  const auto signal = [&] { return interruption ? interruption->signal() : 0; };
  const ResumableRun::Condition interrupted = [&] { return signal() != 0; };
  Outcome outcome = advance(request, *run, interruption);
  const bool resumable = run->finish(outcome, interrupted);
  std::string undrawn;
  if (lock) {
    write_files(request, *run, resumable);
    undrawn = draw(request, *run, resumable);
  }
  print_result(request, *run, resumable);
  printed = print_warnings(*run, printed);
  if (!undrawn.empty()) print_failure(undrawn);
  const std::string time = run->time_text(outcome.time);
  if (!outcome) {
    print_failure(fmt::format("the run diverged at t = {}; its summary gives the reason", time));
    return diverged;
  }
  if (signal() == 0) return !undrawn.empty() ? io_failed : resumable || run->is_usable() ? ok : unusable;
  const std::string_view name = interruption->name();
  if (outcome.kind == Outcome::Kind::finished) {
    // The signal may have interrupted the repeat of a fence's run; the summary then reports it.
    print_failure(fmt::format("{} came when the run had finished", name));
  } else {
    print_failure(fmt::format("{}: the run was interrupted at t = {} and saved in {}; resume it by {}", name, time,
                              (request.folder / checkpoint_name).string(), resume_command(request)));
  }
  return 128 + signal();
}

}  // namespace talus::app
