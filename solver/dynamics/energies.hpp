#pragma once

#include "solver/base/vec.hpp"

namespace talus {

/// Mechanical energy of a state, by its form [F L].
struct Energies {
  double kinetic{};
  double gravity{};   ///< potential of the weights, zero at the world's origin
  double applied{};   ///< potential of the constant applied forces: minus their work since the reference positions
  double contacts{};  ///< stored in contact springs
  double cables{};    ///< stored in cables

  double total() const { return kinetic + gravity + applied + contacts + cables; }
};

/// Linear momentum [M L/T], and angular momentum about the world's origin [M L^2/T], of all bodies that can move.
struct Momenta {
  Vec2 linear;
  double angular{};  ///< counter-clockwise > 0
};

}  // namespace talus
