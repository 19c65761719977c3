#pragma once

#include <concepts>
#include <functional>
#include <type_traits>
#include <utility>

#include "solver/state/state.hpp"

namespace talus {

class Snapshot;

/// Information that an observer receives in addition to the state.
struct StepInfo {
  long step{};          ///< steps done; 0 for the initial state
  long evaluations{};   ///< force evaluations done
  bool due{};           ///< output of the history is due at this step; always true at the first and last step of the
                        ///< plan
  bool last{};          ///< no step follows: the plan ends or the run stops
  bool stop{};          ///< the run stops at this step, before the end of its plan
  const State* held{};  ///< the state as stored by the integrator; staggered methods have velocities at t and
                        ///< coordinates half a step later, as the listings of 1993 print them
};

/// A function of the snapshot after a step, or of its state alone (construction from the latter requires snapshot.hpp).
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

/// Called at the start of a run and after each step; cannot change the run. It requests from the snapshot only the
/// stages that it needs at that step.
using Observer = OfSnapshot<void, const StepInfo&>;

/// Ends a run early when it returns true after a step.
using StopCondition = OfSnapshot<bool>;

}  // namespace talus
