/// How far something long has come, for people at a terminal.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <string>
#include <thread>

namespace talus::reports {

/// A line on a terminal's stderr, from the second second on and wiped at the end: what is done, how much of it, and the
/// time that it has taken. Where stderr is no terminal it shows nothing. Nothing may be printed while it lives.
class Progress {
 public:
  /// `what`: "drawing"; `all`: parts that it has, 0 if there is nothing to count.
  Progress(std::string what, std::size_t all);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  /// One more part is done; by any thread.
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
