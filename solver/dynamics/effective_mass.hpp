#pragma once

#include <vector>

#include "solver/geometry/pose.hpp"
#include "solver/model/model.hpp"

namespace talus {

/// A point of a body, and a direction in which an impulse acts there.
struct ImpulseLine {
  Vec2 p_WP;  ///< world [L]
  Vec2 n;     ///< unit vector, world
};

/// Velocities of points of bodies for unit impulses: the kinematics from which effective masses follow.
class PointMobility {
 public:
  explicit PointMobility(const Model& model);

  /// Velocity [L/T] of the body's point on the first line, along it, for a unit impulse [M L/T] on the second line
  /// [1/M]: n_1^T J_1 M^-1 J_2^T n_2 over the body's coordinates in its present pose. Symmetric; 0 for a fixed body.
  [[nodiscard]] double between(BodyId body, const Pose& pose, const ImpulseLine& one, const ImpulseLine& two) const;

 private:
  struct Compiled {
    Mobility mobility{};
    double mass{};
    double inertia{};  ///< about the centre of mass [M L^2]
    Vec2 p_BPin;
  };
  std::vector<Compiled> bodies_;
};

}  // namespace talus
