#include "verification/driver/runner.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <new>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <thread>

#include "verification/driver/case_run.hpp"
#include "verification/driver/earlier_record.hpp"
#include "verification/driver/exit_code.hpp"

namespace talus::verification {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr auto poll_interval = std::chrono::milliseconds(5);

/// A case that runs in a child process.
struct Child {
  std::size_t index = 0;  ///< Index in the list of cases.
  pid_t pid = 0;
  Clock::time_point start;
  bool timed_out = false;    ///< Killed at its time limit.
  bool over_memory = false;  ///< Killed at its memory limit.
};

/// Runs in the child and does not return. Output of the case goes to output.txt, not between the driver's lines.
[[noreturn]] void run_in_child(const Case& verification_case, const fs::path& folder, const RunPlan& plan,
                               const Record* earlier) {
  // A crash must terminate the child, whatever handlers the parent has installed.
  for (const int signal : {SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSEGV})
    ::signal(signal, SIG_DFL);
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // An interrupted driver leaves no cases running.
  const int log = ::open((folder / "output.txt").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  if (log >= 0) {
    ::dup2(log, STDOUT_FILENO);
    ::dup2(log, STDERR_FILENO);
  }
  // If the kernel must kill a process because memory runs out, it kills a case and not the driver.
  std::ofstream("/proc/self/oom_score_adj") << 1000;
  int status = 0;
  try {
    std::fesetround(plan.rounding);
    const Record record = run_case(verification_case, plan.tier, earlier);
    std::fesetround(FE_TONEAREST);
    write_record(record, folder);
  } catch (const std::bad_alloc&) {
    std::fputs("out of memory (std::bad_alloc)\n", stderr);
    status = exit_io;
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "%s\n", fault.what());
    status = exit_io;
  }
  std::fflush(nullptr);
  ::_exit(status);
}

/// Starts a case; no value if the system cannot create a process (see `errno`). Forks without executing another
/// program, because the case may exist only in this process, as in a test.
std::optional<Child> start(const Case& verification_case, std::size_t index, const RunPlan& plan,
                           const Record* earlier) {
  const fs::path folder = plan.out / verification_case.id;
  fs::remove_all(folder);
  fs::create_directories(folder);
  std::fflush(nullptr);
  const pid_t pid = ::fork();
  if (pid < 0) return std::nullopt;
  if (pid == 0) run_in_child(verification_case, folder, plan, earlier);
  ::setpgid(pid, pid);  // Called in parent and child, whichever runs first.
  return Child{index, pid, Clock::now()};
}

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// The last non-empty line, with characters other than printable ASCII replaced, because it may be truncated anywhere.
std::string last_line(const fs::path& file) {
  std::ifstream in(file);
  std::string last;
  for (std::string line; std::getline(in, line);) {
    if (!line.empty()) last = line;
  }
  std::replace_if(
      last.begin(), last.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return last;
}

/// Reads the record of a child that exited with status zero; RecordError if it does not belong to this case.
Record read_back(const Case& verification_case, const fs::path& folder) {
  Record record = read_record(folder);
  if (record.id != verification_case.id) throw RecordError("the record is of case '" + record.id + "'");
  if (record.controls.size() != verification_case.faults.size()) {
    throw RecordError("the record has another number of controls than the case has faults");
  }
  Record judged = record;
  judge(verification_case, judged);
  if (record.status != judged.status && record.status != Status::error) {
    throw RecordError("the record's status does not follow from its checks");
  }
  return record;
}

Record outcome_of(const Child& child, int status, const Case& verification_case, const RunPlan& plan) {
  const fs::path folder = plan.out / verification_case.id;
  const auto failed = [&](Status how, std::string message) {
    const std::string last = last_line(folder / "output.txt");
    if (!last.empty()) message += "; its last words: " + last;
    Record record = unfinished(verification_case, how, message);
    record.seconds = seconds_since(child.start);
    write_record(record, folder);  // The folder must agree with results.json.
    return record;
  };
  if (child.timed_out) {
    return failed(Status::timeout, fmt::format("stopped at its time limit of {:g} s", verification_case.time_limit));
  }
  if (child.over_memory) {
    return failed(Status::error,
                  fmt::format("stopped at its memory limit of {:g} GiB", verification_case.memory_limit));
  }
  if (WIFSIGNALED(status)) {
    const bool by_kernel = WTERMSIG(status) == SIGKILL;
    return failed(Status::error,
                  fmt::format("ended by signal {} ({}{})", WTERMSIG(status), ::strsignal(WTERMSIG(status)),
                              by_kernel ? ", which the kernel sends when memory runs out" : ""));
  }
  if (WEXITSTATUS(status) != 0) {
    return failed(Status::error, fmt::format("ended with exit status {}", WEXITSTATUS(status)));
  }
  if (!fs::exists(folder / "record.json")) {
    return failed(Status::missing, "the case ended without leaving a record");
  }
  try {
    Record record = read_back(verification_case, folder);
    if (!plan.program.empty()) mark_record(folder, plan.program);
    return record;
  } catch (const RecordError& fault) {
    return failed(Status::error, fault.what());
  }
}

/// Resident memory of a process [GiB]; 0 once it has ended. Memory that is reserved but was never touched does not
/// count.
double memory_of(pid_t pid) {
  std::ifstream file("/proc/" + std::to_string(pid) + "/statm");
  double all = 0.0, resident = 0.0;
  if (!(file >> all >> resident)) return 0.0;
  return resident * static_cast<double>(::sysconf(_SC_PAGESIZE)) / (1024.0 * 1024.0 * 1024.0);
}

/// Whether the child has ended; kills its process group when the case exceeds its time or memory limit.
bool has_ended(Child& child, const Case& verification_case, int& status) {
  const pid_t ended = ::waitpid(child.pid, &status, WNOHANG);
  if (ended == child.pid) return true;
  if (child.timed_out || child.over_memory) return false;
  child.timed_out = seconds_since(child.start) > verification_case.time_limit;
  child.over_memory = !child.timed_out && memory_of(child.pid) > verification_case.memory_limit;
  if (child.timed_out || child.over_memory) ::kill(-child.pid, SIGKILL);
  return false;
}

std::vector<std::string> ids_of(const std::vector<Child>& children, const std::vector<Case>& cases) {
  std::vector<std::string> ids;
  for (const auto& child : children)
    ids.push_back(cases[child.index].id);
  return ids;
}

/// The record of a case that is used if no other can be obtained. It is created before the case runs, because later
/// there may be no memory for it.
Record not_recorded(const Case& verification_case) {
  return unfinished(verification_case, Status::error, "the driver ran out of memory before it had the case's record");
}

/// Stores the record of a child that has ended; keeps the existing record if there is no memory for the new one.
void take(Record& record, const Child& child, int status, const Case& verification_case, const RunPlan& plan) {
  try {
    record = outcome_of(child, status, verification_case, plan);
    return;
  } catch (const std::bad_alloc&) {
    record.seconds = seconds_since(child.start);
  }
  try {
    write_record(record, plan.out / verification_case.id);  // The folder must agree with results.json.
  } catch (const std::exception&) {
    // Ignored: results.json has the information, and no data are lost.
  }
}

/// The order in which cases start: long cases first, so that none of them delays the end.
std::vector<std::size_t> starting_order(const std::vector<Case>& cases, Tier tier) {
  const auto seconds = [&](std::size_t i) {
    return tier == Tier::full ? std::max(cases[i].seconds, cases[i].full_seconds) : cases[i].seconds;
  };
  std::vector<std::size_t> order(cases.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return seconds(a) > seconds(b); });
  return order;
}

/// The queue of cases: at most `plan.jobs` run at the same time; when one ends, the next in starting_order() starts.
class Queue {
 public:
  Queue(const std::vector<Case>& cases, const RunPlan& plan, std::vector<Record>& records)
      : cases_(cases), order_(starting_order(cases, plan.tier)), plan_(plan), records_(records) {
    running_.reserve(std::max(1u, plan.jobs));
  }
  Queue(const Queue&) = delete;
  Queue& operator=(const Queue&) = delete;
  /// Kills all running cases, also when an exception ends the driver.
  ~Queue() {
    for (const Child& child : running_) {
      ::kill(-child.pid, SIGKILL);
      ::waitpid(child.pid, nullptr, 0);
    }
  }

