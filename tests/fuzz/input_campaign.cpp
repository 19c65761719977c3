#include "tests/fuzz/input_campaign.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <iterator>
#include <random>
#include <string_view>
#include <system_error>

#include "tests/fuzz/mutation.hpp"

#if defined(__SANITIZE_ADDRESS__)
#define TALUS_WITH_ASAN
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define TALUS_WITH_ASAN
#endif
#endif

namespace talus::fuzz {
namespace {

namespace fs = std::filesystem;

/// Number of inputs that one child process reads.
constexpr long batch = 2000;
/// Address space of a child; the address sanitizer reserves far more, and is limited elsewhere (mutate_inputs.cpp).
[[maybe_unused]] constexpr rlim_t maximum_memory = rlim_t{3} << 30U;
/// Exit status of a child that found a flaw.
constexpr int flawed = 77;

/// Data that a child writes and its parent reads.
struct Progress {
  long number{};  ///< number of the input that is being read
  long accepted{}, refused{}, cut_short{};
};

/// Memory that is shared with child processes.
class SharedProgress {
 public:
  SharedProgress()
      : memory_{::mmap(nullptr, sizeof(Progress), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)} {
    if (memory_ == MAP_FAILED) throw std::system_error{errno, std::generic_category(), "mmap"};
    new (memory_) Progress;
  }
  SharedProgress(const SharedProgress&) = delete;
  SharedProgress& operator=(const SharedProgress&) = delete;
  ~SharedProgress() { ::munmap(memory_, sizeof(Progress)); }

  Progress* operator->() const { return static_cast<Progress*>(memory_); }

 private:
  void* memory_;
};

void redirect(int stream, const fs::path& file) {
  const int opened = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  if (opened < 0 || ::dup2(opened, stream) < 0) std::_Exit(flawed);
  ::close(opened);
}

/// Ends the process after this many more seconds of processor time.
void limit_time(long seconds) {
  const itimerval limit{{0, 0}, {seconds, 0}};
  ::setitimer(ITIMER_PROF, &limit, nullptr);
}

/// Output files of a batch in the folder of a reader.
struct BatchFiles {
  fs::path errors, messages;
  explicit BatchFiles(const fs::path& folder) : errors{folder / "stderr.txt"}, messages{folder / "messages.txt"} {}
};

/// Reads inputs up to `end`; never returns.
[[noreturn]] void read_batch(const Reader& reader, const CampaignPlan& plan, const fs::path& folder, Progress& progress,
                             long end) {
  const BatchFiles files{folder};
  redirect(STDOUT_FILENO, "/dev/null");
  redirect(STDERR_FILENO, files.errors);
#ifndef TALUS_WITH_ASAN
  const rlimit memory{maximum_memory, maximum_memory};
  ::setrlimit(RLIMIT_AS, &memory);
#endif
  const rlimit core{0, 0};
  ::setrlimit(RLIMIT_CORE, &core);
  std::ofstream messages;
  if (plan.messages) messages.open(files.messages, std::ios::app);
  for (; progress.number < end; ++progress.number) {
    limit_time(plan.cpu_seconds);
    const fs::path file = put(reader, input(reader, progress.number, plan.seed), folder);
    Reading reading = read(reader, file);
    const bool sound = progress.number < static_cast<long>(reader.corpus.size());
    if (sound && reading.ending == Ending::refused) reading.flaw = "a sound file is refused: " + reading.message;
    if (!reading.flaw.empty()) {
      fmt::print(stderr, "flaw: {}\n", reading.flaw.substr(0, 1000));
      std::fflush(stderr);
      std::_Exit(flawed);
    }
    if (plan.messages && !reading.message.empty()) messages << pattern_of(reading.message, file) << '\n';
    switch (reading.ending) {
      case Ending::accepted:
        ++progress.accepted;
        break;
      case Ending::refused:
        ++progress.refused;
        break;
      case Ending::cut_short:
        ++progress.cut_short;
        break;
    }
  }
  messages.flush();
  std::_Exit(0);
}

/// Summary of a child's standard error: the line that says what went wrong, and the first frame in our sources.
std::string text_of(const fs::path& errors) {
  std::ifstream in{errors};
  std::string what, frame;
  for (std::string line; std::getline(in, line);) {
    for (const std::string_view mark : {"flaw: ", "runtime error: ", "ERROR: ", "contract is broken", "what(): "})
      if (what.empty() && line.find(mark) != std::string::npos) what = line;
    for (const std::string_view tree : {"/solver/", "/verification/", "/reports/"})
      if (const std::size_t at = line.find(tree); frame.empty() && line.find("    #") == 0 && at != std::string::npos)
        frame = line.substr(at + 1);
  }
  return frame.empty() ? what : fmt::format("{} in {}", what, frame);
}

std::string how_it_ended(int status, const fs::path& errors, long seconds) {
  const std::string text = text_of(errors);
  if (WIFEXITED(status))
    return WEXITSTATUS(status) == flawed ? text : fmt::format("exit status {}: {}", WEXITSTATUS(status), text);
  const int signal = WTERMSIG(status);
  if (signal == SIGPROF) return fmt::format("took more than {} s", seconds);
  return fmt::format("{}: {}", ::strsignal(signal), text);
}

/// Starts a child for the remaining inputs of a batch and waits for it.
int status_of_batch(const Reader& reader, const CampaignPlan& plan, const fs::path& folder, Progress& progress,
                    long end) {
  std::fflush(nullptr);
  const pid_t child = ::fork();
  if (child < 0) throw std::system_error{errno, std::generic_category(), "fork"};
  if (child == 0) read_batch(reader, plan, folder, progress, end);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0)
    if (errno != EINTR) throw std::system_error{errno, std::generic_category(), "waitpid"};
  return status;
}

/// Saves the input of a finding unless one with the same pattern was saved before.
void save(Finding& finding, const std::vector<Finding>& others, const Reader& reader, const CampaignPlan& plan) {
  const std::string pattern = pattern_of(finding.what, reader.file);
  const auto same = [&](const Finding& other) { return pattern_of(other.what, reader.file) == pattern; };
  if (plan.findings.empty() || std::any_of(others.begin(), others.end(), same)) return;
  const fs::path folder = plan.findings / fmt::format("{}_{}", reader.name, finding.input);
  fs::create_directories(folder);
  finding.file = put(reader, input(reader, finding.input, plan.seed), folder);
  std::ofstream{folder / "what.txt"} << finding.what << '\n';
}

}  // namespace

