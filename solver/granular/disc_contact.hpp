#pragma once

#include <cstddef>

#include "solver/base/vec.hpp"

namespace talus {

/// Two discs that touch, as they stand.
struct DiscContact {
  std::size_t a{}, b{};
  double depth{};     ///< [L]
  Vec2 n_ab;          ///< unit normal from a to b
  double distance{};  ///< of the centres [L]
  double force{};     ///< [F], > 0 pushes apart
  double friction{};  ///< force on a along the normal turned counter-clockwise, on b the opposite [F]
  double stored{};    ///< energy [F L]

  /// On b, and the opposite on a [F].
  Vec2 force_on_b() const { return force * n_ab - friction * cross(1.0, n_ab); }
};

}  // namespace talus
