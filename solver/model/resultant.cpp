#include "solver/model/resultant.hpp"

#include <fmt/format.h>

namespace talus {
namespace {

bool is_blunt(const Shape& shape) {
  const auto* outline = std::get_if<Superquadric>(&shape);
  return outline && outline->exponent > largest_rocking_exponent;
}

bool has_flat_sides(const Shape& shape) {
  return is_blunt(shape) || std::holds_alternative<Rectangle>(shape) || std::holds_alternative<HalfPlane>(shape) ||
         std::holds_alternative<Terrain>(shape);
}

}  // namespace

std::string resultant_error(const Shape& a, const Shape& b) {
  if ((!is_blunt(a) && !is_blunt(b)) || !has_flat_sides(a) || !has_flat_sides(b)) return {};
  const Superquadric& blunt = std::get<Superquadric>(is_blunt(a) ? a : b);
  return fmt::format(
      "found a superquadric of exponent {:g} on a {}: one resultant has no position on sides that are flat; give a "
      "rectangle, an exponent of at most {:g}, or contact by nodes",
      blunt.exponent, std::visit([](const auto& shape) { return shape.name; }, is_blunt(a) ? b : a),
      largest_rocking_exponent);
}

}  // namespace talus
