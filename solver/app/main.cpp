/// talus: the solver's command line.

#include <fcntl.h>
#include <unistd.h>

#include <csignal>

#include "solver/app/command.hpp"

namespace {

/// Occupies the descriptors of closed standard streams; otherwise a file opened later would get one of them, and
/// receive the printed output. Reading from and writing to these streams still fails.
void occupy_closed_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(stream, F_GETFD) < 0) ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

}  // namespace

int main(int count, char** arguments) {
  occupy_closed_streams();
  // Exceeding a file size limit then is a write error with a message and clean-up, instead of ending the program.
  std::signal(SIGXFSZ, SIG_IGN);
  return talus::app::run_command_line(count, arguments);
}