  [[nodiscard]] bool done() const { return next_ == cases_.size() && running_.empty(); }

  void start_cases(const Progress& progress) {
    while (!refused_ && next_ < cases_.size() && running_.size() < std::max(1u, plan_.jobs)) {
      const std::size_t index = order_[next_];
      const auto earlier =
          plan_.reuse ? earlier_record(cases_[index], plan_.out / cases_[index].id, plan_.program) : std::nullopt;
      if (earlier && !cases_[index].has_full_part()) {
        records_[index] = *earlier;
        progress(records_[index], ids_of(running_, cases_), true);
        ++next_;
        continue;
      }
      if (const auto child = start(cases_[index], index, plan_, earlier ? &*earlier : nullptr)) {
        running_.push_back(*child);
        ++next_;
        continue;
      }
      const int reason = errno;
      // A process may become available when a case ends.
      refused_ = !running_.empty();
      if (refused_) return;
      records_[index] =
          unfinished(cases_[index], Status::error, fmt::format("no process for the case: {}", std::strerror(reason)));
      progress(records_[index], {}, false);
      ++next_;
    }
  }

  void collect(const Progress& progress) {
    for (std::size_t i = 0; i < running_.size();) {
      int status = 0;
      if (!has_ended(running_[i], cases_[running_[i].index], status)) {
        ++i;
        continue;
      }
      const Child child = running_[i];
      running_.erase(running_.begin() + static_cast<std::ptrdiff_t>(i));
      refused_ = false;
      take(records_[child.index], child, status, cases_[child.index], plan_);
      progress(records_[child.index], ids_of(running_, cases_), false);
    }
  }

 private:
  const std::vector<Case>& cases_;
  const std::vector<std::size_t> order_;
  const RunPlan& plan_;
  std::vector<Record>& records_;
  std::vector<Child> running_;
  std::size_t next_ = 0;
  bool refused_ = false;  ///< The system could not create a process for the next case, and no case has ended since.
};

}  // namespace

std::vector<Record> run_all(const std::vector<Case>& cases, const RunPlan& plan, const Progress& progress) {
  std::vector<Record> records;
  for (const Case& verification_case : cases)
    records.push_back(not_recorded(verification_case));
  try {
    Queue queue(cases, plan, records);
    while (!queue.done()) {
      queue.start_cases(progress);
      std::this_thread::sleep_for(poll_interval);
      queue.collect(progress);
    }
  } catch (const std::bad_alloc&) {
    // Records that are still missing already say that memory ran out.
  }
  return records;
}

}  // namespace talus::verification
