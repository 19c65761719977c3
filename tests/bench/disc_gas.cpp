#include "tests/bench/disc_gas.hpp"

#include <cmath>
#include <numbers>
#include <random>

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

}  // namespace talus::bench
