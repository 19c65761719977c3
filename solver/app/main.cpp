/// talus: the solver's command line.

#include <csignal>

#include "solver/app/command.hpp"

int main(int count, char** arguments) {
  // A limit on the size of files is an error of the write, with a message and nothing left behind, not the end of the
  // program.
  std::signal(SIGXFSZ, SIG_IGN);
  return talus::app::run_command_line(count, arguments);
}
