#include "reports/base/process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <sstream>

#include "reports/base/error.hpp"

extern "C" char** environ;

namespace talus::reports {
namespace {

/// A pipe that closes both ends in its destructor. They are close-on-exec from the start: a child started meanwhile by
/// another thread must not inherit them, or reading would wait for its end.
struct Pipe {
  std::array<int, 2> ends{-1, -1};
  Pipe() {
    if (pipe2(ends.data(), O_CLOEXEC) != 0) throw OutputError(fmt::format("no pipe: {}", std::strerror(errno)));
  }
  ~Pipe() {
    close_end(0);
    close_end(1);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  void close_end(std::size_t end) {
    if (ends[end] >= 0) close(ends[end]);
    ends[end] = -1;
  }
};

std::vector<std::string> environment_of(const Command& command) {
  std::vector<std::string> entries;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string text = *entry;
    if (command.environment.count(text.substr(0, text.find('='))) == 0) entries.push_back(text);
  }
  for (const auto& [name, value] : command.environment)
    entries.push_back(name + "=" + value);
  return entries;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> result;
  for (std::string& text : texts)
    result.push_back(text.data());
  result.push_back(nullptr);
  return result;
}

/// Reads both pipes as they fill, so that neither can block the child, and asks `watch` for signals to it.
void drain(Pipe& out, Pipe& err, Finished& finished, pid_t child, const std::function<int()>& watch) {
  const int interval = watch ? 200 : -1;  // [ms]
  std::array<pollfd, 2> watched{pollfd{out.ends[0], POLLIN, 0}, pollfd{err.ends[0], POLLIN, 0}};
  std::array<std::string*, 2> sinks{&finished.output, &finished.messages};
  int open = 2;
  while (open > 0) {
    const int ready = poll(watched.data(), watched.size(), interval);
    const int failure = errno;
    if (const int signal = watch ? watch() : 0; signal != 0) kill(child, signal);
    if (ready < 0) {
      if (failure == EINTR) continue;
      throw OutputError(fmt::format("poll: {}", std::strerror(failure)));
    }
    for (std::size_t i = 0; i < watched.size(); ++i) {
      if (watched[i].fd < 0 || watched[i].revents == 0) continue;
      std::array<char, 4096> buffer{};
      const ssize_t count = read(watched[i].fd, buffer.data(), buffer.size());
      if (count > 0) {
        sinks[i]->append(buffer.data(), static_cast<std::size_t>(count));
      } else if (count == 0 || errno != EINTR) {
        watched[i].fd = -1;
        --open;
      }
    }
  }
}

/// A program with its Debian packages, and the part of scripts/setup that installs them.
struct ProgramPackages {
  std::string packages;
  std::string setup{"scripts/setup installs what reports and pictures need"};
};

const std::map<std::string, ProgramPackages> programs{
    {"gnuplot", {"gnuplot-nox"}},
    {"pandoc", {"pandoc"}},
    {"pdflatex", {"texlive-latex-recommended and lmodern"}},
    {"parallel", {"parallel", "scripts/setup --engines installs it"}},
    {"sbatch", {"slurm-client", "scripts/setup --engines installs it with a Slurm of one node"}}};

OutputError cannot_start(const std::string& program, int failure) {
  std::string cure;
  if (failure == ENOENT) {
    const auto known = programs.find(program);
    const ProgramPackages of = known == programs.end() ? ProgramPackages{} : known->second;
    cure = fmt::format(" (is it installed?{} {})",
                       of.packages.empty() ? "" : " Debian's packages: " + of.packages + ";", of.setup);
  }
  return OutputError(fmt::format("{}: cannot be started: {}{}", program, std::strerror(failure), cure));
}

pid_t start(const Command& command, Pipe& out, Pipe& err) {
  std::vector<std::string> arguments{command.program};
  arguments.insert(arguments.end(), command.arguments.begin(), command.arguments.end());
  std::vector<std::string> entries = environment_of(command);

  posix_spawn_file_actions_t actions{};
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, out.ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, err.ends[1], STDERR_FILENO);
  if (!command.folder.empty()) posix_spawn_file_actions_addchdir_np(&actions, command.folder.c_str());
  pid_t child = 0;
  const int failure = posix_spawnp(&child, command.program.c_str(), &actions, nullptr, pointers(arguments).data(),
                                   pointers(entries).data());
  posix_spawn_file_actions_destroy(&actions);
  if (failure == 0) return child;
  if (!command.folder.empty() && !std::filesystem::is_directory(command.folder)) {
    throw OutputError(fmt::format("{}: cannot be started in {}: {}", command.program, command.folder.string(),
                                  std::strerror(failure)));
  }
  throw cannot_start(command.program, failure);
}

}  // namespace

Finished run(const Command& command, const std::function<int()>& watch) {
  Pipe out;
  Pipe err;
  const pid_t child = start(command, out, err);
  out.close_end(1);
  err.close_end(1);
  Finished finished;
  drain(out, err, finished, child, watch);
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) throw OutputError(fmt::format("{}: {}", command.program, std::strerror(errno)));
  }
  finished.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return finished;
}

void demand_program(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::istringstream folders{path != nullptr ? path : ""};
  for (std::string folder; std::getline(folders, folder, ':');)
    if (::access((std::filesystem::path{folder} / name).c_str(), X_OK) == 0) return;
  throw cannot_start(name, ENOENT);
}

Finished run_or_throw(const Command& command, const std::string& purpose) {
  Finished finished = run(command);
  if (finished.status != 0) {
    std::string& message = finished.messages.empty() ? finished.output : finished.messages;
    message.erase(message.find_last_not_of('\n') + 1);
    throw OutputError(
        fmt::format("{} failed on {} (exit status {}):\n{}", command.program, purpose, finished.status, message));
  }
  return finished;
}

}  // namespace talus::reports
