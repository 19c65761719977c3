#pragma once

#include <utility>

#include "solver/dynamics/dynamics.hpp"
#include "solver/integrate/integrator_list.hpp"
#include "solver/run/energy_ledger.hpp"
#include "solver/run/observer.hpp"
#include "solver/run/run_plan.hpp"
#include "solver/run/snapshot.hpp"
#include "solver/scenes/scene.hpp"
#include "verification/check/findings.hpp"
#include "verification/study/runs/usage.hpp"

/// A scene run by the solver, with the results that a case reads during and after the run.
namespace talus::verification::problems {

/// Called at the start and after each step, with the Snapshot or with its State alone.
using Watcher = Observer;
/// Ends a run when it returns true after a step.
using Until = StopCondition;

struct RunEnd {
  State state{};       ///< synchronised final state; q and v are NaN if the run diverged, so that no check passes on it
  long evaluations{};  ///< number of force evaluations
  bool finished{};     ///< false if the run diverged
  Integrator method{};  ///< final state of the integrator, which for example counts located events
};

/// Runs a scene from its start with a method and a plan, counts the evaluations, and records the features used by the
/// run. Work and impulse are accumulated if the plan requires it. (Without findings evaluations are not counted.)
RunEnd run_scene(const Scene& scene, Integrator integrator, const RunPlan& plan, Findings* findings,
                 const Watcher& watch = {}, const Until& until = {});
inline RunEnd run_scene(const Scene& scene, Integrator integrator, const RunPlan& plan, Findings& findings,
                        const Watcher& watch = {}, const Until& until = {}) {
  return run_scene(scene, std::move(integrator), plan, &findings, watch, until);
}
/// Runs a scene with its own method and plan.
inline RunEnd run_scene(const Scene& scene, Findings& findings, const Watcher& watch = {}, const Until& until = {}) {
  return run_scene(scene, scene.integrator, scene.plan, &findings, watch, until);
}

/// Runs `steps` steps of length `step` from the scene's start, without the energy ledger.
RunEnd run_steps(const Scene& scene, Integrator integrator, double step, long steps, Findings* findings = nullptr,
                 const Watcher& watch = {});
inline RunEnd run_steps(const Scene& scene, Integrator integrator, double step, long steps, Findings& findings,
                        const Watcher& watch = {}) {
  return run_steps(scene, std::move(integrator), step, steps, &findings, watch);
}

/// Time between the first and the third zero crossing of the scene's first coordinate, with steps of length `step`; NaN
/// if there are none within `maximum` [T].
[[nodiscard]] double period_of(const Scene& scene, Integrator integrator, double step, double maximum);

/// Forces, overlaps and elongations of a model in any state, evaluated outside a run.
class Probe {
 public:
  explicit Probe(const Model& model) : dynamics_{model}, seen_{dynamics_} { record_use(model); }

  /// Evaluates a state, to which the accessors below refer.
  void evaluate(const State& state) { seen_.set(state); }
  /// Normal force of each contact law and tension of each cable [F].
  [[nodiscard]] const LawForces& forces() const { return seen_.forces(); }
  /// Elongation of a cable [L]; negative while slack.
  [[nodiscard]] double elongation(std::size_t cable) const {
    return dynamics_.elongation(seen_.geometry(), static_cast<CableId>(cable));
  }
  /// Overlap of a contact [L].
  [[nodiscard]] double overlap(std::size_t contact) const { return seen_.depths()[contact]; }

 private:
  Dynamics dynamics_;
  Snapshot seen_;
};

/// Energy and momentum balances of a run of a model, relative to its first state.
class RunLedger {
 public:
  RunLedger(const Model& model, const State& start) : dynamics_{model}, ledger_{dynamics_, start} {}
  RunLedger(const RunLedger&) = delete;
  RunLedger& operator=(const RunLedger&) = delete;

  Accounts operator()(const State& state) { return ledger_.accounts(state); }
  Accounts operator()(const Snapshot& seen) { return ledger_.accounts(seen); }
  [[nodiscard]] const EnergyLedger& energy() const { return ledger_; }

 private:
  Dynamics dynamics_;
  EnergyLedger ledger_;
};

/// First state of a run of the scene: its start with the modes that a run assigns to it.
[[nodiscard]] State first_state(const Scene& scene);

}  // namespace talus::verification::problems
