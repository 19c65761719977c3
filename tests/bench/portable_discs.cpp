/// The elastic gas by an engine that is compiled once for every processor. Arguments: columns rows solid_fraction
/// steps.
#include <fmt/format.h>

#include <string>

#include "tests/bench/disc_gas.hpp"

int main(int argc, char** argv) {
  if (argc != 5) return 2;
  const auto run =
      talus::bench::run_gas(std::stoul(argv[1]), std::stoul(argv[2]), std::stod(argv[3]), std::stol(argv[4]));
  fmt::print("{} {}\n", run.nanoseconds, run.bits);
}
