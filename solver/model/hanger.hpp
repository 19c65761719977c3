#pragma once

#include <string>

#include "solver/base/ids.hpp"
#include "solver/base/vec.hpp"

namespace talus {

/// A joint that may break: the point of a body at which one or two cables end. When the sum of their pulls in the plane
/// of motion passes the strength the body loses them, and two cables go on as one: straight from the far end of one to
/// that of the other, with one tension, as the massless point between them slides into balance. (Cables that harden
/// and were drawn out unequally before have it only as far as their elastic shares of a stretch go.)
struct Hanger {
  std::string name{};  ///< unique in the model
  BodyId body{};
  Vec3 p{};           ///< as in the ends of its cables: body coordinates, z the place along the fence [L]
  double strength{};  ///< pull at which it breaks [F] > 0
};

}  // namespace talus
