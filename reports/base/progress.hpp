/// Progress of a long task, shown on a terminal.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <string>
#include <thread>

namespace talus::reports {

/// A line on stderr, shown from the second second on and erased at the end: the task, the completed fraction, and the
/// elapsed time. Shows nothing if stderr is not a terminal. Nothing may be printed during its lifetime.
class Progress {
 public:
  /// `what`: name of the task, such as "drawing"; `all`: number of its parts, 0 if they are not counted.
  Progress(std::string what, std::size_t all);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  /// Counts one more completed part; callable from any thread.
  void add() { ++done_; }

 private:
  void show(const std::string& what, std::size_t all);

  std::atomic<std::size_t> done_{0};
  std::mutex mutex_;
  std::condition_variable ends_;
  bool ended_{false};
  std::thread shows_;
};

}  // namespace talus::reports
