#pragma once

#include <functional>

#include "solver/scenes/scene.hpp"

namespace talus {

/// The scene with another damping of one contact [F T/L]. Errors: InputError if its law has none.
[[nodiscard]] Scene with_damping(Scene scene, ContactId contact, double damping);

/// What one simulated impact did.
struct Impact {
  double restitution{};      ///< speed of separation over speed of approach along the normal
  double contact_time{};     ///< from the last step apart to the first step at which the law no longer acts [T]
  double largest_overlap{};  ///< [L]
  double largest_force{};    ///< [F]
  double least_force{};      ///< [F]; < 0 where the contact pulled
};

/// Simulates a particle of the effective mass that meets a fixed plane at the given speed, by the solver itself.
/// `phase` in [0, 1] says where between two steps the surfaces meet. Errors: InputError if the contact does not end, or
/// for a law that does not know its impacts in closed form (laws/law.hpp).
[[nodiscard]] Impact simulate_impact(const ContactLaw& law, double effective_mass, double speed, double step,
                                     double phase, const Integrator& integrator);

/// A step at which the simulated restitution is as good as asked for.
struct ImpactStep {
  double step{};           ///< [T]
  double restitution{};    ///< mean over the phases at which surfaces can meet and part within a step
  double largest_error{};  ///< of the restitution over those phases, against the closed form
};

/// Finds a step, of the form contact time/(2^n + 0.38), that keeps the error of e below `bound` at whatever phases the
/// surfaces meet and part: the largest error of 64 pairs of phases is at most .8 of the bound.
/// Errors: InputError if bound is not > 0, or too small to be reached with 2^18 steps in a contact; for a law as above.
[[nodiscard]] ImpactStep advise_impact_step(const ContactLaw& law, double effective_mass, double bound,
                                            const Integrator& integrator);

/// Restitution of the first impact of one contact of a scene, simulated by the scene's own method and step: speed of
/// separation at the first step after the contact, over speed of approach at the last step before it.
/// Errors: InputError if the bodies do not meet or do not part before the scene's end.
[[nodiscard]] Impact simulate_impact(const Scene& scene, ContactId contact);

/// A calibrated contact of a scene.
struct Calibration {
  double damping{};      ///< c that gives the wanted restitution [F T/L]
  double restitution{};  ///< as simulated with it
  int runs{};            ///< simulations taken
};

/// Finds the damping of one contact of a scene that gives its first impact the restitution e, by simulation between a
/// bracket: no damping, and damping doubled until the restitution is below e.
/// Errors: InputError for e outside (0, 1], or when the undamped scene itself stays below e: the rest is lost
/// elsewhere.
[[nodiscard]] Calibration calibrate(const Scene& scene, ContactId contact, double e, double tolerance = 1e-6);

}  // namespace talus
