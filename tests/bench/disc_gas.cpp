#include "tests/bench/disc_gas.hpp"

#include <bit>
#include <cmath>
#include <ctime>
#include <numbers>
#include <random>

#include "solver/granular/fast_disc_system.hpp"
#include "solver/granular/list_skin.hpp"

namespace talus::bench {

DiscGas lattice(std::size_t columns, std::size_t rows, double solid_fraction) {
  const double apart = std::sqrt(std::numbers::pi / (2.0 * std::numbers::sqrt3 * solid_fraction));
  const double up = 0.5 * std::numbers::sqrt3 * apart;
  DiscGas gas;
  gas.box = {.width = apart * static_cast<double>(columns), .height = up * static_cast<double>(rows)};
  std::mt19937_64 random{1};
  std::normal_distribution<double> speed{0.0, 0.0014};
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      const double x = apart * (static_cast<double>(column) + (row % 2 == 0 ? 0.25 : 0.75));
      gas.shapes.add(0.5, 1.0);
      gas.discs.add(x - 0.5 * gas.box.width, up * (static_cast<double>(row) + 0.5) - 0.5 * gas.box.height,
                    speed(random), speed(random));
    }
  }
  return gas;
}

GasRun run_gas(std::size_t columns, std::size_t rows, double solid_fraction, long steps) {
  DiscGas gas = lattice(columns, rows, solid_fraction);
  FastDiscSystem system{gas.shapes, gas.box, elastic, list_skin(gas.discs.size(), solid_fraction)};
  system.begin(gas.discs);
  system.advance(gas.discs, gas_step, 1000);
  const std::clock_t start = std::clock();
  system.advance(gas.discs, gas_step, steps);
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  GasRun run{.nanoseconds = 1e9 * seconds / static_cast<double>(steps) / static_cast<double>(gas.discs.size())};
  for (const auto* numbers : {&gas.discs.x, &gas.discs.y, &gas.discs.vx, &gas.discs.vy}) {
    for (const double number : *numbers)
      run.bits = (run.bits ^ std::bit_cast<std::uint64_t>(number)) * 0x100000001b3U;
  }
  return run;
}

}  // namespace talus::bench
