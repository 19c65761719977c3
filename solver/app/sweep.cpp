#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>

#include "reports/base/error.hpp"
#include "solver/app/command.hpp"
#include "solver/app/interruption.hpp"
#include "solver/app/sweep/dakota.hpp"
#include "solver/app/sweep/engine.hpp"
#include "solver/app/sweep/executed_runs.hpp"
#include "solver/app/sweep/sweep_file.hpp"
#include "solver/app/sweep/sweep_folder.hpp"
#include "solver/app/sweep/sweep_function.hpp"
#include "solver/app/sweep/sweep_table.hpp"
#include "solver/base/error.hpp"
#include "solver/base/progress.hpp"
#include "solver/command_line/completion.hpp"
#include "solver/command_line/shell_word.hpp"
#include "solver/command_line/usage_error.hpp"
#include "solver/io/fence_file.hpp"
#include "solver/io/file/atomic_file.hpp"
#include "solver/io/file/folder_lock.hpp"

namespace talus::app {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

struct SweepOptions {
  std::string file;    ///< of plan
  std::string folder;  ///< of all others, and --out of plan
  std::string shard{"1/1"};
  unsigned threads{std::max(1U, std::thread::hardware_concurrency())};
  bool json{false};
  bool partial{false};
  std::string engine{"local"};
  std::optional<std::size_t> parts;  ///< default: threads
  std::string hosts;
  std::vector<std::string> engine_options;
  bool waits{false};
  std::string parameters, results;  ///< files of evaluate
};

/// Part `number` of `count` of a sweep, which has every count-th run.
struct Shard {
  std::size_t number{}, count{};
};

Shard shard_of(const std::string& text) {
  Shard shard;
  const char* const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, shard.number);
  if (first.ec == std::errc{} && first.ptr != end && *first.ptr == '/') {
    const auto second = std::from_chars(first.ptr + 1, end, shard.count);
    constexpr std::size_t maximum = 1'000'000;
    const bool is_whole = second.ec == std::errc{} && second.ptr == end;
    if (is_whole && shard.number >= 1 && shard.number <= shard.count && shard.count <= maximum) return shard;
  }
  throw InputError{
      fmt::format("--shard: found \"{}\"; it must be I/N, part I from 1 to N of N parts, at most 1000000", text)};
}

/// A time as text; below 10 s with two digits.
std::string time_text(double seconds) {
  return seconds < 10.0 ? fmt::format("{:.2g} s", seconds) : duration_text(seconds);
}

/// Time of the processor that this process has used [s].
double processor_time() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// What a run costs, measured at the start of one.
struct Sample {
  std::size_t number{};
  SweepResult result;
  double seconds{};
};

/// Runs the first, the middle and the last one, each for at most a tenth of a second: the cost of all is extrapolated.
/// The first one is run before, since it touches and tidies memory, too; short ones are repeated.
std::vector<Sample> samples_of(const SweepFolder& sweep, const SweepBase& base) {
  std::vector<Sample> samples;
  SweepLimits limits = sweep.limits;
  constexpr double sample_time = 0.1;
  const bool is_short = limits.time > 0.0 && limits.time <= sample_time;
  if (!is_short) limits.time = sample_time;
  std::size_t last = sweep.runs.size();
  static_cast<void>(base.result(sweep.runs.front(), limits, [] { return false; }));
  for (const std::size_t i : {std::size_t{0}, sweep.runs.size() / 2, sweep.runs.size() - 1}) {
    if (i == last) continue;
    last = i;
    Sample sample{i + 1, {}, 0.0};
    // Their mean: with a limit of the processor's time (ulimit -t) the kernel counts it in ticks.
    constexpr double repeated_time = 0.02;
    const double first = processor_time();
    double elapsed = 0.0;
    for (int runs = 1; elapsed < repeated_time; ++runs) {
      sample.result = base.result(sweep.runs[i], limits, [] { return false; });
      elapsed = processor_time() - first;
      sample.seconds = elapsed / runs;
    }
    const auto evaluations = static_cast<double>(sample.result.evaluations);
    const bool is_of_sweep = is_short || (limits.evaluations > 0 && sample.result.evaluations >= limits.evaluations);
    if (sample.result.end == SweepEnd::limited && sample.result.time > 0.0 && !is_of_sweep) {
      // The run ends at its end, or at a limit of the sweep.
      double whole = base.end(sweep.runs[i]) / sample.result.time;
      if (limits.evaluations > 0) whole = std::min(whole, static_cast<double>(limits.evaluations) / evaluations);
      if (sweep.limits.time > 0.0) whole = std::min(whole, sweep.limits.time / sample.seconds);
      sample.seconds *= whole;
      sample.result.evaluations = std::lround(evaluations * whole);
    }
    samples.push_back(std::move(sample));
  }
  return samples;
}

