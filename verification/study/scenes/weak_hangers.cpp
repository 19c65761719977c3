#include "verification/study/scenes/weak_hangers.hpp"

#include <algorithm>

#include "solver/io/fence1993/read_deck.hpp"
#include "verification/check/case_file.hpp"
#include "verification/study/runs/scene_run.hpp"

namespace talus::verification::problems {
namespace {

/// Samples the energies and the central hanger's load.
class Watch {
 public:
  Watch(WeakFenceRun& run, const Dynamics& dynamics, const State& start, long every)
      : run_{&run}, dynamics_{&dynamics}, work_{dynamics.workspace()}, every_{every} {
    dynamics.update(start, work_);
    const Energies energies = dynamics.energies(start, work_);
    held_at_start_ = held(energies);
    if (const auto hanger = run.made.members[2].hanger) slot_ = dynamics.layout().first_hanger + index(*hanger);
    joint_ = dynamics.cables().ends()[index(*run.made.members[2].top)].a;
  }

  void operator()(const State& state, const StepInfo& info) {
    dynamics_->update(state, work_);
    if (slot_ == 0 || state.mode[slot_] == 0) {
      Rates rates{state};
      dynamics_->rates(state, work_, rates, false);
      run_->largest_joint_force = std::max(run_->largest_joint_force, norm(work_.joints.force(joint_)));
    }
    if (every_ == 0 || info.step % every_ != 0) return;
    const Energies energies = dynamics_->energies(state, work_);
    EnergySample sample{.time = state.t, .rock = kinetic_of_rock()};
    sample.fence = energies.kinetic - sample.rock;
    sample.held = held(energies) - held_at_start_;
    for (const double loss : state.work)
      sample.lost += loss;
    sample.hangers = state.work[static_cast<std::size_t>(Mechanism::hanger_break)];
    sample.lost -= sample.hangers;
    run_->history.push_back(sample);
  }

 private:
  static double held(const Energies& e) { return e.gravity + e.applied + e.contacts + e.cables; }
  double kinetic_of_rock() const {
    const std::size_t rock = index(*run_->made.members[1].body);
    const Body& body = dynamics_->model().bodies[rock];
    const Pose pose = work_.poses[rock];
    return 0.5 * body.mass * dot(pose.v_WB, pose.v_WB) + 0.5 * body.inertia * pose.w_WB * pose.w_WB;
  }

  WeakFenceRun* run_;
  const Dynamics* dynamics_;
  Workspace work_;
  long every_;
  double held_at_start_{};
  std::size_t slot_{};
  std::size_t joint_{};
};

}  // namespace

scenes::Fence weak_fence(double hanger_strength) {
  scenes::Fence fence = read_deck(case_file("fence/table_2.DAT"));
  fence.options.contact = scenes::FenceContact::resultant;
  fence.options.end_rule = EndRule::clamped;
  fence.options.start = scenes::FenceStart::plain;
  fence.options.integrator = "velocity_verlet";
  fence.options.column_ground = scenes::ColumnGround::contact;
  fence.options.hanger_strength = hanger_strength;
  return fence;
}

WeakFenceRun run_weak_fence(const scenes::Fence& fence, double step, double end, long every) {
  WeakFenceRun run;
  run.made = scenes::fence_scene(fence);
  const Dynamics dynamics{run.made.scene.model};
  const State start = first_state(run.made.scene);
  RunLedger ledger{run.made.scene.model, start};
  FailureLog failures{dynamics};
  Watch watch{run, dynamics, start, every};
  const RunEnd ended = run_scene(run.made.scene, run.made.scene.integrator, {step, end, end, true}, nullptr,
                                 [&](const State& seen, const StepInfo& info) {
                                   failures(seen, info);
                                   watch(seen, info);
                                 });
  run.end = ended.state;
  run.failures = failures.failures();
  run.balance_error = ledger(run.end).energy_balance_error;
  run.scale = ledger.energy().energy_scale();
  run.hanger_loss = run.end.work[static_cast<std::size_t>(Mechanism::hanger_break)];
  run.evaluations = ended.evaluations;
  return run;
}

}  // namespace talus::verification::problems
