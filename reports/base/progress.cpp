#include "reports/base/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <utility>

namespace talus::reports {

Progress::Progress(std::string what, std::size_t all) {
  if (::isatty(STDERR_FILENO) != 1) return;
  shows_ = std::thread{[this, what = std::move(what), all] { show(what, all); }};
}

Progress::~Progress() {
  if (!shows_.joinable()) return;
  {
    const std::lock_guard lock{mutex_};
    ended_ = true;
  }
  ends_.notify_one();
  shows_.join();
}

void Progress::show(const std::string& what, std::size_t all) {
  const auto start = std::chrono::steady_clock::now();
  std::size_t width = 0;
  std::unique_lock lock{mutex_};
  for (long seconds = 2; !ends_.wait_until(lock, start + std::chrono::seconds{seconds}, [this] { return ended_; });
       ++seconds) {
    const std::string count = all > 1 ? fmt::format(", {} of {}", done_.load(), all) : "";
    const std::string line = fmt::format("{}{}, {} s", what, count, seconds);
    width = std::max(width, line.size());
    std::fputs(fmt::format("\r{:{}}", line, width).c_str(), stderr);
  }
  if (width > 0) std::fputs(fmt::format("\r{:{}}\r", "", width).c_str(), stderr);
}

}  // namespace talus::reports