/// Why a sample is refused, after the field with its value: the reason names the line of the base.
std::string refusal(const Sample& sample, const SweepFolder& sweep, const SweepBase& base) {
  const std::string& reason = sample.result.reason;
  const SweptRun& run = sweep.runs[sample.number - 1];
  const std::optional<std::size_t> wrong = base.refused_parameter(run, reason);
  if (!wrong) return reason;
  const auto& [field, value] = run.parameters[*wrong];
  return fmt::format("{} = {}: {}", field, found(value), reason);
}

int plan(const SweepOptions& options) {
  const fs::path file{options.file};
  const SweepFile described = read_sweep(read_text(file), file);
  SweepFolder sweep;
  sweep.folder = options.folder.empty() ? file.stem() : fs::path{options.folder};
  sweep.title = described.title;
  sweep.outputs = described.outputs, sweep.limits = described.limits;
  sweep.base_text = base_text(described.base, described.base_location());
  const std::string base_name = is_deck(described.base) ? "base.toml" : described.base.string();
  SweepBase base{parse_toml(sweep.base_text, base_name), base_name};
  base.choose(sweep.outputs, described.outputs_location());
  SweptRuns made = swept_runs(described);
  sweep.runs = std::move(made.runs);
  base.check_axes(described, sweep.runs.front());
  const std::vector<Sample> samples = samples_of(sweep, base);
  if (std::ranges::all_of(samples, [](const Sample& of) { return of.result.end == SweepEnd::refused; })) {
    throw InputError{fmt::format("{}: run {} is refused, as are all that were tried: {}", file.string(),
                                 samples.front().number, refusal(samples.front(), sweep, base))};
  }
  write_sweep_folder(sweep);
  double seconds = 0.0, evaluations = 0.0, bytes = 0.0;
  const std::string key = sweep.key();
  for (const Sample& sample : samples) {
    seconds += sample.seconds, evaluations += static_cast<double>(sample.result.evaluations);
    bytes += static_cast<double>(result_line(sample.result, key).size()) +
             20.0 * static_cast<double>(sample.result.values.empty() ? sweep.outputs.size() : 0);
  }
  const double scale = static_cast<double>(sweep.runs.size()) / static_cast<double>(samples.size());
  const std::string folder = sweep.folder.string();
  if (options.json) {
    nlohmann::ordered_json json{{"folder", folder},
                                {"runs", sweep.runs.size()},
                                {"left_out", made.left_out},
                                {"evaluations", std::round(evaluations * scale)},
                                {"processor_time", seconds * scale},
                                {"bytes", std::round(bytes * scale)}};
    fmt::print("{}\n", json.dump(2));
  } else {
    fmt::print("{} runs", sweep.runs.size());
    if (made.left_out > 0) fmt::print(", without {} that do not satisfy the constraints", made.left_out);
    fmt::print("\nestimated from {} runs: {:.3g} force evaluations, {} of processor time, {:.3g} MB of results\n",
               samples.size(), evaluations * scale, time_text(seconds * scale), 1e-6 * bytes * scale);
    fmt::print("written: {}, base.toml, manifest.jsonl\nrun it by:\n  talus sweep run {}\n",
               shell_word((sweep.folder / "sweep.json").string()), shell_word(folder));
  }
  for (const Sample& sample : samples) {
    if (sample.result.end == SweepEnd::refused)
      print_failure(fmt::format("warning: run {} is refused: {}", sample.number, refusal(sample, sweep, base)));
  }
  return ok;
}

