#include "verification/study/plane_impact.hpp"

#include <cmath>

#include "solver/run/energy_ledger.hpp"
#include "solver/run/simulate.hpp"
#include "solver/scenes/bouncing_disc.hpp"

namespace talus::verification::problems {

PlaneRebound plane_rebound(const ContactLaw& law, const PlaneImpact& impact, Findings& findings) {
  const double lead = impact.phase * impact.step;
  const Scene scene = scenes::bouncing_disc(
      {.radius = impact.radius, .gap = lead * impact.speed, .speed = impact.speed, .contact = law});
  const Dynamics dynamics{scene.model};
  RigidBodySystem system{dynamics};
  Workspace work = dynamics.workspace();
  LawForces forces;
  PlaneRebound seen;
  bool pushed = false, ended = false;
  const StopCondition watch = [&](const State& state) {
    dynamics.update_all(state, work);
    dynamics.forces(state, work, forces);
    seen.time.push_back(state.t - lead);
    seen.depth.push_back(work.gaps[0].depth);
    seen.force.push_back(forces.contacts[0]);
    pushed = pushed || forces.contacts[0] != 0.0;
    ended = pushed && forces.contacts[0] == 0.0;
    return ended;
  };
  State state = scene.initial;
  EnergyLedger ledger{dynamics, state};
  Integrator verlet = VelocityVerlet{};
  const double end = lead + impact.longest;
  const Outcome outcome = simulate(system, verlet, state, {impact.step, end, end, true}, {}, watch);
  findings.count(static_cast<std::uint64_t>(system.evaluations()));
  if (!outcome || !ended) return {};
  const Accounts accounts = ledger.accounts(state);
  const double energy = 0.5 * impact.speed * impact.speed;
  seen.speed = state.v[1];
  seen.closure = accounts.energy_closure / energy;
  seen.lost = accounts.dissipated() / energy;
  return seen;
}

double fraction(double x) { return x - std::floor(x); }

double farther_from_one(double ratio, double other) {
  return std::abs(other - 1.0) < std::abs(ratio - 1.0) ? ratio : other;
}

}  // namespace talus::verification::problems
