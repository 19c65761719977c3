#include "verification/driver/command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cfenv>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "solver/base/error.hpp"
#include "solver/command_line/usage_error.hpp"
#include "verification/catalogue/catalogue.hpp"
#include "verification/check/case_file.hpp"
#include "verification/data/measured_case.hpp"
#include "verification/driver/baseline_gate.hpp"
#include "verification/driver/case_error.hpp"
#include "verification/driver/case_run.hpp"
#include "verification/driver/earlier_record.hpp"
#include "verification/driver/exit_code.hpp"
#include "verification/driver/junit.hpp"
#include "verification/driver/provenance.hpp"
#include "verification/driver/results.hpp"
#include "verification/driver/runner.hpp"
#include "verification/driver/terminal.hpp"
#include "verification/record/utf8.hpp"
#include "verification/record/whole_file.hpp"

namespace talus::verification {

namespace {

namespace fs = std::filesystem;

struct Options {
  std::string out = "build/verify";
  std::vector<std::string> only;
  std::vector<std::string> data;
  unsigned jobs = 0;
  bool list = false;
  bool quick = false;
  bool full = false;
  bool reuse = false;
  std::string rounding = "nearest";
  std::string inputs;  ///< in place of the project's folder `cases`; empty: that one
  BaselineOptions baseline;
};

const std::map<std::string, int> rounding_modes{
    {"nearest", FE_TONEAREST}, {"upward", FE_UPWARD}, {"downward", FE_DOWNWARD}, {"toward_zero", FE_TOWARDZERO}};

void declare_baseline(CLI::App& app, BaselineOptions& options) {
  constexpr const char* group = "Comparison with a baseline";
  auto* const baseline =
      app.add_option("--baseline", options.baseline,
                     "Compare with this earlier results.json of the same tier: baseline.json and baseline.md (a job "
                     "summary) in --out")
          ->group(group);
  app.add_option("--compare", options.compare, "Run nothing: compare this results.json with --baseline")
      ->needs(baseline)
      ->excludes("--quick", "--full", "--jobs", "--list", "--rounding", "--inputs")
      ->group(group);
  app.add_option("--tolerance", options.tolerances,
                 "Measured values may change by X times the error bound of their check (an exact check: times its "
                 "reference): X for all, NAME=X for a family, its letter, or a case; the last that applies is taken. "
                 "Default 0: the same values")
      ->allow_extra_args(false)
      ->type_name("[NAME=]X")
      ->needs(baseline)
      ->group(group);
  app.add_option("--margin", options.margin, "error/bound may grow by X (default: the tolerance of the check)")
      ->type_name("X")
      ->needs(baseline)
      ->group(group);
  app.add_flag("--allow-round-off", options.allow_round_off,
               "Measured values may change within round-off: by 1e-9 of the bound, by the bound in checks of kind "
               "round_off")
      ->needs(baseline)
      ->group(group);
  app.add_option("--evaluation-growth", options.evaluation_growth,
                 "The force evaluations of a case may grow by this fraction")
      ->type_name("X")
      ->capture_default_str()
      ->needs(baseline)
      ->group(group);
  app.add_option("--renamed", options.renamed,
                 "File of what was renamed or removed (-) since the baseline, one in a line: 'old_case -> new_case', "
                 "'old_case/old check -> new_case/new check', 'old_case/control: old -> new_case/control: new'")
      ->needs(baseline)
      ->group(group);
}

void declare(CLI::App& app, Options& options) {
  app.add_option("--out", options.out, "Folder for records, results.json and junit.xml")->capture_default_str();
  app.add_option("--only", options.only, "Run or compare only these cases: ID[,ID...]")->delimiter(',');
  app.add_option("--data", options.data,
                 "Folder of measurements: each file NAME.measured.toml in it becomes case NAME, beside the others")
      ->allow_extra_args(false)
      ->type_name("FOLDER");
  app.add_option("--jobs", options.jobs, "Cases at once (default: the processors of this machine)")
      ->check(CLI::Range(1u, 1024u));
  app.add_flag("--list", options.list, "List the cases and end");
  auto* const quick = app.add_flag("--quick", options.quick, "The quick tier (default)");
  app.add_flag("--full", options.full, "The long studies as well")->excludes(quick);
  auto* const reuse = app.add_flag("--reuse", options.reuse,
                                   "Do not run again what this program, unchanged, has found in --out: cases that "
                                   "passed, and of those that run more "
                                   "in the full tier the controls");
  app.add_option("--rounding", options.rounding,
                 "Rounding of floating-point numbers while cases run: nearest, upward, downward or toward_zero. Other "
                 "than nearest it shows which bounds rest on rounding; checks of the same bits may then fail")
      ->check(CLI::IsMember(rounding_modes))
      ->excludes(reuse)
      ->capture_default_str();
  app.add_option("--inputs", options.inputs,
                 "Read decks, published numbers and recorded fingerprints from this folder, a changed copy of the "
                 "project's cases/: whether cases notice the change (scripts/inputs)")
      ->check(CLI::ExistingDirectory)
      ->excludes(reuse)
      ->type_name("FOLDER");
  declare_baseline(app, options.baseline);
  app.footer(
      "Exit status: 0 every check holds and every control turned red, 1 not so, 2 wrong command line, catalogue, "
      "baseline "
      "or renames, 4 a file cannot be read or written, 6 something other than time is worse than the baseline (1 if a "
      "check fails as well).");
}

std::vector<std::string> ids_of(const std::vector<Case>& cases) {
  std::vector<std::string> ids;
  for (const auto& c : cases)
    ids.push_back(c.id);
  return ids;
}

/// The cases to run, in the order of the list. Errors: InputError for an unknown id, std::invalid_argument for one that
/// needs the full tier.
std::vector<Case> chosen(const std::vector<Case>& cases, const std::vector<std::string>& only, Tier tier) {
  std::vector<Case> selection;
  for (const auto& c : cases) {
    const bool named = std::find(only.begin(), only.end(), c.id) != only.end();
    const bool in_tier = tier == Tier::full || c.tier == Tier::quick;
    if (named && !in_tier) throw std::invalid_argument("--only: case '" + c.id + "' needs --full");
    if (in_tier && (only.empty() || named)) selection.push_back(c);
  }
  for (const auto& id : only) {
    if (std::none_of(cases.begin(), cases.end(), [&](const Case& c) { return c.id == id; }))
      throw unknown_name("--only: case", id, ids_of(cases));
  }
  return selection;
}

void print_list(const std::vector<Case>& cases) {
  for (const auto& c : cases) {
    fmt::print("{:<20} {:<6} {:>2} controls  {}\n", c.id, name_of(c.tier), c.faults.size(), c.title);
  }
}

/// Runs the valid cases. Invalid ones are not run: they fail with the error as their message.
std::vector<Record> records_of(const std::vector<Case>& selection, const std::vector<Case>& all,
                               const Catalogue& catalogue, const RunPlan& plan, Terminal& terminal) {
  std::vector<Record> records(selection.size());
  std::vector<Case> sound;
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < selection.size(); ++i) {
    const std::string flaw = case_error(selection[i], all, catalogue);
    if (flaw.empty()) {
      sound.push_back(selection[i]);
      indices.push_back(i);
    } else {
      records[i] = unfinished(selection[i], Status::error, "the case is not well formed: " + flaw);
      terminal.report(records[i], {});
    }
  }
  auto finished = run_all(sound, plan, [&](const Record& ended, const std::vector<std::string>& running, bool reused) {
    terminal.report(ended, running, reused);
  });
  for (std::size_t i = 0; i < finished.size(); ++i)
    records[indices[i]] = std::move(finished[i]);
  return records;
}

/// Memory that is released when memory runs out, so that the results so far can still be written. It is never touched
/// and costs address space only.
constexpr std::size_t reserve_size = std::size_t{16} << 20U;

void write_results(Results& results, const Catalogue& catalogue, const fs::path& out) {
  complete(results, catalogue);
  records::write_whole(out / "results.json", text_of(results));
  records::write_whole(out / "junit.xml", junit_of(results.records));
}

/// Reduces a record to its head, checks and controls when there is not enough memory for all of it.
void shorten(Record& record) {
  record.figures = {};
  record.tables = {};
  record.data = {};
  record.notes = {};
  if (record.status == Status::pass || record.status == Status::fail) {
    record.status = Status::error;
    record.message = "the driver ran out of memory: figures, tables and notes of this case are not in the results";
  }
}

/// Writes both files; if memory runs out, without the largest parts of the records.
void write_results_within_memory(Results& results, const Catalogue& catalogue, const fs::path& out,
                                 std::unique_ptr<char[]> reserve) {
  try {
    write_results(results, catalogue, out);
    return;
  } catch (const std::bad_alloc&) {
    reserve.reset();
  }
  std::fputs("talus_verify: out of memory; the results are written without figures, tables and notes\n", stderr);
  for (Record& record : results.records)
    shorten(record);
  write_results(results, catalogue, out);
}

/// The exit status of results that are compared with a baseline. The status of the results themselves has priority.
int exit_status(bool holds, GateVerdict verdict) {
  if (!holds) return exit_fail;
  if (verdict == GateVerdict::wrong_renames) return exit_usage;
  return verdict == GateVerdict::worse ? exit_worse : exit_pass;
}

/// Compares the results just written. If memory runs out, the results are kept.
int compared(const BaselineGate& gate, const ResultsFile& after, const fs::path& out) {
  const bool holds = records::holds(after.results);
  try {
    return exit_status(holds, finish(gate, after, out));
  } catch (const std::bad_alloc&) {
    std::fputs("talus_verify: out of memory; the results were not compared with the baseline\n", stderr);
    return holds ? exit_io : exit_fail;
  }
}

int run(const std::vector<Case>& cases, const Catalogue& catalogue, const Options& options,
        const std::vector<fs::path>& read) {
  const Tier tier = options.full ? Tier::full : Tier::quick;
  const auto selection = chosen(cases, options.only, tier);
  Results results;
  results.provenance = provenance();
  if (options.rounding != "nearest") results.provenance.flags += " --rounding " + options.rounding;
  if (!options.inputs.empty()) results.provenance.flags += " --inputs " + options.inputs;
  results.tier = tier;
  results.registered = ids_of(cases);
  results.selected = ids_of(selection);
  results.only = options.only;
  const fs::path out = options.out;
  // Must precede any removal: the baseline may be the results.json of the previous run in this folder.
  std::optional<BaselineGate> gate;
  if (!options.baseline.baseline.empty()) {
    gate = read_gate(options.baseline, options.only, out);
    validate(gate->before, tier, gate->allowance, gate->renames, catalogue.families, results.registered);
  }
  fs::create_directories(out);
  fs::remove(out / "results.json");
  fs::remove(out / "junit.xml");
  remove_comparison(out);
  Terminal terminal(selection.size(), options.rounding);
  const unsigned jobs = options.jobs == 0 ? std::max(1u, results.provenance.cores) : options.jobs;
  auto reserve = std::make_unique_for_overwrite<char[]>(reserve_size);
  const RunPlan plan{
      .out = out,
      .jobs = jobs,
      .tier = tier,
      .rounding = rounding_modes.at(options.rounding),
      .program = options.rounding == "nearest" && options.inputs.empty() ? program_fingerprint(read) : "",
      .reuse = options.reuse};
  results.records = records_of(selection, cases, catalogue, plan, terminal);
  write_results_within_memory(results, catalogue, out, std::move(reserve));
  terminal.summarise(results, (out / "results.json").string());
  if (gate) return compared(*gate, {out / "results.json", std::move(results)}, out);
  return holds(results) ? exit_pass : exit_fail;
}

/// Compares two files without running any case.
int compare_files(const Catalogue& catalogue, const Options& options) {
  const fs::path out = options.out;
  const BaselineGate gate = read_gate(options.baseline, options.only, out);
  const ResultsFile after = read_results_file(options.baseline.compare);
  const std::vector<std::string>& known = after.results.registered;
  validate(gate.before, after.results.tier, gate.allowance, gate.renames, catalogue.families, known);
  for (const auto& id : options.only) {
    if (find_case(after.results, id) == nullptr && find_case(gate.before.results, id) == nullptr)
      throw unknown_name("--only: case", id, known);
  }
  fs::create_directories(out);
  remove_comparison(out);
  return exit_status(holds(after.results), finish(gate, after, out));
}

void print_error(const std::exception& error) {
  fmt::print(stderr, "talus_verify: {}\n", records::shown_lines(error.what()));
}

}  // namespace

