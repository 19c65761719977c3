#pragma once

namespace talus {

/// 2 (sqrt(1 + xi^2) - xi): the linear limit of leapfrog methods whose dashpots see the velocity of half a step before.
[[nodiscard]] double leapfrog_limit(double damping_ratio);

/// The shortest step, in 1/omega, at which a method begins to grow. `growth(h, xi)`: largest factor by which a step h
/// [1/omega] multiplies the oscillation q'' = -q - 2 xi q'.
[[nodiscard]] double first_growth(double (*growth)(double h, double damping_ratio), double damping_ratio);

/// Growth by the Taylor polynomial of degree 4 of the exact motion: largest |R(z)|, z = h (-xi +- sqrt(xi^2 - 1)).
[[nodiscard]] double fourth_order_growth(double h, double damping_ratio);

}  // namespace talus
