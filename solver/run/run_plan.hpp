#pragma once

#include <array>
#include <string_view>

#include "solver/base/fields.hpp"

namespace talus {

/// What a run does when the watch over it finds a limit passed.
enum class CheckAction {
  off,      ///< nothing is looked for
  warning,  ///< it says so and goes on
  error,    ///< it ends as diverged
};
template <>
struct Names<CheckAction> {
  static constexpr std::array<std::string_view, 3> list{"off", "warning", "error"};
};

/// What is watched during a run, and what follows a breach.
struct MonitorRules {
  CheckAction instability{CheckAction::error};  ///< the springs that act are beyond the linear limit of the method
  CheckAction tunnelling{
      CheckAction::error};  ///< bodies may pass each other in a step, or press half-way into each other
  CheckAction accuracy{CheckAction::warning};  ///< contacts of few steps, deep overlaps, a ledger that does not close

  /// A kind of breach, by its name in scenes.
  struct Choice {
    std::string_view name;
    CheckAction MonitorRules::*member;
  };
  static constexpr std::array<Choice, 3> choices() {
    return {{{"instability", &MonitorRules::instability},
             {"tunnelling", &MonitorRules::tunnelling},
             {"accuracy", &MonitorRules::accuracy}}};
  }
  friend bool operator==(const MonitorRules&, const MonitorRules&) = default;
};

/// How long a scene runs, in which steps, and how often it is looked at.
struct RunPlan {
  /// Length of a step [T] > 0; for a method with step control, the interval between its outputs.
  double step{};
  /// Time at which the run ends [T] > 0: reached by a whole number of steps, at the first that is not before it.
  double end{};
  /// Time between records of the history [T]; rounded to whole steps, at least one.
  double interval{};
  /// Whether the balances of energy and impulse are recorded (`ledger = off` saves their cost; the summary says so).
  bool ledger{true};
  MonitorRules watch{};
};

}  // namespace talus
