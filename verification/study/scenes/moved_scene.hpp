#pragma once

#include "solver/geometry/pose.hpp"
#include "solver/scenes/scene.hpp"

/// The same scene in another frame: mirrored, turned, shifted, or moving at constant velocity.
namespace talus::verification::problems {

/// Frame in which a point p of the scene is at R M p + shift + boost t, M the mirror x -> -x if `mirrored`.
struct Viewpoint {
  bool mirrored{};
  Rotation turn{};  ///< R
  double angle{};   ///< angle of R [rad]
  Vec2 shift{};     ///< [L]
  Vec2 boost{};     ///< [L/T]

  [[nodiscard]] Vec2 direction(Vec2 v) const { return turn * (mirrored ? Vec2{-v.x, v.y} : v); }
  [[nodiscard]] Vec2 point(Vec2 p) const { return direction(p) + shift; }
  [[nodiscard]] double sense(double moment) const { return mirrored ? -moment : moment; }
};

/// Turn by a quarter, without rounding.
inline constexpr Rotation quarter_turn{0.0, 1.0};

/// The model in the other frame at t = 0. Rails along an axis remain so only under quarter turns: for any other turn
/// the model must have none; a boost requires a model without fixed bodies, pins and anchors.
[[nodiscard]] Model seen(Model model, const Viewpoint& view);
/// Coordinates, velocities, work and impulse of a state at its time. Stretch and modes of friction are transformed with
/// their sign for resultant contacts, and left unchanged for nodal ones (a mirrored body has another order of nodes).
[[nodiscard]] State seen(const Model& model, State state, const Viewpoint& view);

/// The scene with its bodies in the opposite order, all names unchanged.
[[nodiscard]] Scene with_bodies_reversed(const Scene& scene);
/// The scene with A and B exchanged in every contact, and contacts in the opposite order.
[[nodiscard]] Scene with_contacts_swapped(const Scene& scene);

/// Largest difference of coordinates and velocities of two states.
struct Difference {
  double position{};  ///< [L], angles [rad]
  double velocity{};  ///< [L/T], [rad/T]
};
[[nodiscard]] Difference difference(const State& one, const State& other);

/// Number of coordinates and velocities that differ in any bit.
[[nodiscard]] int differing_motion(const State& one, const State& other);

}  // namespace talus::verification::problems
