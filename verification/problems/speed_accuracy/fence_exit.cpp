#include "verification/problems/speed_accuracy/fence_exit.hpp"

#include "solver/scenes/fence_scene.hpp"
#include "verification/study/scenes/fence_table.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems {

FenceHit fence_hit() {
  FenceHit hit{scenes::fence_scene(published_fence("table_2.DAT")).scene, 0};
  const auto& v = hit.scene.initial.v;
  hit.rock =
      static_cast<std::size_t>(std::find_if(v.begin(), v.end(), [](double rate) { return rate != 0.0; }) - v.begin());
  return hit;
}

FenceExit run_fence(const FenceHit& hit, Integrator integrator, const FenceSteps& plan, Findings& findings) {
  Probe probe{hit.scene.model};
  FenceExit found;
  const Watcher watch = [&](const State& seen, const StepInfo& info) {
    if (!info.due) return;
    found.speed = seen.v[hit.rock];
    probe.evaluate(seen);
    const std::vector<double>& tensions = probe.forces().tensions;
    found.tension = std::max(found.tension, *std::max_element(tensions.begin(), tensions.end()));
  };
  const double span = plan.end / static_cast<double>(plan.spans);
  const RunEnd end = run_scene(hit.scene, std::move(integrator),
                               {span / static_cast<double>(plan.steps), plan.end, span, false}, findings, watch);
  found.evaluations = static_cast<double>(end.evaluations);
  if (!end.finished) found.speed = std::nan("");
  if (const auto* located = std::get_if<StormerCowell>(&end.method)) found.events = located->events();
  return found;
}

}  // namespace talus::verification::problems
