#include "verification/problems/fence/sample2_run.hpp"

#include <algorithm>

#include "solver/io/fence1993/out_listing.hpp"
#include "solver/io/fence1993/read_deck.hpp"
#include "verification/check/case_file.hpp"
#include "verification/study/runs/scene_run.hpp"

namespace talus::verification::problems {
namespace {

ElementState state_of(const scenes::FenceMember& member, const Model& model, const State& held) {
  if (!member.body) return {member.position.x, member.position.y, member.angle, 0.0, 0.0, 0.0};
  // The ground's frame lies in its surface; its element is the block below.
  if (model.bodies[index(*member.body)].mobility == Mobility::fixed)
    return {member.position.x, member.position.y, member.angle, 0.0, 0.0, 0.0};
  const Pose at = pose(model, held, *member.body);
  return {at.p_WB.x, at.p_WB.y, angle(model, held, *member.body), at.v_WB.x, at.v_WB.y, at.w_WB};
}

}  // namespace

Sample2Run run_sample2(const Sample2Change& change) {
  Sample2Run run;
  run.fence = read_deck(case_file("fence/sample2.DAT"));
  if (change.records) change.records(run.fence);
  run.made = scenes::fence_scene(run.fence);
  if (change.made) change.made(run.made);
  const Scene& scene = run.made.scene;
  RunPlan plan = scene.plan;
  plan.end = static_cast<double>(printed_steps.back()) * plan.step;
  OutListing listing{run.fence, run.made, scene.plan};
  const Watcher print = [&](const State& seen, const StepInfo& info) {
    listing(seen, info);
    if (std::find(printed_steps.begin(), printed_steps.end(), info.step) == printed_steps.end()) return;
    run.states.emplace_back();
    for (const scenes::FenceMember& member : run.made.members)
      run.states.back().push_back(state_of(member, scene.model, *info.held));
  };
  run.evaluations = run_scene(scene, scene.integrator, plan, nullptr, print).evaluations;
  run.listing = listing.text();
  return run;
}

}  // namespace talus::verification::problems
