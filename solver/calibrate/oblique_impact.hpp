#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/calibrate/impact_step.hpp"
#include "solver/integrate/integrator_list.hpp"
#include "solver/laws/law_list.hpp"

namespace talus {

/// A free body whose outline is a circle.
struct RoundBody {
  double mass{};     ///< [M] > 0
  double inertia{};  ///< about the centre of mass [M L^2] > 0
  double radius{};   ///< [L] > 0
};

/// Oblique impact of two round bodies, or of one on a fixed plane, that do not spin before it.
struct ObliqueImpact {
  ContactLaw law;
  FrictionLaw friction;
  std::optional<RoundBody> first;  ///< none: a fixed plane
  RoundBody second;
  double speed{};  ///< of body 2 relative to body 1 [L/T] > 0
  double angle{};  ///< of this velocity from the normal of the contact [rad], in (0, pi/2)

  double approach_speed() const;  ///< along the normal [L/T]
  double slip_speed() const;      ///< along the plane [L/T]
  double effective_mass() const;  ///< along the normal [M]
  /// n >= 1: a friction force F changes the slip rate of the contact at the rate n F/m, with m the effective mass.
  double mobility() const;
};

/// Results of an oblique impact; its tangent has the direction of the velocity of body 2 along the plane.
struct ObliqueRebound {
  double restitution{};  ///< relative speed of the centres along the normal, after over before
  /// Relative speed of the centres along the tangent, after over before; 1 without friction.
  double tangential_restitution{};
  /// Slip rate of the contact, reversed, over that before: -1 without friction, 0 if the bodies roll on each other
  /// (Walton 1993).
  double rotational_restitution{};
  double angle{};  ///< of the relative velocity of the centres from the normal [rad], > 0 along the tangent
  double spin{};   ///< of body 2 [rad/T], > 0 as a body that rolls along the tangent
  /// Fraction of the contact time in which the contact sticks: 0 if it slides throughout.
  double sticking{};
};

/// Simulates the impact with the solver: a method that locates events, with local errors of 1e-10. Friction that
/// sticks again after slip is found at the end of a step of the method, not located: restitutions jump by some 1e-5 as
/// a parameter changes. Errors: InputError for a law without closed-form impacts, an angle or speed outside the ranges
/// above, an overlap of more than half the radius, or if the method cannot simulate it, with the reason.
[[nodiscard]] ObliqueRebound rebound(const ObliqueImpact& impact);

/// Error of the simulated restitutions, normal or tangential, whichever is larger, against rebound(). Errors as above,
/// and as demand_closed_form().
[[nodiscard]] ImpactError rebound_error(const ObliqueImpact& impact, const Integrator& integrator);

/// A parameter of the friction law that gives a tangential restitution.
struct TangentialCalibration {
  double value{};
  ObliqueRebound rebound;  ///< with this value
};

/// Finds the smallest value of the parameter `name` of the impact's friction law that gives the tangential restitution
/// e_t: `friction` up to ten times the coefficient with which a rigid contact stops to slide throughout; stiffness or
/// modulus for tangential stiffnesses, at the largest overlap, of 1e-3 to 10 times m (pi/T)^2, with the effective mass
/// m and the contact time T; `shear_damping` up to ten times the critical one. The range is searched at 12 values a
/// decade and at the extremes between them. Errors: InputError with the tangential restitutions that are reachable, or
/// between which they jump by more than 1e-4.
[[nodiscard]] TangentialCalibration calibrate_tangential(const ObliqueImpact& impact, std::string_view name,
                                                         double e_t);

}  // namespace talus
