#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "solver/base/archive.hpp"
#include "solver/integrate/hybrid_system.hpp"
#include "solver/state/state.hpp"

namespace talus {

/// Number of successive events with hardly any time between them (Zeno behaviour) after which a run fails.
inline constexpr long maximum_accumulated = 1000;
/// Message of that failure.
[[nodiscard]] std::string accumulation_failure(double t);

/// A state near the end of a step.
struct NearEnd {
  const State* state{};
  bool same{};  ///< the system's last evaluation was the derivative of this state
};

/// Finds the first event in each step of a motion that is known at all times within a step: the first time at which a
/// guard is no longer positive, to round-off (Alefeld, Potra & Shi 1995).
class EventSearch {
 public:
  /// Writes the state at a time within the step.
  using StateAt = std::function<void(double t, State& out)>;

  EventSearch() = default;
  explicit EventSearch(const State& like) : sampled_{like} {}

  /// Begins a segment of the motion; `before`: the modes before it. Returns true if a mode began with a guard that is
  /// not positive: only a short first step then shows whether the mode lasts.
  [[nodiscard]] bool begin_segment(HybridSystem& system, const State& start, const std::vector<Mode>& before);
  /// Time of the first event in the step from `begin` to the time `end`; infinite if there is none. The next step is at
  /// most `next` [T]. `near_end` screens out most steps: guards are evaluated again only if one of them at `near_end`
  /// has fallen to a thousandth of its change over the step or less, or may have been negative within the step. An
  /// event that is missed within that thousandth has passed at the beginning of the next step, and is found there.
  [[nodiscard]] double find(HybridSystem& system, const State& begin, double end, double next, NearEnd near_end,
                            const StateAt& state_at);
  /// Longest next step in which no body can pass through another unnoticed, as of the beginning of the segment or near
  /// the end of the last step; infinite before the first evaluation of guards.
  double longest_step() const { return longest_step_; }
  /// Updates the modes at an event; `before`: the state at the beginning of the step.
  void update_modes(HybridSystem& system, State& at, const State& before);

  /// Serializes guards and masks for a state with `modes` modes. Errors when restoring: InputError if they do not fit.
  void serialize(Archive& archive, std::size_t modes);

 private:
  /// Guards of a state, one per mode.
  struct Guards {
    std::vector<double> each;
    bool all_infinite{};  ///< all are infinite, and `each` is not written
    void fill_in();
  };

  void request_guards(HybridSystem& system, NearEnd at, double horizon);
  void unmask_guards();
  void proceed(double begin);
  void list_finite();
  bool may_have_ended(std::size_t guard) const;
  std::optional<double> interior_minimum(double begin, double end) const;
  void evaluate_guards(HybridSystem& system, const State& begin, double t, const StateAt& state_at);
  bool find_ended(HybridSystem& system, const State& begin, double t, const StateAt& state_at);
  double minimum_ratio() const;

  Guards guards_;               ///< at the end of the last step
  Guards earlier_;              ///< at the beginning of the last step; empty in the first step of a segment
  double earlier_time_{};       ///< time of `earlier_`
  std::vector<double> masked_;  ///< per guard: 1 if it has not been positive since the segment began, or 2 if its mode
                                ///< has nevertheless lasted (a slider whose limit falls); else 0
  bool any_masked_{};           ///< some guards may be masked
  double longest_step_{std::numeric_limits<double>::infinity()};

  // Scratch of a step.
  Guards before_;
  std::vector<double> sampled_guards_;
  std::vector<std::size_t> finite_;  ///< indices of guards that are finite
  std::vector<std::size_t> ended_;   ///< indices of guards that were not positive where they were first checked
  State sampled_;
  std::vector<Mode> modes_;
};

}  // namespace talus
