#pragma once

#include "solver/run/turning_point.hpp"
#include "solver/scenes/scene.hpp"
#include "verification/check/case.hpp"
#include "verification/reference/cables/two_cable.hpp"
#include "verification/reference/cables/two_cable_contact.hpp"

/// The solver's two-cable problem with the reference's data, and the run of one impact.
namespace talus::verification::problems {

inline constexpr double contact_stiffness = 1e4;  ///< k_n where not varied [N/m]

/// End rule of a contact, and the end rule whose formula gives its damping for e = 0.5 (Eq. 21 is that of the
/// attractive rule).
struct TwoCableEnd {
  EndRule rule;
  EndRule formula;
};

/// M m/(M + m) [kg].
[[nodiscard]] double reduced_mass();
/// Fraction of the change of the closing speed that the particle receives: M/(M + m).
[[nodiscard]] double particle_fraction();
/// U' = 2 k (1 - l/L) x, L = sqrt(l^2 + x^2): the force of both cables on the particle at x [N].
[[nodiscard]] double cable_pull(double x);

/// The solver's contact, its damping from the solver's own calibration. Faults `dashpot_halved`, `wrong_end_rule`.
[[nodiscard]] LinearSpringDashpot solver_contact(double stiffness, TwoCableEnd end, const Setup& setup);

/// The same contact from the reference's formulas.
[[nodiscard]] reference::SoftContact soft_contact(double stiffness, TwoCableEnd end);

/// The scene with that contact. Faults `mass_halved`, `cable_stiffness_per_length`. Integrator and plan are set by
/// the caller.
[[nodiscard]] Scene scene_of(const LinearSpringDashpot& law, const Setup& setup);

/// Results of the solver for one impact.
struct TwoCableRun {
  double speed_after{};             ///< of the particle when the contact has ended [m/s]
  TurningPoint turning;             ///< of the particle
  double energy_balance_error{};    ///< balance error at the turning point [J]
  double momentum_balance_error{};  ///< largest balance error, over M v0
  double curve_error{};  ///< largest |v^2 - v^2(theta)| until the turning point, Eq. 27 through the state at the
                         ///< end of the contact [m^2/s^2]
};

/// Runs the scene with the surfaces `gap` apart at t = 0, until the particle turns, or only until the contact has
/// ended.
[[nodiscard]] TwoCableRun simulated(Scene scene, double gap, double step, bool to_the_turn, Findings& findings);

}  // namespace talus::verification::problems
