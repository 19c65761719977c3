#pragma once

#include <array>
#include <csignal>

namespace talus::app {

/// Signal handler scope: during the lifetime of an object, the first SIGINT, SIGTERM or SIGHUP (closed terminal) is
/// recorded instead of ending the program; another one of the same kind, at least 0.2 s later, ends it as usual. (The
/// program timeout sends its signal twice at once.) SIGHUP stays ignored if it was ignored before, as under nohup.
class Interruption {
 public:
  Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;
  ~Interruption();

  /// The recorded signal; 0 if none was received.
  int signal() const;
  /// Name of the recorded signal, e.g. "SIGINT".
  const char* name() const;

 private:
  std::array<struct sigaction, 3> before_{};
};

}  // namespace talus::app
