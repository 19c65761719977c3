#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

namespace talus {

/// One line on a terminal's stderr that says how far something long has come, once it takes longer than a second; wiped
/// at the end. Elsewhere nothing.
class Progress {
 public:
  Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  /// Whether a line is to be shown now: five times a second at most. It may be asked at every step, for it reads the
  /// clock only so often that the steps between two readings take a millisecond or so.
  [[nodiscard]] bool due();
  void show(std::string_view words);

 private:
  bool on_terminal_;
  std::size_t width_{};  ///< of the longest line shown
  std::chrono::steady_clock::time_point next_, read_;
  long stride_{1}, asked_{};  ///< the clock is read at every stride_-th question
};

/// Shows the time that something has taken, every second from the second on: for work that does not say how far it has
/// come. Nothing may be printed while it lives. Where stderr is no terminal it shows nothing.
class ElapsedTime {
 public:
  /// `what`: "reading the states".
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

/// A duration for people: "40 s", "3 min", "2.5 h".
[[nodiscard]] std::string duration_text(double seconds);

/// The rest of some work and the whole, from the time that a fraction of it took: "20 s left of about 3 min".
[[nodiscard]] std::string time_left_text(double elapsed, double fraction);

}  // namespace talus
