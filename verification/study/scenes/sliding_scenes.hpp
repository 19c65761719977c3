#pragma once

#include "solver/scenes/scene.hpp"
#include "verification/reference/friction/dragged_slider.hpp"
#include "verification/reference/friction/oblique_impact.hpp"

/// Scenes of the case `friction`: a disc or a particle on a plane, as described by the references.
namespace talus::verification::problems {

/// A disc (mobility 3) or a particle (mobility 1) that touches the plane y = 0 at t = 0, moving down and to the right,
/// without gravity. Bodies "disc" and "plane", contact "impact". Integrator and plan are set by the caller.
[[nodiscard]] Scene oblique_scene(const reference::ObliqueImpact& impact, EndRule end);

/// Radius of that disc, in units of the largest overlap: the arm of the friction, r - d/2, then equals r to 1e-7.
inline constexpr double oblique_radius = 4e6;

/// A body that rests on a plane with N = k_n d and is dragged along x by a constant force m a: gravity on a slope.
struct Slope {
  bool rolls{};               ///< a disc; otherwise a particle
  double angle{};             ///< [rad]
  double friction{};          ///< mu
  double normal_stiffness{};  ///< k_n
  double slip_stiffness{};    ///< k_s
  double speed{};             ///< of the centre along the plane at t = 0
  bool preloaded{};           ///< the spring starts with its stretch of steady sticking, or of slip if the body moves
};

inline constexpr double slope_gravity = 10.0;
inline constexpr double slope_mass = 2.0;
inline constexpr double slope_radius = 0.5;

/// Reference problem for the slope. The disc rolls on r - d/2, where friction acts.
[[nodiscard]] reference::DraggedSlider dragged_slider(const Slope& slope);

/// Scene of the slope; coordinates as above.
[[nodiscard]] Scene slope_scene(const Slope& slope);

}  // namespace talus::verification::problems
