#include "solver/app/run/scene_run.hpp"

#include <fmt/format.h>

#include <chrono>
#include <ctime>
#include <utility>

#include "solver/app/run/start_warnings.hpp"
#include "solver/base/error.hpp"
#include "solver/run/simulate.hpp"
#include "solver/scenes/fence_plausibility.hpp"
#include "solver/state/state_archive.hpp"

namespace talus::app {
namespace {

/// The outputs of a run; adds the scene's file name to their errors.
RunOutputs outputs_of(const OutputRequest& request, const std::filesystem::path& scene) {
  try {
    return RunOutputs{request};
  } catch (const InputError& error) {
    throw InputError{scene.string() + ": " + error.what()};
  }
}

}  // namespace

SceneRun::SceneRun(const SceneFile& file, const std::filesystem::path& folder, const std::filesystem::path& scene,
                   const OutputOptions& options, RecordedColumns recorded, scenes::FenceResults of_fence)
    : file_{&file},
      scene_{&file.scene},
      folder_{folder},
      dynamics_{file.scene.model},
      system_{dynamics_, file.scene.plan.ledger},
      run_state_{initial_run_state(file.scene.integrator, started(file.scene.initial))},
      seen_{dynamics_, run_state_.state},
      integrator_reason_{file.scene.integrator_reason},
      recorder_{dynamics_, run_state_.state, file.scene.plan.ledger, std::move(recorded)},
      failures_{dynamics_},
      watch_{file.scene, dynamics_, run_state_.state},
      overlap_warnings_{app::start_warnings(file, dynamics_)},
      sheet_{options.sheet} {
  if (recorder_.records_all()) parts_.emplace(dynamics_, file.scene.plan.ledger);
  if (!folder.empty()) outputs_ = outputs_of({file, dynamics_, folder, scene.stem().string(), options}, scene);
  if (file.fence) fence_.emplace(file.fence->fence, file.fence->made, dynamics_, of_fence);
}

State SceneRun::started(State state) {
  system_.begin(state);
  return state;
}

StepParts::Found SceneRun::parts() const {
  TALUS_DEMAND(parts_.has_value());
  return parts_->found();
}

std::vector<std::string> SceneRun::start_warnings() const {
  std::vector<std::string> all = overlap_warnings_;
  all.insert(all.end(), watch_.start_warnings().begin(), watch_.start_warnings().end());
  return all;
}

void SceneRun::serialize(Archive& archive) {
  archive.scope("run", [&] { run_state_.serialize(archive); });
  State seen = seen_.state();
  archive.scope("observed_state", [&] { talus::serialize(archive, seen); });
  if (archive.is_loading()) seen_.set(seen);
  archive.text("integrator_reason", integrator_reason_);
  archive.scope("recorder", [&] { recorder_.serialize(archive); });
  archive.scope("failures", [&] { failures_.serialize(archive); });
  archive.scope("monitor", [&] { watch_.serialize(archive); });
  if (!folder_.empty()) archive.scope("outputs", [&] { outputs_.serialize(archive); });
  if (fence_) archive.scope("fence", [&] { fence_->serialize(archive); });
  archive.flag("sheet", sheet_);
}

void SceneRun::bring_files(const std::filesystem::path& from) { outputs_.bring_files(from); }

Outcome SceneRun::proceed(const StopCondition& stop, Progress* progress, const Observer& more) {
  const auto observe = [&](const Snapshot& seen, const StepInfo& info) {
    recorder_(seen, info);
    failures_(seen.state(), info);
    outputs_(seen, info);
    if (fence_) (*fence_)(seen, info);
    if (more) more(seen, info);
    if (progress != nullptr && progress->due()) {
      const double time = seen.state().t, end = scene_->plan.end;
      progress->show(fmt::format("t = {:.5g} of {:.5g}  ({:3.0f} %)", time, end, 100.0 * time / end));
    }
  };
  using Clock = std::chrono::steady_clock;
  const Observer observers[] = {[&](const Snapshot& seen, const StepInfo& info) {
    if (!parts_) return observe(seen, info);
    if (!StepParts::timed(info.step)) {
      observe(seen, info);
    } else {
      const Clock::time_point start = Clock::now();
      observe(seen, info);
      parts_->observed(Clock::now() - start);
    }
    parts_->look(seen.state(), info);
  }};
  const auto broken = [&] { return !watch_.violation().empty(); };
  const auto look = [&](const Snapshot& seen, long at) {
    std::optional<RunMonitor::Balance> balance;
    if (recorder_.ledger()) balance = {recorder_.accounts().energy_balance_error, recorder_.ledger()->energy_scale()};
    watch_.check(seen, at, balance);
  };
  const std::clock_t start = std::clock();
  const long first = run_state_.step, evaluations = run_state_.evaluations;
  long step = first;
  if (step == 0) watch_.check(seen_, step);
  if (broken()) {
    observers[0](seen_, {0, 0, true, true, true, &run_state_.state});
    return {Outcome::Kind::diverged, run_state_.state.t, watch_.violation()};
  }
  const StopCondition stops = [&](const Snapshot& seen) {
    look(seen, ++step);
    ends_early_ = scene_->early_end && reached(*scene_->early_end, scene_->model, seen.state());
    return broken() || ends_early_ || (stop && stop(seen));
  };
  Outcome outcome = simulate(system_, run_state_, scene_->plan, observers, stops, &seen_);
  if (parts_) {
    parts_->ended(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, run_state_.step - first,
                  run_state_.evaluations - evaluations);
  }
  // simulate() does not call the stop condition after the last step, so that step is checked here.
  if (outcome.kind == Outcome::Kind::finished) look(seen_, ++step);
  if (outcome && broken()) return {Outcome::Kind::diverged, outcome.time, watch_.violation()};
  if (outcome && ends_early_) outcome.kind = Outcome::Kind::finished;
  return outcome;
}

Outcome SceneRun::explained(Outcome outcome) const {
  if (!outcome && watch_.violation().empty() && !watch_.step_ratio().empty())
    outcome.message += fmt::format("; {}", watch_.step_ratio());
  return outcome;
}

RunQuality SceneRun::quality(const Outcome& outcome) const {
  RunQuality found;
  found.enforced = scene_->plan.watch.quality == CheckAction::error;
  if (const auto& ledger = recorder_.ledger()) {
    // From the ledger, not from the run monitor, which may be off.
    const double scale = ledger->energy_scale();
    found.balance = scale > 0.0 ? ledger->largest_energy_balance_error() / scale : 0.0;
    found.balance_time = watch_.drift_time();
    if (!(*found.balance <= largest_balance_error)) found.flaw = balance_text(*found.balance);
  } else if (watch_.step_is_beyond()) {
    found.flaw = "its step is beyond the linear limit, and no energy balance was kept: " + watch_.step_ratio();
  }
  if (!outcome) found.flaw = outcome.message;
  if (located_events(run_state_.integrator)) {
    found.step = fmt::format("steps chosen by {}, events located", name(run_state_.integrator));
    if (tolerance(run_state_.integrator) > 0.0)
      found.step += fmt::format(", tolerance {:g}", tolerance(run_state_.integrator));
  } else if (tolerance(run_state_.integrator) > 0.0) {
    found.step = fmt::format("steps chosen by {}, tolerance {:g}", name(run_state_.integrator),
                             tolerance(run_state_.integrator));
  } else if (const RunMonitor::Extreme& acting = watch_.extreme(Watched::frequency); acting.seen) {
    found.step = fmt::format("step {:.3g} times its linear limit", acting.value);
    if (watch_.step_is_beyond()) found.step += ", beyond it with all contacts closed";
  } else if (!watch_.step_ratio().empty()) {
    found.step = watch_.step_ratio();
  } else {
    found.step = "step without a known limit";
  }
  if (const RunMonitor::Extreme& shortest = watch_.extreme(Watched::contact); shortest.seen)
    found.contact_steps = shortest.value;
  if (const auto last = watch_.last_contact())
    found.last_contact = {scene_->model.contacts[index(last->contact)].name, last->time, last->touching};
  const std::vector<Body>& bodies = scene_->model.bodies;
  for (const auto& [a, b] : watch_.undeclared_overlaps())
    found.undeclared_overlaps.emplace_back(bodies[index(a)].name, bodies[index(b)].name);
  return found;
}

std::vector<std::string> SceneRun::warnings() const {
  std::vector<std::string> all = overlap_warnings_;
  const auto add = [&](const std::vector<std::string>& found) { all.insert(all.end(), found.begin(), found.end()); };
  add(watch_.warnings());
  if (fence_) {
    add(geometry_warnings(*file_));
    add(scenes::implausible_motion(file_->fence->fence, fence_->summary()));
  }
  return all;
}

RunRecord SceneRun::record(Outcome outcome) const {
  RunRecord record;
  record.outcome = std::move(outcome);
  record.title = scene_->title;
  record.units = scene_->model.units;
  record.integrator = name(scene_->integrator);
  record.integrator_reason = integrator_reason_;
  record.events = located_events(run_state_.integrator);
  record.plan = scene_->plan;
  record.steps = run_state_.step;
  record.evaluations = run_state_.evaluations;
  record.coordinates = dynamics_.layout().coordinates.size();
  record.laws = dynamics_.layout().mode_count;
  record.contacts = scene_->model.contacts.size();
  record.cables = scene_->model.cables.size();
  record.bodies = body_states(scene_->model, seen_.state());
  record.cables_left = cable_states(dynamics_, seen_.state());
  record.hangers_left = hanger_states(dynamics_, seen_.state());
  record.failures = failures_.failures();
  record_history(record, recorder_);
  record.quality = quality(record.outcome);
  record.warnings = warnings();
  if (fence_) record.fence = fence_->summary();
  record.watched = watch_lines(watch_, *scene_);
  outputs_.report(record);
  return record;
}

}  // namespace talus::app
