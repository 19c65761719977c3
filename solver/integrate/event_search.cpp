#include "solver/integrate/event_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include "solver/base/error.hpp"
#include "solver/base/pack.hpp"

namespace talus {

std::string accumulation_failure(double t) {
  return fmt::format("{} events follow each other with hardly any time between them at t = {:.6g}", maximum_accumulated,
                     t);
}

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
/// Horizon of the guards as a multiple of the next step, so that no guard should reach zero in the first step in which
/// it is finite; one that does is still found in that step. A guard that a steady force turns round at zero must be
/// finite at the beginning of the preceding step: that step may be an eighth as long, and the guard decreases twice as
/// fast there as on average over both.
constexpr double steps_ahead = 5.0;

/// Lists the indices of the numbers that are not `infinite`; returns their count.
TALUS_CLONES std::size_t list_finite_numbers(const std::vector<double>& numbers, std::size_t* list) {
  constexpr auto its_bits = std::bit_cast<std::int64_t>(infinite);
  std::size_t count = 0, first = 0;
  for (; first + pack_size <= numbers.size(); first += pack_size) {
    Sizes bits;
    std::memcpy(&bits, &numbers[first], sizeof bits);
    if (!any_bit(bits ^ its_bits)) continue;
    for (std::size_t i = first; i < first + pack_size; ++i)
      list[count] = i, count += numbers[i] != infinite ? 1 : 0;
  }
  for (std::size_t i = first; i < numbers.size(); ++i)
    list[count] = i, count += numbers[i] != infinite ? 1 : 0;
  return count;
}

}  // namespace

void EventSearch::Guards::fill_in() {
  if (all_infinite) std::fill(each.begin(), each.end(), infinite);
  all_infinite = false;
}

void EventSearch::request_guards(HybridSystem& system, NearEnd at, double horizon) {
  const GuardBounds found = system.guards(*at.state, at.same, horizon, guards_.each);
  longest_step_ = found.longest_step;
  guards_.all_infinite = !found.finite;
}

bool EventSearch::begin_segment(HybridSystem& system, const State& start, const std::vector<Mode>& before) {
  earlier_.each.clear(), earlier_.all_infinite = false;
  request_guards(system, {&start, true}, infinite);
  guards_.fill_in();
  const std::vector<double>& guards = guards_.each;
  masked_.resize(guards.size());
  ended_.reserve(guards.size());
  any_masked_ = false;
  bool in_doubt = false;
  for (std::size_t i = 0; i < guards.size(); ++i) {
    const bool lasted = masked_[i] != 0.0 && before[i] == start.mode[i];
    masked_[i] = guards[i] > 0.0 ? 0.0 : lasted ? 2.0 : 1.0;
    any_masked_ = any_masked_ || masked_[i] != 0.0;
    in_doubt = in_doubt || masked_[i] == 1.0;
  }
  return in_doubt;
}

double EventSearch::find(HybridSystem& system, const State& begin, double end, double next, NearEnd near_end,
                         const StateAt& state_at) {
  std::swap(before_, guards_);
  request_guards(system, near_end, steps_ahead * next);
  if (guards_.all_infinite) {
    unmask_guards();
    proceed(begin.t);
    return infinite;
  }
  before_.fill_in(), earlier_.fill_in();
  list_finite();
  bool near = false, worse = false;
  for (const std::size_t i : finite_) {
    near |= masked_[i] == 0.0 && may_have_ended(i);
    worse |= masked_[i] == 1.0 && guards_.each[i] <= 0.0 && guards_.each[i] < before_.each[i];
  }
  std::optional<double> last = near ? std::optional{end} : interior_minimum(begin.t, end);
  const auto ends_by = [&](const std::optional<double>& t) { return t && find_ended(system, begin, *t, state_at); };
  bool ends = ends_by(last);
  if (near && !ends) {
    last = interior_minimum(begin.t, end);
    ends = ends_by(last);
  }
  if (!ends) {
    // A mode that began with a guard at or below zero, and whose guard has fallen further, ends with the probe step.
    if (worse) return end;
    // Guards that have become positive are checked from the next step on.
    for (std::size_t i = 0; i < guards_.each.size(); ++i)
      masked_[i] = guards_.each[i] > 0.0 ? 0.0 : masked_[i];
    proceed(begin.t);
    return infinite;
  }
  const double after = minimum_ratio();
  const auto ratio_at = [&](double t) {
    evaluate_guards(system, begin, t, state_at);
    return minimum_ratio();
  };
  const double before = ratio_at(begin.t);
  if (!(before > 0.0)) return begin.t;
  std::uintmax_t evaluations = 200;
  const auto found = boost::math::tools::toms748_solve(ratio_at, begin.t, *last, before, after,
                                                       boost::math::tools::eps_tolerance<double>(52), evaluations);
  return found.second;
}

/// Unmasks all guards: their modes may end again.
void EventSearch::unmask_guards() {
  if (any_masked_) std::fill(masked_.begin(), masked_.end(), 0.0);
  any_masked_ = false;
}

