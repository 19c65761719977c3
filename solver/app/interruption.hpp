#pragma once

#include <array>
#include <csignal>

namespace talus::app {

/// While it lives the first SIGINT or SIGTERM is noted instead of ending the program; a second ends it as usual.
class Interruption {
 public:
  Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;
  ~Interruption();

  /// The signal that came; 0 if none did.
  int signal() const;

 private:
  std::array<struct sigaction, 2> before_{};
};

}  // namespace talus::app
