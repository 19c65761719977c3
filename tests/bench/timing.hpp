#pragma once

#include <functional>
#include <string>
#include <vector>

namespace talus::bench {

/// One thing to time.
struct Task {
  std::string name;            ///< unique
  std::function<void()> work;  ///< does the whole of it once and lets the result be used
};

/// Wall time of one task over all repetitions [s].
struct Timing {
  double median{};
  double least{};
  double largest{};
};

/// Times all tasks in one run, their repetitions interleaved in random order (Google Benchmark), so that a disturbance
/// of the machine meets all of them alike. The order of the answer is that of the tasks.
[[nodiscard]] std::vector<Timing> time_tasks(const std::vector<Task>& tasks, int repetitions);

}  // namespace talus::bench
