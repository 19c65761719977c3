#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "solver/integrate/concepts.hpp"
#include "solver/integrate/differences.hpp"

namespace talus {

/// What a method that locates events asks of its system.
struct EventfulSystem {
  /// Rates in the state's present modes: one force evaluation.
  std::function<void(const State&, Rates&)> derivative;
  /// Guards in the state's present modes, one for each mode; `same`: of the state whose derivative was the last.
  std::function<void(const State&, bool same, std::vector<double>&)> guards;
  /// Brings modes and memory up to date.
  std::function<void(State&)> settle;
  /// Whether some memory must be settled as the motion goes on, in the present modes.
  std::function<bool(const State&)> follows;
  /// The longest step [T] in which no body can pass another unseen.
  std::function<double(const State&)> longest_step;
  /// Of each coordinate, the length [L] that one unit of it moves its body by.
  std::vector<double> lengths;
};

/// Steps of variable order and length by the polynomial through the rates at the last times: accelerations are
/// integrated once to velocities and twice to coordinates (Stoermer 1907, Cowell & Crommelin 1910; by differences for
/// steps of any length Krogh 1974, Shampine & Gordon 1975). Predict, evaluate once, correct. Between the ends of the
/// steps the same polynomial says where the system is; where a guard ends there, the step is cut, to round-off, and the
/// motion begins anew.
///
/// tolerance: how far prediction and correction may be apart, as a share of the longest way and the largest speed of
/// the run so far.
class StormerCowellSteps {
 public:
  StormerCowellSteps() = default;
  StormerCowellSteps(const State& state, double tolerance);

  /// Takes steps until they reach `t`, or until they fail: see failure(). `interval`: what is tried first.
  void advance(EventfulSystem& system, double t, double interval);
  /// The system at a time within the last step.
  void state_at(double t, State& out) const;

  /// Events located so far.
  long events() const { return events_; }
  /// Why there are no more steps; empty while there are.
  const std::string& failure() const { return failure_; }

  /// Names its parts; one that is put back was made from a state of the same scene.
  void remember(Memory& memory);

 private:
  using Basis = Differences::Basis;

  void begin_piece(EventfulSystem& system, double interval);
  void take_step(EventfulSystem& system);
  void try_step(EventfulSystem& system, double h);
  void shorten(double h, double error);
  void choose_next(double h, double error);
  double error_with(std::size_t terms) const;
  void measure(double h);
  void move(double t, std::span<const Basis> basis, State& to) const;
  void correct(const Basis& last, State& to) const;
  void add(std::span<const double> rates, double once, double twice, State& to) const;
  void find_event(EventfulSystem& system);
  bool may_have_ended(std::size_t guard) const;
  std::optional<double> dip() const;
  double least_guard(EventfulSystem& system, double t);
  void cut(EventfulSystem& system, double t);
  void flatten(const Rates& rates);

  State begin_;               ///< at the beginning of the last step ...
  State end_;                 ///< ... and at its end, in the modes after it
  Differences rates_;         ///< up to the beginning: accelerations, memory rates, powers, impulses
  std::vector<double> new_;   ///< the same at the end of the last step
  std::vector<double> miss_;  ///< how much of it the prediction missed
  double last_value_{};       ///< at the end of the last step, of the first term that it left out
  bool fresh_{true};          ///< the motion is to begin anew from the end of the last step
  std::size_t order_{1};      ///< terms that predict the next step
  std::size_t used_{1};       ///< and the last
  double step_{};             ///< length of the next step [T]
  double usual_{};            ///< the last that was not held short by an event [T]
  double tolerance_{};
  double way_{};                 ///< longest way of a coordinate so far [L]
  double speed_{};               ///< largest speed so far [L/T]
  std::vector<double> start_;    ///< coordinates at the start of the run
  std::vector<double> guards_;   ///< at the end of the last step
  std::vector<double> earlier_;  ///< at the beginning of the last step; empty in the first of a piece
  double earlier_time_{};        ///< and when that was
  std::vector<double> dormant_;  ///< of guards that are past their end since the piece began: 1, or 2 where the mode
                                 ///< was seen to last all the same (a slider whose limit falls)
  double event_time_{};          ///< of the last event
  long events_{};
  long crowd_{};  ///< events in a row with hardly any time between
  std::string failure_;

  // Scratch of a step.
  std::vector<double> lengths_;
  std::vector<Basis> basis_;
  double way_now_{}, speed_now_{};
  std::vector<double> before_, looked_;
  State predicted_, looked_at_;
  Rates found_;
};

/// Stoermer-Cowell with located events as a Talus integrator: the step h is the interval between outputs, and costs
/// nothing by itself. Of a system without guards it is a method for smooth motion. Bodies do not sleep: a step is
/// longer than a wave takes to the next body.
class StormerCowell {
 public:
  static constexpr std::string_view name = "stormer_cowell";
  static constexpr int order = 12;
  static constexpr bool needs_tolerance = true;
  static constexpr bool has_step_control = true;

  double tolerance{};  ///< of a step: see StormerCowellSteps

  template <Differentiable System>
  void start(System& system, State& state, double) {
    if constexpr (requires { system.wake_all(state); }) system.wake_all(state);
    system.settle(state);
    steps_ = StormerCowellSteps{state, tolerance};
  }

  template <Differentiable System>
  void step(System& system, State& state, double h) {
    EventfulSystem asked = eventful(system, state);
    const double t = state.t + h;
    steps_.advance(asked, t, h);
    if (steps_.failure().empty()) steps_.state_at(t, state);
    state.t = t;
  }

  template <class System>
  const State& synchronized(System&, const State& state, double) const {
    return state;
  }

  long events() const { return steps_.events(); }
  const std::string& failure() const { return steps_.failure(); }

  void remember(Memory& memory, const State& like) {
    if (memory.puts_back()) steps_ = StormerCowellSteps{like, tolerance};
    steps_.remember(memory);
  }

 private:
  template <class System>
  static EventfulSystem eventful(System& system, const State& state) {
    EventfulSystem asked;
    asked.derivative = [&system](const State& at, Rates& out) { system.derivative(at, out); };
    asked.settle = [&system](State& at) { system.settle(at); };
    if constexpr (requires(std::vector<double> & out) { system.guards(state, true, out); }) {
      asked.guards = [&system](const State& at, bool same, std::vector<double>& out) { system.guards(at, same, out); };
      asked.follows = [&system](const State& at) { return system.follows(at); };
      asked.longest_step = [&system](const State& at) { return system.longest_step(at); };
      asked.lengths = system.lengths();
    } else {
      asked.lengths.assign(state.q.size(), 1.0);
    }
    return asked;
  }

  StormerCowellSteps steps_;
};

}  // namespace talus
