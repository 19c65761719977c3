#pragma once

#include "solver/run/turning_point.hpp"
#include "solver/scenes/scene.hpp"
#include "verification/check/case.hpp"
#include "verification/reference/two_cable.hpp"
#include "verification/reference/two_cable_contact.hpp"

/// The solver's two-cable problem with the reference's data, and the run of one impact.
namespace talus::verification::problems {

inline constexpr double contact_stiffness = 1e4;  ///< k_n where not varied [N/m]

/// How a contact ends, and the end rule whose formula sets its dashpot for e = .5 (Eq. 21 is that of the attractive
/// one).
struct TwoCableEnd {
  EndRule rule;
  EndRule formula;
};

/// M m/(M + m) [kg].
[[nodiscard]] double reduced_mass();
/// Share of the closing speed's change that the particle gets: M/(M + m).
[[nodiscard]] double particle_share();
/// U' = 2 k (1 - l/L) x, L = sqrt(l^2 + x^2): the force of both cables on the particle at x [N].
[[nodiscard]] double cable_pull(double x);

/// The solver's contact, its dashpot by the solver's own calibration. Faults `dashpot_halved`, `wrong_end_rule`.
[[nodiscard]] LinearSpringDashpot solver_contact(double stiffness, TwoCableEnd end, const Setup& setup);

/// The same contact by the reference's formulas.
[[nodiscard]] reference::SoftContact soft_contact(double stiffness, TwoCableEnd end);

/// The scene with that contact. Faults `mass_halved`, `cable_stiffness_per_length`. Integrator and plan are left to
/// the caller.
[[nodiscard]] Scene scene_of(const LinearSpringDashpot& law, const Setup& setup);

/// What the solver gives for one impact.
struct TwoCableRun {
  double speed_after{};       ///< of the particle when the contact has ended [m/s]
  TurningPoint turning;       ///< of the particle
  double energy_closure{};    ///< at the turn [J]
  double momentum_closure{};  ///< largest, over M v0
  double curve_error{};  ///< largest |v^2 - v^2(theta)| on the way to the turn, Eq. 27 through the state at the end
                         ///< [m^2/s^2]
};

/// Runs the scene with the surfaces `gap` apart at t = 0, until the particle turns, or only until the contact has
/// ended.
[[nodiscard]] TwoCableRun simulated(Scene scene, double gap, double step, bool to_the_turn, Findings& findings);

}  // namespace talus::verification::problems
