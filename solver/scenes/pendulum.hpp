#pragma once

#include "solver/scenes/scene.hpp"

namespace talus::scenes {

/// A rigid pendulum: a pinned body whose centre of mass is `arm` below the pin at rest (angle 0).
struct Pendulum {
  double mass{1.0};      ///< [M]
  double inertia{0.25};  ///< about the centre of mass [M L^2]
  double arm{1.0};       ///< pin to centre of mass [L]
  double gravity{9.81};  ///< downwards [L/T^2]
  double amplitude{};    ///< angle at the start, at rest [rad]
  double spin{};         ///< angular velocity at the start [rad/T]
};

/// Scene with body "bob"; the pin is at the origin. The caller sets integrator and plan.
[[nodiscard]] Scene pendulum(const Pendulum& parameters);

/// Angular frequency of small oscillations w0 = sqrt(m g a/(I + m a^2)) [rad/T].
[[nodiscard]] double small_swing_frequency(const Pendulum& parameters);

/// A particle suspended from the origin by a cable; approaches the rigid pendulum as the cable's stiffness grows.
struct CablePendulum {
  double mass{1.0};       ///< [M]
  double length{1.0};     ///< of the cable, unstretched [L]
  double stiffness{1e4};  ///< of the cable [F/L]
  double gravity{9.81};   ///< downwards [L/T^2]
  double amplitude{0.5};  ///< initial angle of the cable [rad], at rest, with the elongation m g cos(amplitude)/k due
                          ///< to the weight there
};

/// Scene with body "bob" (particle) and cable "cable". The caller sets integrator and plan.
[[nodiscard]] Scene cable_pendulum(const CablePendulum& parameters);

}  // namespace talus::scenes
