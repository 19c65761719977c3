#pragma once

#include <string>
#include <vector>

#include "solver/dynamics/rigid_body_system.hpp"
#include "solver/run/quantity.hpp"
#include "solver/scenes/scene.hpp"

namespace talus {

/// Integration method of a scene: integrator and number of steps (of output intervals with step control).
struct RunMethod {
  std::string integrator;
  double tolerance{};  ///< of its step control; 0: fixed steps
  long steps{};        ///< number of equal parts of the whole run
};

/// The scene with another integrator and step; everything else is unchanged, except that the interval of the history is
/// at least one step. Errors: InputError if the integrator does not accept the tolerance.
[[nodiscard]] Scene with_method(Scene scene, const RunMethod& method);

/// A small change of a run's start: each velocity changes by up to `fraction` of the largest speed of the run, in the
/// direction of state space that `direction` numbers.
struct Nudge {
  double fraction{};
  int direction{};
  double speed{};  ///< [L/T]
};

/// Result of one pilot run for a quantity.
struct Pilot {
  double printed{};            ///< its value as `talus run` prints it: extremes over the steps
  double between{};            ///< its value with extremes between the steps, by the parabola through three of them
  double size{};               ///< largest magnitude of the column in the run
  double speed{};              ///< largest speed of a coordinate, as a length over time [L/T]
  long evaluations{};          ///< force evaluations
  std::string failure;         ///< why there is no value; empty if there is one
  std::vector<double> values;  ///< of the column at each step
};

/// Maximum number of evaluations of a pilot run with this estimated cost; beyond, it is aborted. Without the limit, a
/// tolerance that cannot be met would use up the evaluations of the other methods.
constexpr long evaluation_limit(long cost) { return 64 * (cost + 100); }

/// Pilot runs of one scene by any method, to evaluate one quantity. The energy balance is computed if the scene
/// requires it, because it may cost evaluations. RunMonitor checks the runs as in `talus run`: a run that it would end
/// or warn about has failed.
class PilotRuns {
 public:
  /// `scene` and `quantity` must outlive this object. `warned`: runs with warnings are accepted, too.
  PilotRuns(const Scene& scene, const Quantity& quantity, bool warned)
      : scene_{&scene}, quantity_{&quantity}, dynamics_{scene.model}, warned_{warned} {}

  /// One run; aborted when it would take more than `maximum` evaluations.
  [[nodiscard]] Pilot run(const RunMethod& method, long maximum, const Nudge& nudge = {});

  /// Estimated force evaluations of a run, extrapolated from its first steps.
  [[nodiscard]] long cost(const RunMethod& method);

  const Scene& scene() const { return *scene_; }
  const Quantity& quantity() const { return *quantity_; }
  const Dynamics& dynamics() const { return dynamics_; }
  /// Force evaluations of all runs.
  long evaluations() const { return evaluations_; }

 private:
  [[nodiscard]] State start(const Nudge& nudge) const;
  void take(RigidBodySystem& system, const Scene& scene, State start, Pilot& pilot) const;

  const Scene* scene_;
  const Quantity* quantity_;
  Dynamics dynamics_;
  bool warned_{};
  long evaluations_{};
};

}  // namespace talus
