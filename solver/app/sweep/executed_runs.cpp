#include "solver/app/sweep/executed_runs.hpp"

#include <mutex>
#include <utility>

#include "solver/threads/parallel_for.hpp"

namespace talus::app {

void for_each_executed(std::size_t count, unsigned threads, const std::function<bool()>& interrupted,
                       const std::function<SweepResult(std::size_t)>& result,
                       const std::function<void(std::size_t, SweepResult&&)>& take) {
  std::mutex one_at_a_time;
  parallel_for(count, threads, [&](std::size_t i) {
    if (interrupted()) return;
    SweepResult found = result(i);
    if (found.id.empty()) return;
    const std::lock_guard one{one_at_a_time};
    take(i, std::move(found));
  });
}

void execute(const SweepFolder& sweep, const SweepBase& base, const std::vector<const SweptRun*>& runs,
             unsigned threads, const std::function<bool()>& interrupted,
             const std::function<void(SweepResult&&)>& take) {
  if (runs.empty()) return;
  ResultFile file{sweep};
  for_each_executed(
      runs.size(), threads, interrupted,
      [&](std::size_t i) { return base.result(*runs[i], sweep.limits, interrupted); },
      [&](std::size_t, SweepResult&& result) {
        file.add(result);
        take(std::move(result));
      });
  file.flush();
}

}  // namespace talus::app
