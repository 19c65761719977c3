#pragma once

namespace talus {

/// How long a scene runs, in which steps, and how often it is looked at.
struct RunPlan {
  double
      step{};  ///< length of a step [T] > 0; for a method with step control: the interval it is asked to cover at once
  double end{};  ///< time at which the run ends [T] > 0; reached by a whole number of steps, at the first not before it
  double interval{};  ///< time between records of the history [T]; rounded to whole steps, at least one
  bool ledger{
      true};  ///< keep the accounts of energy and impulse (`ledger = off` saves their cost; the summary says so)
};

}  // namespace talus