/// Accepts a step without an event that began at `begin`.
void EventSearch::proceed(double begin) {
  std::swap(earlier_, before_);
  earlier_time_ = begin;
}

/// Lists the guards that are finite at the end of the last step: the others have neither ended nor had a minimum.
void EventSearch::list_finite() {
  finite_.resize(guards_.each.size());
  finite_.resize(list_finite_numbers(guards_.each, finite_.data()));
}

bool EventSearch::may_have_ended(std::size_t guard) const {
  const double change = std::abs(before_.each[guard] - guards_.each[guard]);
  return guards_.each[guard] <= (std::isfinite(change) ? 1e-3 * change : 0.0);
}

/// Time of the interior minimum in the last step of a guard that is positive at both ends, if the guard may have been
/// negative there; from the parabola through three times.
std::optional<double> EventSearch::interior_minimum(double begin, double end) const {
  std::optional<double> found;
  if (earlier_.each.size() != guards_.each.size() || finite_.empty()) return found;
  double minimum = std::numeric_limits<double>::infinity();
  const double b = end - begin;
  const double per_a = 1.0 / (begin - earlier_time_), per_b = 1.0 / b, per_both = 1.0 / (end - earlier_time_);
  for (const std::size_t i : finite_) {
    // If a guard was infinite before, none of these numbers is meaningful, and the test below fails.
    const double from = (before_.each[i] - earlier_.each[i]) * per_a, to = (guards_.each[i] - before_.each[i]) * per_b;
    const double curvature = (to - from) * per_both;  // half the second derivative
    const double slope = to - curvature * b;          // at the beginning of the step; at its end: to + curvature b
    // A single branch (&, not &&): hardly any guard turns in a step, and each condition alone is hard to predict.
    if (!((curvature > 0.0) & (curvature < infinite) & (slope < 0.0) & (to + curvature * b > 0.0) &
          (masked_[i] == 0.0)))
      continue;
    const double s = std::min(-0.5 * slope / curvature, b);
    const double ratio = 1.0 + 0.5 * slope * s / before_.each[i];
    if (ratio > 0.1 * std::min(1.0, guards_.each[i] / before_.each[i]) || ratio >= minimum) continue;
    minimum = ratio;
    found = begin + s;
  }
  return found;
}

/// Evaluates the guards listed in ended_ at a time in the last step.
void EventSearch::evaluate_guards(HybridSystem& system, const State& begin, double t, const StateAt& state_at) {
  state_at(t, sampled_);
  sampled_.mode = begin.mode;
  sampled_guards_.resize(guards_.each.size());
  system.guards_of(sampled_, ended_, sampled_guards_);
}

/// Lists in ended_ the guards that are not positive at a time in the last step, except masked ones; returns true if
/// there are any.
bool EventSearch::find_ended(HybridSystem& system, const State& begin, double t, const StateAt& state_at) {
  ended_.clear();
  for (const std::size_t i : finite_) {
    if (masked_[i] == 0.0) ended_.push_back(i);
  }
  evaluate_guards(system, begin, t, state_at);
  std::erase_if(ended_, [this](std::size_t i) { return !(sampled_guards_[i] <= 0.0); });
  return !ended_.empty();
}

/// Minimum of the guards listed in ended_, each relative to its value at the beginning of the step, so that units do
/// not matter.
double EventSearch::minimum_ratio() const {
  double minimum = std::numeric_limits<double>::max();
  for (const std::size_t i : ended_) {
    const bool measured = before_.each[i] > 0.0 && std::isfinite(before_.each[i]);
    minimum = std::min(minimum, measured                   ? sampled_guards_[i] / before_.each[i]
                                : sampled_guards_[i] > 0.0 ? 1.0
                                                           : -1.0);
  }
  return minimum;
}

void EventSearch::update_modes(HybridSystem& system, State& at, const State& before) {
  modes_ = at.mode;
  system.update_modes(at, before);
  // A slider is first brought to its limit and only then found to stick. Guards out of reach last: horizon zero.
  if (!system.guards(at, true, 0.0, sampled_guards_).finite) return;
  bool lasts = true;
  for (std::size_t i = 0; i < sampled_guards_.size(); ++i)
    lasts = lasts && (sampled_guards_[i] > 0.0 || masked_[i] != 0.0 || at.mode[i] != modes_[i]);
  if (!lasts) system.update_modes(at);
}

void EventSearch::serialize(Archive& archive, std::size_t modes) {
  guards_.fill_in(), earlier_.fill_in();
  archive.list("guards", guards_.each);
  archive.list("earlier", earlier_.each);
  archive.number("earlier_time", earlier_time_);
  archive.list("masked", masked_);
  archive.number("longest_step", longest_step_);
  any_masked_ = true;
  if (guards_.each.size() != masked_.size() || (!guards_.each.empty() && guards_.each.size() != modes))
    throw InputError{fmt::format("guards: found {}, of which {} may be masked; there must be {}", guards_.each.size(),
                                 masked_.size(), modes)};
}

}  // namespace talus
