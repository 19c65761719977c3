#pragma once

#include <string>
#include <vector>

#include "solver/dynamics/rigid_body_system.hpp"
#include "solver/run/quantity.hpp"
#include "solver/scenes/scene.hpp"

namespace talus {

/// How a scene is integrated: by which method, and in how many steps (intervals, where it chooses its own).
struct RunMethod {
  std::string integrator;
  double tolerance{};  ///< of its step control; 0: fixed steps
  long steps{};        ///< equal parts of the whole run
};

/// A scene integrated by another method: its integrator and step are those, its end and all else stay. The interval of
/// the history becomes whole steps. Errors: InputError if the method does not go with the tolerance.
[[nodiscard]] Scene with_method(Scene scene, const RunMethod& method);

/// A small change of a run's start: each velocity by up to `share` of the largest speed of the run, in a direction of
/// the state's space told by its number.
struct Nudge {
  double share{};
  int direction{};
  double speed{};  ///< [L/T]
};

/// What one run gives of a quantity.
struct Pilot {
  double printed{};            ///< its value as `talus run` prints it: extremes over the steps
  double between{};            ///< the same with extremes between the steps, by the parabola through three of them
  double size{};               ///< largest magnitude of the column in the run
  double speed{};              ///< largest speed of a coordinate, as a length over time [L/T]
  long evaluations{};          ///< force evaluations
  std::string failure;         ///< why there is no value; empty if there is one
  std::vector<double> values;  ///< of the column at each step
};

/// What a pilot that should cost so many evaluations may take before it is given up: a tolerance that cannot be kept
/// would else eat what others are to have.
constexpr long most_of(long cost) { return 64 * (cost + 100); }

/// Runs of one scene by any method for the sake of one quantity. The accounts are kept where the scene keeps them, for
/// they may cost evaluations; and the run is watched as `talus run` watches it: what that would end, or warn of, has
/// failed.
class PilotRuns {
 public:
  /// Both must outlive it.
  /// `warned`: runs that the watch warns of count, too.
  PilotRuns(const Scene& scene, const Quantity& quantity, bool warned)
      : scene_{&scene}, quantity_{&quantity}, dynamics_{scene.model}, warned_{warned} {}

  /// One run; given up where it would take more than `most` evaluations.
  [[nodiscard]] Pilot run(const RunMethod& method, long most, const Nudge& nudge = {});

  /// Force evaluations that a run takes, about: by its first steps.
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
