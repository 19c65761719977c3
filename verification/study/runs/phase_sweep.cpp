#include "verification/study/runs/phase_sweep.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "verification/study/runs/scene_run.hpp"

namespace talus::verification::problems {
namespace {

struct PhaseRun {
  double step;      ///< [T]
  double lead;      ///< time from start to touch [T]
  long steps;       ///< up to the comparison
  double measured;  ///< velocity at the comparison
  double after;     ///< time of the comparison, from touch [T]
};

double step_of(const PhasedImpact& impact, double count, Offset offset, std::size_t phase) {
  if (offset == Offset::none) return impact.contact_time / count;
  if (offset == Offset::common) return incommensurate_step(impact.contact_time, count);
  return offset_step(impact.contact_time, count, phase);
}

/// Exact velocities of all runs in one call, so that references that integrate do so only once.
std::vector<double> exact_velocities(const PhasedImpact& impact, const std::vector<PhaseRun>& runs) {
  std::vector<std::size_t> order(runs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return runs[a].after < runs[b].after; });
  std::vector<double> times;
  for (const std::size_t i : order)
    times.push_back(runs[i].after);
  const std::vector<double> ascending = impact.exact(times);
  std::vector<double> values(runs.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    values[order[i]] = ascending[i];
  return values;
}

}  // namespace

Sweep sweep(const PhasedImpact& impact, const Integrator& integrator, std::span<const double> counts, Offset offset,
            std::size_t phases) {
  const std::vector<double> onsets = even_phases(phases);
  std::vector<PhaseRun> runs;
  Sweep result;
  for (const double count : counts) {
    double evaluations = 0.0;
    for (std::size_t i = 0; i < phases; ++i) {
      PhaseRun run{.step = step_of(impact, count, offset, i), .lead = 0.0, .steps = 0, .measured = 0.0, .after = 0.0};
      run.lead = onsets[i] * run.step;
      // Two steps more than `watch`: a contact may last up to two steps longer than the exact one.
      run.steps = static_cast<long>(std::ceil(impact.watch * impact.contact_time / run.step)) + 2;
      Scene scene = impact.at_touch;
      impact.taken_back(scene.initial, run.lead);
      const RunEnd end = run_steps(scene, integrator, run.step, run.steps);
      run.measured = std::isfinite(end.state.q[0]) ? end.state.v[impact.observed] : end.state.q[0];
      run.after = static_cast<double>(run.steps) * run.step - run.lead;
      evaluations += static_cast<double>(end.evaluations) / static_cast<double>(phases);
      runs.push_back(run);
    }
    result.evaluations.push_back(evaluations);
  }
  const std::vector<double> exact = exact_velocities(impact, runs);
  for (std::size_t c = 0; c < counts.size(); ++c) {
    PhaseError error;
    double mean_step = 0.0;
    result.by_phase.emplace_back();
    for (std::size_t i = c * phases; i < (c + 1) * phases; ++i) {
      mean_step += runs[i].step / static_cast<double>(phases);
      result.by_phase.back().push_back(runs[i].measured / exact[i] - 1.0);
      error.add(result.by_phase.back().back());
    }
    result.steps.push_back(impact.contact_time / mean_step);
    result.rms.add(1.0 / result.steps.back(), error.rms());
    result.largest.push_back(error.max());
  }
  return result;
}

}  // namespace talus::verification::problems
