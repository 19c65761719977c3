#pragma once

#include <string>

#include "solver/base/ids.hpp"
#include "solver/base/vec.hpp"

namespace talus {

/// A joint that may break: a point of a body at which one or two cables end. When the resultant of the cable forces in
/// the plane of motion reaches the strength, the cables are detached from the body, and two cables continue as one: a
/// straight line between their far ends with one tension, because the massless point between them moves into
/// equilibrium. (Hardening cables that had different plastic elongations before the break have one tension only as far
/// as their elastic parts of the elongation go.)
struct Hanger {
  std::string name{};  ///< unique in the model
  BodyId body{};
  Vec3 p{};           ///< as the ends of its cables: body coordinates, z the position along the fence [L]
  double strength{};  ///< resultant cable force at which it breaks [F] > 0
};

}  // namespace talus
