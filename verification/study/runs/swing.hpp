#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

#include "solver/scenes/pendulum.hpp"
#include "verification/check/case.hpp"
#include "verification/reference/motion/pendulum.hpp"
#include "verification/study/runs/scene_run.hpp"

/// The pinned body as a pendulum: errors of runs relative to the elliptic functions, and the methods with the steps at
/// which their order is fitted.
namespace talus::verification::problems {

inline constexpr double degree = std::numbers::pi / 180.0;

/// The correct body, or one with a planted fault: `gravity_up`, `inertia_halved`, `arm_one_percent`. The references are
/// always those of the correct one.
inline scenes::Pendulum bob(const Setup& setup, double amplitude) {
  scenes::Pendulum p{.mass = 2.0, .inertia = 0.5, .arm = 0.8, .gravity = 9.80665, .amplitude = amplitude};
  if (setup.has("gravity_up")) p.gravity = -p.gravity;
  if (setup.has("inertia_halved")) p.inertia *= 0.5;
  if (setup.has("arm_one_percent")) p.arm *= 1.01;
  return p;
}

/// Velocity Verlet, or its replacement by a fault: `euler_cromer_for_verlet`, `rk4_for_verlet`.
inline Integrator verlet(const Setup& setup) {
  if (setup.has("euler_cromer_for_verlet")) return make_integrator("euler_cromer");
  return make_integrator(setup.has("rk4_for_verlet") ? "rk4" : "velocity_verlet");
}

/// Frequency of small oscillations, computed independently of the scene, w0 = sqrt(m g a/(I + m a^2)) [rad/s].
inline double bob_frequency() {
  const scenes::Pendulum p = bob({}, 1.0);
  return std::sqrt(p.mass * p.gravity * p.arm / (p.inertia + p.mass * p.arm * p.arm));
}

/// Exact motion from rest at `amplitude` [rad].
inline reference::PendulumMotion bob_motion(double amplitude) {
  return reference::PendulumMotion::from_rest(bob_frequency(), amplitude);
}

/// Error of one run from rest, at its end.
struct SwingError {
  double error{};      ///< sqrt(dx^2 + (dx'/w0)^2) [rad]
  long evaluations{};  ///< of the force
};

/// Runs `scene` (with the initial state of `exact`) over `duration` in `steps` steps.
inline SwingError swing_error(const Scene& scene, const Integrator& integrator, double duration, long steps,
                              double frequency, const reference::PendulumMotion& exact) {
  const RunEnd end = run_steps(scene, integrator, duration / static_cast<double>(steps), steps);
  const reference::PendulumState truth = exact.at(duration);
  return {std::hypot(end.state.q[0] - truth.angle, (end.state.v[0] - truth.rate) / frequency), end.evaluations};
}

/// A method, and the range of steps per 0.8 period of a 60 degree oscillation in which its error follows its power law:
/// above round-off, and at steps small enough for the next term of the expansion to be small.
struct MethodRange {
  std::string_view name;
  long first;  ///< steps
  long last;   ///< steps
  /// Contribution of the next two terms of the expansion to the order fitted between `first` and `last`. It is
  /// determined from the errors at three coarser steps, e n^order = c (1 + c1 h^q + c2 h^(2q)), q = 2 for the symmetric
  /// methods, else 1: leapfrogs 16, 32, 64; euler_cromer, euler and taylor 32, 64, 128; rk4 8, 16, 32; blanes_moan4 16,
  /// 32, 64; dopri5 16, 32, 64; cash_karp54 8, 16, 32; fehlberg78 6, 8, 11; abm8 64, 91, 128 (its second term alone is
  /// 9.6 w h times the first, see adams_swing.hpp).
  double tilt;
  /// Admitted deviation of the fitted order from the declared one, in either direction: the tilt, and half of it again
  /// for the higher terms.
  [[nodiscard]] constexpr double admitted() const { return tilt < 0.0 ? -1.5 * tilt : 1.5 * tilt; }
  /// The declared order.
  [[nodiscard]] int order() const { return integrator_traits(name).order; }
  /// True for odeint's steppers, which are drawn separately from the solver's methods.
  [[nodiscard]] constexpr bool is_odeint() const { return name.substr(0, 7) == "odeint_"; }
};

/// All fixed-step methods; bulirsch_stoer has no fixed step.
inline constexpr std::array<MethodRange, 11> method_ranges{{{"central_difference", 64, 65536, -2.7e-5},
                                                            {"velocity_verlet", 64, 65536, 5.3e-5},
                                                            {"euler_cromer", 128, 131072, 1.00e-3},
                                                            {"euler", 128, 131072, 0.00536},
                                                            {"taylor", 128, 131072, 0.00221},
                                                            {"rk4", 32, 1024, -0.0099},
                                                            {"blanes_moan4", 64, 256, -0.00476},
                                                            {"odeint_dopri5", 64, 256, 0.059},
                                                            {"odeint_cash_karp54", 32, 256, -0.0032},
                                                            {"odeint_fehlberg78", 11, 32, -0.128},
                                                            {"odeint_abm8", 91, 182, 0.505}}};

}  // namespace talus::verification::problems
