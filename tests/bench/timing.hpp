#pragma once

#include <functional>
#include <string>
#include <vector>

namespace talus::bench {

/// A task to time.
struct Task {
  std::string name;            ///< unique
  std::function<void()> work;  ///< does the whole task once and lets the result be used
};

/// Wall time of one task over all repetitions [s].
struct Timing {
  double median{};
  double smallest{};
  double largest{};
};

/// Times all tasks in one run, their repetitions interleaved in random order (Google Benchmark), so that a disturbance
/// of the machine affects all of them equally. Results are in the order of the tasks.
[[nodiscard]] std::vector<Timing> time_tasks(const std::vector<Task>& tasks, int repetitions);

}  // namespace talus::bench
