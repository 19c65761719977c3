#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "solver/base/archive.hpp"
#include "solver/dynamics/dynamics.hpp"
#include "solver/run/observer.hpp"

namespace talus {

/// What a part of a scene went through that it does not come back from.
struct Failure {
  double time{};          ///< of the first state that shows it [T]
  std::string part;       ///< "cable 'top1'", "hanger 'hanger1'"
  std::string_view what;  ///< "yields" or "breaks"
};

/// Observer that keeps the order in which cables yield, and cables and hangers break: of each part the first time only.
/// What happens within one step has one time; cables then stand before hangers, each in the order of the model.
class FailureLog {
 public:
  /// The Dynamics must outlive it.
  explicit FailureLog(const Dynamics& dynamics);

  void operator()(const State& state, const StepInfo& info);

  /// Names what it carries from one step to the next; a log of the same scene goes on from it.
  void serialize(Archive& archive);

  const std::vector<Failure>& failures() const { return failures_; }

 private:
  /// One mode of one part that is waited for.
  struct Watch {
    Slot slot{};
    Mode mode{};
    bool seen{};
    const CableLaw* yielding{};  ///< of a cable that may yield: its natural elongation then grows from 0
  };
  static bool drawn_out(const Watch& watch, const State& state);

  /// Whether something may have failed since the last step: a mode has changed or, as long as a cable may yield, a
  /// memory.
  bool has_changed(const State& state);

  std::vector<Watch> watches_;
  std::vector<Mode> modes_;       ///< at the last step seen
  std::vector<double> memory_;    ///< then
  std::vector<Failure> awaited_;  ///< of each
  std::vector<Failure> failures_;
};

}  // namespace talus
