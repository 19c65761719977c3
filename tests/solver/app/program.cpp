#include "tests/solver/app/program.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <boost/process/args.hpp>
#include <boost/process/child.hpp>
#include <boost/process/env.hpp>
#include <boost/process/environment.hpp>
#include <boost/process/posix.hpp>
#include <cerrno>
#include <csignal>
#include <system_error>

namespace {

namespace bp = boost::process;

/// A file opened for appending; O_NOCTTY prevents it from becoming the controlling terminal of the test.
struct Sink {
  int descriptor;
  explicit Sink(const fs::path& file)
      : descriptor{::open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC | O_NOCTTY, 0600)} {
    if (descriptor < 0) throw std::system_error{errno, std::system_category(), file.string()};
  }
  ~Sink() { ::close(descriptor); }
  Sink(const Sink&) = delete;
  Sink& operator=(const Sink&) = delete;
};

}  // namespace

struct StartedProgram::Child {
  bp::child process;
};

StartedProgram::StartedProgram(const std::string& program, const std::vector<std::string>& arguments,
                               const Streams& streams, const std::map<std::string, std::string>& environment) {
  const Sink out{streams.out}, err{streams.err};
  bp::environment variables = boost::this_process::environment();
  for (const auto& [name, value] : environment)
    variables[name] = value;
  child_ = std::make_unique<Child>(
      Child{bp::child{program, bp::args(arguments), variables, bp::posix::fd.bind(STDOUT_FILENO, out.descriptor),
                      bp::posix::fd.bind(STDERR_FILENO, err.descriptor)}});
}

// The destructor of the child kills it unless it was waited for.
StartedProgram::~StartedProgram() = default;

void StartedProgram::send(int signal) const { BOOST_REQUIRE(::kill(child_->process.id(), signal) == 0); }

bool StartedProgram::is_running() { return child_->process.running(); }

int StartedProgram::wait() {
  child_->process.wait();
  return child_->process.native_exit_code();
}

int StartedProgram::exit_code() {
  const int status = wait();
  BOOST_REQUIRE(WIFEXITED(status));
  return WEXITSTATUS(status);
}

Ended ran(const std::string& program, const std::vector<std::string>& arguments, const std::string& stdout_to,
          const char* path) {
  const Folder folder;
  const Streams streams{stdout_to.empty() ? folder.path / "out" : fs::path{stdout_to}, folder.path / "err"};
  std::map<std::string, std::string> environment;
  if (path != nullptr) environment["PATH"] = path;
  const int code = StartedProgram{program, arguments, streams, environment}.exit_code();
  return {code, stdout_to.empty() ? talus::read_text(streams.out) : "", talus::read_text(streams.err)};
}
