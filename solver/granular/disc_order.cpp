#include "solver/granular/disc_order.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace talus {
namespace {

template <class T>
std::vector<T> picked(const std::vector<T>& from, const std::vector<std::size_t>& order) {
  std::vector<T> to;
  to.reserve(from.size());
  for (const std::size_t was : order)
    if (was < from.size()) to.push_back(from[was]);
  return to;
}

}  // namespace

std::vector<std::size_t> order_by_rows(const DiscShapes& shapes, const Discs& discs) {
  const double row = 2.0 * *std::max_element(shapes.radius.begin(), shapes.radius.end());
  std::vector<std::size_t> order(discs.size());
  std::iota(order.begin(), order.end(), std::size_t{});
  const auto key = [&](std::size_t i) {
    return std::tuple{shapes.wall[i], std::floor(discs.y[i] / row), discs.x[i], i};
  };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  return order;
}

DiscShapes reordered(const DiscShapes& shapes, const std::vector<std::size_t>& order) {
  return {.radius = picked(shapes.radius, order),
          .inverse_mass = picked(shapes.inverse_mass, order),
          .wall = picked(shapes.wall, order),
          .walls = shapes.walls};
}

Discs reordered(const Discs& discs, const std::vector<std::size_t>& order) {
  Discs to = discs;
  to.x = picked(discs.x, order), to.y = picked(discs.y, order);
  to.vx = picked(discs.vx, order), to.vy = picked(discs.vy, order);
  to.spin = picked(discs.spin, order);
  return to;
}

}  // namespace talus
