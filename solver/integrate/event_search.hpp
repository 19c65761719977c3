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

/// Events in a row with hardly any time between (Zeno behaviour) after which a motion ends.
inline constexpr long most_accumulated = 1000;
/// The message then.
[[nodiscard]] std::string accumulation_failure(double t);

/// A state near the end of a step.
struct NearEnd {
  const State* state{};
  bool same{};  ///< its derivative was the last that the system was asked for
};

/// Finds the first event in each step of a motion that is known at all times between the steps' ends: the first time at
/// which a guard is no longer positive, to round-off (Alefeld, Potra & Shi 1995).
class EventSearch {
 public:
  /// Writes the state at a time within the step.
  using StateAt = std::function<void(double t, State& out)>;

  EventSearch() = default;
  explicit EventSearch(const State& like) : looked_at_{like} {}

  /// A segment of the motion begins; `before`: the modes before it. True if some mode began at its very end: then only
  /// a short first step tells whether it lasts.
  [[nodiscard]] bool begin_segment(HybridSystem& system, const State& start, const std::vector<Mode>& before);
  /// When the step from `begin` to the time `end` meets its first event; infinite if it meets none. The next step is no
  /// longer than `next` [T]. `near_end` screens out most steps: only where a guard comes within a thousandth of its way
  /// in the step to its end there, or may have been past it in between, are the guards asked again. An event that hides
  /// in that thousandth is past at the beginning of the next step, and is found there.
  [[nodiscard]] double find(HybridSystem& system, const State& begin, double end, double next, NearEnd near_end,
                            const StateAt& state_at);
  /// From the beginning of the piece, or from near the end of the last step, in which no body can pass another unseen:
  /// how long the next may be at most; infinite of a system that was never asked.
  double longest_step() const { return longest_step_; }
  /// Brings the modes up to date at an event, from the state at the beginning of the step.
  void update_modes(HybridSystem& system, State& at, const State& before);

  /// Names its parts, for a state of so many modes. Errors when putting back: InputError if they do not fit.
  void serialize(Archive& archive, std::size_t modes);

 private:
  /// Of a state, one for each mode.
  struct Guards {
    std::vector<double> each;
    bool all_endless{};  ///< and so not written
    void fill_in();
  };

  void ask(HybridSystem& system, NearEnd at, double ahead);
  void forget_dormant();
  void proceed(double begin);
  void list_finite();
  bool may_have_ended(std::size_t guard) const;
  std::optional<double> dip(double begin, double end) const;
  void look_at(HybridSystem& system, const State& begin, double t, const StateAt& state_at);
  bool find_ended(HybridSystem& system, const State& begin, double t, const StateAt& state_at);
  double least_share() const;

  Guards guards_;               ///< at the end of the last step
  Guards earlier_;              ///< at the beginning of the last step; empty in the first of a piece
  double earlier_time_{};       ///< and when that was
  std::vector<double> masked_;  ///< of guards that are past their end since the piece began: 1, or 2 where the mode
                                ///< was seen to last all the same (a slider whose limit falls)
  bool any_masked_{};           ///< there may be some
  double longest_step_{std::numeric_limits<double>::infinity()};

  // Scratch of a step.
  Guards before_;
  std::vector<double> looked_;
  std::vector<std::size_t> finite_;  ///< guards that something may end
  std::vector<std::size_t> ended_;   ///< guards that are past their end where they were looked at first
  State looked_at_;
  std::vector<Mode> modes_;
};

}  // namespace talus
