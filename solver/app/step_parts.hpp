#pragma once

#include <chrono>

#include "solver/dynamics/dynamics.hpp"
#include "solver/run/observer.hpp"

namespace talus::app {

/// What a run carries from step to step and what its steps cost, part by part, from looks at a few of them: a look
/// computes the forces of the state once more, in a separate workspace, and changes nothing. Times are this
/// machine's.
class StepParts {
 public:
  StepParts(const Dynamics& dynamics, bool ledger);

  /// Whether the observers of this step are timed.
  static bool timed(long step) { return step % 61 == 60; }
  /// The observers of a step that is timed have taken so long.
  void observed(std::chrono::steady_clock::duration taken);
  /// Looks at a state that a run has come to, at some of its steps.
  void look(const State& state, const StepInfo& info);
  /// The run has taken so many steps and evaluations in so many seconds of the processor's time, looks and observers
  /// included.
  void ended(double seconds, long steps, long evaluations);

  /// Nanoseconds a step.
  struct Times {
    double step{};  ///< all of it
    double contacts{}, cables{}, bodies{};
    double integration{};  ///< what is left: the method, what it prepares for observers, and the watch
    double observers{};
  };
  /// Counts are means over the looks.
  struct Found {
    long looks{};
    std::size_t pairs{};  ///< of bodies that may touch
    double near{};        ///< of these within reach, whose gaps are computed
    double touching{};    ///< and with a law that acts
    std::size_t cables{};
    double awake{};        ///< cables that are computed
    double taut{};         ///< and pull
    std::size_t memory{};  ///< values that laws keep
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
