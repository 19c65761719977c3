#include "verification/study/impacts/followed_impact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "verification/study/runs/scene_run.hpp"

namespace talus::verification::problems {
namespace {

/// State of the deepest instance of the contact at one step.
struct Sample {
  double t{};
  double depth{};
  double rate{};
  double force{};  ///< force of the law, whether or not it acts
};

class Follower {
 public:
  explicit Follower(const Dynamics& dynamics)
      : dynamics_{dynamics},
        work_{dynamics.workspace()},
        law_{std::get<LinearSpringDashpot>(dynamics.model().contacts.front().law)},
        instances_{dynamics.layout().contact_instances.front()} {}

  void observe(const State& state) {
    const Sample now = sample(state);
    const bool acts = std::any_of(state.mode.begin(), state.mode.begin() + static_cast<std::ptrdiff_t>(instances_),
                                  [](Mode mode) { return mode == UnilateralSpring::acting; });
    if (!touched_) {
      // At the first sample inside, the force may already have acted; a scene that starts at touch has no sample before
      // it.
      if (now.depth <= 0.0 || !started_) found_.approach_speed = now.rate;
      started_ = true;
      touched_ = now.depth > 0.0;
    } else {
      // Along a fixed normal only the contact force changes the rate, so this change measures the force independently
      // of the law.
      const double deceleration = (before_.rate - now.rate) / (now.t - before_.t);
      found_.minimum_deceleration = std::min(found_.minimum_deceleration, deceleration);
      if (!crossed_ && ending(now) <= 0.0) {
        crossed_ = true;
        found_.end_time = before_.t + (now.t - before_.t) * ending(before_) / (ending(before_) - ending(now));
      }
      ended_ = crossed_ && !acts;
    }
    found_.largest_depth = std::max(found_.largest_depth, now.depth);
    if (ended_) {
      found_.separation_speed = -now.rate;
      found_.at_end = state;
    }
    before_ = now;
  }

  [[nodiscard]] bool ended() const { return ended_; }
  [[nodiscard]] const FollowedImpact& found() const { return found_; }

 private:
  [[nodiscard]] Sample sample(const State& state) {
    dynamics_.update_all(state, work_);
    std::size_t deepest = 0;
    for (std::size_t i = 1; i < instances_; ++i) {
      if (work_.gaps[i].depth > work_.gaps[deepest].depth) deepest = i;
    }
    const double depth = work_.gaps[deepest].depth;
    const double rate = work_.rates[deepest];
    return {state.t, depth, rate, law_.stiffness * depth + law_.damping * rate};
  }

  /// Function that falls through zero at the end of the contact.
  [[nodiscard]] double ending(const Sample& at) const {
    return law_.end_rule == EndRule::clamped ? at.force : at.depth;
  }

  const Dynamics& dynamics_;
  Workspace work_;
  LinearSpringDashpot law_;
  std::size_t instances_;
  Sample before_;
  FollowedImpact found_;
  bool started_{false};
  bool touched_{false};
  bool crossed_{false};
  bool ended_{false};
};

}  // namespace

FollowedImpact follow_impact(const Scene& scene, Findings& findings) {
  const Dynamics dynamics{scene.model};
  Follower follower{dynamics};
  const Watcher follow = [&follower](const State& seen, const StepInfo&) {
    if (!follower.ended()) follower.observe(seen);
  };
  const RunEnd end = run_scene(scene, findings, follow, [&follower](const State&) { return follower.ended(); });
  if (end.finished && follower.ended()) return follower.found();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  return {nan, nan, nan, nan, nan, scene.initial};
}

reference::EndRule same(EndRule rule) {
  return rule == EndRule::attractive ? reference::EndRule::attractive : reference::EndRule::clamped;
}

LinearSpringDashpot dashpot_of(double damping_ratio, double stiffness, double effective_mass, EndRule rule) {
  return {stiffness, 2.0 * damping_ratio * std::sqrt(stiffness * effective_mass), rule};
}

}  // namespace talus::verification::problems
