#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "solver/base/fields.hpp"

namespace talus::app {

/// How a run of a sweep ended.
enum class SweepEnd {
  finished,
  unusable,  ///< it finished, but its results are not usable
  diverged,
  refused,  ///< its scene is wrong
  limited,  ///< it reached a limit of the sweep
};

/// The result of one run.
struct SweepResult {
  std::string id;
  SweepEnd end{};
  std::string reason;          ///< of a finished run its warnings, and why an output has no value
  double time{};               ///< the last time of the run, in units of its scene
  long evaluations{};          ///< force evaluations
  std::string verdict;         ///< of a fence; empty of other scenes
  std::vector<double> values;  ///< the outputs in units of the base, NaN of one that does not exist; empty unless the
                               ///< run reached its end

  friend bool operator==(const SweepResult&, const SweepResult&) = default;
};

/// Why an output of a finished run has no value, as a part of its reason.
[[nodiscard]] std::string no_value(std::string_view output, std::string_view reason);

/// A result as one line of JSON, and back; `sweep` is SweepFolder::key(). Errors: InputError for a line of another
/// form, or of another sweep.
[[nodiscard]] std::string result_line(const SweepResult& result, std::string_view sweep);
[[nodiscard]] SweepResult result_of_line(const std::string& line, std::string_view sweep);

}  // namespace talus::app

namespace talus {
template <>
struct Names<app::SweepEnd> {
  static constexpr std::array<std::string_view, 5> list{"finished", "unusable", "diverged", "refused", "limited"};
};
}  // namespace talus
