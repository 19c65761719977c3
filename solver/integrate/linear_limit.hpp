#pragma once

namespace talus {

/// Linear limit 2 (sqrt(1 + xi^2) - xi) of leapfrog methods whose dashpots use the velocity of half a step before.
[[nodiscard]] double leapfrog_limit(double damping_ratio);

/// Shortest step, in 1/omega, at which a method becomes unstable. `growth(h, xi)`: largest factor by which a step h
/// [1/omega] amplifies the oscillation q'' = -q - 2 xi q'; the same for the same arguments, since the last result is
/// reused.
[[nodiscard]] double first_growth(double (*growth)(double h, double damping_ratio), double damping_ratio);

/// Growth factor of the degree-4 Taylor polynomial of the exact motion: largest |R(z)|, z = h (-xi +- sqrt(xi^2 - 1)).
[[nodiscard]] double fourth_order_growth(double h, double damping_ratio);

}  // namespace talus
