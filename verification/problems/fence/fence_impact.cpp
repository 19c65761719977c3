#include "verification/problems/fence/fence_impact.hpp"

#include <variant>

#include "solver/integrate/advance.hpp"
#include "solver/integrate/concepts.hpp"
#include "solver/scenes/fence_scene.hpp"
#include "verification/study/toolkit.hpp"

namespace talus::verification::problems {
namespace {

/// Indices of the bodies and cables of a scene whose quantities a sample contains.
struct CableIndices {
  explicit CableIndices(const scenes::FenceScene& made) {
    std::size_t member = 1;
    for (; made.members[member].layer == 0; ++member)
      rocks.push_back(index(*made.members[member].body));
    centre = member;
    for (; member < made.members.size() && made.members[member].layer == 1; ++member) {
      if (made.members[member].top) top.push_back(index(*made.members[member].top));
      if (made.members[member].bottom) bottom.push_back(index(*made.members[member].bottom));
    }
  }
  std::size_t centre{};             ///< member that is the first layer's central column
  std::vector<std::size_t> rocks;   ///< bodies
  std::vector<std::size_t> top;     ///< segments of the first layer, from the centre outwards
  std::vector<std::size_t> bottom;  ///< likewise; may be empty
};

/// The system of a scene, which records the forces of each evaluation.
class WatchedFence {
 public:
  WatchedFence(const scenes::FenceScene& made, double step, long every)
      : dynamics_{made.scene.model},
        indices_{made},
        work_{dynamics_.workspace()},
        tensions_(made.scene.model.cables.size()),
        joint_{dynamics_.cables().ends()[indices_.top.front()].a},
        memory_{dynamics_.layout().cable_slots[indices_.top.front()].memory},
        half_step_{0.5 * step},
        every_{every} {
    for (const std::size_t rock : indices_.rocks)
      mass_ += made.scene.model.bodies[rock].mass;
    start_energy_ = rock_energy(made.scene.initial);
  }

  void drift(State& state, double h) const { drift_coordinates(state, h); }
  void update_modes(State& state) {
    dynamics_.update(state, work_);
    dynamics_.update_modes(state, work_);
  }
  void derivative(const State& state, Rates& out) {
    dynamics_.update(state, work_);
    dynamics_.rates(state, work_, out, false);
  }
  void evaluate(State& state, Rates& out) {
    update_modes(state);
    dynamics_.rates(state, work_, out, false);
    watch(state);
    ++run_.evaluations;
  }

  FenceRun finished(const State& end) {
    run_.peaks.speed = rock_speed(end);
    run_.energy = rock_energy(end) / start_energy_;
    const auto finite = [](double x) { return std::isfinite(x); };
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    if (!std::all_of(end.q.begin(), end.q.end(), finite)) run_.peaks = {nan, nan, nan, nan, nan, nan};
    return std::move(run_);
  }

 private:
  void watch(const State& state) {
    dynamics_.cables().tensions(state, work_, tensions_);
    const FenceSample now{.time = state.t + half_step_,
                          .joint = norm(work_.joints.force(joint_)),
                          .top = tensions_[indices_.top.front()],
                          .bottom = indices_.bottom.empty() ? 0.0 : tensions_[indices_.bottom.front()],
                          .speed = rock_speed(state),
                          .stretch = state.z[memory_]};
    FenceSample& peaks = run_.peaks;
    if (now.joint > peaks.joint) peaks.time = now.time;
    peaks.joint = std::max(peaks.joint, now.joint);
    peaks.top = std::max(peaks.top, now.top);
    peaks.bottom = std::max(peaks.bottom, now.bottom);
    peaks.stretch = std::max(peaks.stretch, now.stretch);
    for (const std::size_t c : indices_.top)
      run_.top_any = std::max(run_.top_any, tensions_[c]);
    for (const std::size_t c : indices_.bottom)
      run_.bottom_any = std::max(run_.bottom_any, tensions_[c]);
    if (every_ > 0 && run_.evaluations % every_ == 0) run_.history.push_back(now);
  }

  double rock_speed(const State& state) const {
    double momentum = 0.0;
    for (const std::size_t rock : indices_.rocks)
      momentum += dynamics_.model().bodies[rock].mass * state.v[dynamics_.layout().first[rock]];
    return momentum / mass_;
  }

  /// Kinetic energy of the rocks, translational and rotational.
  double rock_energy(const State& state) const {
    double energy = 0.0;
    for (const std::size_t rock : indices_.rocks) {
      const std::size_t first = dynamics_.layout().first[rock];
      for (std::size_t i = first; i < first + 3; ++i)
        energy += 0.5 * dynamics_.inertias()[i] * state.v[i] * state.v[i];
    }
    return energy;
  }

  Dynamics dynamics_;
  CableIndices indices_;
  Workspace work_;
  std::vector<double> tensions_;
  std::size_t joint_;
  std::size_t memory_;
  double half_step_;
  long every_;
  double mass_{};
  double start_energy_{};
  FenceRun run_;
};

static_assert(Differentiable<WatchedFence>);

}  // namespace

FenceRun run_fence(const scenes::Fence& fence, long every) {
  scenes::FenceScene made = scenes::fence_scene(fence);
  const double step = made.scene.plan.step;
  WatchedFence system{made, step, every};
  State state = made.scene.initial;
  auto& method = std::get<LaggedCentralDifference>(made.scene.integrator);
  system.update_modes(state);
  method.start(system, state, step);
  for (long n = 0; n < fence.steps; ++n) {
    state.t = static_cast<double>(n) * step;
    method.step(system, state, step);
  }
  return system.finished(synchronized(method, system, state, step));
}

}  // namespace talus::verification::problems
