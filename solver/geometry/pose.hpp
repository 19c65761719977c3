#pragma once

#include "solver/base/vec.hpp"

namespace talus {

/// A planar rotation, kept as cosine and sine so that they are computed once for a body and an evaluation.
struct Rotation {
  double cosine{1.0};
  double sine{0.0};
};

/// Rotation by `angle` [rad], counter-clockwise > 0. The one place where the solver takes a sine, so that all machines,
/// compilers and build types see the same routine.
[[nodiscard]] Rotation rotation(double angle);

constexpr Vec2 operator*(Rotation r, Vec2 a) { return {r.cosine * a.x - r.sine * a.y, r.sine * a.x + r.cosine * a.y}; }

/// The rotation undone: components of a world vector in the body's frame.
constexpr Vec2 unrotate(Rotation r, Vec2 a) { return {r.cosine * a.x + r.sine * a.y, r.cosine * a.y - r.sine * a.x}; }

/// Where a body B is and how it moves, in the world frame W: its centre of mass and its orientation.
struct Pose {
  Vec2 p_WB;         ///< centre of mass [L]
  Rotation R_WB;     ///< orientation
  Vec2 v_WB;         ///< velocity of the centre of mass [L/T]
  double w_WB{0.0};  ///< angular velocity [rad/T], counter-clockwise > 0
};

/// World position of the point with body coordinates p_BP.
constexpr Vec2 world_point(const Pose& body, Vec2 p_BP) { return body.p_WB + body.R_WB * p_BP; }

/// World velocity of the material point of the body that is now at world position p_WP.
constexpr Vec2 velocity_at(const Pose& body, Vec2 p_WP) { return body.v_WB + cross(body.w_WB, p_WP - body.p_WB); }

}  // namespace talus
