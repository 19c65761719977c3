#pragma once

#include <concepts>
#include <functional>
#include <type_traits>
#include <utility>

#include "solver/state/state.hpp"

namespace talus {

class Snapshot;

/// What an observer is told beside the state.
struct StepInfo {
  long step{};          ///< steps done; 0 for the initial state
  long evaluations{};   ///< force evaluations done
  bool due{};           ///< a record of the history falls on this step, as it does on the plan's first and last
  bool last{};          ///< no step follows: the plan ends with this one, or the run stops
  bool stop{};          ///< the run stops with this step, before its plan's end
  const State* held{};  ///< the state as the integrator holds it: of a staggered method, velocities at t and
                        ///< coordinates half a step on, as the listings of 1993 print them
};

/// A function of the snapshot after a step, or of its state alone (made from which it requires snapshot.hpp).
template <class Result, class... More>
class OfSnapshot {
 public:
  OfSnapshot() = default;
  template <class See>
  requires(!std::same_as<std::remove_cvref_t<See>, OfSnapshot>)  //
      OfSnapshot(See see) {
    if constexpr (std::is_invocable_v<See&, const Snapshot&, More...>) {
      see_ = std::move(see);
    } else {
      see_ = [see = std::move(see)](const auto& snapshot, More... more) mutable -> Result {
        return see(snapshot.state(), more...);
      };
    }
  }

  explicit operator bool() const { return static_cast<bool>(see_); }
  Result operator()(const Snapshot& snapshot, More... more) const { return see_(snapshot, more...); }

 private:
  std::function<Result(const Snapshot&, More...)> see_;
};

/// Sees a run's start and each of its steps; cannot change the run. It requests of the snapshot what it needs at that
/// step.
using Observer = OfSnapshot<void, const StepInfo&>;

/// Ends a run early when it returns true after a step.
using StopCondition = OfSnapshot<bool>;

}  // namespace talus
