#pragma once

#include <array>
#include <span>
#include <vector>

/// How a method of integration multiplies the motion of a damped oscillator in one step: eigenvalues of its
/// amplification matrix, on
///
///   x'' + 2 xi w x' + w^2 x = 0,   eta = w h
namespace talus::verification::reference {

/// What decides the matrix. Of leapfrogs, v += h a(q, v) and q += h v, it is the velocity that the dashpot sees; of
/// velocity Verlet that in a(n+1); of compositions of drifts and kicks that of before each kick. Runge-Kutta methods
/// are named after their tableau, in which the dashpot sees the velocity of the stage.
enum class Scheme {
  half_step,         ///< leapfrog: that of before the kick, half a step old; also velocity Verlet with its v(n+1/2)
  average,           ///< leapfrog: the mean of before and after
  implicit,          ///< leapfrog: that of after the kick
  late,              ///< leapfrog: one and a half steps old
  verlet_old,        ///< velocity Verlet: v(n)
  verlet_predicted,  ///< velocity Verlet: v(n) + h a(n)
  euler,             ///< explicit Euler
  taylor,            ///< q += h v + h^2/2 a, v += h a, a of the step's start
  blanes_moan4,      ///< SRKN_6^b of Blanes & Moan 2002, Table 3: six drifts between seven kicks
  rk4,               ///< Kutta 1901
  dopri5,            ///< Dormand & Prince 1980, the solution of order 5
  cash_karp54,       ///< Cash & Karp 1990, the solution of order 5
  fehlberg78,        ///< Fehlberg 1968, the solution of order 8
  abm8,              ///< Adams, eight values: predicted, evaluated, corrected, evaluated
};

/// ln of the modulus of the largest eigenvalue of one step; > 0 where the motion grows.
[[nodiscard]] double ln_growth(Scheme scheme, double eta, double xi);

/// Every eta in (0, most) at which that passes through zero, either way, in ascending order. A modulus within 1e-10 of
/// one counts as none that grows. Two passages within most/parts of each other are not seen.
[[nodiscard]] std::vector<double> limits(Scheme scheme, double xi, double most, int parts = 200);

/// The coefficients of 1, z, z^2, ... in the factor of one step on y' = lambda y, z = h lambda, of a Runge-Kutta
/// scheme. Errors: std::invalid_argument for any other.
[[nodiscard]] std::vector<double> stability_polynomial(Scheme scheme);

/// Successive states of one run.
using Motion = std::vector<std::array<double, 2>>;

/// ln of the modulus of the largest multiplier of motions that follow one linear map with at most `dimension`
/// eigenvalues other than zero, from runs of it. Each state is weighed by its own size, so that one that grows or dies
/// counts as much at its end as at its beginning. `noise` is what rounding puts into a state: what is no more than its
/// share of the smallest is not taken for a mode of its own. Roundings of a share e come back as a share e over the
/// distance of the eigenvalues, and as up to sqrt(e) where two are one. NaN where all is noise, and for too few states:
/// a run of n gives n less half the dimension, rounded up, of the `dimension` that are needed.
[[nodiscard]] double ln_multiplier(std::span<const Motion> runs, int dimension, double noise);

}  // namespace talus::verification::reference
