#include "solver/advise/pilot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "solver/base/error.hpp"
#include "solver/integrate/integrator_list.hpp"
#include "solver/run/simulate.hpp"
#include "solver/run/snapshot.hpp"
#include "solver/stability/run_monitor.hpp"

namespace talus {
namespace {

/// The largest of evenly spaced values and of the vertices of the parabolas through the three values around each local
/// maximum where the curve is smooth. On a smooth curve the drop at twice the distance from the maximum is about 4
/// times the drop (3 to 5 here); at a jump (the onset of a dashpot) the ratio is 1, at a corner 2.
class LargestBetween {
 public:
  void operator()(double value) {
    std::rotate(last_.begin(), last_.begin() + 1, last_.end());
    last_.back() = value;
    largest_ = std::max(largest_, value);
    if (++seen_ < static_cast<long>(last_.size())) return;
    const auto [a, b, middle, d, e] = last_;
    if (middle < b || middle < d) return;
    const double near = 2.0 * middle - b - d, far = 2.0 * middle - a - e;
    if (!(near > 0.0 && far > 3.0 * near && far < 5.0 * near)) return;
    largest_ = std::max(largest_, middle + (d - b) * (d - b) / (8.0 * near));
  }
  double largest() const { return largest_; }

 private:
  std::array<double, 5> last_{};
  long seen_{};
  double largest_{-std::numeric_limits<double>::infinity()};
};

/// A number in [-1, 1], evenly distributed over coordinates and directions (multiples of the golden ratio).
double spread(std::size_t coordinate, int direction) {
  const double x = 0.6180339887498949 * static_cast<double>((coordinate + 1) * static_cast<std::size_t>(direction));
  return 2.0 * (x - std::floor(x)) - 1.0;
}

double largest_speed(const State& state, const std::vector<double>& lengths) {
  double speed = 0.0;
  for (std::size_t i = 0; i < state.v.size(); ++i)
    speed = std::max(speed, lengths[i] * std::abs(state.v[i]));
  return speed;
}

}  // namespace

Scene with_method(Scene scene, const RunMethod& method) {
  const IntegratorChoice chosen = choose_integrator(scene.model, method.integrator, method.tolerance);
  scene.integrator = chosen.integrator;
  scene.integrator_reason = chosen.why;
  scene.plan.step = (scene.plan.end - scene.initial.t) / static_cast<double>(method.steps);
  scene.plan.interval = std::max(scene.plan.interval, scene.plan.step);
  return scene;
}

State PilotRuns::start(const Nudge& nudge) const {
  State state = scene_->initial;
  if (nudge.direction == 0) return state;
  dynamics_.wake_all(state);
  const std::vector<double> lengths = dynamics_.lengths();
  for (std::size_t i = 0; i < state.v.size(); ++i)
    state.v[i] += nudge.fraction * nudge.speed / lengths[i] * spread(i, nudge.direction);
  return state;
}

Pilot PilotRuns::run(const RunMethod& method, long maximum, const Nudge& nudge) {
  Pilot pilot;
  try {
    const Scene scene = with_method(*scene_, method);
    RigidBodySystem system{dynamics_, scene.plan.ledger || quantity_->ledger};
    system.allow(std::max(0L, maximum));
    try {
      take(system, scene, start(nudge), pilot);
    } catch (const TooManyEvaluations&) {
      pilot.failure = fmt::format("given up after {} evaluations", system.evaluations());
    }
    pilot.evaluations = system.evaluations();
    evaluations_ += pilot.evaluations;
  } catch (const InputError& error) {
    pilot.failure = error.what();
  }
  return pilot;
}

void PilotRuns::take(RigidBodySystem& system, const Scene& scene, State start, Pilot& pilot) const {
  system.begin(start);
  // A missing contact is a property of the scene, not of the method that is tried.
  Scene monitored = scene;
  monitored.plan.watch.missing_contacts = CheckAction::off;
  Recorder recorder{dynamics_, start, scene.plan.ledger || quantity_->ledger, std::vector{quantity_->column}};
  RunMonitor monitor{monitored, dynamics_, start};
  LargestBetween largest, smallest;
  const std::vector<double> lengths = dynamics_.lengths();
  const Observer observer = [&](const Snapshot& seen, const StepInfo& info) {
    recorder(seen, info);
    std::optional<RunMonitor::Balance> balance;
    if (recorder.ledger()) balance = {recorder.accounts().energy_balance_error, recorder.ledger()->energy_scale()};
    monitor.check(seen, info.step, balance);
    const double value = recorder.row()[quantity_->column];
    pilot.values.push_back(value);
    largest(value);
    smallest(-value);
    pilot.speed = std::max(pilot.speed, largest_speed(seen.state(), lengths));
  };
  Integrator integrator = scene.integrator;
  const Outcome outcome = simulate(system, integrator, start, scene.plan, {&observer, 1}, [&](const State& seen) {
    return !monitor.violation().empty() || (scene.early_end && reached(*scene.early_end, scene.model, seen));
  });
  pilot.failure = outcome ? monitor.violation() : outcome.message;
  if (pilot.failure.empty() && !warned_) {
    if (monitor.step_is_beyond()) {
      pilot.failure = monitor.step_ratio();
    } else if (const auto warnings = monitor.warnings(); !warnings.empty()) {
      pilot.failure = warnings.front();
    }
  }
  if (!pilot.failure.empty()) return;
  const Extreme extreme = recorder.extreme(quantity_->column);
  pilot.printed = quantity_->of(extreme.minimum, extreme.maximum, pilot.values.back());
  pilot.between = quantity_->of(-smallest.largest(), largest.largest(), pilot.values.back());
  pilot.size = std::max(std::abs(extreme.minimum), std::abs(extreme.maximum));
}

long PilotRuns::cost(const RunMethod& method) {
  constexpr long sampled = 32, maximum_sampled = 10'000;
  if (method.steps <= sampled) return method.steps;
  try {
    Scene scene = with_method(*scene_, method);
    RigidBodySystem system{dynamics_, scene.plan.ledger || quantity_->ledger};
    scene.plan.end = scene.initial.t + static_cast<double>(sampled) * scene.plan.step;
    system.allow(maximum_sampled);
    try {
      static_cast<void>(simulate(system, scene.integrator, scene.initial, scene.plan));
    } catch (const TooManyEvaluations&) {
      // The run is that expensive already; the estimate below suffices.
    }
    evaluations_ += system.evaluations();
    return method.steps / sampled * std::max(1L, system.evaluations());
  } catch (const InputError&) {
    return method.steps;
  }
}

}  // namespace talus
