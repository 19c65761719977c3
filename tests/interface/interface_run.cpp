/// talus_interface_run: changes each item of the program's interface that a case uses (options, fields of scenes,
/// columns and members of its files), one at a time, and runs the cases that use it.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "reports/base/process.hpp"
#include "solver/base/progress.hpp"
#include "solver/io/output/checkpoint.hpp"
#include "solver/threads/parallel_for.hpp"
#include "tests/interface/known_gaps.hpp"
#include "tests/interface/tried_items.hpp"
#include "verification/check/case_file.hpp"
#include "verification/check/findings.hpp"
#include "verification/driver/case_list.hpp"
#include "verification/driver/earlier_record.hpp"
#include "verification/record/interface.hpp"
#include "verification/record/whole_file.hpp"

namespace talus::interface_audit {
namespace {

namespace fs = std::filesystem;
using records::InterfaceStatus;
using verification::Case;

struct Options {
  fs::path out = "build/interface/interface.json";
  unsigned jobs = std::max(1U, std::thread::hardware_concurrency());
  std::filesystem::path known;
  std::vector<std::string> cases{TALUS_PROGRAM_CASES}, only;
};

/// Result of a case with an item changed.
struct Trial {
  enum class End { green, red, error } end{};
  std::string check;           ///< the first failed check, or the error
  std::string why;             ///< justification of this check
  std::set<std::string> seen;  ///< items of the program's calls
  int refusals{};              ///< calls that ended with exit status 2
  bool reached{};              ///< something was changed
  double seconds{};
};

/// The right setup of the case up to its first failed check, in this process: its result as a text, "green", "error
/// WHAT" or "red CHECK" with the justification of the check, which names what differs, on the next line.
std::string result_of(const Case& one) {
  auto findings = verification::Findings::until_one_fails();
  try {
    one.run(findings, {.fault = "", .coarse = false, .tier = records::Tier::quick, .machine = "", .needed = {}});
  } catch (const verification::Findings::Decided&) {
  } catch (const std::exception& thrown) {
    return std::string("error ") + thrown.what();
  }
  for (const records::Check& check : findings.checks())
    if (!check.pass) return "red " + check.name + "\n" + check.why;
  return "green";
}

/// Runs the case in a child process, its program being interface_talus with `item` changed.
Trial tried(const Case& one, const std::string& item, const fs::path& folder) {
  const auto start = std::chrono::steady_clock::now();
  fs::remove_all(folder);
  fs::create_directories(folder / "tmp");
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("no process for a case");
  if (child == 0) {
    ::setpgid(0, 0);
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    const rlimit time{120, 121};
    ::setrlimit(RLIMIT_CPU, &time);
    ::setenv("TMPDIR", (folder / "tmp").c_str(), 1);
    ::setenv("TALUS_PROGRAM", TALUS_INTERFACE_TALUS, 1);
    ::setenv("TALUS_INTERFACE_PROGRAM", TALUS_BUILT_PROGRAM, 1);
    ::setenv("TALUS_INTERFACE_LOG", (folder / "log").c_str(), 1);
    ::setenv("TALUS_INTERFACE_ITEM", item.c_str(), 1);
    std::ofstream(folder / "result") << result_of(one);
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  ::kill(-child, SIGKILL);  // programs that other threads of the case have started
  Trial trial;
  const std::string result = fs::exists(folder / "result") ? records::read_whole(folder / "result") : "error crash";
  trial.end = result == "green" ? Trial::End::green : result.starts_with("red ") ? Trial::End::red : Trial::End::error;
  if (trial.end != Trial::End::green) {
    const std::size_t line = std::min(result.find('\n'), result.size()), name = result.find(' ') + 1;
    trial.check = result.substr(name, line - name);
    trial.why = result.substr(std::min(line + 1, result.size()));
  }
  std::ifstream log(folder / "log");
  for (std::string line; std::getline(log, line);) {
    if (line.starts_with("exit ")) {
      trial.refusals += line == "exit 2";
    } else if (line == "reached") {
      trial.reached = true;
    } else {
      trial.seen.insert(line);
    }
  }
  fs::remove_all(folder);
  trial.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return trial;
}

/// Kind and name of an item as the log has it: "option run --out".
records::InterfaceItem item_of(const std::string& logged) {
  const std::size_t blank = logged.find(' ');
  return {.kind = logged.substr(0, blank), .name = logged.substr(blank + 1)};
}
std::string logged(const records::InterfaceItem& item) { return item.kind + " " + item.name; }

std::string output_of(const std::vector<std::string>& arguments) {
  return reports::run({TALUS_BUILT_PROGRAM, arguments, {}, {}}).output;
}

std::vector<std::string> matches(const std::string& text, const char* pattern) {
  const std::regex regex(pattern);
  std::vector<std::string> found;
  for (std::sregex_iterator it(text.begin(), text.end(), regex), end; it != end; ++it)
    found.push_back((*it)[1].str());
  return found;
}

/// What the program's help lists.
struct Help {
  std::vector<std::string> options;  ///< as the log has them
  std::string commands{"\n"};        ///< of two names, each with an end of line
};

Help read_help() {
  Help found;
  const std::function<void(const std::vector<std::string>&)> add = [&](const std::vector<std::string>& command) {
    std::vector<std::string> arguments = command;
    arguments.emplace_back("--help");
    const std::string help = output_of(arguments), name = fmt::format("{}", fmt::join(command, " "));
    if (command.size() == 2) found.commands += name + "\n";
    for (const std::string& option : matches(help, "\n  (?:-[a-z],)?(--[a-z-]+)"))
      if (option != "--help")
        found.options.push_back(fmt::format("option {} {}", command.empty() ? "talus" : name, option));
    const std::size_t list = help.find("Subcommands:");
    if (list == std::string::npos) return;
    for (const std::string& next : matches(help.substr(list, help.find("\n\n", list) - list), "\n  ([a-z]+) ")) {
      arguments.back() = next;
      add(arguments);
    }
  };
  add({});
  return found;
}

/// Where the fields of a section of `talus list fields` are in a file, from the section's title.
std::vector<std::string> prefixes_of(const std::string& title) {
  if (title.starts_with("from and to of a cable")) return {"cable.from.", "cable.to."};
  if (title.starts_with("shape")) return {"body.shape."};
  std::vector<std::string> prefixes;
  for (const std::string& table : matches(title.substr(0, title.find(':')), "\\[+([a-z_.]+)\\]"))
    prefixes.push_back(table + (title.starts_with("watch of") ? ".watch." : "."));
  if (prefixes.empty()) prefixes.emplace_back();
  return prefixes;
}

/// All fields, from `talus list fields`; of those in several tables each position.
std::vector<std::string> all_fields() {
  std::vector<std::string> fields, prefixes;
  std::istringstream lines(output_of({"list", "fields"}));
  for (std::string line; std::getline(lines, line);) {
    static const std::regex field("^  (?:  |\\* )([a-z_0-9]+) .+$");
    std::smatch match;
    if (!line.empty() && line.front() != ' ' && line.front() != '*') {
      prefixes = prefixes_of(line);
    } else if (std::regex_match(line, match, field)) {
      for (const std::string& prefix : prefixes)
        fields.push_back("field " + prefix + match[1].str());
    }
  }
  return fields;
}

/// Whether a file has the field, or something below it.
bool is_used(const std::string& field, const std::set<std::string>& used) {
  const auto next = used.lower_bound(field);
  return next != used.end() && (*next == field || next->starts_with(field + "."));
}

/// Hash of the sources of the program and of the changes. The program itself names the revision, with which it changes.
std::string program_sources() {
  const fs::path root{TALUS_SOURCES};
  const fs::path tool = root / "tests/interface";
  return verification::content_hash({root / "solver", root / "reports", root / "verification/record",
                                     tool / "interface_run.cpp", tool / "interface_talus.cpp",
                                     tool / "interface_text.cpp", tool / "interface_text.hpp"});
}

/// Of each case a hash of the sources in its folder, of those that all cases share, and of the files that cases read.
std::map<std::string, std::string> sources_of(const std::vector<Case>& cases) {
  const fs::path root{TALUS_SOURCES}, problems = root / "verification/problems";
  std::vector<fs::path> shared{verification::case_file("")};
  for (const char* const folder : {"check", "data", "record", "reference", "study"})
    shared.push_back(root / "verification" / folder);
  const std::string of_shared = verification::content_hash(shared);
  std::map<std::string, std::string> sources;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator{problems}) {
    const auto found = std::ranges::find(cases, entry.path().stem().string(), &Case::id);
    if (entry.path().extension() != ".cpp" || found == cases.end()) continue;
    sources[found->id] = fnv1a(of_shared + verification::content_hash({entry.path().parent_path()}));
  }
  for (const Case& one : cases)
    if (!sources.contains(one.id)) throw std::runtime_error(fmt::format("case {} has no file {}.cpp", one.id, one.id));
  return sources;
}

int run(const Options& options) {
  std::vector<Case> cases;
  for (Case& one : verification::all_cases()) {
    const std::vector<std::string>& chosen = options.cases;
    const bool wanted = std::ranges::find(chosen, one.id) != chosen.end();
    if (wanted) cases.push_back(std::move(one));
  }
  const Help help = read_help();
  ::setenv("TALUS_INTERFACE_COMMANDS", help.commands.c_str(), 1);
  const fs::path scratch = fs::absolute(options.out).parent_path() / "scratch";
  std::vector<Trial> unchanged(cases.size());
  parallel_for(2 * cases.size(), options.jobs, [&](std::size_t i) {
    const Case& one = cases[i / 2];
    const Trial trial = tried(one, i % 2 == 0 ? "" : "rewrite", scratch / std::to_string(i));
    if (trial.end != Trial::End::green)
      throw std::runtime_error(fmt::format("case {} is red without a change: {}\n{}", one.id, trial.check, trial.why));
    if (i % 2 == 0) unchanged[i / 2] = trial;
  });

  std::map<std::string, std::vector<std::size_t>> users;  // of an item: the cases, the fastest first
  for (std::size_t i = 0; i < cases.size(); ++i) {
    for (const std::string& name : unchanged[i].seen) {
      // Cases also try options that do not exist.
      const bool unknown = name.starts_with("option ") && std::ranges::find(help.options, name) == help.options.end();
      if (!unknown) users[name].push_back(i);
    }
  }
  std::vector<records::InterfaceItem> items;
  std::set<std::string> used;
  for (auto& [name, by] : users) {
    used.insert(name);
    if (!options.only.empty() && std::ranges::find(options.only, name) == options.only.end()) continue;
    std::ranges::sort(by, {}, [&](std::size_t i) { return unchanged[i].seconds; });
    items.push_back(item_of(name));
    for (const std::size_t i : by)
      items.back().cases.push_back(cases[i].id);
  }
  std::optional<TriedItems> kept;  // of a whole audit
  if (options.only.empty()) kept.emplace(options.out, program_sources(), sources_of(cases));
  std::vector<std::size_t> remaining;
  for (std::size_t i = 0; i < items.size(); ++i)
    if (!kept || !kept->find(items[i])) remaining.push_back(i);
  Progress progress;
  std::atomic<std::size_t> done{items.size() - remaining.size()};
  parallel_for(remaining.size(), options.jobs, [&](std::size_t number) {
    const std::size_t i = remaining[number];
    records::InterfaceItem& item = items[i];
    item.status = InterfaceStatus::unchanged;
    for (const std::size_t at : users.at(logged(item))) {
      const Trial trial = tried(cases[at], logged(item), scratch / std::to_string(i));
      if (trial.end == Trial::End::green) {
        if (trial.reached) item.status = InterfaceStatus::survived;
        continue;
      }
      // A case that notices counts more than one that does not, and this more than a refusal, whatever the order.
      const bool refused = trial.refusals > unchanged[at].refusals;
      if (refused && item.status == InterfaceStatus::survived) continue;
      item.status = refused ? InterfaceStatus::refused : InterfaceStatus::killed;
      item.killed_by = cases[at].id, item.check = trial.check;
      if (!refused) break;
    }
    if (kept) kept->add(item);
    const std::size_t count = ++done;
    if (progress.due()) progress.show(fmt::format("{} of {} items", count, items.size()));
  });
  if (options.only.empty()) {
    for (const auto& all : {help.options, all_fields()}) {
      for (const std::string& name : all) {
        if (is_used(name, used)) continue;
        items.push_back(item_of(name));
        items.back().status = InterfaceStatus::unused;
      }
    }
  }
  records::write_interface(items, options.out);
  fs::remove_all(scratch);

  std::map<InterfaceStatus, std::size_t> counts;
  for (const records::InterfaceItem& item : items) {
    ++counts[item.status];
    if (item.status == InterfaceStatus::survived || item.status == InterfaceStatus::unused)
      fmt::print("{}: {}\n", name_of(item.status), logged(item));
  }
  const std::size_t killed = counts[InterfaceStatus::killed], survived = counts[InterfaceStatus::survived];
  const double score = static_cast<double>(killed) / static_cast<double>(std::max<std::size_t>(1, killed + survived));
  fmt::print(
      "{} items: {} killed, {} survived, {} unused, {} refused by the program, {} without a value; score {:.1f} %\n",
      items.size(), killed, survived, counts[InterfaceStatus::unused], counts[InterfaceStatus::refused],
      counts[InterfaceStatus::unchanged], 100.0 * score);
  if (options.known.empty() || !options.only.empty()) return 0;
  const std::vector<std::string> unexpected =
      unexpected_gaps(items, read_known_gaps(records::read_whole(options.known)));
  for (const std::string& gap : unexpected)
    fmt::print("{}\n", gap);
  return unexpected.empty() ? 0 : 1;
}

}  // namespace
}  // namespace talus::interface_audit

int main(int argc, char** argv) {
  using namespace talus::interface_audit;
  CLI::App app{
      "talus_interface_run: changes one option, field, column or member of the program's interface at a time and runs "
      "the "
      "cases that use it. Exit status: 0 done, 1 other gaps than those of --known or not done, 2 wrong command line"};
  Options options;
  app.add_option("--out", options.out, "Results (JSON)")->capture_default_str();
  app.add_option("--jobs", options.jobs, "Cases at once (default: the processors of this machine)")
      ->check(CLI::Range(1U, 1024U));
  app.add_option("--known", options.known,
                 "Known gaps of a whole audit: fail if others are found, or one of them is none any more")
      ->check(CLI::ExistingFile);
  app.add_option("--cases", options.cases, "Cases that start the program: ID[,ID...]")
      ->capture_default_str()
      ->delimiter(',');
  app.add_option("--only", options.only, "Only this item; may be repeated")->take_all()->allow_extra_args(false);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& fault) {
    return app.exit(fault) == 0 ? 0 : 2;
  }
  try {
    return run(options);
  } catch (const std::exception& fault) {
    fmt::print(stderr, "talus_interface_run: {}\n", fault.what());
    return 1;
  }
}
