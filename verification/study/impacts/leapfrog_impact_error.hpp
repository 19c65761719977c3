#pragma once

#include "verification/reference/impacts/end_rule.hpp"

/// Predicted (not fitted) first-order error of leapfrog methods in a damped impact.
///
/// Central difference and velocity Verlet evaluate F = k d + c d' with the overlap of the step and the velocity half a
/// step earlier. This has two effects, with w = sqrt(k/m), h the step, s^2 = 1 - xi^2 and A(xi) as in
/// reference/impacts/restitution.hpp:
///
/// - Lag. d'(t - h/2) = d' - (h/2) d'' turns m d'' = -F into (m - c h/2) d'' = -k d - c d', the same contact with the
///   mass m (1 - xi w h): w grows by the factor 1 + xi w h/2, and xi by xi^2 w h/2. The derivatives of the closed forms
///   with respect to xi give the shifts
///     attractive  ln e: -(pi/s^3) xi^2 w h/2,   ln T: -(1 - 2 xi^2)/(2 s^2) xi w h
///     clamped     ln e: -2 (A - xi)/s^2 xi^2 w h/2,   ln T: -(1 - xi (xi A - 1)/(A s^2)) xi w h/2
///     both        ln d_max: -(xi/2 + xi^2 (A - xi)/(2 s^2)) w h
/// - Jump. The force jumps to c v0 = 2 xi m w v0 at an instant that the steps resolve only to +-h/2, uniformly
///   distributed over phases: the speed just after is off by 2 xi w v0 h u, u uniform in (-1/2, 1/2), of variance 1/12.
///   The subsequent motion scales with that speed. The attractive contact ends with a second jump, 2 xi m w e v0, of
///   independent phase; the clamped force ends continuously. Contact times do not depend on the speed.
///
/// With shift and jumps independent, the mean squares add. The remainder is of order h^2.
namespace talus::verification::problems {

/// Root-mean-square errors over all phases, relative to the quantity and per unit of w h.
struct ImpactError {
  double restitution{};
  double contact_time{};
  double largest_depth{};
};

/// The prediction for a damping ratio xi > 0 (xi < 1 when attractive).
[[nodiscard]] ImpactError leapfrog_impact_error(double xi, reference::EndRule end);

/// Mean of the relative error of e over all phases, per unit of w h: due to the lag alone, < 0.
[[nodiscard]] double leapfrog_restitution_shift(double xi, reference::EndRule end);

}  // namespace talus::verification::problems
