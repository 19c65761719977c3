#include "solver/app/sweep/design.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/random/sobol.hpp>
#include <cmath>
#include <exception>
#include <numeric>
#include <random>
#include <utility>

#include "solver/base/error.hpp"

namespace talus::app {
namespace {

using Generator = std::mt19937_64;

/// A whole number below `count`, without bias.
std::size_t below(std::size_t count, Generator& generator) {
  const std::uint64_t excess = (~std::uint64_t{0} % count + 1) % count;
  for (;;) {
    const std::uint64_t bits = generator();
    if (bits <= ~std::uint64_t{0} - excess) return bits % count;
  }
}

void fill_sobol(std::vector<std::vector<double>>& points, std::size_t axes, Generator& generator) {
  std::vector<std::uint64_t> shifts;
  for (std::size_t axis = 0; axis < axes; ++axis)
    shifts.push_back(generator());
  try {
    boost::random::sobol sequence{axes};
    bool is_first = true;
    for (std::vector<double>& point : points) {
      // The library leaves out the first point, zero, without which no 2^k points are evenly spread.
      for (std::size_t axis = 0; axis < axes; ++axis)
        point[axis] = unit_number((is_first ? 0 : sequence()) ^ shifts[axis]);
      is_first = false;
    }
  } catch (const std::exception&) {  // 3667 with the library's table
    throw InputError{fmt::format("design: kind: found \"sobol\" of {} axes; choose latin_hypercube or random", axes)};
  }
}

void fill_latin_hypercube(std::vector<std::vector<double>>& points, std::size_t axes, Generator& generator) {
  const std::size_t runs = points.size();
  std::vector<std::size_t> parts(runs);
  for (std::size_t axis = 0; axis < axes; ++axis) {
    std::iota(parts.begin(), parts.end(), std::size_t{0});
    for (std::size_t i = runs; i > 1; --i)
      std::swap(parts[i - 1], parts[below(i, generator)]);
    for (std::size_t run = 0; run < runs; ++run) {
      const double point = (static_cast<double>(parts[run]) + unit_number(generator())) / static_cast<double>(runs);
      points[run][axis] = std::min(point, std::nextafter(1.0, 0.0));
    }
  }
}

}  // namespace

double unit_number(std::uint64_t bits) { return std::ldexp(static_cast<double>(bits >> 11U), -53); }

std::vector<std::vector<double>> design_points(const Design& design, std::size_t axes) {
  std::vector<std::vector<double>> points(static_cast<std::size_t>(design.runs), std::vector<double>(axes));
  Generator generator{static_cast<std::uint64_t>(design.seed)};
  switch (design.kind) {
    case DesignKind::sobol:
      fill_sobol(points, axes, generator);
      break;
    case DesignKind::latin_hypercube:
      fill_latin_hypercube(points, axes, generator);
      break;
    case DesignKind::random:
      for (std::vector<double>& point : points) {
        for (double& coordinate : point)
          coordinate = unit_number(generator());
      }
      break;
    case DesignKind::grid:
      TALUS_DEMAND(false);
  }
  return points;
}

}  // namespace talus::app
