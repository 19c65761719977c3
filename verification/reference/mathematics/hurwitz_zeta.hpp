#pragma once

/// Hurwitz zeta function, which gives the error of a sum of equal steps.
///
/// For f(t) = t^p, t > 0 (0 before), sampled at (j + u) h, j = 0, 1, ..., 0 < u <= 1:
///   h sum f((j + u) h) - int f dt = h^(p+1) zeta(-p, u) + (terms of the far end alone)
/// (Euler & Maclaurin; Navot, J. Math. Phys. 40 (1961) 271). A force that begins as kappa t^p at any instant within a
/// leapfrog step therefore causes an impulse error kappa h^(p+1) zeta(-p, u). p = 0: 1/2 - u, a jump; p = 1: -B_2(u)/2,
/// a kink.
namespace talus::verification::reference {

/// zeta(-p, u) for -1 < p <= 4, 0 < u <= 1: the sum of 30 terms and the Euler-Maclaurin remainder, to about 1e-15 times
/// 30^p. std::invalid_argument outside.
[[nodiscard]] double hurwitz_zeta_of_minus(double p, double u);

}  // namespace talus::verification::reference