std::string input(const Reader& reader, long number, std::uint64_t seed) {
  const auto index = static_cast<std::uint64_t>(number);
  if (index < reader.corpus.size()) return reader.corpus[index];
  std::uint64_t mixed = seed;
  for (const char c : reader.name)
    mixed = (mixed ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  std::mt19937_64 random{mixed + index};
  std::string text = mutated(reader.corpus, random);
  if (reader.seal && random() % 8 != 0) reader.seal(text);
  return text;
}

Tally run_inputs(const Reader& reader, const CampaignPlan& plan, const fs::path& scratch) {
  const fs::path folder = scratch / ("inputs_" + reader.name);
  fs::create_directories(folder);
  const BatchFiles files{folder};
  Tally tally{.reader = reader.name};
  const auto start = std::chrono::steady_clock::now();
  const long inputs = std::max(static_cast<long>(reader.corpus.size()), reader.slow ? plan.inputs / 4 : plan.inputs);
  const SharedProgress progress;
  while (progress->number < inputs && tally.findings.size() < plan.maximum_findings) {
    const long end = std::min(inputs, progress->number + batch);
    const int status = status_of_batch(reader, plan, folder, *progress.operator->(), end);
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) continue;
    Finding finding{progress->number, how_it_ended(status, files.errors, plan.cpu_seconds), {}};
    save(finding, tally.findings, reader, plan);
    tally.findings.push_back(std::move(finding));
    ++progress->number;
  }
  tally.inputs = progress->number;
  tally.accepted = progress->accepted, tally.refused = progress->refused, tally.cut_short = progress->cut_short;
  tally.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::ifstream messages{files.messages};
  for (std::string line; std::getline(messages, line);)
    ++tally.messages[line];
  fs::remove_all(folder);
  return tally;
}

}  // namespace talus::fuzz
