#pragma once

#include <chrono>

#include "solver/dynamics/dynamics.hpp"
#include "solver/run/observer.hpp"

namespace talus::app {

/// Profile of a run's steps: counts of pairs and cables, and computing time by part, sampled at a few steps (looks). A
/// look evaluates the forces of the state again in a separate workspace and does not change the run. Times depend on
/// the machine.
class StepParts {
 public:
  StepParts(const Dynamics& dynamics, bool ledger);

  /// Whether the observers of this step are timed.
  static bool timed(long step) { return step % 61 == 60; }
  /// Records the time that the observers took in a timed step.
  void observed(std::chrono::steady_clock::duration taken);
  /// Call after every step; samples the state at some of the steps.
  void look(const State& state, const StepInfo& info);
  /// Records the processor time [s] of a run, including looks and observers, with its numbers of steps and evaluations.
  void ended(double seconds, long steps, long evaluations);

  /// Nanoseconds per step.
  struct Times {
    double step{};  ///< total
    double contacts{}, cables{}, bodies{};
    double integration{};  ///< the remainder: the method, its preparations for observers, and the run monitor
    double observers{};
  };
  /// Counts are means over the looks.
  struct Found {
    long looks{};
    std::size_t pairs{};  ///< of bodies that may touch
    double near{};        ///< pairs within reach, whose gaps are computed
    double touching{};    ///< pairs with an acting law
    std::size_t cables{};
    double awake{};        ///< cables that are computed
    double taut{};         ///< cables with tension
    std::size_t memory{};  ///< number of values in the laws' memory
    Times times;
  };
  [[nodiscard]] Found found() const;

 private:
  template <class Work>
  static std::chrono::duration<double, std::nano> time(Work&& work);
  void count(const State& state);

  const Dynamics* dynamics_;
  bool ledger_;
  Workspace work_;
  Rates rates_;
  long next_{64};
  Found sums_;
  std::chrono::duration<double, std::nano> evaluation_{}, contacts_{}, cables_{}, looking_{}, run_{};
  std::chrono::steady_clock::duration observers_{};
  long observed_{}, steps_{}, evaluations_{};
};

}  // namespace talus::app
