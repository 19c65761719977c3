#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "solver/base/archive.hpp"
#include "solver/dynamics/rigid_body_system.hpp"
#include "solver/python/advancing.hpp"
#include "solver/python/script_scene.hpp"
#include "solver/run/outcome.hpp"
#include "solver/run/run_state.hpp"
#include "solver/run/snapshot.hpp"

namespace talus::python {

/// A run that a script advances step by step, and whose state it reads: the bare run, without the checks of the run
/// monitor and without records.
class ScriptSimulation {
 public:
  /// At the start of the scene. Errors: InputError naming the argument.
  ScriptSimulation(const ScriptScene& scene, const app::MethodOptions& method);
  ScriptSimulation(const ScriptSimulation&) = delete;
  ScriptSimulation& operator=(const ScriptSimulation&) = delete;

  /// This object. Errors: std::runtime_error while a step is taken: another thread, or a handler of a signal, must not
  /// use it then.
  const ScriptSimulation& idle() const;

  /// Needed to advance; the run is not idle as long as it exists. Errors: as idle().
  [[nodiscard]] Advancing begin() { return Advancing{is_advancing_}; }
  /// Takes up to `steps` steps, fewer if `interrupted` returns true after one; false if none is left: the run has ended
  /// or diverged, and the state is the last one whose numbers are finite. `advancing`: of begin().
  bool advance(const Advancing& advancing, long steps, const std::function<bool()>& interrupted = {});
  /// Puts the run back to the time of its start, with other coordinates and velocities if they are given. Errors:
  /// InputError for a list of another length than the scene has coordinates, or numbers that are not finite; as idle().
  void restart(const std::optional<std::vector<double>>& q, const std::optional<std::vector<double>>& v);

  /// Saves or restores the run between two steps.
  void serialize(Archive& archive);

  const ScriptScene& scene() const { return scene_; }
  const app::MethodOptions& method() const { return method_; }
  const Model& model() const { return file_.scene.model; }
  const RunPlan& plan() const { return file_.scene.plan; }
  const Dynamics& dynamics() const { return dynamics_; }
  /// The state after the last step, all its parts at the same time.
  const Snapshot& seen() const { return seen_; }
  const RunState& run_state() const { return run_state_; }
  /// Empty while steps are left.
  const std::optional<Outcome>& outcome() const { return outcome_; }
  bool has_ended() const { return idle().outcome_.has_value(); }
  /// The angle of each body [rad], counter-clockwise > 0, not reduced to one turn.
  [[nodiscard]] std::vector<double> angles() const;
  /// The elongation of each cable [L]; negative while slack.
  [[nodiscard]] std::vector<double> elongations() const;

 private:
  State started(State state);
  Outcome take(long until, const std::function<bool()>& interrupted);

  ScriptScene scene_;
  app::MethodOptions method_;
  SceneFile file_;  ///< with this method
  Dynamics dynamics_;
  RigidBodySystem system_;
  RunState run_state_;
  Snapshot seen_;
  long steps_{};  ///< of the whole run
  std::optional<Outcome> outcome_;
  std::atomic<bool> is_advancing_{false};
};

}  // namespace talus::python
