#include "solver/app/interruption.hpp"

namespace talus::app {
namespace {

constexpr std::array signals{SIGINT, SIGTERM, SIGHUP};
volatile std::sig_atomic_t caught = 0;

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
  return caught == SIGINT ? "SIGINT" : caught == SIGTERM ? "SIGTERM" : "SIGHUP";
}

}  // namespace talus::app
