#include "verification/driver/command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>

#include "verification/driver/case_run.hpp"
#include "verification/driver/catalogue.hpp"
#include "verification/driver/junit.hpp"
#include "verification/driver/provenance.hpp"
#include "verification/driver/results.hpp"
#include "verification/driver/runner.hpp"
#include "verification/driver/terminal.hpp"
#include "verification/record/whole_file.hpp"

namespace talus::verification {

namespace {

namespace fs = std::filesystem;

constexpr int exit_pass = 0;
constexpr int exit_fail = 1;
constexpr int exit_usage = 2;
constexpr int exit_io = 4;

struct Options {
  std::string out = "build/verify";
  std::vector<std::string> only;
  unsigned jobs = 0;
  bool list = false;
  bool quick = false;
  bool full = false;
};

void declare(CLI::App& app, Options& options) {
  app.add_option("--out", options.out, "Folder for records, results.json and junit.xml")->capture_default_str();
  app.add_option("--only", options.only, "Run only these cases: ID[,ID...]")->delimiter(',');
  app.add_option("--jobs", options.jobs, "Cases at once (default: the processors of this machine)")
      ->check(CLI::Range(1u, 1024u));
  app.add_flag("--list", options.list, "List the cases and end");
  auto* const quick = app.add_flag("--quick", options.quick, "The quick tier (default)");
  app.add_flag("--full", options.full, "The long studies as well")->excludes(quick);
  app.footer(
      "Exit status: 0 every check holds and every control turned red, 1 not so, 2 wrong command line, 4 cannot write.");
}

/// Number of single-letter changes between two words (Levenshtein), by rows.
std::size_t distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j)
    row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t above = row[j];
      row[j] = std::min({above + 1, row[j - 1] + 1, diagonal + (a[i - 1] == b[j - 1] ? 0 : 1)});
      diagonal = above;
    }
  }
  return row.back();
}

std::invalid_argument unknown_id(const std::string& id, const std::vector<Case>& cases) {
  std::string known;
  std::string nearest;
  for (const auto& c : cases) {
    known += (known.empty() ? "" : ", ") + c.id;
    if (nearest.empty() || distance(id, c.id) < distance(id, nearest)) nearest = c.id;
  }
  return std::invalid_argument(fmt::format("--only: case '{}' is not known; nearest: {}; known: {}", id,
                                           nearest.empty() ? "none" : nearest, known.empty() ? "none" : known));
}

/// The cases to run, in the order of the catalogue; std::invalid_argument for an unknown id or one of the other tier.
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
      throw unknown_id(id, cases);
  }
  return selection;
}

void print_list(const std::vector<Case>& cases) {
  for (const auto& c : cases) {
    fmt::print("{:<20} {:<6} {:>2} controls  {}\n", c.id, name_of(c.tier), c.faults.size(), c.title);
  }
}

/// Cases with a flaw are not run: they fail with the flaw as their message. The others run.
std::vector<Record> records_of(const std::vector<Case>& selection, const std::vector<Case>& all, const RunPlan& plan,
                               Terminal& terminal) {
  std::vector<Record> records(selection.size());
  std::vector<Case> sound;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < selection.size(); ++i) {
    const std::string flaw = flaw_of(selection[i], all);
    if (flaw.empty()) {
      sound.push_back(selection[i]);
      places.push_back(i);
    } else {
      records[i] = unfinished(selection[i], Status::error, "the case is not well formed: " + flaw);
      terminal.report(records[i], {});
    }
  }
  auto finished = run_all(sound, plan, [&](const Record& ended, const std::vector<std::string>& running) {
    terminal.report(ended, running);
  });
  for (std::size_t i = 0; i < finished.size(); ++i)
    records[places[i]] = std::move(finished[i]);
  return records;
}

/// Memory that is given back when there is no more, so that what was found can still be written. Never touched, it
/// costs address space only.
constexpr std::size_t reserve_size = std::size_t{16} << 20U;

void write_results(Results& results, const fs::path& out) {
  complete(results);
  records::write_whole(out / "results.json", text_of(results));
  records::write_whole(out / "junit.xml", junit_of(results.records));
}

/// What remains of a record when there is no memory for all of it: head, checks and controls.
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

/// Writes both files, without the largest parts of the records if memory runs out.
void write_results_within_memory(Results& results, const fs::path& out, std::unique_ptr<char[]> reserve) {
  try {
    write_results(results, out);
    return;
  } catch (const std::bad_alloc&) {
    reserve.reset();
  }
  std::fputs("talus_verify: out of memory; the results are written without figures, tables and notes\n", stderr);
  for (Record& record : results.records)
    shorten(record);
  write_results(results, out);
}

int run(const std::vector<Case>& cases, const Options& options) {
  const Tier tier = options.full ? Tier::full : Tier::quick;
  const auto selection = chosen(cases, options.only, tier);
  Results results;
  results.provenance = provenance();
  results.tier = tier;
  for (const auto& c : cases)
    results.registered.push_back(c.id);
  for (const auto& c : selection)
    results.selected.push_back(c.id);
  const fs::path out = options.out;
  fs::create_directories(out);
  fs::remove(out / "results.json");
  fs::remove(out / "junit.xml");
  Terminal terminal(selection.size());
  const unsigned jobs = options.jobs == 0 ? std::max(1u, results.provenance.cores) : options.jobs;
  auto reserve = std::make_unique_for_overwrite<char[]>(reserve_size);
  results.records = records_of(selection, cases, {out, jobs, tier}, terminal);
  write_results_within_memory(results, out, std::move(reserve));
  terminal.summarise(results, (out / "results.json").string());
  return holds(results) ? exit_pass : exit_fail;
}

}  // namespace

int verify(const std::vector<Case>& cases, int argc, const char* const* argv) {
  CLI::App app{"talus_verify: run the verification cases and record what they find"};
  Options options;
  declare(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& fault) {
    return app.exit(fault) == 0 ? exit_pass : exit_usage;
  }
  try {
    if (options.list) {
      print_list(cases);
      return exit_pass;
    }
    return run(cases, options);
  } catch (const std::invalid_argument& fault) {
    fmt::print(stderr, "talus_verify: {}\n", fault.what());
    return exit_usage;
  } catch (const std::bad_alloc&) {
    std::fputs("talus_verify: out of memory; no results were written\n", stderr);
    return exit_io;
  } catch (const std::exception& fault) {
    fmt::print(stderr, "talus_verify: {}\n", fault.what());
    return exit_io;
  }
}

}  // namespace talus::verification
