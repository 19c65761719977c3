#pragma once

#include <array>
#include <string_view>

#include "solver/base/fields.hpp"
#include "solver/laws/unilateral_spring.hpp"

namespace talus {

/// Dashpot of a contact by Hertz's law.
enum class HertzDashpot {
  tsuji,     ///< c (d/R)^(1/4) dd/dt: the restitution is the same at every speed (Tsuji et al. 1992)
  constant,  ///< c dd/dt: the restitution increases with the speed
};
template <>
struct Names<HertzDashpot> {
  static constexpr std::array<std::string_view, 2> list{"tsuji", "constant"};
};

/// Impact by Hertz's law without units. With the length L = (m v^2/K)^(2/5) and the time L/v of a mass m that hits the
/// spring F = K d^(3/2) at the speed v, the overlap X = d/L follows
///
///   X'' = -X^(3/2) - sqrt(5) xi X^p X',     X = 0, X' = 1 at touch,     p = 1/4 (tsuji), 0 (constant)
///
/// and only the damping ratio xi and the end rule enter. With Tsuji's dashpot xi is that of the linear spring and
/// dashpot with the same restitution (see Hertz).
struct HertzImpact {
  double restitution{};
  double contact_time{};     ///< in units of L/v; infinite if the contact does not end, or beyond 1e30 (e < 1e-150)
  double largest_overlap{};  ///< in units of L
};
/// The impact with damping ratio xi >= 0, to a relative error of about 1e-12; below e = 1e-5 of at most 1e-4.
[[nodiscard]] HertzImpact hertz_impact(double damping_ratio, HertzDashpot dashpot, EndRule rule);

/// The damping ratio that gives restitution e. Errors: InputError for e outside (0, 1], or below 1e-6 with the constant
/// dashpot.
[[nodiscard]] double hertz_damping_ratio(double e, HertzDashpot dashpot, EndRule rule);

}  // namespace talus
