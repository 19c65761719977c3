#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

/// Integration of a smooth system with a tight tolerance and located events, for references without a closed form.
///
/// odeint's Runge-Kutta-Fehlberg 7(8) under step control in long double (64 bits of mantissa on x86: 1.1e-19), with a
/// relative tolerance of 1e-17 per step. It shares no code with the solver's integrators. An event is a guard that
/// falls from positive to zero: the step that contains it is repeated with a shorter length, found by bracketing (TOMS
/// 748), from the same starting point. The rates continue smoothly past the event, so each attempted step is one of a
/// smooth system and the event is located to round-off.
namespace talus::verification::reference {

using Coordinates = std::vector<long double>;

/// dy/dt = f(y); autonomous: time does not enter.
using Rates = std::function<void(const Coordinates& y, Coordinates& dydt)>;

/// Guard function, positive while the present segment of motion lasts.
using Guard = std::function<long double(const Coordinates& y)>;

class Trajectory {
 public:
  /// `longest_step` [T] limits the steps: a guard that falls and rises within one is missed, so it must be a small
  /// fraction (for example a twentieth) of the shortest time scale of the guards.
  Trajectory(Rates rates, Coordinates start, long double start_time, long double longest_step);

  [[nodiscard]] long double time() const { return time_; }
  [[nodiscard]] const Coordinates& coordinates() const { return y_; }

  /// Integrates to exactly `t` (>= time()).
  void advance_to(long double t);

  /// Integrates to the first fall of a guard from positive to zero and returns its index, or to `limit` and returns
  /// nothing. A guard that is not positive at the start is inactive until it becomes positive.
  [[nodiscard]] std::optional<std::size_t> advance_until(std::span<const Guard> guards, long double limit);

 private:
  struct Step {
    long double length;
    Coordinates end;
  };
  [[nodiscard]] Step next_step(long double maximum);
  [[nodiscard]] Coordinates moved_by(long double length) const;
  void pass(long double length);
  void land(long double t);
  [[nodiscard]] long double fall_within(const Guard& guard, const Step& step) const;

  Rates rates_;
  Coordinates y_;
  long double time_;
  long double excess_{0.0L};  // of time_ over the sum of the steps (Kahan): equal steps round the same way each time
  long double longest_step_;
  long double proposed_step_;
};

}  // namespace talus::verification::reference
