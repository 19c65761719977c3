/// talus: the solver's command line.

#include <fcntl.h>
#include <unistd.h>

#include <csignal>

#include "solver/app/command.hpp"

namespace {

/// Takes the numbers of standard streams that are closed, or a file that is opened would get one of them, and with it
/// what is printed. Reading and writing them fails as before.
void occupy_closed_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(stream, F_GETFD) < 0) ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

}  // namespace

int main(int count, char** arguments) {
  occupy_closed_streams();
  // A limit on the size of files is an error of the write, with a message and nothing left behind, not the end of the
  // program.
  std::signal(SIGXFSZ, SIG_IGN);
  return talus::app::run_command_line(count, arguments);
}
