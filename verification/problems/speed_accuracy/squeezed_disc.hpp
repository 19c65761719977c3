#pragma once

#include "verification/study/toolkit.hpp"

/// A disc squeezed between two planes: both contacts remain closed, so that the motion about the middle is that of a
/// bilateral damped oscillator, and each step of a method multiplies the state by the same matrix.
namespace talus::verification::problems {

struct SqueezedDisc {
  double frequency = 100.0;    ///< w of the oscillator [rad/s]: two contacts of k = m w^2/2 each
  double damping_ratio = 0.0;  ///< xi of the oscillator
};

inline Scene squeezed_disc(const SqueezedDisc& p) {
  constexpr double mass = 1.0;
  constexpr double radius = 1.0;
  constexpr double depth = 0.5;
  const LinearSpringDashpot law{0.5 * mass * p.frequency * p.frequency, p.damping_ratio * mass * p.frequency,
                                EndRule::attractive};
  SceneBuilder builder{si};
  const BodyId disc =
      builder.add({.name = "disc", .mobility = Mobility::particle, .mass = mass, .shape = Circle{radius}});
  const BodyId floor =
      builder.add({.name = "floor", .mobility = Mobility::fixed, .shape = HalfPlane{}, .p_WB = {0.0, depth - radius}});
  const BodyId ceiling = builder.add({.name = "ceiling",
                                      .mobility = Mobility::fixed,
                                      .shape = HalfPlane{},
                                      .p_WB = {0.0, radius - depth},
                                      .angle = std::acos(-1.0)});
  builder.add_contact("below", disc, floor, law);
  builder.add_contact("above", disc, ceiling, law);
  return builder.at_rest("Disc squeezed between two planes");
}

/// Distance from the middle, and velocity over w [m].
using Deviation = std::array<double, 2>;

inline double size(const Deviation& deviation) { return std::hypot(deviation[0], deviation[1]); }

/// Runs of one squeezed disc.
class SqueezedRuns {
 public:
  explicit SqueezedRuns(const SqueezedDisc& disc) : frequency_{disc.frequency}, scene_{squeezed_disc(disc)} {}

  /// Deviations at the start and after each of `steps` steps of length eta/w. The run ends earlier if the deviation
  /// reaches 0.01, because a stage of the next step may lie far beyond, and at 0.5 a contact opens.
  std::vector<Deviation> run(Integrator integrator, double eta, long steps, const Deviation& start) const {
    Scene scene = scene_;
    scene.initial.q[1] = start[0];
    scene.initial.v[1] = start[1] * frequency_;
    std::vector<Deviation> all;
    const Watcher watch = [&](const State& seen, const StepInfo&) {
      all.push_back({seen.q[1], seen.v[1] / frequency_});
    };
    const Until far = [&](const State& seen) { return !(size({seen.q[1], seen.v[1] / frequency_}) < 0.01); };
    const double step = eta / frequency_;
    const RunPlan plan{.step = step, .end = step * static_cast<double>(steps), .interval = step, .ledger = false};
    run_scene(scene, std::move(integrator), plan, nullptr, watch, far);
    return all;
  }

 private:
  double frequency_;
  Scene scene_;
};

}  // namespace talus::verification::problems
