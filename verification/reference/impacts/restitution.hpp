#pragma once

#include "verification/reference/impacts/end_rule.hpp"

/// Central impact of two bodies through a linear spring-dashpot contact, in closed form.
///
/// With the overlap d, the effective mass m (of the relative motion along the normal) and F = k d + c d':
///   m d'' = -F   ->   d'' + 2 xi w d' + w^2 d = 0,   d(0) = 0, d'(0) = v0,   w = sqrt(k/m), xi = c/(2 m w).
/// With s = sqrt(|1 - xi^2|) the solution is  d(t) = (v0/(w s)) exp(-xi w t) sin(s w t)  for xi < 1, sinh beyond, and
/// v0 t exp(-w t) at xi = 1. Every event is expressed by one function, continuous at xi = 1 where it is 1:
///   A(xi) = acos(xi)/sqrt(1 - xi^2) for xi < 1,  acosh(xi)/sqrt(xi^2 - 1) for xi > 1.
/// - d' = 0 (largest overlap): tan(s w t) = s/xi, so w t = A and d = (v0/w) exp(-xi A).
/// - F = 0 (clamped end), where d'' = 0: tan(s w t) = 2 xi s/(2 xi^2 - 1) = tan(2 acos xi), so w t = 2 A; there
///   d' = -v0 exp(-2 xi A) and d = 2 xi v0 exp(-2 xi A)/w.
/// - d = 0 (attractive end): w t = pi/s for xi < 1, d' = -v0 exp(-pi xi/s); for xi >= 1 d never returns to zero.
/// Functions check their arguments and throw std::invalid_argument. The clamped e was also derived by Schwager and
/// Poeschel, Granular Matter 9 (2007) 465.
namespace talus::verification::reference {

/// A(xi) above [rad]; xi >= 0. Relative error of a few units in the last place for every xi.
[[nodiscard]] double contact_angle(double xi);

/// Restitution e = (separation speed)/(approach speed) in [0, 1]; xi >= 0. Attractive: 0 for xi >= 1.
[[nodiscard]] double restitution(double xi, EndRule end);

/// Damping ratio that gives e, solved at 50 digits. Attractive: 0 < e <= 1, from ln(1/e)/sqrt(pi^2 + ln(1/e)^2).
/// Clamped: 0 < e <= 1 by a bracketed root of 2 xi A(xi) = ln(1/e).
[[nodiscard]] double damping_ratio(double e, EndRule end);

/// Eq. 21 of the 1993 report: c = 2 ln(1/e) sqrt(k m)/sqrt(pi^2 + ln(1/e)^2) [M/T], m = m1 m2/(m1 + m2) (attractive
/// end). `effective_mass` [M] may be that of any contact, see effective_mass() below.
[[nodiscard]] double eq_21_damping(double e, double stiffness, double effective_mass);

/// One contact: the parameters of the equation above, in any consistent units.
struct Impact {
  double stiffness{};       ///< k [F/L] > 0.
  double damping{};         ///< c [M/T] >= 0.
  double effective_mass{};  ///< m [M] > 0.
  double approach_speed{};  ///< v0 = d'(0) [L/T] > 0.
};

/// Events between touch and end.
struct ImpactEvents {
  double damping_ratio{};       ///< xi [-].
  double frequency{};           ///< w [rad/T], undamped.
  double restitution{};         ///< e [-].
  double contact_time{};        ///< From touch to the end [T]; infinite for the attractive end at xi >= 1.
  double largest_depth{};       ///< largest overlap [L].
  double largest_depth_time{};  ///< From touch [T].
  double depth_at_end{};        ///< overlap at the end [L]; 0 for the attractive end.
  double force_at_end{};        ///< [F]; 0 for the clamped end, -c e v0 (pull) for the attractive one.
  double force_at_touch{};      ///< c v0 [F]: the force jumps to it.
  double largest_force{};       ///< [F]; at touch when xi >= 1/2.
};

[[nodiscard]] ImpactEvents impact_events(const Impact& impact, EndRule end);

/// Overlap and its rate at time t after touch, 0 <= t <= contact time (the formula is also evaluated beyond).
struct DepthState {
  double depth{};  ///< d [L].
  double rate{};   ///< d' [L/T]; > 0 while closing.
};
[[nodiscard]] DepthState depth_at(const Impact& impact, double t);

/// Effective mass at a contact point, along the unit normal n. A unit impulse along n changes the velocity of the
/// body's contact point along n by the body's mobility; the impulse acts on both bodies, so mobilities add:
///   1/m_eff = mobility_A + mobility_B.
/// Free body: r x n is the moment arm of the normal's line about the centre of mass; the impulse gives 1/m to the
/// centre of mass and (r x n)/I to the spin, hence 1/m + (r x n)^2/I. Pivoted body: no translation, and arm and inertia
/// are taken about the pivot: (r x n)^2/I_p. Wall: 0. The impact depends on m_eff alone as long as the arm stays
/// constant during the contact (stiff contact).
[[nodiscard]] double free_mobility(double mass, double inertia, double arm);    ///< [1/M]; arm 0 needs no inertia.
[[nodiscard]] double pivoted_mobility(double inertia_about_pivot, double arm);  ///< [1/M].
[[nodiscard]] double effective_mass(double mobility_a, double mobility_b);      ///< [M]; their sum must be > 0.

}  // namespace talus::verification::reference
