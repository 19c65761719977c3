/// talus_mutate_inputs: lets the readers of Talus read mutated files. Findings are crashes, hangs, excessive memory and
/// errors that do not say where.

#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iterator>
#include <map>
#include <stdexcept>
#include <system_error>
#include <thread>

#include "tests/fuzz/input_campaign.hpp"
#include "tests/temporary_folder.hpp"
#include "verification/record/audits.hpp"

/// Options of the address sanitizer: a request for more memory throws std::bad_alloc, as without it.
extern "C" const char* __asan_default_options() {
  return "allocator_may_return_null=1:max_allocation_size_mb=2048:detect_leaks=0";
}

namespace {

namespace fs = std::filesystem;
using namespace talus::fuzz;

struct Options {
  CampaignPlan plan;
  std::vector<std::string> readers;
  std::string json, corpus, replay;
  std::size_t jobs{std::max(1U, std::thread::hardware_concurrency())};
  bool list{};
};

/// The chosen readers, or all.
std::vector<Reader> chosen(std::vector<Reader> readers, const std::vector<std::string>& names) {
  const auto named = [&](const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  for (const std::string& name : names)
    if (std::none_of(readers.begin(), readers.end(), [&](const Reader& reader) { return reader.name == name; }))
      throw CLI::ValidationError{"--readers", fmt::format("reader '{}' is not known; --list names all", name)};
  if (!names.empty()) std::erase_if(readers, [&](const Reader& reader) { return !named(reader.name); });
  return readers;
}

void write_corpus(const std::vector<Reader>& readers, const fs::path& folder) {
  for (const Reader& reader : readers) {
    fs::create_directories(folder / reader.name);
    for (std::size_t i = 0; i < reader.corpus.size(); ++i)
      std::ofstream{folder / reader.name / std::to_string(i), std::ios::binary} << reader.corpus[i];
  }
}

/// Lets one reader read one file in this process.
int replay(const Reader& reader, const fs::path& file, const fs::path& scratch) {
  std::ifstream in{file, std::ios::binary};
  const std::string text{std::istreambuf_iterator<char>{in}, {}};
  const Reading reading = read(reader, put(reader, text, scratch));
  constexpr const char* endings[] = {"accepted", "refused", "cut short"};
  fmt::print("{}: {}\n{}{}\n", reader.name, endings[static_cast<int>(reading.ending)], reading.message,
             reading.flaw.empty() ? "" : "\nfinding: " + reading.flaw);
  return reading.flaw.empty() ? 0 : 1;
}

talus::records::FuzzAudit audit_of(const std::vector<Tally>& tallies, std::uint64_t seed) {
  talus::records::FuzzAudit audit{seed, {}};
  const auto count = [](long number) { return static_cast<std::size_t>(number); };
  for (const Tally& tally : tallies)
    audit.readers.push_back({tally.reader, count(tally.inputs), count(tally.accepted), count(tally.refused),
                             count(tally.cut_short), tally.seconds, tally.findings.size()});
  return audit;
}

std::string text_of(const Tally& tally, const CampaignPlan& plan) {
  std::string text = fmt::format("{:<18}{:>10}{:>10}{:>10}{:>11}{:>10.1f}{:>10}\n", tally.reader, tally.inputs,
                                 tally.accepted, tally.refused, tally.cut_short, tally.seconds, tally.findings.size());
  for (const Finding& finding : tally.findings)
    if (!finding.file.empty() || plan.findings.empty())
      text += fmt::format("  {}: {} {}\n", finding.input, finding.what, finding.file.string());
  for (const auto& [pattern, count] : tally.messages)
    text += fmt::format("  {:>7} {}\n", count, pattern);
  return text;
}

/// A process that gives one reader its inputs and writes the result into the folder of the reader. A thread would fork
/// the processes of the inputs while others hold locks.
pid_t started(const Reader& reader, const CampaignPlan& plan, const fs::path& folder) {
  fs::create_directories(folder);
  std::fflush(nullptr);
  const pid_t process = ::fork();
  if (process < 0) throw std::system_error{errno, std::generic_category(), "fork"};
  if (process > 0) return process;
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // if another reader's process fails
  int status = 4;
  try {
    const Tally tally = run_inputs(reader, plan, folder);
    std::ofstream{folder / "text"} << text_of(tally, plan);
    talus::records::write_fuzz(audit_of({tally}, plan.seed), folder / "fuzz.json");
    status = 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "talus_mutate_inputs: {}: {}\n", reader.name, error.what());
  }
  std::fflush(nullptr);
  std::_Exit(status);
}

/// Runs the readers side by side, and prints their results in their order as soon as they are there.
int run(const std::vector<Reader>& readers, const Options& options, const fs::path& scratch) {
  fmt::print("{:<18}{:>10}{:>10}{:>10}{:>11}{:>10}{:>10}\n", "reader", "inputs", "accepted", "refused", "cut short",
             "seconds", "findings");
  const auto folder_of = [&](std::size_t reader) { return scratch / ("of_" + readers[reader].name); };
  std::map<pid_t, std::size_t> running;
  std::vector<bool> ended(readers.size());
  talus::records::FuzzAudit audit{options.plan.seed, {}};
  std::size_t next = 0, printed = 0, findings = 0;
  while (printed < readers.size()) {
    while (next < readers.size() && running.size() < options.jobs) {
      running.emplace(started(readers[next], options.plan, folder_of(next)), next);
      ++next;
    }
    int status = 0;
    const pid_t process = ::waitpid(-1, &status, 0);
    if (process < 0 && errno == EINTR) continue;
    if (process < 0) throw std::system_error{errno, std::generic_category(), "waitpid"};
    const std::size_t reader = running.at(process);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
      throw std::runtime_error(fmt::format("the process of reader '{}' failed", readers[reader].name));
    running.erase(process);
    ended[reader] = true;
    for (; printed < readers.size() && ended[printed]; ++printed) {
      std::ifstream in{folder_of(printed) / "text"};
      fmt::print("{}", std::string{std::istreambuf_iterator<char>{in}, {}});
      audit.readers.push_back(talus::records::read_audits(folder_of(printed), {}).fuzz->readers.at(0));
      findings += audit.readers.back().findings;
      std::fflush(stdout);
      if (!options.json.empty()) talus::records::write_fuzz(audit, options.json);
    }
  }
  return findings == 0 ? 0 : 1;
}

void describe(CLI::App& app, Options& options) {
  app.description(
      "Lets the readers of Talus read mutated files, in child processes.\n"
      "Exit statuses: 0 no finding, 1 findings, 2 wrong usage, 4 a file or process failed.");
  app.add_option("--inputs", options.plan.inputs,
                 "inputs of a reader; a quarter of them for one that runs models or reads several files")
      ->check(CLI::Range(1L, 1'000'000'000L));
  app.add_option("--seed", options.plan.seed, "the same inputs for the same seed");
  app.add_option("--readers", options.readers, "names of the readers; default: all")->delimiter(',');
  app.add_option("--seconds", options.plan.cpu_seconds, "processor time that an input may take [s]")
      ->check(CLI::Range(1L, 3600L));
  app.add_option("--findings", options.plan.findings, "folder in which inputs that are findings are kept");
  app.add_option("--json", options.json, "file for the table's numbers");
  app.add_option("--jobs", options.jobs, "readers at a time; default the number of processors")
      ->check(CLI::Range(1, 1024));
  app.add_flag("--messages", options.plan.messages,
               "list the distinct errors of each reader, without numbers and names");
  app.add_option("--corpus", options.corpus, "write the sound files into this folder, one folder a reader, and end");
  app.add_option("--replay", options.replay,
                 "let the one reader of --readers read this file, in this process, and end");
  app.add_flag("--list", options.list, "list the readers and end");
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app;
  Options options;
  describe(app, options);
  try {
    app.parse(argc, argv);
    const Folder scratch;
    const std::vector<Reader> readers = chosen(all_readers(scratch.path), options.readers);
    if (options.list) {
      for (const Reader& reader : readers)
        fmt::print("{}\n", reader.name);
      return 0;
    }
    if (!options.corpus.empty()) return write_corpus(readers, options.corpus), 0;
    if (!options.replay.empty()) {
      if (readers.size() != 1) throw CLI::ValidationError{"--replay", "it requires one name in --readers"};
      return replay(readers.front(), options.replay, scratch.path);
    }
    return run(readers, options, scratch.path);
  } catch (const CLI::ParseError& wrong) {
    return app.exit(wrong) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "talus_mutate_inputs: {}\n", error.what());
    return 4;
  }
}
