/// talus: the solver's command line.

#include "solver/app/command.hpp"

int main(int count, char** arguments) { return talus::app::run_command_line(count, arguments); }
