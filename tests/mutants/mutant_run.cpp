/// talus_mutant_run: runs the cases with each mutant that is compiled into this build.
#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "solver/base/progress.hpp"
#include "tests/mutants/mutant_switch.hpp"
#include "tests/mutants/schema_report.hpp"
#include "verification/check/findings.hpp"
#include "verification/check/record.hpp"
#include "verification/driver/case_list.hpp"
#include "verification/record/mutants.hpp"
#include "verification/record/whole_file.hpp"

namespace talus::mutants {

namespace {

namespace fs = std::filesystem;
using records::MutantRecord;
using records::MutantStatus;
using records::Trial;
using records::TrialEnd;
using verification::Case;
using Clock = std::chrono::steady_clock;

struct Options {
  fs::path list = "build/mutants/mutants.json";
  fs::path root = ".";
  fs::path out;
  unsigned jobs = 0;
  double build_seconds = 0.0;
  double minimum_score = 0.0;
  double longest = 0.0;
  bool full = false;
  std::vector<std::string> only;
  std::vector<std::string> cases;
};

/// Result of one case in its child process.
struct Outcome {
  Trial trial{};
  double seconds{};  ///< processor time
};

// --- Child process ---------------------------------------------------------------------------------------------------

double size_of(const records::Check& check) {
  if (!std::isfinite(check.error)) return std::numeric_limits<double>::infinity();
  if (check.bound > 0.0) return check.error / check.bound;
  return check.pass ? 0.0 : std::numeric_limits<double>::infinity();
}

/// Runs the right setup of a case; its controls do not count as detecting a mutant.
Trial tried(const Case& one, records::Tier tier) {
  verification::Findings findings;
  try {
    one.run(findings, {.fault = "", .coarse = false, .tier = tier, .machine = "", .needed = {}});
  } catch (const std::exception& thrown) {
    return {one.id, TrialEnd::error, std::numeric_limits<double>::infinity(), thrown.what()};
  }
  Trial trial{.case_id = one.id, .end = TrialEnd::pass};
  for (const records::Check& check : findings.checks()) {
    if (!check.pass) trial.end = TrialEnd::fail, trial.failed.push_back(check.name);
    const double ratio = size_of(check);
    if (!(ratio > trial.ratio)) continue;
    trial.ratio = ratio;
    trial.check = check.name;
  }
  const Case with_names = verification::with_check_names(one, findings);
  for (const std::string& name : with_names.main_checks) {
    if (findings.find(name) != nullptr) continue;
    return {one.id, TrialEnd::fail, std::numeric_limits<double>::infinity(), name};
  }
  return trial;
}

std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

std::string text_of(const Trial& trial) {
  std::string text =
      fmt::format("{}\n{:a}\n{}\n", static_cast<int>(trial.end), trial.ratio, one_line(trial.check.substr(0, 300)));
  for (const std::string& name : trial.failed)
    text += one_line(name) + '\n';
  return text;
}

/// Limits of a child process, to protect the machine.
void limit(double seconds, double memory) {
  const auto whole = static_cast<rlim_t>(std::ceil(seconds));
  const rlimit time{whole, whole + 1};
  ::setrlimit(RLIMIT_CPU, &time);
  const auto bytes = static_cast<rlim_t>(memory * 1024.0 * 1024.0 * 1024.0);
  const rlimit space{bytes, bytes};
  ::setrlimit(RLIMIT_AS, &space);
  const rlimit core{0, 0};
  ::setrlimit(RLIMIT_CORE, &core);
}

struct Request {
  const Case* one{};
  int number{};      ///< of the mutant; 0: none; -1: none, and mutants that are reached are recorded
  double seconds{};  ///< limit of processor time
  fs::path reached;  ///< file for the mutants that are reached
  records::Tier tier{};
};

[[noreturn]] void run_in_child(const Request& request, int result) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  const int nowhere = ::open("/dev/null", O_WRONLY);
  ::dup2(nowhere, STDOUT_FILENO);
  ::dup2(nowhere, STDERR_FILENO);
  limit(request.seconds, 12.0);
  active = request.number;
  ::setenv("TALUS_MUTANT", std::to_string(request.number).c_str(), 1);
  if (!request.reached.empty()) ::setenv("TALUS_MUTANTS_REACHED", request.reached.c_str(), 1);
  const std::string text = text_of(tried(*request.one, request.tier));
  if (!request.reached.empty()) write_reached();
  // Capacity of the pipe before it is read: the names of some hundred checks.
  const std::size_t fits = std::min(text.size(), std::size_t{60000});
  const bool written = ::write(result, text.data(), fits) == static_cast<ssize_t>(fits);
  ::_exit(written ? 0 : 1);
}

// --- Parent process --------------------------------------------------------------------------------------------------

class Child {
 public:
  explicit Child(const Request& request) : request_{request}, start_{Clock::now()} {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe for a child process");
    pid_ = ::fork();
    if (pid_ < 0) throw std::runtime_error("no process for a case");
    if (pid_ == 0) run_in_child(request, ends[1]);
    ::close(ends[1]);
    result_ = ends[0];
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child() {
    if (running_) {
      ::kill(-pid_, SIGKILL);
      ::waitpid(pid_, nullptr, 0);
    }
    ::close(result_);
  }

  /// Its result, once it has ended. It is killed if it waits for longer than its limit of processor time allows.
  std::optional<Outcome> outcome() {
    int status = 0;
    rusage usage{};
    const pid_t ended = ::wait4(pid_, &status, WNOHANG, &usage);
    if (ended != pid_) {
      const double waited = std::chrono::duration<double>(Clock::now() - start_).count();
      if (waited > 4.0 * request_.seconds + 20.0) {
        late_ = true;
        ::kill(-pid_, SIGKILL);
      }
      return std::nullopt;
    }
    running_ = false;
    ::kill(-pid_, SIGKILL);  // Programs that it started.
    Outcome outcome;
    const auto seconds = [](const timeval& time) {
      return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    outcome.seconds = seconds(usage.ru_utime) + seconds(usage.ru_stime);
    outcome.trial = WIFEXITED(status) && WEXITSTATUS(status) == 0 ? read() : unfinished(status);
    return outcome;
  }

 private:
  Trial unfinished(int status) const {
    const bool by_time = late_ || (WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL));
    return {request_.one->id, by_time ? TrialEnd::timeout : TrialEnd::crash, std::numeric_limits<double>::infinity(),
            WIFSIGNALED(status) ? fmt::format("signal {}", WTERMSIG(status)) : "no result"};
  }
  Trial read() const {
    std::string text;
    char part[512];
    for (ssize_t got = 0; (got = ::read(result_, part, sizeof part)) > 0;)
      text.append(part, static_cast<std::size_t>(got));
    std::istringstream in(text);
    std::string end, ratio, check;
    std::getline(in, end), std::getline(in, ratio), std::getline(in, check);
    Trial trial{
        request_.one->id, static_cast<TrialEnd>(std::stoi(end)), std::strtod(ratio.c_str(), nullptr), check, {}};
    for (std::string name; std::getline(in, name);)
      trial.failed.push_back(name);
    return trial;
  }

  Request request_;
  Clock::time_point start_;
  pid_t pid_{};
  int result_{};
  bool running_{true};
  bool late_{};
};

/// Runs work in parallel: `next` returns a request for a free job slot, or nothing; `done` receives its outcome.
template <class Next, class Done>
void run_side_by_side(unsigned jobs, Next&& next, Done&& done) {
  struct Slot {
    std::unique_ptr<Child> child;
    std::size_t task{};
  };
  std::vector<Slot> slots(jobs);
  bool any = true;
  while (any) {
    any = false;
    for (Slot& slot : slots) {
      if (slot.child) {
        if (const auto outcome = slot.child->outcome()) {
          slot.child.reset();
          done(slot.task, *outcome);
        }
      }
      if (!slot.child) {
        if (const auto request = next(slot.task)) slot.child = std::make_unique<Child>(*request);
      }
      any = any || slot.child;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

/// A case without a mutant: its time, and the mutants that it evaluates.
struct Unchanged {
  const Case* one{};
  double seconds{};
  std::set<int> reached{};
};

std::set<int> read_reached(const fs::path& file) {
  std::set<int> numbers;
  std::ifstream in(file);
  for (int number = 0; in >> number;)
    numbers.insert(number);
  return numbers;
}

/// Runs all cases without a mutant. Errors: std::runtime_error if a case is red.
std::vector<Unchanged> run_unchanged(const std::vector<Case>& cases, records::Tier tier, unsigned jobs,
                                     const fs::path& folder) {
  std::vector<Unchanged> all;
  for (const Case& one : cases)
    all.push_back({.one = &one});
  std::size_t at = 0;
  std::size_t ended = 0;
  Progress progress;
  run_side_by_side(
      jobs,
      [&](std::size_t& task) -> std::optional<Request> {
        if (at == all.size()) return std::nullopt;
        task = at++;
        const fs::path file = folder / (cases[task].id + ".reached");
        fs::remove(file);
        return Request{.one = all[task].one, .number = -1, .seconds = 600.0, .reached = file, .tier = tier};
      },
      [&](std::size_t task, const Outcome& outcome) {
        if (records::kills(outcome.trial))
          throw std::runtime_error(fmt::format("case {} is red without a mutant: {}: {}", outcome.trial.case_id,
                                               name_of(outcome.trial.end), outcome.trial.check));
        all[task].seconds = outcome.seconds;
        all[task].reached = read_reached(folder / (cases[task].id + ".reached"));
        ++ended;
        if (progress.due()) progress.show(fmt::format("without a mutant: {} of {} cases", ended, all.size()));
      });
  return all;
}

/// True if every case that evaluates the mutant must turn red.
bool concerns_every_case(const MutantRecord& mutant) {
  return std::find(mutant.cases.begin(), mutant.cases.end(), "*") != mutant.cases.end();
}

/// Progress of one mutant through the cases that evaluate it.
struct Passage {
  MutantRecord* mutant{};
  std::vector<const Unchanged*> cases{};
  std::size_t next{};
  bool busy{};

  /// After the first kill only cases of at most this processor time [s] are run.
  void leave_out(double longest) {
    if (mutant->status != MutantStatus::killed || concerns_every_case(*mutant)) return;
    while (next < cases.size() && cases[next]->seconds > longest)
      ++next;
  }
  [[nodiscard]] bool ended() const { return next == cases.size(); }
};

/// Order of the cases: those that a bug names first, then by time; those that compare with recorded results last, so
/// that they kill only mutants that no other case kills.
std::vector<const Unchanged*> order_of(const MutantRecord& mutant, const std::vector<Unchanged>& unchanged) {
  std::vector<const Unchanged*> order;
  for (const Unchanged& one : unchanged) {
    if (one.reached.count(mutant.number) > 0) order.push_back(&one);
  }
  const auto named = [&](const Unchanged* one) {
    return std::find(mutant.cases.begin(), mutant.cases.end(), one->one->id) != mutant.cases.end();
  };
  std::stable_sort(order.begin(), order.end(), [&](const Unchanged* a, const Unchanged* b) {
    if (a->one->recorded != b->one->recorded) return b->one->recorded;
    if (named(a) != named(b)) return named(a);
    return a->seconds < b->seconds;
  });
  return order;
}

/// Checks that all ids exist. Errors: std::invalid_argument for an id that no mutant has.
void demand_known(const records::Mutants& mutants, const std::vector<std::string>& ids) {
  for (const std::string& id : ids) {
    if (std::none_of(mutants.mutants.begin(), mutants.mutants.end(),
                     [&](const auto& mutant) { return mutant.id == id; }))
      throw std::invalid_argument(fmt::format("--only: there is no mutant '{}'", id));
  }
}

/// Runs the mutants. `save` is called about once a minute with the results so far: unfinished mutants are pending.
template <class Save>
void run_mutants(records::Mutants& mutants, const std::vector<Unchanged>& unchanged, const Options& options,
                 records::Tier tier, unsigned jobs, Save&& save) {
  std::vector<Passage> passages;
  for (MutantRecord& mutant : mutants.mutants) {
    if (mutant.status != MutantStatus::pending) continue;
    if (!options.only.empty() && std::find(options.only.begin(), options.only.end(), mutant.id) == options.only.end())
      continue;
    Passage passage{.mutant = &mutant, .cases = order_of(mutant, unchanged)};
    for (const Unchanged& one : unchanged) {
      if (one.reached.count(mutant.number) > 0) mutant.covered_by.push_back(one.one->id);
    }
    if (passage.cases.empty())
      mutant.status = MutantStatus::unreached;
    else
      passages.push_back(std::move(passage));
  }
  const auto start = Clock::now();
  Clock::time_point saved = start;
  std::size_t ended = 0;
  Progress progress;
  // The mutant whose next case is shortest comes first: most mutants are soon killed, and an interrupted run has missed
  // only the longest cases of the others.
  run_side_by_side(
      jobs,
      [&](std::size_t& task) -> std::optional<Request> {
        Passage* first = nullptr;
        for (Passage& passage : passages) {
          if (passage.busy || passage.ended()) continue;
          if (first == nullptr || passage.cases[passage.next]->seconds < first->cases[first->next]->seconds)
            first = &passage;
        }
        if (first == nullptr) return std::nullopt;
        first->busy = true;
        task = static_cast<std::size_t>(first - passages.data());
        const Unchanged& one = *first->cases[first->next++];
        return Request{.one = one.one,
                       .number = first->mutant->number,
                       .seconds = 10.0 * one.seconds + 3.0,
                       .reached = {},
                       .tier = tier};
      },
      [&](std::size_t task, const Outcome& outcome) {
        Passage& passage = passages[task];
        passage.busy = false;
        passage.mutant->trials.push_back(outcome.trial);
        if (records::kills(outcome.trial)) passage.mutant->status = MutantStatus::killed;
        passage.leave_out(options.longest);
        if (passage.ended()) {
          ++ended;
          if (passage.mutant->status == MutantStatus::pending) passage.mutant->status = MutantStatus::survived;
        }
        const double elapsed = std::chrono::duration<double>(Clock::now() - start).count();
        if (Clock::now() - saved > std::chrono::seconds(60)) {
          mutants.run_seconds = elapsed;
          save();
          saved = Clock::now();
        }
        if (progress.due()) {
          const double fraction = static_cast<double>(ended) / static_cast<double>(passages.size());
          progress.show(fmt::format("{} of {} mutants, {}", ended, passages.size(), time_left_text(elapsed, fraction)));
        }
      });
  mutants.run_seconds = std::chrono::duration<double>(Clock::now() - start).count();
}

/// Prints the score and the surviving mutants by file; the mutants of operation "bug" separately. Returns the score of
/// the generated ones.
records::Score print(const records::Mutants& mutants) {
  std::map<std::string, records::Score> files;
  records::Score all, bugs;
  for (const MutantRecord& mutant : mutants.mutants) {
    if (mutant.operation == "bug") {
      count(bugs, mutant);
      continue;
    }
    count(files[mutant.file], mutant);
    count(all, mutant);
  }
  const auto row = [](const std::string& name, const records::Score& score) {
    fmt::print("{:<44} {:>6} {:>8} {:>9} {:>10} {:>7.1f} %\n", name, score.killed, score.survived, score.unreached,
               score.equivalent, 100.0 * score.fraction());
  };
  fmt::print("{:<44} {:>6} {:>8} {:>9} {:>10} {:>9}\n", "file", "killed", "survived", "unreached", "equivalent",
             "score");
  for (const auto& [name, score] : files)
    row(name, score);
  row("all generated mutants", all);
  row("written bugs", bugs);
  for (const MutantRecord& mutant : mutants.mutants) {
    if (mutant.status == MutantStatus::survived || mutant.status == MutantStatus::unreached)
      fmt::print("{}: {}\n    {}  ->  {}\n", name_of(mutant.status), mutant.id, mutant.original, mutant.replacement);
  }
  return all;
}

/// Checks that each bug turns a case red that it names, or every case that evaluates it. Returns true if all do.
bool demand_named(const records::Mutants& mutants) {
  bool all = true;
  for (const MutantRecord& mutant : mutants.mutants) {
    if (mutant.operation != "bug" || mutant.status == MutantStatus::pending) continue;
    if (concerns_every_case(mutant)) {
      for (const Trial& trial : mutant.trials) {
        if (records::kills(trial)) continue;
        all = false;
        fmt::print("bug {}: case {} stays green\n", mutant.id, trial.case_id);
      }
      continue;
    }
    const bool named = std::any_of(mutant.trials.begin(), mutant.trials.end(), [&](const Trial& trial) {
      return records::kills(trial) &&
             std::find(mutant.cases.begin(), mutant.cases.end(), trial.case_id) != mutant.cases.end();
    });
    if (named) continue;
    all = false;
    fmt::print("bug {}: no case that it names turned red\n", mutant.id);
  }
  return all;
}

std::vector<Case> chosen_cases(const Options& options, records::Tier tier) {
  std::vector<Case> cases;
  for (Case& one : verification::all_cases()) {
    const bool in_tier = tier == records::Tier::full || one.tier == records::Tier::quick;
    const bool named =
        options.cases.empty() || std::find(options.cases.begin(), options.cases.end(), one.id) != options.cases.end();
    if (in_tier && named) cases.push_back(std::move(one));
  }
  for (const std::string& id : options.cases) {
    if (std::none_of(cases.begin(), cases.end(), [&](const Case& one) { return one.id == id; }))
      throw std::invalid_argument(fmt::format("--cases: there is no case '{}' in this tier", id));
  }
  return cases;
}

/// Removes bugs that name none of the chosen cases.
void leave_out_others(records::Mutants& mutants, const std::vector<std::string>& cases) {
  const auto chosen = [&](const std::string& id) {
    return id == "*" || std::find(cases.begin(), cases.end(), id) != cases.end();
  };
  if (cases.empty()) return;
  std::erase_if(mutants.mutants, [&](const MutantRecord& mutant) {
    return mutant.operation == "bug" && std::none_of(mutant.cases.begin(), mutant.cases.end(), chosen);
  });
}

int run(const Options& options) {
  const records::Tier tier = options.full ? records::Tier::full : records::Tier::quick;
  const unsigned jobs = options.jobs > 0 ? options.jobs : std::max(1u, std::thread::hardware_concurrency());
  records::Mutants mutants = records::read_mutants(options.list);
  demand_known(mutants, options.only);
  leave_out_others(mutants, options.cases);
  const fs::path out = options.out.empty() ? options.list.parent_path() / "killed.json" : options.out;
  const auto cases = chosen_cases(options, tier);
  // Absolute: programs that cases start run in other folders.
  const fs::path folder = fs::absolute(options.list).parent_path() / "reached";
  fs::create_directories(folder);
  auto unchanged = run_unchanged(cases, tier, jobs, folder);
  mutants.whole_matrix = options.longest > 0.0;
  mutants.build_seconds = options.build_seconds;
  for (const Unchanged& one : unchanged)
    mutants.cases.push_back(
        {one.one->id, one.one->family, one.seconds, one.one->recorded, one.seconds <= options.longest});
  const auto save = [&] { records::write_mutants(mutants, out); };
  run_mutants(mutants, unchanged, options, tier, jobs, save);
  save();
  records::write_whole(out.parent_path() / "report.json", schema_report(mutants, options.root));
  const records::Score score = print(mutants);
  const bool enough = score.fraction() >= options.minimum_score;
  if (!enough) fmt::print("the score is less than {:.1f} %\n", 100.0 * options.minimum_score);
  return demand_named(mutants) && enough ? 0 : 1;
}

}  // namespace

}  // namespace talus::mutants

int main(int argc, char** argv) {
  using namespace talus::mutants;
  CLI::App app{
      "talus_mutant_run: runs the cases with each mutant of this build. Exit status: 0 done and every written "
      "bug turned a case red that it names, 1 not so, a score below --minimum-score, or not done, 2 wrong command "
      "line"};
  Options options;
  app.add_option("--list", options.list, "What talus_mutate wrote")->capture_default_str()->check(CLI::ExistingFile);
  app.add_option("--root", options.root, "The sources without mutants")->capture_default_str();
  app.add_option("--out", options.out, "Results; default: killed.json beside the list");
  app.add_option("--jobs", options.jobs, "Cases at once (default: the processors of this machine)");
  app.add_option("--build-seconds", options.build_seconds, "What building took, for the report");
  app.add_option("--minimum-score", options.minimum_score,
                 "Fail if a smaller fraction of the generated mutants that count is killed")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  app.add_option("--matrix", options.longest,
                 "Run all cases that evaluate a mutant and take at most this processor time without one [s]; longer "
                 "ones, as all without this option, only until one is red")
      ->check(CLI::PositiveNumber);
  app.add_flag("--full", options.full, "The long studies as well");
  app.add_option("--only", options.only, "Only these mutants: ID[,ID...]")->delimiter(',');
  app.add_option("--cases", options.cases, "Only these cases, and bugs that name one of them: ID[,ID...]")
      ->delimiter(',');
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& fault) {
    return app.exit(fault) == 0 ? 0 : 2;
  }
  try {
    return run(options);
  } catch (const std::exception& fault) {
    fmt::print(stderr, "talus_mutant_run: {}\n", fault.what());
    return 1;
  }
}
