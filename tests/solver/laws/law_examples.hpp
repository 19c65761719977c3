#pragma once

#include <algorithm>
#include <vector>

#include "solver/laws/law_list.hpp"

namespace talus {

/// The law with its parameters set to different values that satisfy its orders, with and without damping and other
/// parameters that may be 0, and with each end rule and each dashpot where it has one.
template <Law L>
std::vector<L> examples() {
  std::vector<L> made;
  for (const EndRule rule : {EndRule::attractive, EndRule::clamped}) {
    for (const double other : {0.0, 0.75}) {
      L law;
      double positive = 5.0;
      for (const auto& field : L::fields()) {
        if (law.*field.member != 0.0) continue;  // a limit that is not reached
        const bool is_positive = field.range == Range::positive;
        law.*field.member = is_positive ? positive : field.range == Range::one_to_hundred ? 1.5 : other;
        if (is_positive) positive *= 4.0;
      }
      if constexpr (HasOrders<L>) {
        for (const auto& order : L::orders())
          law.*order.larger = std::max(law.*order.larger, law.*order.smaller);
      }
      if constexpr (HasYieldTable<L>) law.yield = 3.0;
      if constexpr (HasEndRule<L>) law.end_rule = rule;
      made.push_back(law);
      if constexpr (HasHertzDashpot<L>) {
        law.dashpot = HertzDashpot::constant;
        made.push_back(law);
      }
    }
  }
  return made;
}

/// The friction law with its parameters set to different values: what must be positive grows, all else is 0.5.
template <IsFrictionLaw F>
F friction_example() {
  F law;
  double positive = 3.0;
  for (const auto& field : F::fields()) {
    law.*field.member = field.range == Range::positive ? positive : 0.5;
    if (field.range == Range::positive) positive += 1.0;
  }
  return law;
}

}  // namespace talus
