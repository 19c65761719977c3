#include "solver/stability/inertia_bound.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <variant>

namespace talus {
namespace {

constexpr double rounded_input = 1e-3;

/// The maximum of x^2 + y^2 on |x/a|^n + |y/b|^n = 1. For n > 2 it is between the axes: R^2 = (a^2q + b^2q)^(1/q) with
/// q = n/(n - 2), by Hoelder's inequality; else at the end of the longer axis.
double largest_distance_of(const Superquadric& shape) {
  const double longer = std::max(shape.half_width, shape.half_height);
  if (!(shape.exponent > 2.0)) return longer;
  const double ratio = std::min(shape.half_width, shape.half_height) / longer;
  const double twice_q = 2.0 * shape.exponent / (shape.exponent - 2.0);
  return longer * power(1.0 + power(ratio, twice_q), 1.0 / twice_q);
}

}  // namespace

double largest_distance(const Shape& shape) {
  return std::visit(
      []<class S>(const S& of) {
        if constexpr (std::is_same_v<S, Circle>) return of.radius;
        if constexpr (std::is_same_v<S, Rectangle>) return std::hypot(of.half_width, of.half_height);
        if constexpr (std::is_same_v<S, Superquadric>) return largest_distance_of(of);
        return std::numeric_limits<double>::infinity();
      },
      shape);
}

double inertia_bound(const Body& body) {
  const double distance = largest_distance(body.shape);
  return body.mass * distance * distance;
}

std::string inertia_warning(const Model& model) {
  const Body* worst = nullptr;
  double largest = 1.0 + rounded_input;
  std::size_t count = 0;
  for (const Body& body : model.bodies) {
    if (!turns(body.mobility)) continue;
    const double ratio = body.inertia / inertia_bound(body);
    if (!(ratio > 1.0 + rounded_input)) continue;
    ++count;
    if (ratio > largest) worst = &body, largest = ratio;
  }
  if (worst == nullptr) return "";
  const std::string unit = symbol(model.units, dimension::inertia);
  const std::string others = count == 1   ? ""
                             : count == 2 ? "; so is that of 1 more body"
                                          : fmt::format("; so is that of {} more bodies", count - 1);
  return fmt::format(
      "body '{}': its moment of inertia, {:.4g} {}, is more than m R^2 = {:.4g} {}, that of its mass, {:.4g} {}, at "
      "the largest distance of its outline from the centre of mass, {:.4g} {}{}",
      worst->name, worst->inertia, unit, inertia_bound(*worst), unit, worst->mass, symbol(model.units, dimension::mass),
      largest_distance(worst->shape), symbol(model.units, dimension::length), others);
}

}  // namespace talus