/// The number of runs that are done, shown while it grows.
class RunCounter {
 public:
  /// `before` of `all` runs were done before.
  RunCounter(std::size_t before, std::size_t all) : before_{before}, all_{all} {}

  void add() {
    ++done_;
    if (!line_.due()) return;
    const double elapsed = std::chrono::duration<double>(Clock::now() - start_).count();
    const double fraction = static_cast<double>(done_) / static_cast<double>(all_ - before_);
    line_.show(fmt::format("{} of {} runs, {}", before_ + done_, all_, time_left_text(elapsed, fraction)));
  }

 private:
  Progress line_;
  std::size_t before_, all_, done_{};
  Clock::time_point start_{Clock::now()};
};

/// Errors: IoError while a part of another division of the sweep runs, since both have some runs.
void demand_one_division(const fs::path& parts, const Shard& shard) {
  for (const fs::directory_entry& entry : fs::directory_iterator{parts}) {
    const std::string part = entry.path().filename().string();
    if (!entry.is_directory() || part.ends_with(fmt::format("-of-{}", shard.count))) continue;
    try {
      const FolderLock is_free{entry.path()};
    } catch (const FolderInUse&) {
      throw IoError{
          fmt::format("{}: part {} of another division runs, which has some of the same runs; it must end first",
                      parts.parent_path().string(), part)};
    }
  }
}

void print_duplicates(const KnownResults& known) {
  if (!known.duplicates.empty()) fmt::print("{} results of runs that have another one\n", known.duplicates.size());
}

int run(const SweepOptions& options) {
  const Shard shard = shard_of(options.shard);
  const SweepFolder part = read_sweep_folder(options.folder).part(shard.number, shard.count);
  // The same run twice at a time would have two results.
  const fs::path parts = part.folder / "parts",
                 lock_folder = parts / fmt::format("{}-of-{}", shard.number, shard.count);
  make_folder(lock_folder);
  const FolderLock lock{lock_folder};
  demand_one_division(parts, shard);
  const SweepBase base = part.base();
  std::vector<const SweptRun*> missing;
  {
    const KnownResults known = read_results(part);
    for (const SweptRun& run : part.runs)
      if (!known.by_id.contains(run.id)) missing.push_back(&run);
  }
  Interruption interruption;
  const auto interrupted = [&] { return interruption.signal() != 0; };
  {
    RunCounter counter{part.runs.size() - missing.size(), part.runs.size()};
    execute(part, base, missing, options.threads, interrupted, [&](SweepResult&&) { counter.add(); });
  }
  const KnownResults known = read_results(part);
  const SweepCounts counts = counts_of(part, known);
  const std::string of_all = shard.count > 1 ? fmt::format(", part {} of {}", shard.number, shard.count) : "";
  fmt::print("{}\n", counts.text(" done" + of_all));
  print_duplicates(known);
  if (interrupted()) {
    print_failure(fmt::format("{}: {} runs are missing; the same command continues with them", interruption.name(),
                              counts.missing()));
    return 128 + interruption.signal();
  }
  return exit_of_runs(counts.failed(), counts.done());
}

int status(const SweepOptions& options) {
  const SweepFolder sweep = read_sweep_folder(options.folder);
  const KnownResults known = read_results(sweep);
  const SweepCounts counts = counts_of(sweep, known);
  if (options.json) {
    nlohmann::ordered_json json = counts.json();
    json["duplicates"] = known.duplicates.size();
    json["of_others"] = known.of_others;
    fmt::print("{}\n", json.dump(2));
    return ok;
  }
  fmt::print("{}\n", counts.text(" done"));
  print_duplicates(known);
  if (known.of_others > 0) fmt::print("{} results of runs that are not in the plan\n", known.of_others);
  return ok;
}

