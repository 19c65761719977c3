#pragma once

#include <optional>
#include <string>

#include "solver/base/ids.hpp"
#include "solver/base/vec.hpp"
#include "solver/laws/law_list.hpp"

namespace talus {

/// One end of a cable: a point of a body, or a point fixed in the world when no body is named.
struct CableEnd {
  std::optional<BodyId> body{};
  Vec3 p{};  ///< [L]; in body coordinates (z: the body's position along the fence), or in the world
};

/// A straight cable between two ends.
struct Cable {
  std::string name{};  ///< unique in the model
  CableEnd a{};
  CableEnd b{};
  double rest_length{};  ///< length of zero elongation in the tension law [L] >= 0
  CableLaw law{};
  int multiplicity{1};  ///< number of identical cables that this one represents, by symmetry of the scene
};

}  // namespace talus
