#pragma once

#include <functional>
#include "solver/calibrate/impact_step.hpp"
#include "solver/scenes/scene.hpp"

namespace talus {

/// Returns the law with another value of the parameter by which it dissipates: `damping` [F T/L] or `hysteresis` [T/L].
/// Errors: InputError if it has none.
[[nodiscard]] ContactLaw with_dissipation(ContactLaw law, double value);
/// Returns the scene with another value of that parameter of one contact. Errors: as above.
[[nodiscard]] Scene with_dissipation(Scene scene, ContactId contact, double value);

/// Properties of an impact in closed form.
struct KnownImpact {
  double contact_time{};  ///< [T]; infinite if the contact does not end
  double restitution{};
  double largest_overlap{};  ///< [L]
};
/// The impact of a particle of the effective mass on a fixed plane. Errors: InputError for a law without closed-form
/// impacts (laws/law.hpp).
[[nodiscard]] KnownImpact known_impact(const ContactLaw& law, double effective_mass, double speed);

/// Results of one simulated impact.
struct Impact {
  double restitution{};      ///< speed of separation over speed of approach along the normal
  double approach_speed{};   ///< along the normal [L/T]
  double contact_time{};     ///< from the last step before contact to the first after the last at which the law acts
                             ///< [T]
  double largest_overlap{};  ///< [L]
  double largest_force{};    ///< [F]
  double minimum_force{};    ///< minimum [F]; < 0 if the contact pulled
};

/// Simulates, with the solver itself, the impact of a particle of the effective mass on a fixed plane at the given
/// speed. `phase` in [0, 1]: the fraction of a step at which the surfaces meet. Errors: InputError if the contact does
/// not end, or for a law without closed-form impacts (laws/law.hpp).
[[nodiscard]] Impact simulate_impact(const ContactLaw& law, double effective_mass, double speed, double step,
                                     double phase, const Integrator& integrator);

/// Error of the restitution of such impacts, against the closed form. Errors: InputError for a law as above,
/// and as demand_closed_form().
[[nodiscard]] ImpactError restitution_error(const ContactLaw& law, double effective_mass, double speed,
                                            const Integrator& integrator);

/// A step at which the simulated restitution is as accurate as required.
struct ImpactStep {
  double step{};           ///< [T]
  double restitution{};    ///< mean over the phases at which surfaces can meet and part within a step
  double largest_error{};  ///< upper estimate of the error of the restitution over those phases (StepOfImpact)
};

/// Finds a step, of the form contact time/(2^n + 0.38), at which the error of e of impacts at this speed is below
/// `bound` for all phases at which the surfaces meet and part: the largest error of 64 pairs of phases is at most 0.8
/// of the bound.
/// Errors: InputError if bound is not > 0, or too small to be reached with 2^18 steps in a contact; for a law as above.
[[nodiscard]] ImpactStep advise_impact_step(const ContactLaw& law, double effective_mass, double speed, double bound,
                                            const Integrator& integrator);

/// Simulates the first impact of one contact of a scene with the scene's method and step. Restitution is, as in
/// ImpactLog, the speed of separation at the first step after the surfaces have parted over the speed of approach at
/// the last step before the contact: a clamped force ends earlier, and from then on weights change the speed.
/// Errors: InputError if the bodies do not meet or do not part before the scene's end.
[[nodiscard]] Impact simulate_impact(const Scene& scene, ContactId contact);

/// Result of calibrating a contact of a scene.
struct Calibration {
  double dissipation{};  ///< `damping` [F T/L] or `hysteresis` [T/L] that gives the required restitution
  Impact impact;         ///< simulated with that value, which is the nearest of all to the restitution
  int runs{};            ///< number of simulations
};

/// Error of the restitution at which a calibration ends.
inline constexpr double restitution_tolerance = 1e-6;

/// Finds the damping or hysteresis of one contact of a scene that gives its first impact the restitution e, by
/// simulations within a bracket: none, and a value doubled until the restitution is below e.
/// Errors: InputError for e outside (0, 1], or if the undamped scene is already below e: the remaining loss has other
/// causes. `progress` is called at each step of each simulation; what it throws ends the search.
[[nodiscard]] Calibration calibrate(const Scene& scene, ContactId contact, double e,
                                    double tolerance = restitution_tolerance,
                                    const std::function<void()>& progress = {});

}  // namespace talus
