#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// The rigid pendulum x'' = -w0^2 sin x, released at rest, integrated by odeint's steppers: independent integrators in
/// double.
namespace talus::verification::reference {

struct PendulumStepper {
  std::string_view name;
  int order{};        ///< Order of the solution that is continued; 0: chosen step by step.
  bool fixed_step{};  ///< Supports a fixed step.
  bool controlled{};  ///< Supports a tolerance.
};

/// rk4, cash_karp54, dopri5, fehlberg78, adams_bashforth_moulton (8 steps, started by fehlberg78), bulirsch_stoer.
[[nodiscard]] const std::vector<PendulumStepper>& pendulum_steppers();

struct PendulumRun {
  std::string stepper;    ///< A name of the list.
  double frequency{1.0};  ///< w0 [rad/T] > 0.
  double amplitude{1.0};  ///< x(0) [rad], 0 < x < pi; at rest.
  double duration{};      ///< Final time [T] > 0.
  int steps{};            ///< > 0: number of equal steps; 0: under `tolerance`.
  double tolerance{};     ///< Absolute and relative error of a step, when steps = 0.
};

struct PendulumRunResult {
  double angle{};                 ///< x at the end [rad].
  double rate{};                  ///< x' at the end [rad/T].
  double angle_error{};           ///< At the end, relative to the elliptic functions [rad], signed.
  double largest_angle_error{};   ///< Over all accepted steps [rad].
  double largest_energy_error{};  ///< |E - E(0)|/E(0) over all accepted steps.
  std::int64_t evaluations{};     ///< Evaluations of the right-hand side, including rejected and starting steps.
};

/// Throws std::invalid_argument for an unknown stepper (the message lists the names) or one that does not support the
/// requested mode.
[[nodiscard]] PendulumRunResult run_pendulum(const PendulumRun& run);

}  // namespace talus::verification::reference
