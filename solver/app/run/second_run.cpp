#include "solver/app/run/second_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace talus::app {
namespace {

constexpr const char* interrupted = "it was interrupted";

/// The record of a run without files; nothing if `stop` ended it. The run is aborted after `maximum` evaluations.
std::optional<RunRecord> record_of(const SceneFile& file, long maximum, const StopCondition& stop) {
  SceneRun run{file, {}, {}, {}};
  bool given_up = false;
  Progress progress;
  const auto ends = [&](const Snapshot& seen) {
    given_up = run.run_state().evaluations > maximum;
    return given_up || (stop && stop(seen));
  };
  Outcome outcome = run.proceed(ends, &progress);
  if (given_up)
    outcome = {Outcome::Kind::diverged, outcome.time, fmt::format("given up after {} evaluations", maximum)};
  if (outcome.kind == Outcome::Kind::stopped) return std::nullopt;
  return run.record(outcome);
}

double largest_tension(const RunRecord& record) {
  const scenes::SegmentRecord* segment = record.fence ? record.fence->largest_segment() : nullptr;
  return segment ? segment->peak : 0.0;
}

}  // namespace

RunQuality::Repeat repeat_run(const SceneFile& file, const RunRecord& record, const StopCondition& stop) {
  SceneFile changed = file;
  const Model& model = changed.scene.model;
  const Layout layout{model};
  for (const scenes::FenceMember& member : changed.fence->made.members) {
    if (!member.body || member.layer != 0) continue;
    const std::size_t body = index(*member.body);
    for (std::size_t i = layout.first[body]; i < layout.first[body + 1]; ++i)
      changed.scene.initial.v[i] *= 1.0 + repeat_change;
  }
  const auto repeated = record_of(changed, std::numeric_limits<long>::max(), stop);
  RunQuality::Repeat repeat;
  repeat.change = repeat_change;
  if (!repeated) {
    repeat.failure = interrupted;
    return repeat;
  }
  repeat.verdict = repeated->fence->verdict();
  if (!repeated->outcome) repeat.failure = repeated->outcome.message;
  const double before = largest_tension(record);
  if (before > 0.0) repeat.cable_change = largest_tension(*repeated) / before - 1.0;
  return repeat;
}

RunQuality::Repair repair_run(const SceneFile& file, const RunRecord& record, const StopCondition& stop) {
  SceneFile located = file;
  RunQuality::Repair repair;
  repair.option = "--integrator auto";
  const IntegratorChoice chosen = choose_integrator(located.scene.model, automatic_integrator);
  located.scene.integrator = chosen.integrator;
  located.scene.integrator_reason = chosen.why;
  const auto repaired = record_of(located, std::max(1'000'000L, 20 * record.evaluations), stop);
  if (!repaired) {
    repair.flaw = interrupted;
    return repair;
  }
  repair.flaw = repaired->quality.flaw;
  repair.balance = repaired->quality.balance;
  if (repaired->fence) repair.verdict = repaired->fence->verdict();
  return repair;
}

}  // namespace talus::app
