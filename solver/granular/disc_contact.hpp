#pragma once

#include <cstddef>

#include "solver/base/vec.hpp"

namespace talus {

/// Two discs in contact, at their present positions.
struct DiscContact {
  std::size_t a{}, b{};
  double depth{};     ///< overlap [L]
  Vec2 n_ab;          ///< unit normal from a to b
  double distance{};  ///< between the centres [L]
  double force{};     ///< normal force [F], > 0: repulsive
  double friction{};  ///< force on a along the normal turned counter-clockwise, on b the opposite [F]
  double stored{};    ///< energy [F L]

  /// Force on b [F]; that on a is the opposite.
  Vec2 force_on_b() const { return force * n_ab - friction * cross(1.0, n_ab); }
};

}  // namespace talus
