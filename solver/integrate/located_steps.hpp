#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "solver/integrate/concepts.hpp"
#include "solver/integrate/event_search.hpp"
#include "solver/integrate/hybrid_system.hpp"
#include "solver/integrate/internal_steps.hpp"
#include "solver/state/state_archive.hpp"

namespace talus {

/// A motion: the continuation of a state in its modes from the beginning of a step.
///   Motion(like, tolerance)              for states of the same sizes as `like`
///   begin(system, start, interval)       begins a segment, with one force evaluation; `interval` between outputs [T]
///   shorten_to_probe()                   makes the next step a probe: a ten-thousandth of what it would be
///   advance(system, begin, end, longest) takes a step of at most `longest` [T]; returns the error message, or ""
///   near_end(end)                        a state near `end`, and whether the last derivative was evaluated there
///   state_at(begin, end, t, out)         the state at a time within the last step
///   complete(system, begin, end)         finishes the step at `end`: adds what depends on where it ends
///   ends_at_outputs(system)              true if no step may extend beyond an output
///   next_step()                          upper bound of the next step of the segment [T]
///   usual_step()                         length of a step that is not cut short by an event [T]
///   serialize(archive, like)             serializes its parts
///   name, order, step_control            of the resulting method
template <class M>
concept Motion = std::semiregular<M> && std::constructible_from<M, const State&, double> &&
    requires(M& motion, const M& fixed, HybridSystem& system, const State& begin, State& end, double t,
             Archive& archive) {
  { M::name } -> std::same_as<const std::string_view&>;
  { M::order } -> std::same_as<const int&>;
  { M::step_control } -> std::same_as<const StepControl&>;
  { motion.begin(system, begin, t) } -> std::same_as<void>;
  { motion.shorten_to_probe() } -> std::same_as<void>;
  { motion.advance(system, begin, end, t) } -> std::same_as<std::string>;
  { fixed.near_end(begin) } -> std::same_as<NearEnd>;
  { fixed.state_at(begin, begin, t, end) } -> std::same_as<void>;
  { motion.complete(system, begin, end) } -> std::same_as<void>;
  { fixed.ends_at_outputs(system) } -> std::same_as<bool>;
  { fixed.next_step() } -> std::same_as<double>;
  { fixed.usual_step() } -> std::same_as<double>;
  { motion.serialize(archive, begin) } -> std::same_as<void>;
};

/// Integration method with event location: each step of a motion is cut at its first event, to round-off; there modes
/// change, and the motion restarts.
///
/// The step h of the method is the interval between outputs and has no cost in itself. For a system without guards this
/// is a method for smooth motion. Bodies do not sleep: a step is longer than the time a wave takes to the next body.
template <Motion M>
class LocatedSteps {
 public:
  static constexpr std::string_view name = M::name;
  static constexpr int order = M::order;
  static constexpr StepControl step_control = M::step_control;
  static constexpr int evaluations = 0;
  static constexpr int additions = 1;  ///< outputs lie within steps that may be much longer or shorter

  double tolerance{};  ///< as the motion uses it; 0 if it uses none

  template <Hybrid System>
  void start(System& system, State& state, double) {
    if constexpr (NamesWakeAll<System>) system.wake_all(state);
    system.update_modes(state);
    reset(state);
  }

  /// Advances the state by h, or records why it cannot: see failure().
  template <Hybrid System>
  void step(System& system, State& state, double h) {
    HybridSystemOf<System> hybrid{system};
    advance(hybrid, state, h);
  }

  /// Number of events located so far.
  long events() const { return events_; }
  /// Why the method cannot continue; empty while it can.
  const std::string& failure() const { return failure_; }

  void serialize(Archive& archive, const State& like) {
    if (archive.is_loading()) reset(like);
    archive.scope("begin", [&] { talus::serialize(archive, begin_); });
    archive.scope("end", [&] { talus::serialize(archive, end_); });
    archive.flag("needs_restart", needs_restart_);
    motion_.serialize(archive, end_);
    search_.serialize(archive, end_.mode.size());
    archive.flag("follows", follows_);
    archive.number("event_time", event_time_);
    archive.count("events", events_);
    archive.count("accumulated_events", accumulated_);
  }

 private:
  /// Resets everything that a run carries to its value at the start.
  void reset(const State& like) {
    const double kept = tolerance;
    *this = {};
    tolerance = kept;
    begin_ = end_ = cut_ = like;
    motion_ = M{like, tolerance};
    search_ = EventSearch{like};
  }

  void advance(HybridSystem& system, State& state, double h) {
    const double t = state.t + h;
    for (long steps = 0; failure_.empty() && end_.t < t; ++steps) {
      if (steps == maximum_internal_steps) {
        failure_ = internal_steps_failure(end_.t);
        break;
      }
      if (needs_restart_) begin_segment(system, h);
      take_step(system, t);
    }
    if (failure_.empty()) {
      state_at(t, state);
      if (follows_ && t < end_.t) system.update_modes(state, begin_);
    }
    state.t = t;
  }

  /// State of the system at a time within the last step.
  void state_at(double t, State& out) const {
    if (t >= end_.t) {
      out = end_;
      return;
    }
    motion_.state_at(begin_, end_, t, out);
    out.mode = begin_.mode;
  }

  void begin_segment(HybridSystem& system, double interval) {
    motion_.begin(system, end_, interval);
    needs_restart_ = false;
    if (search_.begin_segment(system, end_, begin_.mode)) motion_.shorten_to_probe();
    follows_ = system.follows(end_);  // valid until a mode changes
  }

  void take_step(HybridSystem& system, double t) {
    std::swap(begin_, end_);
    double longest = search_.longest_step();
    if (motion_.ends_at_outputs(system)) longest = std::min(longest, t - begin_.t);
    failure_ = motion_.advance(system, begin_, end_, longest);
    if (!failure_.empty()) return std::swap(begin_, end_);
    const double event = find_event(system);
    if (event < end_.t) {
      motion_.state_at(begin_, end_, event, cut_);
      cut_.mode = begin_.mode;
      std::swap(end_, cut_);
    }
    motion_.complete(system, begin_, end_);
    if (std::isfinite(event)) return settle_event(system);
    if (!follows_) return;
    modes_ = end_.mode;
    system.update_modes(end_, begin_);
    if (end_.mode != modes_) ++events_, needs_restart_ = true;
  }

  double find_event(HybridSystem& system) {
    const auto near_end = motion_.near_end(end_);
    return search_.find(system, begin_, end_.t, motion_.next_step(), near_end,
                        [this](double t, State& out) { state_at(t, out); });
  }

  void settle_event(HybridSystem& system) {
    modes_ = end_.mode;
    search_.update_modes(system, end_, begin_);
    if (end_.mode != modes_) ++events_;
    accumulated_ = end_.t - event_time_ <= 1e-3 * motion_.usual_step() ? accumulated_ + 1 : 0;
    event_time_ = end_.t;
    needs_restart_ = true;
    if (accumulated_ == maximum_accumulated) failure_ = accumulation_failure(end_.t);
  }

  State begin_;  ///< state at the beginning of the last step ...
  State end_;    ///< ... and at its end, in the modes after it
  M motion_;
  EventSearch search_;
  bool needs_restart_{true};  ///< the motion must restart from the end of the last step
  bool follows_{};            ///< some memory must be updated after each step of the segment
  double event_time_{};       ///< time of the last event
  long events_{};
  long accumulated_{};  ///< successive events with hardly any time between them: Zeno behaviour, if they do not end
  std::string failure_;

  // Scratch.
  State cut_;
  std::vector<Mode> modes_;
};

}  // namespace talus
