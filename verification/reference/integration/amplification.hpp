#pragma once

#include <array>
#include <span>
#include <vector>

/// Growth per step of a damped oscillator under a method of integration: eigenvalues of the amplification matrix, on
///
///   x'' + 2 xi w x' + w^2 x = 0,   eta = w h
namespace talus::verification::reference {

/// Integration scheme, which determines the matrix. The leapfrogs, v += h a(q, v) and q += h v, differ in the velocity
/// that the dashpot uses; variants of velocity Verlet in the velocity used in a(n+1). In compositions of drifts and
/// kicks the dashpot uses the velocity before each kick. Runge-Kutta methods are named after their tableau; their
/// dashpot uses the velocity of the stage.
enum class Scheme {
  half_step,         ///< leapfrog, velocity before the kick, half a step old; also velocity Verlet with its v(n+1/2)
  average,           ///< leapfrog, mean of the velocities before and after the kick
  implicit,          ///< leapfrog, velocity after the kick
  late,              ///< leapfrog, velocity one and a half steps old
  verlet_old,        ///< velocity Verlet: v(n)
  verlet_predicted,  ///< velocity Verlet: v(n) + h a(n)
  euler,             ///< explicit Euler
  taylor,            ///< q += h v + h^2/2 a, v += h a, with a at the start of the step
  blanes_moan4,      ///< SRKN_6^b of Blanes & Moan 2002, Table 3: six drifts between seven kicks
  rk4,               ///< Kutta 1901
  dopri5,            ///< Dormand & Prince 1980, the solution of order 5
  cash_karp54,       ///< Cash & Karp 1990, the solution of order 5
  fehlberg78,        ///< Fehlberg 1968, the solution of order 8
  abm8,              ///< Adams-Bashforth-Moulton with eight values: predict, evaluate, correct, evaluate
};

/// ln of the modulus of the largest eigenvalue of one step; > 0 if the motion grows.
[[nodiscard]] double ln_growth(Scheme scheme, double eta, double xi);

/// All eta in (0, most) at which ln_growth() crosses zero, in either direction, in ascending order. A modulus within
/// 1e-10 of one counts as not growing. Two crossings within most/parts of each other are not found.
[[nodiscard]] std::vector<double> limits(Scheme scheme, double xi, double maximum, int parts = 200);

/// The coefficients of 1, z, z^2, ... in the factor of one step on y' = lambda y, z = h lambda, of a Runge-Kutta
/// scheme. Errors: std::invalid_argument for any other.
[[nodiscard]] std::vector<double> stability_polynomial(Scheme scheme);

/// Successive states of one run.
using Motion = std::vector<std::array<double, 2>>;

/// ln of the modulus of the largest eigenvalue of a linear map with at most `dimension` non-zero eigenvalues, estimated
/// from runs that follow it. Each state is normalized, so that a growing or decaying run has the same weight at its
/// beginning and end. `noise` is the rounding error of a state: components smaller than noise relative to the smallest
/// state are not counted as separate modes. Rounding errors of relative size e change the result by about e over the
/// distance of the eigenvalues, and by up to sqrt(e) if two coincide. NaN if all is noise, and for too few states: a
/// run of n states gives n - dimension/2 (dimension/2 rounded up) of the `dimension` samples that are needed.
[[nodiscard]] double ln_multiplier(std::span<const Motion> runs, int dimension, double noise);

}  // namespace talus::verification::reference
