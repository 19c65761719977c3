#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "solver/base/archive.hpp"
#include "solver/dynamics/dynamics.hpp"
#include "solver/run/observer.hpp"

namespace talus {

/// An irreversible change of a part of a scene: it yields or breaks.
struct Failure {
  double time{};          ///< of the first state that shows the change [T]
  std::string part;       ///< "cable 'top1'", "hanger 'hanger1'"
  std::string_view what;  ///< "yields" or "breaks"
};

/// Observer that records the order in which cables yield and cables and hangers break, only the first time for each
/// part. Changes within one step have the same time; cables are then listed before hangers, each in the order of the
/// model.
class FailureLog {
 public:
  /// The Dynamics must outlive the log.
  explicit FailureLog(const Dynamics& dynamics);

  void operator()(const State& state, const StepInfo& info);

  /// Serializes the data carried from step to step; restore into a log of the same scene.
  void serialize(Archive& archive);

  const std::vector<Failure>& failures() const { return failures_; }

 private:
  /// A mode change to be recorded.
  struct Watch {
    Slot slot{};
    Mode mode{};
    bool seen{};
    const CableLaw* yielding{};  ///< of a cable that can yield: its natural elongation then grows from zero
  };
  static bool drawn_out(const Watch& watch, const State& state);

  /// Whether something may have failed since the last step: a mode has changed or, as long as a cable can yield, a
  /// memory variable.
  bool has_changed(const State& state);

  std::vector<Watch> watches_;
  std::vector<Mode> modes_;       ///< at the last observed step
  std::vector<double> memory_;    ///< at the last observed step
  std::vector<Failure> awaited_;  ///< the failure that each watch would report
  std::vector<Failure> failures_;
};

}  // namespace talus