int collect(const SweepOptions& options) {
  const SweepFolder sweep = read_sweep_folder(options.folder);
  const SweepBase base = sweep.base();
  const KnownResults known = read_results(sweep);
  const SweepCounts counts = counts_of(sweep, known);
  if (!options.partial && counts.missing() > 0) {
    throw InputError{
        fmt::format("{}: {} of {} runs have no result; run them by `talus sweep run {}`, or collect those "
                    "that are done with --partial",
                    options.folder, counts.missing(), counts.runs, shell_word(options.folder))};
  }
  if (!options.partial && !known.duplicates.empty()) {
    std::map<std::string, int> counts_by_file;
    for (const auto& [id, file] : known.duplicates)
      ++counts_by_file[file.string()];
    for (const auto& [file, count] : counts_by_file)
      print_failure(fmt::format("{}: {} results of runs that have another one", file, count));
    throw InputError{
        fmt::format("{}: run {} has several results, as have {} in all; remove these files and run the sweep again, or "
                    "give --partial to take the first one of each, in the order of the files' names",
                    options.folder, known.duplicates.front().first, known.duplicates.size())};
  }
  if (counts.done() == 0) throw InputError{fmt::format("{}: no run has a result", options.folder)};
  const fs::path csv = sweep.folder / "results.csv", json = sweep.folder / "results.json";
  write_whole(csv, sweep_csv(sweep, known, base));
  write_whole(json, sweep_json(sweep, known, base));
  fmt::print("{}\n{}\n{}\n", counts.text(""), csv.string(), json.string());
  return exit_of_runs(counts.failed(), counts.done());
}

/// Runs an engine with its progress, until it ends. A signal to this process ends it: GNU parallel ends its parts at
/// the second SIGTERM.
reports::Finished run_engine(const reports::Command& command, const SweepFolder& sweep,
                             const Interruption& interruption) {
  Progress line;
  int calls = 0;
  return reports::run(command, [&] {
    // All results are read for it, so that it is not renewed at each call.
    if (calls++ % 10 == 0 && line.due()) line.show(counts_of(sweep, read_results(sweep)).text(" done"));
    return interruption.signal() != 0 ? SIGTERM : 0;
  });
}

int submit(const SweepOptions& options) {
  const Engine engine = value_named<Engine>("--engine: engine", options.engine);
  const SweepFolder sweep = read_sweep_folder(options.folder);
  if (engine == Engine::local) {
    if (!options.hosts.empty() || options.waits || !options.engine_options.empty() || options.parts)
      throw InputError{"--hosts, --wait, --option and --parts: the engine 'local' does not use them; remove them"};
    return run(options);
  }
  EngineRequest request;
  request.folder = fs::absolute(sweep.folder).lexically_normal();
  if (request.folder.filename().empty()) request.folder = request.folder.parent_path();
  request.program = fs::read_symlink("/proc/self/exe");
  request.parts = std::min(options.parts.value_or(options.threads), sweep.runs.size());
  request.threads = options.threads;
  request.hosts = options.hosts, request.options = options.engine_options, request.waits = options.waits;
  const fs::path script = request.folder / "part.sh";
  const reports::Command command = engine_command(engine, request, script);
  try {
    reports::demand_program(command.program);
    write_whole(script, part_script(request));
    const Interruption interruption;
    reports::Finished ended = run_engine(command, sweep, interruption);
    ended.messages.resize(ended.messages.find_last_not_of('\n') + 1);
    fmt::print("{}", ended.output);
    if (interruption.signal() != 0) {
      print_failure(
          fmt::format("{}: {} was ended; {}", interruption.name(), command.program,
                      engine == Engine::slurm ? "its jobs continue, scancel ends them" : "the same command continues"));
      return 128 + interruption.signal();
    }
    // Of parallel, and of sbatch with --wait, the status counts parts whose runs failed.
    if (engine == Engine::slurm && !options.waits) {
      if (ended.status != 0) throw IoError{fmt::format("{}: {}", command.program, ended.messages)};
      return ok;
    }
    const SweepCounts counts = counts_of(sweep, read_results(sweep));
    if (counts.missing() > 0) {
      throw IoError{fmt::format("{}: {} of {} runs have no result; status {}: {}", command.program, counts.missing(),
                                counts.runs, ended.status, ended.messages)};
    }
    fmt::print("{}\n", counts.text(" done"));
    return exit_of_runs(counts.failed(), counts.done());
  } catch (const reports::OutputError& error) {
    throw IoError{error.what()};
  }
}

