#pragma once

#include <vector>

#include "solver/base/vec.hpp"
#include "solver/geometry/gap.hpp"
#include "solver/geometry/path.hpp"
#include "solver/geometry/pose.hpp"

namespace talus {

/// Force and moment on a body about its centre of mass, world components.
struct Wrench {
  Vec2 force;       ///< [F]
  double moment{};  ///< [F L], counter-clockwise > 0
};

/// Scratch of one force evaluation, kept by the caller so that a step allocates nothing and Dynamics stays pure.
struct Workspace {
  std::vector<Pose> poses;       ///< one for each body
  std::vector<Wrench> wrenches;  ///< one for each body
  std::vector<Gap> gaps;         ///< one for each law instance of the contacts
  std::vector<double> rates;     ///< their depth rates [L/T]
  std::vector<Path> paths;       ///< one for each cable
};

}  // namespace talus
