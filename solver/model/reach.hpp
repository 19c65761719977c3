#pragma once

#include <string>

#include "solver/geometry/shape.hpp"
#include "solver/model/contact.hpp"

namespace talus {

/// Why a law that acts between surfaces apart cannot act between these outlines: their gap function is no distance
/// there. Empty: it can. At least one of the shapes has an outline that moves.
[[nodiscard]] std::string objection_to_reach(ContactMethod method, NodeDepth node_depth, const Shape& a,
                                             const Shape& b);

}  // namespace talus
