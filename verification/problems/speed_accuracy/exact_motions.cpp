#include "verification/problems/speed_accuracy/exact_motions.hpp"

#include "solver/scenes/bouncing_disc.hpp"
#include "solver/scenes/pendulum.hpp"
#include "verification/reference/cables/two_cable.hpp"
#include "verification/reference/impacts/damped_bounce.hpp"
#include "verification/study/runs/swing.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems {
namespace {

std::vector<double> times_to(double duration) {
  std::vector<double> times;
  for (int i = 0; i <= compared_times; ++i)
    times.push_back(duration * i / compared_times);
  return times;
}

ExactMotion pendulum_from(const char* name, double amplitude, double duration) {
  ExactMotion made{
      name,
      // Nearly all mass at the end of the arm, so that w0^2 = g to the last digit.
      scenes::pendulum({.mass = 1.0, .inertia = 1e-20, .arm = 1.0, .gravity = 9.81, .amplitude = amplitude}),
      duration,
      0,
      {}};
  const auto motion = reference::PendulumMotion::from_rest(std::sqrt(9.81), amplitude);
  for (const double t : times_to(duration)) {
    const auto state = motion.at(t);
    made.exact.push_back({state.angle, state.rate});
  }
  return made;
}

Scene particle_on_cables() {
  SceneBuilder builder{si};
  const BodyId particle = builder.add_particle("particle", 1.0);
  for (const double side : {10.0, -10.0}) {
    builder.add_cable(side > 0.0 ? "upper" : "lower", {particle, {}}, {std::nullopt, {0.0, side, 0.0}}, 10.0,
                      TensionOnly{4.0, 0.0});
  }
  Scene scene = builder.at_rest("Particle on two cables");
  set_velocity(scene.model, scene.initial, particle, {2.0, 0.0}, 0.0);
  return scene;
}

ExactMotion two_cables() {
  ExactMotion made{"two cables", particle_on_cables(), 50.0, 0, {}};
  const reference::TwoCableMotion motion{{.stiffness = 4.0, .length = 10.0, .mass = 1.0}, 2.0};
  for (const double t : times_to(made.duration)) {
    const auto state = motion.at(t);
    made.exact.push_back({state.position, state.velocity});
  }
  return made;
}

ExactMotion damped_bounce() {
  constexpr double w = 100.0, xi = 0.2, gravity = 9.81, gap = 0.618, speed = 1.0, radius = 1.0;
  ExactMotion made{"damped bounce",
                   scenes::bouncing_disc({.mass = 1.0,
                                          .radius = radius,
                                          .gap = gap,
                                          .speed = speed,
                                          .gravity = gravity,
                                          .contact = LinearSpringDashpot{w * w, 2.0 * xi * w, EndRule::clamped}}),
                   3.0,
                   1,
                   {}};
  const auto states =
      reference::bounce_states({w, xi, gravity, gap, speed, reference::EndRule::clamped}, times_to(made.duration));
  for (const auto& state : states)
    made.exact.push_back({radius + state.gap, -state.velocity});
  return made;
}

}  // namespace

std::vector<ExactMotion> exact_motions() {
  std::vector<ExactMotion> all;
  all.push_back(pendulum_from("pendulum, 90 degrees", 90.0 * degree, 24.388772));
  all.push_back(pendulum_from("pendulum, 170 degrees", 170.0 * degree, 50.4033));
  all.push_back(two_cables());
  all.push_back(damped_bounce());
  return all;
}

WorkPoint run_motion(const ExactMotion& motion, Integrator integrator, long steps, Findings& findings) {
  double position = 0.0, velocity = 0.0, largest_position = 0.0, largest_velocity = 0.0;
  const Watcher compare = [&](const State& seen, const StepInfo& info) {
    if (info.step == 0 || info.step % steps != 0) return;
    const PositionAndVelocity& exact = motion.exact[static_cast<std::size_t>(info.step / steps)];
    keep_largest(position, seen.q[motion.coordinate] - exact.position);
    keep_largest(velocity, seen.v[motion.coordinate] - exact.velocity);
    keep_largest(largest_position, exact.position);
    keep_largest(largest_velocity, exact.velocity);
  };
  const double interval = motion.duration / compared_times;
  const RunPlan plan{interval / static_cast<double>(steps), motion.duration, interval, false};
  const RunEnd end = run_scene(motion.scene, std::move(integrator), plan, findings, compare);
  WorkPoint point{worst_of({position / largest_position, velocity / largest_velocity}),
                  static_cast<double>(end.evaluations)};
  if (!end.finished) point.error = std::nan("");
  if (const auto* located = std::get_if<StormerCowell>(&end.method)) point.events = located->events();
  return point;
}

}  // namespace talus::verification::problems
