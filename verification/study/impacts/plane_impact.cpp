#include "verification/study/impacts/plane_impact.hpp"

#include <cmath>

#include "solver/scenes/bouncing_disc.hpp"
#include "verification/study/runs/scene_run.hpp"

namespace talus::verification::problems {

PlaneRebound plane_rebound(const ContactLaw& law, const PlaneImpact& impact, Findings& findings) {
  const double lead = impact.phase * impact.step;
  const Scene scene = scenes::bouncing_disc(
      {.radius = impact.radius, .gap = lead * impact.speed, .speed = impact.speed, .contact = law});
  PlaneRebound seen;
  bool pushed = false, ended = false;
  Probe probe{scene.model};
  const Until over = [&](const State& state) {
    probe.evaluate(state);
    const double force = probe.forces().contacts[0];
    seen.time.push_back(state.t - lead);
    seen.depth.push_back(probe.overlap(0));
    seen.force.push_back(force);
    pushed = pushed || force != 0.0;
    ended = pushed && force == 0.0;
    return ended;
  };
  RunLedger ledger{scene.model, scene.initial};
  const double end = lead + impact.longest;
  const RunEnd run = run_scene(scene, VelocityVerlet{}, {impact.step, end, end, true}, findings, {}, over);
  if (!run.finished || !ended) return {};
  const Accounts accounts = ledger(run.state);
  const double energy = 0.5 * impact.speed * impact.speed;
  seen.speed = run.state.v[1];
  seen.balance_error = accounts.energy_balance_error / energy;
  seen.lost = accounts.total_dissipated() / energy;
  return seen;
}

double fraction(double x) { return x - std::floor(x); }

}  // namespace talus::verification::problems
