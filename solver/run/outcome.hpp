#pragma once

#include <string>

namespace talus {

/// How a run ended. A diverged run is a result: it has a time and a reason.
struct [[nodiscard]] Outcome {
  enum class Kind {
    finished,
    stopped,  ///< before its plan's end, because it was asked to
    diverged
  };

  Kind kind{Kind::finished};
  double time{};      ///< the last time reached [T]
  std::string words;  ///< for a diverged run: what went wrong, with the body and the step's ratio to its limit

  /// Whether the numbers are good, as far as the run went.
  explicit operator bool() const { return kind != Kind::diverged; }
};

}  // namespace talus
