#pragma once

#include <array>
#include <string>
#include <string_view>

#include "solver/base/fields.hpp"

namespace talus {

/// Result of a run. Divergence is a result, too: it has a time and a reason.
struct [[nodiscard]] Outcome {
  enum class Kind {
    finished,
    stopped,  ///< before the end of its plan, by its stop condition
    diverged
  };

  Kind kind{Kind::finished};
  double time{};        ///< the last time reached [T]
  std::string message;  ///< for a diverged run: the cause, with the body or contact where there is one

  /// Whether the results are valid up to `time`.
  explicit operator bool() const { return kind != Kind::diverged; }
};

template <>
struct Names<Outcome::Kind> {
  static constexpr std::array<std::string_view, 3> list{"finished", "stopped", "diverged"};
};

}  // namespace talus
