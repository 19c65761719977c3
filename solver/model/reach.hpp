#pragma once

#include <string>

#include "solver/geometry/shape.hpp"
#include "solver/model/contact.hpp"

namespace talus {

/// Reason why a law that acts between surfaces apart cannot act between these outlines: their gap function is not a
/// distance there. Empty if it can. At least one of the shapes must be able to move.
[[nodiscard]] std::string reach_error(ContactMethod method, NodeDepth node_depth, const Shape& a, const Shape& b);

}  // namespace talus
