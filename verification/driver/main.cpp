#include "verification/driver/catalogue.hpp"
#include "verification/driver/command.hpp"

int main(int argc, char** argv) { return talus::verification::verify(talus::verification::catalogue(), argc, argv); }
