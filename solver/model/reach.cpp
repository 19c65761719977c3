#include "solver/model/reach.hpp"

#include <fmt/format.h>

#include <variant>

namespace talus {

std::string reach_error(ContactMethod method, NodeDepth node_depth, const Shape& a, const Shape& b) {
  constexpr std::string_view is_no_distance = "is no distance between outlines that are apart";
  if (method == ContactMethod::nodes) {
    if (node_depth == NodeDepth::nearest) return {};
    return fmt::format("it acts at a distance, and the depth of nodes by '{}' {}; node_depth must be '{}'",
                       name_of(node_depth), is_no_distance, name_of(NodeDepth::nearest));
  }
  if (!std::holds_alternative<Rectangle>(a) || !std::holds_alternative<Rectangle>(b)) return {};
  return fmt::format(
      "it acts at a distance, and the gap of a rectangle and a rectangle {}; give a superquadric, or "
      "contact by nodes",
      is_no_distance);
}

}  // namespace talus