/// The index of the item with a name. Errors: InputError with the names that are known.
template <class Items, class Name>
std::size_t index_of(const Items& items, const std::string& name, const std::string& what, Name&& name_of) {
  const auto found = std::ranges::find(items, name, name_of);
  if (found != items.end()) return static_cast<std::size_t>(found - items.begin());
  std::vector<std::string> known;
  for (const auto& item : items)
    known.push_back(std::invoke(name_of, item));
  throw unknown_name(what, name, known);
}

/// A request of Dakota in the order of a function.
struct RequestedPoint {
  std::vector<double> point;        ///< one number for each input
  std::vector<std::size_t> wanted;  ///< output of each response
};

RequestedPoint requested_point(const DakotaRequest& request, const SweepFunction& function) {
  RequestedPoint requested;
  std::vector<std::optional<double>> numbers(function.inputs().size());
  for (const auto& [label, value] : request.variables)
    numbers[index_of(function.inputs(), label, "variable: field of an axis", &SweepInput::field)] = value;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (!numbers[i]) throw InputError{fmt::format("variable '{}': it is missing", function.inputs()[i].field)};
    requested.point.push_back(*numbers[i]);
  }
  for (const auto& [label, is_requested] : request.responses)
    requested.wanted.push_back(index_of(function.outputs(), label, "response: output", &SweepOutput::name));
  return requested;
}

int evaluate(const SweepOptions& options) {
  const SweepFunction function{options.file};
  const std::vector<DakotaRequest> requests = read_dakota(read_text(options.parameters), options.parameters);
  std::vector<RequestedPoint> points;
  of_file(options.parameters, [&] {
    for (const DakotaRequest& request : requests)
      points.push_back(requested_point(request, function));
  });
  Interruption interruption;
  const auto interrupted = [&] { return interruption.signal() != 0; };
  std::vector<SweepResult> results(points.size());
  {
    RunCounter counter{0, points.size()};
    for_each_executed(
        points.size(), options.threads, interrupted,
        [&](std::size_t i) { return function(points[i].point, interrupted); },
        [&](std::size_t i, SweepResult&& result) {
          results[i] = std::move(result);
          counter.add();
        });
  }
  if (std::ranges::any_of(results, [](const SweepResult& of) { return of.id.empty(); })) {
    print_failure(fmt::format("{}: no results were written", interruption.name()));
    return 128 + interruption.signal();
  }
  std::string text;
  for (std::size_t i = 0; i < results.size(); ++i) {
    // Dakota learns of a failure from the file, and decides by it.
    const std::string failure = failure_of(results[i]);
    std::vector<double> values;
    if (failure.empty())
      for (const std::size_t output : points[i].wanted)
        values.push_back(results[i].values[output]);
    else
      print_failure(results.size() == 1 ? failure : fmt::format("run {}: {}", i + 1, failure));
    if (i > 0) text += "#\n";  // between the results of a batch
    text += dakota_results(requests[i], values, failure);
  }
  write_whole(options.results, text);
  return ok;
}

void add_folder(CLI::App& app, SweepOptions& options) {
  app.add_option("FOLDER", options.folder, "folder of the sweep, written by `talus sweep plan`")->required();
}

}  // namespace

