#pragma once

#include "solver/scenes/scene.hpp"

namespace talus::scenes {

/// A rigid pendulum: a pinned body with its centre of mass `arm` below the pin when it hangs at rest (angle 0).
struct Pendulum {
  double mass{1.0};      ///< [M]
  double inertia{0.25};  ///< about the centre of mass [M L^2]
  double arm{1.0};       ///< pin to centre of mass [L]
  double gravity{9.81};  ///< downwards [L/T^2]
  double amplitude{};    ///< angle at the start, at rest [rad]
  double spin{};         ///< angular velocity at the start [rad/T]
};

/// Name: body "bob"; the pin is at the origin. Integrator and plan are left to the caller.
[[nodiscard]] Scene pendulum(const Pendulum& parameters);

/// Frequency of small swings w0 = sqrt(m g a/(I + m a^2)) [rad/T].
[[nodiscard]] double small_swing_frequency(const Pendulum& parameters);

/// A particle hung from the origin by a cable: the rigid pendulum's limit as the cable's stiffness grows.
struct CablePendulum {
  double mass{1.0};       ///< [M]
  double length{1.0};     ///< of the cable, unstretched [L]
  double stiffness{1e4};  ///< of the cable [F/L]
  double gravity{9.81};   ///< downwards [L/T^2]
  double amplitude{0.5};  ///< angle of the cable at the start [rad], from rest, with the stretch m g cos(amplitude)/k
                          ///< that the weight gives it there
};

/// Names: body "bob" (particle), cable "cable". Integrator and plan are left to the caller.
[[nodiscard]] Scene cable_pendulum(const CablePendulum& parameters);

}  // namespace talus::scenes
