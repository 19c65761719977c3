#include "solver/app/interruption.hpp"

#include <atomic>
#include <cstdint>
#include <ctime>

namespace talus::app {
namespace {

constexpr std::array signals{SIGINT, SIGTERM, SIGHUP};
/// Other threads than that of the handler read it, which std::sig_atomic_t does not allow.
std::atomic<int> caught{0};
std::atomic<std::int64_t> caught_at{0};  ///< [ns]
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<std::int64_t>::is_always_lock_free,
              "a signal handler may only use atomics without locks");

constexpr std::int64_t second_in_ns = 1'000'000'000, same_request = second_in_ns / 5;

/// All functions that it calls are safe in a handler (POSIX).
void note(int signal) {
  timespec time{};
  ::clock_gettime(CLOCK_MONOTONIC, &time);
  const std::int64_t now = time.tv_sec * second_in_ns + time.tv_nsec;
  if (caught == signal) {
    if (now - caught_at < same_request) return;
    std::signal(signal, SIG_DFL);
    std::raise(signal);  // it acts once this handler has returned
    return;
  }
  caught_at = now;
  caught = signal;
}

}  // namespace

Interruption::Interruption() {
  caught = 0;
  struct sigaction action {};
  action.sa_handler = note;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  for (std::size_t i = 0; i < signals.size(); ++i)
    ::sigaction(signals[i], &action, &before_[i]);
  if (before_.back().sa_handler == SIG_IGN) ::sigaction(signals.back(), &before_.back(), nullptr);
}

Interruption::~Interruption() {
  for (std::size_t i = 0; i < signals.size(); ++i)
    ::sigaction(signals[i], &before_[i], nullptr);
}

int Interruption::signal() const { return caught; }

const char* Interruption::name() const {
  const int signal = caught;
  return signal == SIGINT ? "SIGINT" : signal == SIGTERM ? "SIGTERM" : "SIGHUP";
}

}  // namespace talus::app
