#pragma once

#include "solver/laws/law_list.hpp"
#include "solver/scenes/scene.hpp"

namespace talus::scenes {

/// A disc that falls on a plane, without rotation. The defaults have no gravity: one impact.
struct BouncingDisc {
  double mass{1.0};     ///< [M]
  double radius{1.0};   ///< [L]
  double gap{0.0};      ///< between disc and plane at the start [L]; < 0: overlap
  double speed{1.0};    ///< towards the plane [L/T]
  double gravity{0.0};  ///< downwards [L/T^2]
  ContactLaw contact;
};

/// Names: bodies "disc" (particle) and "plane" (fixed, the x axis), contact "impact". Integrator and plan are left to
/// the caller. Errors: InputError as by ModelBuilder.
[[nodiscard]] Scene bouncing_disc(const BouncingDisc& parameters);

}  // namespace talus::scenes
