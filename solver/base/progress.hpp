#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

namespace talus {

/// Status line of a long operation on stderr: appears when the operation takes longer than a second and is erased at
/// the end. Nothing is shown if stderr is not a terminal.
class Progress {
 public:
  Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  /// Whether a line is to be shown now: at most five times a second. Cheap enough to call at every step: the clock is
  /// read only about once a millisecond.
  [[nodiscard]] bool due();
  void show(std::string_view text);

 private:
  bool on_terminal_;
  std::size_t width_{};  ///< of the longest line shown
  std::chrono::steady_clock::time_point next_, read_;
  long stride_{1}, calls_{};  ///< the clock is read at every stride_-th call of due()
};

/// Shows the elapsed time of an operation that reports no progress, every second from 2 s on. Nothing may be
/// printed during its lifetime. Nothing is shown if stderr is not a terminal.
class ElapsedTime {
 public:
  /// `what` names the operation: "reading the states".
  explicit ElapsedTime(std::string what);
  ElapsedTime(const ElapsedTime&) = delete;
  ElapsedTime& operator=(const ElapsedTime&) = delete;
  ~ElapsedTime();

 private:
  std::mutex mutex_;
  std::condition_variable ends_;
  bool ended_{false};
  std::thread shows_;
};

/// A duration as text, in s, min or h by its size: "40 s", "3 min", "2.5 h".
[[nodiscard]] std::string duration_text(double seconds);

/// Remaining and total time, extrapolated from the time that a fraction of the work took: "20 s left of about 3 min".
[[nodiscard]] std::string time_left_text(double elapsed, double fraction);

}  // namespace talus
