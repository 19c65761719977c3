#include "solver/app/interruption.hpp"

#include <atomic>

namespace talus::app {
namespace {

constexpr std::array signals{SIGINT, SIGTERM, SIGHUP};
/// Other threads than that of the handler read it, which std::sig_atomic_t does not allow.
std::atomic<int> caught{0};
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may only use atomics without locks");

void note(int signal) { caught = signal; }

}  // namespace

Interruption::Interruption() {
  caught = 0;
  struct sigaction action {};
  action.sa_handler = note;
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
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