Command add_sweep(CLI::App& talus) {
  CLI::App* const app = talus.add_subcommand("sweep", "Run a scene many times with changed fields and collect numbers");
  const auto options = std::make_shared<SweepOptions>();
  app->require_subcommand(1);
  // Before its commands are added, which take it over.
  app->footer(
      "Examples:\n"
      "  talus sweep plan cases/sweeps/rock.toml --out rock\n"
      "  talus sweep run rock\n"
      "  talus sweep run rock --shard 1/4             a quarter of the runs, e.g. on one of four machines\n"
      "  talus sweep submit rock --engine slurm --parts 100 --option=--time=1:00:00\n"
      "  talus sweep collect rock                     rock/results.csv, rock/results.json\n"
      "  talus sweep evaluate cases/sweeps/rock.toml params.in results.out    for Dakota\n"
      "A run that diverges, is refused or reaches a limit is a row with its reason. `run` can be stopped at any time "
      "and\n"
      "started again. Exit statuses: 6 some runs failed, 3 all did.");
  CLI::App* const plan_app = app->add_subcommand("plan", "List the runs of a sweep and estimate their cost");
  plan_app->add_option("SWEEP", options->file, "the sweep (.toml): base, axes, outputs")->required();
  plan_app->add_option("--out", options->folder,
                       "folder of the sweep; default: the name of SWEEP without .toml, in the present folder");
  plan_app->add_flag("--json", options->json, "print JSON");
  CLI::App* const run_app = app->add_subcommand("run", "Execute the runs that have no result yet");
  add_folder(*run_app, *options);
  run_app->add_option("--shard", options->shard, "I/N: only part I of N equal parts, e.g. on one of N machines");
  run_app->add_option("--threads", options->threads, "default: all; results do not depend on it")
      ->check(whole_between(1, 1024));
  CLI::App* const status_app = app->add_subcommand("status", "Count the runs that are done, failed and missing");
  add_folder(*status_app, *options);
  status_app->add_flag("--json", options->json, "print JSON");
  CLI::App* const submit_app =
      app->add_subcommand("submit", "Start the parts of a sweep by Slurm, by GNU parallel or in this process");
  add_folder(*submit_app, *options);
  offer(submit_app->add_option("--engine", options->engine,
                               "local (default), parallel (GNU parallel, also on ssh hosts) or slurm (a job array)"),
        names_of<Engine>());
  submit_app
      ->add_option("--parts", options->parts,
                   "number of processes with one thread each; default: one for each thread of this machine")
      ->check(whole_between(1, 100000));
  submit_app->add_option("--hosts", options->hosts, "of parallel: file with a host for ssh on each line");
  submit_app
      ->add_option("--option", options->engine_options,
                   "for sbatch or parallel as it is, e.g. --option=--partition=long; repeat it for several")
      ->allow_extra_args(false);
  submit_app->add_flag("--wait", options->waits, "of slurm: wait until all parts have ended");
  CLI::App* const collect_app =
      app->add_subcommand("collect", "Write results.csv and results.json, in the order of the plan");
  add_folder(*collect_app, *options);
  collect_app->add_flag("--partial", options->partial, "accept missing runs, and runs with several results");
  CLI::App* const evaluate_app =
      app->add_subcommand("evaluate", "Execute the run, or the batch of runs, of a parameters file of Dakota");
  evaluate_app->add_option("SWEEP", options->file, "the sweep (.toml); fields of its axes are labels of variables")
      ->required();
  evaluate_app->add_option("PARAMETERS", options->parameters, "file that Dakota wrote, in its standard format")
      ->required();
  evaluate_app->add_option("RESULTS", options->results, "file for the outputs, or FAIL and a reason")->required();
  evaluate_app->add_option("--threads", options->threads, "of a batch; default: all; results do not depend on it")
      ->check(whole_between(1, 1024));
  return {app, [=] {
            if (plan_app->parsed()) return plan(*options);
            if (evaluate_app->parsed()) return evaluate(*options);
            if (run_app->parsed()) return run(*options);
            if (submit_app->parsed()) return submit(*options);
            return status_app->parsed() ? status(*options) : collect(*options);
          }};
}

}  // namespace talus::app
