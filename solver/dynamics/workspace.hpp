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

/// A point of a body, or of the world, at which cables end.
struct JointPoint {
  Vec2 p_WP;   ///< [L]
  Vec2 arm;    ///< from the body's centre of mass [L]
  Vec2 v_WP;   ///< [L/T]
  Vec2 force;  ///< sum of the pulls of all cables that end here [F]
};

/// Scratch of one force evaluation, kept by the caller so that a step allocates nothing and Dynamics stays pure.
struct Workspace {
  std::vector<Pose> poses;         ///< one for each body
  std::vector<Wrench> wrenches;    ///< one for each body
  std::vector<JointPoint> joints;  ///< one for each joint
  std::vector<Path> paths;         ///< one for each cable
  std::vector<Gap> gaps;           ///< one for each law instance of the contacts that is near
  std::vector<double> rates;       ///< their depth rates [L/T]
  std::vector<char> near;          ///< one for each pair of the contact search: whether its gaps were worked out
};

}  // namespace talus
