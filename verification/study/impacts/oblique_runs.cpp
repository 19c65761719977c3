#include "verification/study/impacts/oblique_runs.hpp"

#include <cmath>

#include "verification/check/convergence.hpp"
#include "verification/study/runs/scene_run.hpp"

namespace talus::verification::problems {

reference::ObliqueImpact oblique_disc(double kappa, double ratio) {
  return {.normal = {1.0, 0.0, 1.0, 1.0},
          .tangential_stiffness = kappa,
          .friction = oblique_friction,
          .mobility = 3.0,
          .slip_rate = ratio * oblique_friction / kappa};
}

Scene oblique_scene_of(const reference::ObliqueImpact& impact, const Setup& setup) {
  reference::ObliqueImpact wrong = impact;
  if (setup.has("friction_halved")) wrong.friction *= 0.5;
  if (setup.has("slip_stiffness_doubled")) wrong.tangential_stiffness *= 2.0;
  if (setup.has("disc_that_cannot_spin")) wrong.mobility = 1.0;
  return oblique_scene(wrong, EndRule::clamped);
}

void go_back(State& state, double t) {
  for (std::size_t i = 0; i < state.q.size(); ++i)
    state.q[i] -= t * state.v[i];
}

ObliqueRun run_oblique_at_step(const Scene& scene, double contact_time, double step, std::size_t phase,
                               Findings& findings) {
  Scene from = scene;
  go_back(from.initial, even_phases(fewest_phases)[phase] * step);
  RunLedger ledger{scene.model, from.initial};
  const double steps = std::ceil(1.2 * contact_time / step) + 2.0;
  ObliqueRun run{run_scene(from, VelocityVerlet{}, {step, step * steps, 1e9, true}, findings).state, 0.0, 0.0};
  run.slip_rate = run.end.v[0] + (run.end.v.size() > 2 ? oblique_radius * run.end.v[2] : 0.0);
  run.balance_error = ledger(run.end).energy_balance_error;
  return run;
}

ObliqueRun run_oblique(const Scene& scene, double contact_time, double count, std::size_t phase, Findings& findings) {
  return run_oblique_at_step(scene, contact_time, offset_step(contact_time, count, phase), phase, findings);
}

double kinetic_energy(const State& end) {
  const double rim = end.v.size() > 2 ? end.v[2] * oblique_radius : 0.0;
  return 0.5 * (end.v[0] * end.v[0] + end.v[1] * end.v[1] + 0.5 * rim * rim);
}

}  // namespace talus::verification::problems