int verify(std::vector<Case> cases, const fs::path& catalogue_folder, int argc, const char* const* argv,
           std::vector<fs::path> read) {
  CLI::App app{"talus_verify: run the verification cases and record what they find", "talus_verify"};
  Options options;
  declare(app, options);
  refuse_empty_values(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& fault) {
    return exit_of_parse(app, fault);
  }
  try {
    for (const std::string& folder : options.data) {
      const std::vector<Case> measured = measured_cases(folder);
      cases.insert(cases.end(), measured.begin(), measured.end());
      read.emplace_back(folder);
    }
    if (options.list) {
      print_list(cases);
      return exit_pass;
    }
    if (!options.inputs.empty()) replace_case_folder(fs::absolute(options.inputs));
    const Catalogue catalogue = read_catalogue(catalogue_folder);
    read.push_back(catalogue_folder);
    return options.baseline.compare.empty() ? run(cases, catalogue, options, read) : compare_files(catalogue, options);
  } catch (const std::invalid_argument& fault) {
    print_error(fault);
    return exit_usage;
  } catch (const InputError& fault) {
    print_error(fault);
    return exit_usage;
  } catch (const std::bad_alloc&) {
    std::fputs("talus_verify: out of memory; no results were written\n", stderr);
    return exit_io;
  } catch (const std::exception& fault) {
    print_error(fault);
    return exit_io;
  }
}

}  // namespace talus::verification
