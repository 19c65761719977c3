#include "verification/problems/founding/two_cable_impact.hpp"

#include "solver/laws/restitution.hpp"
#include "solver/scenes/two_cable.hpp"
#include "verification/reference/impacts/restitution.hpp"
#include "verification/study/impacts/followed_impact.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems {
namespace {

const reference::TwoCable problem{};

/// Observes the particle: detects the end of the contact, and records the deviation from Eq. 27 after it.
class ParticleMonitor {
 public:
  explicit ParticleMonitor(const Model& model) : probe_{model} {}

  void check(const State& state) {
    probe_.evaluate(state);
    const bool acts = state.mode[0] == UnilateralSpring::acting && probe_.overlap(0) >= 0.0;
    touched_ = touched_ || acts;
    const double x = state.q[0], v = state.v[0];
    if (touched_ && !acts && !ended_) {
      ended_ = true;
      speed_after = v;
      energy_ = v * v + 2.0 * stretch_energy(x);
    }
    if (ended_ && v > 0.0) keep_largest(curve_error, v * v + 2.0 * stretch_energy(x) - energy_);
  }

  bool ended() const { return ended_; }
  double speed_after{std::nan("")};
  double curve_error{};

 private:
  /// Half the last term of Eq. 27, k l^2 (1 - cos theta)^2/(m cos^2 theta). The elongation l (1 - cos theta)/cos theta
  /// is computed as x tan(theta/2), which avoids cancellation.
  static double stretch_energy(double x) {
    const double s = x * std::tan(0.5 * std::atan(x / problem.length));
    return problem.stiffness * s * s / problem.mass;
  }

  Probe probe_;
  bool touched_{false}, ended_{false};
  double energy_{};
};

}  // namespace

double reduced_mass() { return problem.mass * problem.striker_mass / (problem.mass + problem.striker_mass); }

double particle_fraction() { return problem.striker_mass / (problem.mass + problem.striker_mass); }

double cable_pull(double x) {
  return 2.0 * problem.stiffness * (1.0 - problem.length / std::sqrt(problem.length * problem.length + x * x)) * x;
}

LinearSpringDashpot solver_contact(double stiffness, TwoCableEnd end, const Setup& setup) {
  const double mass = effective_mass({problem.mass, {}, 0.0, false}, {problem.striker_mass, {}, 0.0, false});
  const double c = damping(damping_ratio(problem.restitution, end.formula), stiffness, mass);
  return {stiffness, setup.has("dashpot_halved") ? 0.5 * c : c,
          setup.has("wrong_end_rule") ? EndRule::clamped : end.rule};
}

reference::SoftContact soft_contact(double stiffness, TwoCableEnd end) {
  const double xi = reference::damping_ratio(problem.restitution, same(end.formula));
  return {stiffness, 2.0 * xi * std::sqrt(stiffness * reduced_mass()), same(end.rule)};
}

Scene scene_of(const LinearSpringDashpot& law, const Setup& setup) {
  scenes::TwoCable parameters{.contact = law};
  if (setup.has("mass_halved")) parameters.mass *= 0.5;
  if (setup.has("cable_stiffness_per_length")) parameters.cable_stiffness /= parameters.cable_length;
  return scenes::two_cable(parameters);
}

TwoCableRun simulated(Scene scene, double gap, double step, bool to_the_turn, Findings& findings) {
  scene.initial.q[2] -= gap;
  RunLedger ledger{scene.model, scene.initial};
  TurningPointFinder finder{0};
  ParticleMonitor watch{scene.model};
  TwoCableRun run;
  const Watcher watcher = [&](const State& state, const StepInfo& info) {
    finder(state, info);
    watch.check(state);
    if (!to_the_turn) return;
    const Accounts accounts = ledger(state);
    run.energy_balance_error = accounts.energy_balance_error;
    keep_largest(run.momentum_balance_error, accounts.momentum_balance_error.x);
  };
  const Until stop = [&](const State&) { return to_the_turn ? finder.found().has_value() : watch.ended(); };
  const RunEnd end = run_scene(scene, scene.integrator, {step, 5.0, 5.0, to_the_turn}, findings, watcher, stop);
  run.speed_after = end.finished ? watch.speed_after : std::nan("");
  run.curve_error = watch.curve_error;
  run.turning = end.finished && finder.found() ? *finder.found() : TurningPoint{std::nan(""), std::nan("")};
  run.momentum_balance_error /= problem.striker_mass * problem.approach_speed;
  return run;
}

}  // namespace talus::verification::problems
