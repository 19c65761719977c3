#pragma once

#include <array>
#include <csignal>

namespace talus::app {

/// While it lives the first SIGINT, SIGTERM or SIGHUP (a terminal that is closed) is noted instead of ending the
/// program; a second ends it as usual. SIGHUP stays ignored where it was, as under nohup.
class Interruption {
 public:
  Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;
  ~Interruption();

  /// The signal that came; 0 if none did.
  int signal() const;
  /// Its name, e.g. "SIGINT".
  const char* name() const;

 private:
  std::array<struct sigaction, 3> before_{};
};

}  // namespace talus::app
