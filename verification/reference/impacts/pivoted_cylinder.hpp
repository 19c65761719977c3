#pragma once

#include <span>
#include <vector>

#include "verification/reference/impacts/end_rule.hpp"
#include "verification/reference/motion/pendulum.hpp"

/// Validation problem 2 of the 1993 report (section 5, Eqs. 28-30): a rock strikes a column that is pinned at its top.
///
///            o pin                 h = l/2 from pin to centre of mass G, where the horizontal line of impact passes
///          __|__                   y up, x to the right, theta counter-clockwise, so theta > 0 swings G to the right
///         |  |  |                  the rock comes from the left (-x) and moves to the right with v0
///   (M)-> |  G  |  l               (mirror x and theta for a rock from the right)
///         |__|__|
///
/// Rigid impact. Angular momentum about the pin, rock moving on a line at distance h: I_p w1 + M h V1 = M h v0, with
/// I_p = I_G + m h^2; restitution at the line: h w1 - V1 = e v0. With v1 = h w1:
///   v1 (I_p/h^2 + M) = M (1 + e) v0   ->   v1 = M (1 + e) v0 h^2/(I_G + (M + m) h^2),   V1 = v1 - e v0.
/// The report's Eq. 28, with l^2/4 = h^2, is this without the factor v0. The pinned column thus acts as a particle of
/// mass I_p/h^2. Motion after the impact. Energy about the pin, G rising by h (1 - cos theta):
///   w^2 = w1^2 + 2 m g h (cos theta - 1)/I_p = w1^2 + m g l (cos theta - 1)/(I_G + m l^2/4);
/// the report's Eq. 30 has 2 m g l there, too large by a factor of two.
namespace talus::verification::reference {

/// Any consistent units; the defaults are the report's (slug, ft, s), with r from its I_G (1.2 ft is a misprint for
/// 1.25 ft), and g = 9.80665/0.3048 ft/s^2.
struct PivotedCylinder {
  double mass{14.92};                ///< m [M] of the column, > 0.
  double length{8.0};                ///< l [L] of the column, > 0; the pin is at its upper end, l/2 above G.
  double inertia{85.42};             ///< I_G [M L^2], > 0.
  double half_width{1.25};           ///< r [L]: distance of the struck face from the column's axis.
  double rock_mass{37.23};           ///< M [M] > 0.
  double rock_radius{1.2};           ///< R [L] of the rock, > 0.
  double approach_speed{5.0};        ///< v0 [L/T] of the rock, > 0.
  double restitution{0.5};           ///< e [-].
  double gravity{9.80665 / 0.3048};  ///< g [L/T^2] > 0, downwards.
};

[[nodiscard]] double inertia_about_pin(const PivotedCylinder& problem);  ///< I_p = I_G + m l^2/4 [M L^2].
/// Effective mass of the column in the impact: I_p/h^2 [M].
[[nodiscard]] double effective_column_mass(const PivotedCylinder& problem);
/// I_G of a homogeneous cylinder of radius `radius` about a diameter through G, m (l^2/12 + r^2/4) [M L^2].
[[nodiscard]] double cylinder_inertia(double mass, double length, double radius);

/// Velocities just after the rigid impact.
struct PivotedImpact {
  double column{};   ///< v1 of the centre of mass [L/T].
  double rock{};     ///< V1 [L/T].
  double angular{};  ///< w1 = 2 v1/l [rad/T], Eq. 29.
};
[[nodiscard]] PivotedImpact rigid_impact(const PivotedCylinder& problem);

[[nodiscard]] double printed_eq_28(const PivotedCylinder& problem);    ///< v1 as printed: without v0 (a number).
[[nodiscard]] double corrected_eq_28(const PivotedCylinder& problem);  ///< v1 [L/T].
/// w^2(theta) [rad^2/T^2] for the initial rate `angular` w1 at theta = 0; negative beyond the turning angle.
[[nodiscard]] double printed_eq_30(const PivotedCylinder& problem, double angular, double theta);
[[nodiscard]] double corrected_eq_30(const PivotedCylinder& problem, double angular, double theta);
/// Angle at which this w^2 vanishes [rad]; NaN when the column turns over.
[[nodiscard]] double printed_largest_angle(const PivotedCylinder& problem, double angular);
[[nodiscard]] double corrected_largest_angle(const PivotedCylinder& problem, double angular);

/// Motion of the column after the rigid impact: exact compound pendulum leaving theta = 0 with w1 (elliptic functions).
[[nodiscard]] PendulumMotion swing(const PivotedCylinder& problem, double angular);

/// Contact of the rock with the struck face, with one resultant: the face's outward normal n turns with the column,
///   overlap = R - (n . (p - p_G) - r),   n = -(cos theta, sin theta),
/// and F = k_n overlap + c overlap' acts on the rock along n, at the projection of the rock's centre onto the face.
struct PivotedContact {
  double stiffness{};                ///< k_n [F/L] > 0.
  double damping{};                  ///< c [M/T] >= 0.
  EndRule end{EndRule::attractive};  ///< When the contact ends.
};

/// Damping from Eq. 21 for the problem's e with the two particle masses, as in the report [M/T].
[[nodiscard]] double particle_damping(const PivotedCylinder& problem, double contact_stiffness);
/// Damping with the column's I_p/h^2 in place of m: gives the correct e in the stiff limit [M/T].
[[nodiscard]] double pivoted_damping(const PivotedCylinder& problem, double contact_stiffness);
/// Actual restitution of this dashpot at the pinned column in the stiff limit.
[[nodiscard]] double restitution_of(const PivotedCylinder& problem, const PivotedContact& contact);

struct PivotedState {
  double t{};              ///< Time since touch [T].
  double angle{};          ///< theta [rad].
  double rate{};           ///< theta' [rad/T].
  double rock_x{};         ///< Rock's centre relative to the initial position of G [L].
  double rock_y{};         ///< [L].
  double rock_vx{};        ///< [L/T].
  double rock_vy{};        ///< [L/T].
  double contact_force{};  ///< F [F] on the rock along n; 0 after the end.
};

struct PivotedSoftImpact {
  PivotedState at_end;     ///< When the contact ends.
  double column_speed{};   ///< (l/2) theta' at that time [L/T].
  double depth_at_end{};   ///< Overlap [L]; 0 for the attractive rule.
  double largest_depth{};  ///< Largest overlap [L].
  double peak_force{};     ///< [F].
  double peak_rate{};      ///< Largest theta' [rad/T].
  double largest_angle{};  ///< Largest angle after contact, from the energy [rad]; NaN: turns over.
  double turning_time{};   ///< From touch to theta' = 0 [T]; NaN when it turns over or is struck again before.
  bool struck_again{};     ///< Rock and face (taken as unbounded) touch again before the turning point.
  std::vector<PivotedState> samples;  ///< At the requested times.
};

/// Soft contact of the whole problem from touch on: theta = theta' = 0, rock at G's height with velocity (v0, 0),
/// gravity on both, no friction (so no torque on the rock). Integrated by `Trajectory` with located events. After the
/// contact the rock flies freely and the column moves as a pendulum; a second contact is reported, but not simulated.
/// `sample_times` ascending, >= 0 [T].
[[nodiscard]] PivotedSoftImpact soft_impact(const PivotedCylinder& problem, const PivotedContact& contact,
                                            std::span<const double> sample_times = {});

}  // namespace talus::verification::reference
