#pragma once

#include "solver/laws/law_list.hpp"
#include "solver/scenes/scene.hpp"

namespace talus::scenes {

/// A disc that falls on a plane without rotating. The defaults have no gravity: a single impact.
struct BouncingDisc {
  double mass{1.0};     ///< [M]
  double radius{1.0};   ///< [L]
  double gap{0.0};      ///< between disc and plane at the start [L]; < 0: overlap
  double speed{1.0};    ///< towards the plane [L/T]
  double gravity{0.0};  ///< downwards [L/T^2]
  ContactLaw contact;
};

/// Scene with bodies "disc" (particle) and "plane" (fixed, the x axis) and contact "impact". The caller sets integrator
/// and plan. Errors: InputError as by ModelBuilder.
[[nodiscard]] Scene bouncing_disc(const BouncingDisc& parameters);

}  // namespace talus::scenes
