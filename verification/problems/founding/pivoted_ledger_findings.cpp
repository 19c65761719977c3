#include "verification/problems/founding/pivoted_ledger_findings.hpp"

#include <algorithm>
#include <cmath>

#include "verification/reference/restitution.hpp"
#include "verification/study/curves.hpp"
#include "verification/study/phases.hpp"
#include "verification/study/pivoted_impact.hpp"
#include "verification/study/scene_run.hpp"

namespace talus::verification::problems {
namespace {

const reference::PivotedCylinder problem{};

/// The ledger's closures against the predicted constant.
void check_closures(Findings& findings, const Convergence& closures, double damping) {
  const double e = problem.restitution;
  const double constant = 0.25 * damping * (1.0 - e * e) / (0.5 * problem.rock_mass);
  findings.expect_order(
      "order of the ledger's closure", closures, 0.953, 1.047,
      "the dashpot's power is booked with the velocity of half a step before; a next term of w h times "
      "the first, .2 at 16 steps and .006 at 512, tilts the fit by .047");
  findings.expect("closure of the ledger after the impact, 512 steps per contact", closures.errors().back(),
                  constant * closures.steps().back(),
                  Tolerance::model(0.0065,
                                   "(h/4) c (1 - e^2) v0^2, over the rock's kinetic energy; the next power of the step "
                                   "is w h = .006 of it")
                      .relative());
  findings.figure({.name = "ledger",
                   .title = "Closure of the energy ledger after the impact",
                   .caption =
                       "Energy now, plus what the dashpot was booked to take, less energy before, over the rock's "
                       "kinetic energy; root mean square over 64 phases. The line is not fitted.",
                   .x = {.label = "step", .unit = "s", .log = true},
                   .y = {.label = "closure / kinetic energy", .log = true},
                   .series = {{"velocity Verlet", closures.steps(), closures.errors(), Style::points},
                              curve("predicted", closures.steps(), [&](double step) { return constant * step; })},
                   .slopes = {{1.0, closures.steps().front(), 0.5 * closures.errors().front(), "h"}}});
}

/// Angular momentum of rock and column about the pin.
double about_pin(const State& s) {
  const double x = s.q[1];
  const double y = s.q[2] - 0.5 * problem.length;
  return reference::inertia_about_pin(problem) * s.v[0] + problem.rock_mass * (x * s.v[2] - y * s.v[1]) +
         0.4 * problem.rock_mass * problem.rock_radius * problem.rock_radius * s.v[3];
}

/// The accounts of one impact.
struct Closure {
  double energy{};    ///< at the end, over the largest kinetic energy
  double momentum{};  ///< largest relative change of the angular momentum about the pin
};

Closure closure_of(const Scene& scene, const Integrator& method, double step, double end, Findings& findings) {
  Accounting accounting{scene.model, scene.initial};
  const double before = about_pin(scene.initial);
  Closure found;
  const RunEnd ended = run_scene(scene, method, {step, end, end, true}, findings, [&](const State& state, const auto&) {
    found.momentum = std::max(found.momentum, std::abs(about_pin(state) / before - 1.0));
    found.energy = accounting(state).energy_closure;
  });
  found.energy = ended.finished ? found.energy / accounting.ledger().energy_scale() : std::nan("");
  return found;
}

}  // namespace

void check_ledger(Findings& findings, const Setup& setup) {
  Convergence closures;
  double worst_momentum = 0.0;
  PivotedRun run{.gravity = false};
  const double damping = contact_of(run).damping;
  const double time =
      reference::impact_events({run.stiffness, damping, impact_mass(), problem.approach_speed}, contact_of(run).end)
          .contact_time;
  const Integrator method = setup.has("rk4") ? Integrator{RungeKutta4{}} : Integrator{VelocityVerlet{}};
  for (const double n : doublings(16.0, setup.coarse ? 1 : 6)) {
    PhaseError energy;
    for (const Phase& phase : offset_phases(time, n)) {
      run.gap = phase.lead() * problem.approach_speed;
      const Closure found = closure_of(scene_of(run, setup), method, phase.step, 1.5 * time, findings);
      energy.add(found.energy);
      worst_momentum = std::max(worst_momentum, found.momentum);
    }
    closures.add(time / (n + 0.5), energy.rms());
  }
  findings.expect("angular momentum about the pin, largest relative change", worst_momentum, 0.0,
                  Tolerance::round_off(3e-14,
                                       "a kick adds equal and opposite moments, a drift moves the rock along its own "
                                       "velocity: 800 steps of a dozen roundings, sqrt(1e4) x 2.2e-16 = 2.2e-14"));
  if (!setup.coarse) check_closures(findings, closures, damping);
}

}  // namespace talus::verification::problems
