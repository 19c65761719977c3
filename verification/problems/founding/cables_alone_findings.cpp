#include "verification/problems/founding/cables_alone_findings.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "verification/problems/founding/two_cable_impact.hpp"
#include "verification/study/curves.hpp"
#include "verification/study/scene_run.hpp"

namespace talus::verification::problems {
namespace {

const reference::TwoCable problem{};

/// The particle launched at v1 with the striker out of reach: smooth motion under velocity Verlet.
struct Launch {
  double time_error{};      ///< of the turn, signed [s]
  double distance_error{};  ///< of the turn, signed [m]
  double curve_error{};     ///< largest |v^2 - v^2(theta)|, Eq. 27 [m^2/s^2]
  Series curve{.label = "solver, every eighth of 160 steps", .style = Style::points};
};
Launch launched(const reference::TwoCableMotion& motion, double turning_time, double v1, double step,
                const Setup& setup, Findings& findings) {
  Scene scene = scene_of({contact_stiffness, 0.0, EndRule::clamped}, setup);
  scene.integrator = setup.has("euler_cromer") ? Integrator{EulerCromer{}} : Integrator{VelocityVerlet{}};
  scene.initial.v = {v1, 0.0, 0.0, 0.0};
  scene.initial.q[2] = -100.0;
  TurningPointFinder finder{0};
  Launch launch;
  const Watcher watch = [&](const State& seen, const StepInfo& info) {
    finder(seen, info);
    const double theta = std::atan(seen.q[0] / problem.length);
    if (finder.found() || theta >= motion.largest_angle()) return;
    const double exact = motion.speed_at_angle(theta);
    launch.curve_error = std::max(launch.curve_error, std::abs(seen.v[0] * seen.v[0] - exact * exact));
    if (info.step % 8 != 0) return;
    launch.curve.add(theta, seen.v[0]);
  };
  const RunEnd end = run_scene(scene, scene.integrator, {step, 5.0, 5.0, false}, findings, watch,
                               [&](const State&) { return finder.found().has_value(); });
  const bool turned = end.finished && finder.found();
  launch.time_error = turned ? finder.found()->time - turning_time : std::nan("");
  launch.distance_error = turned ? finder.found()->value - motion.largest_distance() : std::nan("");
  return launch;
}

/// D of the Hamiltonian that velocity Verlet really keeps, H + h^2 D: v^2 U''/12 - U'^2/(24 m) (Hairer, Lubich & Wanner
/// 2006, IX.8), with U'' = 2 k (1 - l/L + x^2 l/L^3), L = sqrt(l^2 + x^2).
double kept_in_addition(double x, double v) {
  const double l = problem.length, L = std::sqrt(l * l + x * x);
  const double slope = cable_pull(x);
  const double curvature = 2.0 * problem.stiffness * (1.0 - l / L + x * x * l / (L * L * L));
  return v * v * curvature / 12.0 - slope * slope / (24.0 * problem.mass);
}

/// Integral of D over the quarter swing launched at v1, by Simpson's rule in u with x = x_max sin u: dt = du sqrt(s_max
/// (L_max + L)/ (1 + s/s_max))/v1, s the stretch (verification/reference/two_cable.hpp).
double integral_in_addition(double v1) {
  const reference::TwoCableMotion motion{problem, v1};
  const double furthest = motion.largest_distance();
  const double longest = std::hypot(problem.length, furthest), most = longest - problem.length;
  constexpr int n = 200;
  double sum = 0.0;
  for (int i = 0; i <= n; ++i) {
    const double x = furthest * std::sin(0.5 * std::numbers::pi * i / n);
    const double length = std::hypot(problem.length, x), s = length - problem.length;
    const double rate = std::sqrt(most * (longest + length) / (1.0 + s / most)) / v1;
    const double v_square = v1 * v1 * (1.0 - s / most) * (1.0 + s / most);
    sum += (i == 0 || i == n ? 1.0
            : i % 2 == 1     ? 4.0
                             : 2.0) *
           rate * kept_in_addition(x, std::sqrt(std::max(0.0, v_square)));
  }
  return sum * 0.5 * std::numbers::pi / (3.0 * n);
}

/// What the launch at v1 in steps of that length misses, over what it is predicted to miss.
void check_constants(const reference::TwoCableMotion& motion, double v1, double step, const Launch& launch,
                     Findings& findings) {
  // At the launch D = 0 (the cables have no stiffness across their line), so E is the true one; the quarter period at
  // fixed energy changes by -h^2 d/dE of the integral of D, dE = m v1 dv1, and the turn lies where U - h^2 U'^2/(24 m)
  // = E.
  const double dv = 1e-3;
  const double per_energy =
      (integral_in_addition(v1 + dv) - integral_in_addition(v1 - dv)) / (2.0 * dv * problem.mass * v1);
  const double x = motion.largest_distance();
  const double pull = cable_pull(x);
  double largest = 0.0;
  for (int i = 0; i <= 400; ++i) {
    const double at = x * i / 400.0;
    largest = std::max(largest,
                       2.0 / problem.mass * step * step * std::abs(kept_in_addition(at, motion.speed_at_distance(at))));
  }
  const std::string argument =
      "second-order constant derived from the Hamiltonian that the method keeps; the next order is (w h)^2 "
      "of it, with w h = .02 at the turn";
  findings.expect(
      "time of travel, cables alone: error over its prediction", launch.time_error / (-step * step * per_energy), 1.0,
      Tolerance::model(0.02, argument + "; the cubic between two steps takes the method's v for dx/dt, which differ by "
                                        "h^2 U''/(6 m): about 1 % of the error"));
  findings.expect("distance, cables alone: error over its prediction",
                  launch.distance_error / (step * step * pull / (24.0 * problem.mass)), 1.0,
                  Tolerance::model(1e-3, argument));
  findings.expect("curve v^2(theta): largest error over its prediction", launch.curve_error / largest, 1.0,
                  Tolerance::model(1e-3, argument));
}

/// Speed over angle, the solver beside Eq. 27.
Figure speed_curve(const reference::TwoCableMotion& motion, const Series& solver) {
  Series exact{.label = "Eq. 27", .style = Style::lines};
  for (int i = 0; i <= 200; ++i) {
    const double theta = motion.largest_angle() * i / 200.0;
    exact.add(theta, motion.speed_at_angle(theta));
  }
  return {.name = "speed_curve",
          .title = "Speed of the particle over the angle of the cables",
          .caption = "Launched at $v_1 = 2$ m/s: velocity Verlet against Eq. 27.",
          .x = {.label = "angle of the cables", .unit = "rad"},
          .y = {.label = "speed", .unit = "m/s"},
          .series = {exact, solver}};
}

}  // namespace

void check_cables_alone(Findings& findings, const Setup& setup) {
  const double v1 = reference::rigid_impact(problem).particle;
  const reference::TwoCableMotion motion{problem, v1};
  const double turning_time = motion.time_to_turning();  // at 50 digits: taken once
  Convergence time, distance;
  Launch launch;
  double step = 0.0;
  for (const double steps : doublings(20, setup.coarse ? 3 : 4)) {
    step = turning_time / (steps - 0.381966);
    launch = launched(motion, turning_time, v1, step, setup, findings);
    time.add(step, std::abs(launch.time_error));
    distance.add(step, std::abs(launch.distance_error));
  }
  const std::string why =
      "smooth motion under velocity Verlet: even powers of the step only; at 20 steps the fourth order is some "
      "hundredths of the second";
  findings.expect_order("order of the time of travel, cables alone", time, 1.95, 2.05, why);
  findings.expect_order("order of the distance, cables alone", distance, 1.95, 2.05, why);
  if (setup.coarse) return;
  check_constants(motion, v1, step, launch, findings);
  findings.figure(speed_curve(motion, launch.curve));
}

}  // namespace talus::verification::problems
