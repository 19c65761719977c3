#pragma once

#include <array>
#include <string_view>

#include "solver/base/fields.hpp"

namespace talus {

/// Reaction of a run when a monitored limit is exceeded.
enum class CheckAction {
  off,      ///< no check
  warning,  ///< prints a warning and continues
  error,    ///< ends the run as diverged; of a check after the end, an exit status of the program
};
template <>
struct Names<CheckAction> {
  static constexpr std::array<std::string_view, 3> list{"off", "warning", "error"};
};

/// Checks during a run, and the action if a check fails.
struct MonitorRules {
  CheckAction instability{CheckAction::error};  ///< the active springs exceed the linear stability limit of the method
  CheckAction tunnelling{
      CheckAction::error};  ///< bodies could pass through each other in a step, or overlap by half the half-width of
                            ///< the smaller body
  CheckAction accuracy{CheckAction::warning};  ///< too few steps per contact, deep overlaps, energy balance errors
  CheckAction missing_contacts{CheckAction::warning};  ///< bodies without a contact between them overlap
  CheckAction quality{CheckAction::error};  ///< the results of a run that has ended are NOT USABLE: an error is an exit
                                            ///< code of the program, also of `check` for a step beyond its limit

  /// A kind of check, by its name in scenes, and what it finds.
  struct Choice {
    std::string_view name;
    std::string_view meaning;
    CheckAction MonitorRules::*member;
  };
  static constexpr std::array<Choice, 5> choices() {
    return {
        {{"instability", "step beyond the linear limit of the springs that act", &MonitorRules::instability},
         {"tunnelling", "bodies that may pass each other in a step, or overlap half-way", &MonitorRules::tunnelling},
         {"accuracy", "contacts of few steps, large overlaps, error of the energy balance", &MonitorRules::accuracy},
         {"missing_contacts", "bodies that overlap and have no contact between them", &MonitorRules::missing_contacts},
         {"quality", "results that are NOT USABLE: an error is exit status 7 (default with rules 1993: warning)",
          &MonitorRules::quality}}};
  }
  /// No checks.
  static constexpr MonitorRules off() {
    MonitorRules rules;
    for (const Choice& choice : choices())
      rules.*choice.member = CheckAction::off;
    return rules;
  }
  friend bool operator==(const MonitorRules&, const MonitorRules&) = default;
};

/// Duration, step and output interval of a run.
struct RunPlan {
  /// Length of a step [T] > 0; for a method with step control, the interval between its outputs.
  double step{};
  /// Time at which the run ends [T] > 0; the run takes the smallest whole number of steps that reaches it.
  double end{};
  /// Time between rows of the history [T]; rounded to whole steps, at least one.
  double interval{};
  /// Whether the balances of energy and impulse are recorded (`ledger = off` saves their cost; the summary reports it).
  bool ledger{true};
  MonitorRules watch{};
};

}  // namespace talus
