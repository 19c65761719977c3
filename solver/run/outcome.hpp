#pragma once

#include <string>

namespace talus {

/// How a run ended. A diverged run is a result: it has a time and a reason.
struct [[nodiscard]] Outcome {
  enum class Kind { finished, diverged };

  Kind kind{Kind::finished};
  double time{};      ///< the last time reached [T]
  std::string words;  ///< for a diverged run: what went wrong, with the body and the step's ratio to its limit

  explicit operator bool() const { return kind == Kind::finished; }
};

}  // namespace talus
