#pragma once

#include "solver/geometry/pose.hpp"
#include "solver/scenes/scene.hpp"

/// The same scene looked at from elsewhere: mirrored, turned, from another place, or in passing.
namespace talus::verification::problems {

/// A point p of the scene is seen at R M p + shift + boost t, M the mirror x -> -x if `mirrored`.
struct Viewpoint {
  bool mirrored{};
  Rotation turn{};  ///< R
  double angle{};   ///< that of R [rad]
  Vec2 shift{};     ///< [L]
  Vec2 boost{};     ///< [L/T]

  [[nodiscard]] Vec2 direction(Vec2 v) const { return turn * (mirrored ? Vec2{-v.x, v.y} : v); }
  [[nodiscard]] Vec2 point(Vec2 p) const { return direction(p) + shift; }
  [[nodiscard]] double sense(double moment) const { return mirrored ? -moment : moment; }
};

/// Turned by a quarter, without a rounding.
inline constexpr Rotation quarter_turn{0.0, 1.0};

/// The model as seen at t = 0. Rails along an axis stay so under quarter turns only: for any other turn the model must
/// have none; a boost is for models without fixed bodies, pins and anchors.
[[nodiscard]] Model seen(Model model, const Viewpoint& view);
/// Coordinates, velocities, work and impulse of a state at its time; memory and modes of friction by resultants with
/// their sense, those of nodes as they are (a mirrored body's nodes have another order).
[[nodiscard]] State seen(const Model& model, State state, const Viewpoint& view);

/// Bodies in the opposite order, all names kept.
[[nodiscard]] Scene with_bodies_reversed(const Scene& scene);
/// A for B in every contact, and the other way round; contacts in the opposite order.
[[nodiscard]] Scene with_contacts_swapped(const Scene& scene);

/// Largest difference of coordinates and velocities of two states.
struct Difference {
  double place{};     ///< [L], angles [rad]
  double velocity{};  ///< [L/T], [rad/T]
};
[[nodiscard]] Difference difference(const State& one, const State& other);

/// Coordinates and velocities that are not the same to the last bit.
[[nodiscard]] int differing_motion(const State& one, const State& other);

}  // namespace talus::verification::problems
