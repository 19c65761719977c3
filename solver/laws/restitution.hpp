#pragma once

#include <optional>

#include "solver/laws/kinematics.hpp"
#include "solver/laws/unilateral_spring.hpp"

namespace talus {

/// Inertia of one body at a contact, along the normal.
struct ContactSide {
  double mass{};                  ///< [M] > 0; of a free body
  std::optional<double> inertia;  ///< [M L^2] > 0; about the centre of mass (free) or about the pin (pinned)
  double arm{};  ///< distance of the normal's line from the centre of mass (free) or from the pin (pinned) [L]
  bool pinned{false};
};

/// Effective mass of two bodies along the normal at their contact point [M]:
///
///   1/m_eff = sum over bodies of   1/m + arm^2/I   (free),   arm^2/I_pin   (pinned)
///
/// Two particles give m1 m2/(m1 + m2), the mass of Eq. 21 of Mustoe & Huttelmaier (1993).
/// Errors: InputError for a mass or inertia that is not > 0, or a pinned body hit along a line through its pin.
[[nodiscard]] double effective_mass(const ContactSide& a, const ContactSide& b);

/// Restitution of an impact on a linear spring and dashpot of damping ratio xi = c/(2 sqrt(k m_eff)) >= 0:
///
///   attractive   e = exp(-pi xi/sqrt(1 - xi^2));  0 for xi >= 1
///   clamped      e = exp(-2 xi acos(xi)/sqrt(1 - xi^2));  e^-2 at xi = 1;  acosh(xi)/sqrt(xi^2 - 1) beyond
///
/// Source of the clamped rule: Schwager & Poeschel 2007.
[[nodiscard]] double restitution(double damping_ratio, EndRule rule);

/// The damping ratio that gives restitution e. Errors: InputError for e outside (0, 1].
/// For the attractive rule this is Eq. 21: xi = ln(1/e)/sqrt(pi^2 + ln(1/e)^2).
[[nodiscard]] double damping_ratio(double e, EndRule rule);

/// Dashpot coefficient c = 2 xi sqrt(k m_eff) [F T/L].
[[nodiscard]] double damping(double damping_ratio, double stiffness, double effective_mass);

/// Damping ratio xi = c/(2 sqrt(k m_eff)) of a linear spring and dashpot.
[[nodiscard]] double damping_ratio_of(const Tangent& spring, double effective_mass);

/// Time from touch to the end of the contact of a linear spring and dashpot [T], with w0 = sqrt(k/m_eff):
///
///   attractive   pi/(w0 sqrt(1 - xi^2));  infinite for xi >= 1
///   clamped      2 acos(xi)/(w0 sqrt(1 - xi^2)), and its continuation beyond xi = 1
[[nodiscard]] double contact_time(const Tangent& spring, EndRule rule, double effective_mass);

/// Largest overlap of an impact at the given speed of approach [L]: (v/w0) exp(-xi acos(xi)/sqrt(1 - xi^2)) for both
/// end rules.
[[nodiscard]] double largest_overlap(const Tangent& spring, double effective_mass, double speed);

}  // namespace talus
