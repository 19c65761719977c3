#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "solver/integrate/concepts.hpp"
#include "solver/integrate/event_search.hpp"
#include "solver/state/state_memory.hpp"

namespace talus {

/// A method of integration: steps of a motion, each cut at its first event, to round-off; there modes change, and the
/// motion begins anew.
///
/// Motion: how a state goes on in its modes from the beginning of a step.
///   begin(system, start, interval)       a piece begins, one force evaluation; `interval` between outputs [T]
///   hesitate()                           the next step is to be a ten-thousandth of what it would be
///   advance(system, begin, end, longest) takes a step, at most so long [T]; says why if it cannot
///   near_end(end)                        a state near that at the end, and whether the last derivative was its own
///   state_at(begin, end, t, out)         the state at a time within the last step
///   complete(system, begin, end)         the step ends here: what it kept for its end
///   ends_at_outputs(system)              whether no step may go beyond an output
///   next_step()                          the next step of the piece is no longer than this [T]
///   usual_step()                         length of a step that no event holds short [T]
///   remember(memory, like)               its parts
///   name, order, needs_tolerance, needs_closed_form   of the method that it makes
///   Motion(like, tolerance)                           of a state of the scene
///
/// The step h of the method is the interval between outputs, and costs nothing by itself. Of a system without guards it
/// is a method for smooth motion. Bodies do not sleep: a step is longer than a wave takes to the next body.
template <class Motion>
class LocatedSteps {
 public:
  static constexpr std::string_view name = Motion::name;
  static constexpr int order = Motion::order;
  static constexpr bool needs_tolerance = Motion::needs_tolerance;
  static constexpr bool has_step_control = Motion::needs_tolerance;
  static constexpr bool needs_closed_form = Motion::needs_closed_form;

  double tolerance{};  ///< as the motion takes it; 0 where it takes none

  template <Differentiable System>
  void start(System& system, State& state, double) {
    if constexpr (requires { system.wake_all(state); }) system.wake_all(state);
    system.settle(state);
    set_out(state);
  }

  /// Takes the state on by h, or says why it cannot: see failure().
  template <Differentiable System>
  void step(System& system, State& state, double h) {
    EventfulSystem asked = eventful(system);
    const double t = state.t + h;
    while (failure_.empty() && end_.t < t) {
      if (fresh_) begin_piece(asked, h);
      take_step(asked, t);
    }
    if (failure_.empty()) {
      state_at(t, state);
      if (follows_ && t < end_.t) asked.settle_step(state, begin_);
    }
    state.t = t;
  }

  /// Events located so far.
  long events() const { return events_; }
  /// Why there are no more steps; empty while there are.
  const std::string& failure() const { return failure_; }

  void remember(Memory& memory, const State& like) {
    if (memory.puts_back()) set_out(like);
    memory.part("begin", [&] { talus::remember(memory, begin_); });
    memory.part("end", [&] { talus::remember(memory, end_); });
    memory.flag("fresh", fresh_);
    motion_.remember(memory, end_);
    search_.remember(memory, end_.mode.size());
    memory.flag("follows", follows_);
    memory.number("event_time", event_time_);
    memory.count("events", events_);
    memory.count("crowd", crowd_);
  }

 private:
  /// All that a run carries, as at its start.
  void set_out(const State& like) {
    const double kept = tolerance;
    *this = {};
    tolerance = kept;
    begin_ = end_ = cut_ = like;
    motion_ = Motion{like, tolerance};
    search_ = EventSearch{like};
  }

  /// The system at a time within the last step.
  void state_at(double t, State& out) const {
    if (t >= end_.t) {
      out = end_;
      return;
    }
    motion_.state_at(begin_, end_, t, out);
    out.mode = begin_.mode;
  }

  void begin_piece(EventfulSystem& system, double interval) {
    motion_.begin(system, end_, interval);
    fresh_ = false;
    if (!system.guards) return;
    if (search_.begin_piece(system, end_, begin_.mode)) motion_.hesitate();
    follows_ = system.follows(end_);  // as long as no mode changes
  }

  void take_step(EventfulSystem& system, double t) {
    std::swap(begin_, end_);
    double longest = search_.longest_step();
    if (motion_.ends_at_outputs(system)) longest = std::min(longest, t - begin_.t);
    failure_ = motion_.advance(system, begin_, end_, longest);
    if (!failure_.empty()) return std::swap(begin_, end_);
    const double event = system.guards ? find_event(system) : std::numeric_limits<double>::infinity();
    if (event < end_.t) {
      motion_.state_at(begin_, end_, event, cut_);
      cut_.mode = begin_.mode;
      std::swap(end_, cut_);
    }
    motion_.complete(system, begin_, end_);
    if (std::isfinite(event)) return settle_event(system);
    if (!follows_) return;
    modes_ = end_.mode;
    system.settle_step(end_, begin_);
    if (end_.mode != modes_) ++events_, fresh_ = true;
  }

  double find_event(EventfulSystem& system) {
    const auto near_end = motion_.near_end(end_);
    return search_.find(system, begin_, end_.t, motion_.next_step(), near_end,
                        [this](double t, State& out) { state_at(t, out); });
  }

  void settle_event(EventfulSystem& system) {
    modes_ = end_.mode;
    search_.settle(system, end_, begin_);
    if (end_.mode != modes_) ++events_;
    crowd_ = end_.t - event_time_ <= 1e-3 * motion_.usual_step() ? crowd_ + 1 : 0;
    event_time_ = end_.t;
    fresh_ = true;
    if (crowd_ == crowd_limit) failure_ = crowd_failure(end_.t);
  }

  State begin_;  ///< at the beginning of the last step ...
  State end_;    ///< ... and at its end, in the modes after it
  Motion motion_;
  EventSearch search_;
  bool fresh_{true};     ///< the motion is to begin anew from the end of the last step
  bool follows_{};       ///< some memory is to be settled after each step of the piece
  double event_time_{};  ///< of the last event
  long events_{};
  long crowd_{};  ///< events in a row with hardly any time between
  std::string failure_;

  // Scratch.
  State cut_;
  std::vector<Mode> modes_;
};

}  // namespace talus
