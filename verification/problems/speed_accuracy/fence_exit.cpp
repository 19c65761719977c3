#include "verification/problems/speed_accuracy/fence_exit.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "solver/run/simulate.hpp"
#include "solver/scenes/fence_scene.hpp"
#include "verification/study/fence_table.hpp"

namespace talus::verification::problems {

FenceHit fence_hit() {
  FenceHit hit{scenes::fence_scene(published_fence("table_2.DAT")).scene, 0};
  const auto& v = hit.scene.initial.v;
  hit.rock =
      static_cast<std::size_t>(std::find_if(v.begin(), v.end(), [](double rate) { return rate != 0.0; }) - v.begin());
  return hit;
}

FenceExit run_fence(const FenceHit& hit, Integrator integrator, const FenceSteps& plan, Findings& findings) {
  const Dynamics dynamics{hit.scene.model};
  RigidBodySystem system{dynamics, false};
  State state = hit.scene.initial;
  Workspace work = dynamics.workspace();
  LawForces forces;
  FenceExit found;
  const Observer observer = [&](const State& seen, const StepInfo& info) {
    if (!info.due) return;
    found.speed = seen.v[hit.rock];
    dynamics.update(seen, work);
    dynamics.forces(seen, work, forces);
    found.tension = std::max(found.tension, *std::max_element(forces.tensions.begin(), forces.tensions.end()));
  };
  const double span = plan.end / static_cast<double>(plan.spans);
  const Outcome outcome = simulate(system, integrator, state,
                                   {span / static_cast<double>(plan.steps), plan.end, span, false}, {&observer, 1});
  findings.count(static_cast<std::uint64_t>(system.evaluations()));
  found.evaluations = static_cast<double>(system.evaluations());
  if (!outcome) found.speed = std::nan("");
  if (const auto* located = std::get_if<StormerCowell>(&integrator)) found.events = located->events();
  return found;
}

}  // namespace talus::verification::problems
