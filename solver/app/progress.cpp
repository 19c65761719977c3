#include "solver/app/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace talus::app {

using Clock = std::chrono::steady_clock;

Progress::Progress() : on_terminal_{::isatty(STDERR_FILENO) == 1}, next_{Clock::now() + std::chrono::seconds{1}} {}

Progress::~Progress() {
  if (width_ > 0) fmt::print(stderr, "\r{:{}}\r", "", width_);
}

bool Progress::due() {
  if (!on_terminal_ || Clock::now() < next_) return false;
  next_ = Clock::now() + std::chrono::milliseconds{200};
  return true;
}

void Progress::show(std::string_view words) {
  width_ = std::max(width_, words.size());
  fmt::print(stderr, "\r{:{}}", words, width_);
  std::fflush(stderr);
}

}  // namespace talus::app
