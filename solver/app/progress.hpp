#pragma once

#include <chrono>
#include <string_view>

namespace talus::app {

/// One line on a terminal's stderr that says how far something long has come, once it takes longer than a second; wiped
/// at the end. Elsewhere nothing.
class Progress {
 public:
  Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  /// Whether a line is to be shown now: five times a second at most.
  [[nodiscard]] bool due();
  void show(std::string_view words);

 private:
  bool on_terminal_;
  std::size_t width_{};  ///< of the longest line shown
  std::chrono::steady_clock::time_point next_;
};

}  // namespace talus::app
