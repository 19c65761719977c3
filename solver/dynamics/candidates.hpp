#pragma once

#include <cstddef>

#include "solver/base/ids.hpp"
#include "solver/geometry/pose.hpp"
#include "solver/geometry/shape.hpp"

namespace talus {

/// A box around a shape, sides along the body's axes; around a circle it does not turn.
struct Bounds {
  double half_width{};   ///< [L]
  double half_height{};  ///< [L]
  bool round{};
  bool plane{};  ///< a half-plane: no box, all that lies below the body's x axis
};

[[nodiscard]] Bounds bounds(const Shape& shape);

/// Two bodies that may touch, and their law instances in the state.
struct Candidate {
  BodyId a{};
  BodyId b{};
  Bounds bounds_a;
  Bounds bounds_b;
  std::size_t first{};  ///< first mode slot of the contact
  std::size_t last{};   ///< one past its last
};

/// Whether a side of one of the boxes separates the two shapes (a half-plane: whether the other's box lies above it).
/// Never says so of bodies that touch.
[[nodiscard]] bool out_of_reach(const Candidate& pair, const Pose& A, const Pose& B);

}  // namespace talus
