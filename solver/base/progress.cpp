#include "solver/base/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace talus {
namespace {

using Clock = std::chrono::steady_clock;

bool on_terminal() { return ::isatty(STDERR_FILENO) == 1; }

/// Overwrites the current line of the terminal. Output to a closed terminal is lost; the run continues.
void overwrite(std::string_view text, std::size_t width, const char* end = "") {
  std::fputs(fmt::format("\r{:{}}{}", text, width, end).c_str(), stderr);
  std::fflush(stderr);
}

}  // namespace

Progress::Progress()
    : on_terminal_{on_terminal()}, next_{Clock::now() + std::chrono::seconds{1}}, read_{Clock::now()} {}

Progress::~Progress() {
  if (width_ > 0) overwrite("", width_, "\r");
}

bool Progress::due() {
  if (!on_terminal_ || ++calls_ < stride_) return false;
  calls_ = 0;
  const Clock::time_point now = Clock::now();
  // The stride adapts to the rate of the calls: the clock is read every 0.5 to 2 ms.
  constexpr long longest = 4096;
  if (now - read_ < std::chrono::microseconds{500}) stride_ = std::min(2 * stride_, longest);
  if (now - read_ > std::chrono::milliseconds{2}) stride_ = std::max(stride_ / 2, 1L);
  read_ = now;
  if (now < next_) return false;
  next_ = now + std::chrono::milliseconds{200};
  return true;
}

void Progress::show(std::string_view text) {
  width_ = std::max(width_, text.size());
  overwrite(text, width_);
}

ElapsedTime::ElapsedTime(std::string what) {
  if (!on_terminal()) return;
  shows_ = std::thread{[this, what = std::move(what)] {
    const Clock::time_point start = Clock::now();
    std::size_t width = 0;
    std::unique_lock lock{mutex_};
    for (long seconds = 2; !ends_.wait_until(lock, start + std::chrono::seconds{seconds}, [this] { return ended_; });
         ++seconds) {
      const std::string line = fmt::format("{}, {} s", what, seconds);
      width = std::max(width, line.size());
      overwrite(line, width);
    }
    if (width > 0) overwrite("", width, "\r");
  }};
}

ElapsedTime::~ElapsedTime() {
  if (!shows_.joinable()) return;
  {
    const std::lock_guard lock{mutex_};
    ended_ = true;
  }
  ends_.notify_one();
  shows_.join();
}

std::string duration_text(double seconds) {
  constexpr double minute = 60.0, hour = 3600.0;
  if (seconds < 1.5 * minute) return fmt::format("{:.0f} s", seconds);
  if (seconds < 1.5 * hour) return fmt::format("{:.0f} min", seconds / minute);
  return fmt::format("{:.1f} h", seconds / hour);
}

std::string time_left_text(double elapsed, double fraction) {
  const double whole = elapsed / fraction;
  return fmt::format("{} left of about {}", duration_text(whole - elapsed), duration_text(whole));
}

}  // namespace talus
