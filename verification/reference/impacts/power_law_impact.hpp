#pragma once

#include "verification/reference/impacts/end_rule.hpp"

/// Impacts on springs whose force is a power of the overlap, with dashpots by which the restitution depends on the
/// speed. Without units: lengths in L = (m v^2/K)^(1/(n+1)), times in L/v, with the spring F = K x^n and the speed of
/// approach v.
///
///   Hertz with a constant dashpot c         X'' = -X^(3/2) - g X',      g = c L/(m v)
///   Hunt & Crossley 1975                    X'' = -X^n (1 + a X'),      a = a_hc v
///
/// both with X = 0, X' = 1 at touch. For n = 3/2 they are integrated with z = sqrt(X) and ds = dt/(2 z), which makes
/// them polynomials; for n = 1 and 2 they are polynomials in t.
namespace talus::verification::reference {

struct ScaledEvents {
  double restitution{};
  double contact_time{};
  double largest_depth{};
};

/// Hertz with the constant dashpot g >= 0; the contact must end (std::invalid_argument if it lasts longer than 1000).
[[nodiscard]] ScaledEvents constant_dashpot_events(double g, EndRule end);

/// Hunt & Crossley with a >= 0 and the exponent n = 1, 3/2 or 2 (std::invalid_argument otherwise); the contact ends
/// where the force is zero.
[[nodiscard]] ScaledEvents hunt_crossley_events(double a, double n);

/// Restitution of Hunt & Crossley's law for every n: the root e of ln((1 + a)/(1 - a e)) = a (1 + e) in (0, 1), by
/// bisection at 50 digits; a > 0. (From X'' = dX'/dX X', which separates.)
[[nodiscard]] double hunt_crossley_restitution(double a);
/// The root a of the same equation for 0 < e < 1.
[[nodiscard]] double hunt_crossley_number(double e);

}  // namespace talus::verification::reference
