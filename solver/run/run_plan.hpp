#pragma once

#include <array>
#include <string_view>

#include "solver/base/fields.hpp"

namespace talus {

/// What a run does when the watch over it finds a limit passed.
enum class Breach {
  off,      ///< nothing is looked for
  warning,  ///< it says so and goes on
  error,    ///< it ends as diverged
};
template <>
struct Names<Breach> {
  static constexpr std::array<std::string_view, 3> list{"off", "warning", "error"};
};

/// What is watched during a run, and what follows a breach.
struct WatchRules {
  Breach instability{Breach::error};  ///< the springs that act are beyond the linear limit of the method
  Breach tunnelling{Breach::error};   ///< bodies may pass each other in a step, or press half-way into each other
  Breach accuracy{Breach::warning};   ///< contacts of few steps, deep overlaps, a ledger that does not close

  /// A kind of breach, by its name in scenes.
  struct Choice {
    std::string_view name;
    Breach WatchRules::*member;
  };
  static constexpr std::array<Choice, 3> choices() {
    return {{{"instability", &WatchRules::instability},
             {"tunnelling", &WatchRules::tunnelling},
             {"accuracy", &WatchRules::accuracy}}};
  }
  friend bool operator==(const WatchRules&, const WatchRules&) = default;
};

/// How long a scene runs, in which steps, and how often it is looked at.
struct RunPlan {
  double
      step{};  ///< length of a step [T] > 0; for a method with step control: the interval it is asked to cover at once
  double end{};  ///< time at which the run ends [T] > 0; reached by a whole number of steps, at the first not before it
  double interval{};  ///< time between records of the history [T]; rounded to whole steps, at least one
  bool ledger{
      true};  ///< keep the accounts of energy and impulse (`ledger = off` saves their cost; the summary says so)
  WatchRules watch{};
};

}  // namespace talus
