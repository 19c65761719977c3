#include "solver/integrate/stormer_cowell.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

#include "solver/base/error.hpp"
#include "solver/state/state_memory.hpp"

namespace talus {
namespace {

constexpr std::size_t most_terms = 12;
/// Events in a row with hardly any time between after which the motion is said not to go on.
constexpr long crowd_limit = 1000;

/// How much longer than the last a step may be: the first few feel their way, high orders bear little.
double largest_growth(std::size_t terms) { return terms == 1 ? 8.0 : terms <= 3 ? 4.0 : terms <= 6 ? 2.0 : 1.3; }

/// e^(-1/n) to a percent, e > 0, by nothing but sums, products and powers of two: the library's power is not the same
/// on all processors, and this decides the length of steps.
double inverse_root(double e, std::size_t n) {
  int exponent = 0;
  const double m = 2.0 * std::frexp(e, &exponent) - 1.0;  // e = (1 + m) 2^(exponent - 1)
  const double x = -(exponent - 1.0 + m * (1.346 - 0.346 * m)) / static_cast<double>(n);
  const double floor = std::floor(x), f = x - floor;
  return std::ldexp(1.0 + f * (0.6565 + 0.3435 * f), static_cast<int>(floor));
}

}  // namespace

StormerCowellSteps::StormerCowellSteps(const State& state, double tolerance)
    : begin_{state},
      end_{state},
      tolerance_{tolerance},
      start_{state.q},
      basis_(Differences::most + 1),
      predicted_{state},
      looked_at_{state},
      found_{state} {}

void StormerCowellSteps::flatten(const Rates& rates) {
  new_.assign(rates.v.begin(), rates.v.end());
  new_.insert(new_.end(), rates.z.begin(), rates.z.end());
  new_.insert(new_.end(), rates.work.begin(), rates.work.end());
  new_.insert(new_.end(), rates.impulse.begin(), rates.impulse.end());
}

void StormerCowellSteps::advance(EventfulSystem& system, double t, double interval) {
  lengths_ = system.lengths;
  while (failure_.empty() && end_.t < t) {
    if (fresh_) begin_piece(system, interval);
    take_step(system);
  }
}

/// The first step of a piece knows the rates at one time alone.
void StormerCowellSteps::begin_piece(EventfulSystem& system, double interval) {
  system.derivative(end_, found_);
  flatten(found_);
  rates_.begin(end_.t, new_);
  order_ = 1;
  if (usual_ == 0.0) usual_ = interval;
  step_ = 0.25 * usual_;
  earlier_.clear();
  if (system.guards) {
    system.guards(end_, true, guards_);
    dormant_.resize(guards_.size());
    bool in_doubt = false;
    for (std::size_t i = 0; i < guards_.size(); ++i) {
      const bool lasted = dormant_[i] != 0.0 && begin_.mode[i] == end_.mode[i];
      dormant_[i] = guards_[i] > 0.0 ? 0.0 : lasted ? 2.0 : 1.0;
      in_doubt = in_doubt || dormant_[i] == 1.0;
    }
    // Of a mode that began at its very end only the first step tells whether it lasts.
    if (in_doubt) step_ *= 1e-4;
  }
  fresh_ = false;
}

void StormerCowellSteps::take_step(EventfulSystem& system) {
  // The rates at the end of the last step join the others only now: until then they told of that step.
  if (end_.t > rates_.newest()) rates_.add(end_.t, new_);
  std::swap(begin_, end_);
  double h = step_;
  if (system.longest_step) h = std::min(h, system.longest_step(begin_));
  for (int attempt = 0;; ++attempt) {
    if (!(begin_.t + h > begin_.t) || attempt == 60) {
      failure_ = fmt::format("no step is short enough for the tolerance at t = {:.6g}", begin_.t);
      std::swap(begin_, end_);
      return;
    }
    used_ = std::min(order_, rates_.count());
    try_step(system, h);
    const double error = error_with(used_);
    if (error <= 1.0) {
      choose_next(h, error);
      break;
    }
    shorten(h, error);
    h = step_;
  }
  if (system.guards) find_event(system);
  if (fresh_ || !system.follows || !system.follows(end_)) return;
  const std::vector<Mode> modes = end_.mode;
  system.settle(end_);
  if (end_.mode != modes) ++events_, fresh_ = true;
}

/// Predicts, evaluates and corrects; says nothing of whether the step will do.
void StormerCowellSteps::try_step(EventfulSystem& system, double h) {
  const double t = begin_.t + h;
  rates_.basis(t, std::min(used_ + 2, rates_.count() + 1), basis_);
  last_value_ = basis_[used_].value;
  predicted_.mode = begin_.mode;
  move(t, {basis_.data(), used_}, predicted_);
  system.derivative(predicted_, found_);
  flatten(found_);
  miss_ = new_;
  for (std::size_t i = 0; i < used_; ++i) {
    const auto d = rates_[i];
    for (std::size_t c = 0; c < miss_.size(); ++c)
      miss_[c] -= d[c] * basis_[i].value;
  }
  end_ = predicted_;
  correct(basis_[used_], end_);
  measure(h);
}

/// Adds rates, by their integral over time and the integral of that.
void StormerCowellSteps::add(std::span<const double> rates, double once, double twice, State& to) const {
  auto rate = rates.begin();
  for (std::size_t i = 0; i < to.v.size(); ++i, ++rate)
    to.v[i] += *rate * once, to.q[i] += *rate * twice;
  for (double& z : to.z)
    z += *rate++ * once;
  for (double& work : to.work)
    work += *rate++ * once;
  for (double& impulse : to.impulse)
    impulse += *rate++ * once;
}

/// The state at a time by the first terms of the polynomial.
void StormerCowellSteps::move(double t, std::span<const Basis> basis, State& to) const {
  const double h = t - begin_.t;
  to.t = t;
  to.q = begin_.q, to.v = begin_.v, to.z = begin_.z, to.work = begin_.work, to.impulse = begin_.impulse;
  for (std::size_t i = 0; i < to.q.size(); ++i)
    to.q[i] += h * begin_.v[i];
  for (std::size_t i = 0; i < basis.size(); ++i)
    add(rates_[i], basis[i].once, basis[i].twice, to);
}

/// Adds the term of what the prediction missed.
void StormerCowellSteps::correct(const Basis& last, State& to) const {
  add(miss_, last.once / last_value_, last.twice / last_value_, to);
}

void StormerCowellSteps::state_at(double t, State& out) const {
  if (t >= end_.t) {
    out = end_;
    return;
  }
  std::array<Basis, Differences::most + 1> basis;
  rates_.basis(t, used_ + 1, basis);
  move(t, {basis.data(), used_}, out);
  correct(basis[used_], out);
  out.mode = begin_.mode;
}

/// How large a motion has to be for its errors to count fully: the longest way and the largest speed so far.
void StormerCowellSteps::measure(double h) {
  double speed = 0.0, way = 0.0;
  for (std::size_t i = 0; i < end_.q.size(); ++i) {
    speed = std::max(speed, lengths_[i] * std::max(std::abs(begin_.v[i]), std::abs(end_.v[i])));
    way = std::max(way, lengths_[i] * std::abs(begin_.q[i] - start_[i]));
  }
  // Of a step that fails nothing is to be remembered: its end may be anywhere.
  speed_now_ = std::max(speed_, speed);
  way_now_ = std::max(way_, std::max(way, h * speed_now_));
}

/// What the last step's error would be with so many terms, as a multiple of the tolerance: the difference between
/// prediction and correction.
double StormerCowellSteps::error_with(std::size_t terms) const {
  const double once = basis_[terms].once / basis_[terms].value, twice = basis_[terms].twice / basis_[terms].value;
  const std::size_t n = end_.v.size(), m = end_.z.size();
  // Of a motion that has not begun no error is too small.
  const double speed_share = std::abs(once) / speed_now_, way_share = std::abs(twice) / way_now_;
  const double memory_share = std::abs(once) / way_now_;
  // The terms between are missed as well, or no longer.
  const std::size_t low = std::min(terms, used_), high = std::max(terms, used_);
  const double sign = terms < used_ ? 1.0 : -1.0;
  double error = 0.0;
  for (std::size_t c = 0; c < n + m; ++c) {
    double miss = miss_[c];
    for (std::size_t i = low; i < high; ++i)
      miss += sign * rates_[i][c] * basis_[i].value;
    miss = std::abs(c < n ? lengths_[c] * miss : miss);
    // Written so that what is not a number is too large.
    if (const double of_speed = c < n ? miss * speed_share : 0.0; !(of_speed <= error)) error = of_speed;
    if (const double of_way = miss * (c < n ? way_share : memory_share); !(of_way <= error)) error = of_way;
  }
  return speed_now_ > 0.0 || error > 0.0 ? error / tolerance_ : 0.0;
}

/// The step failed: how long the next attempt may be.
void StormerCowellSteps::shorten(double h, double error) {
  const double share = std::isfinite(error) ? 0.8 * inverse_root(error, used_ + 1) : 0.0;
  step_ = h * std::clamp(share, used_ == 1 ? 1e-3 : 0.1, 0.8);
  if (used_ > 1 && error_with(used_ - 1) < error) order_ = used_ - 1;
}

/// The step was good: takes over its scales, and chooses the order that allows the longest next step, and that step.
void StormerCowellSteps::choose_next(double h, double error) {
  speed_ = speed_now_, way_ = way_now_;
  const auto growth = [](double e, std::size_t terms) { return e > 0.0 ? 0.9 * inverse_root(e, terms + 1) : 10.0; };
  double best = growth(error, used_);
  order_ = used_;
  if (used_ > 1) {
    const double lower = growth(error_with(used_ - 1), used_ - 1);
    if (lower > best) best = lower, order_ = used_ - 1;
  }
  if (order_ == used_ && used_ < most_terms) {
    if (rates_.count() == used_) {
      ++order_;  // all that is known served: the next step knows more
    } else {
      const double higher = growth(error_with(used_ + 1), used_ + 1);
      if (higher > best) best = higher, ++order_;
    }
  }
  const double most = largest_growth(used_);
  step_ = h * std::clamp(best, 0.3, most);
  usual_ = best < most ? step_ : std::max(usual_, step_);
}

/// Ends the step at its first event, if there is one. The prediction is off by less than a thousandth of a guard's way
/// in the step: only where one comes that near to its end, or may have been there in between, is it asked again.
void StormerCowellSteps::find_event(EventfulSystem& system) {
  std::swap(before_, guards_);
  system.guards(predicted_, true, guards_);
  bool near = false, worse = false;
  for (std::size_t i = 0; i < guards_.size(); ++i) {
    if (dormant_[i] != 0.0 && guards_[i] > 0.0) dormant_[i] = 0.0;
    if (dormant_[i] == 0.0) {
      near = near || may_have_ended(i);
    } else {
      worse = worse || (dormant_[i] == 1.0 && guards_[i] < before_[i]);
    }
  }
  std::optional<double> last = near ? std::optional{end_.t} : dip();
  if (last && least_guard(system, *last) > 0.0) last = near ? dip() : std::nullopt;
  const double after = last ? least_guard(system, *last) : 1.0;
  if (after > 0.0) {
    // A mode that began at its very end, and goes on past it, ends with the first short step.
    if (worse) return cut(system, end_.t);
    std::swap(earlier_, before_);
    earlier_time_ = begin_.t;
    return;
  }
  double low = begin_.t, high = *last;
  const double before = least_guard(system, low);
  if (before > 0.0) {
    std::uintmax_t evaluations = 200;
    const auto [left, right] =
        boost::math::tools::toms748_solve([&](double t) { return least_guard(system, t); }, low, high, before, after,
                                          boost::math::tools::eps_tolerance<double>(52), evaluations);
    low = left, high = right;
  }
  cut(system, high);
}

bool StormerCowellSteps::may_have_ended(std::size_t guard) const {
  const double change = std::abs(before_[guard] - guards_[guard]);
  return guards_[guard] <= (std::isfinite(change) ? 1e-3 * change : 0.0);
}

/// When in the last step a guard that is positive at both its ends was least, if that may have been past its end: by
/// the parabola through three times.
std::optional<double> StormerCowellSteps::dip() const {
  std::optional<double> found;
  if (earlier_.size() != guards_.size()) return found;
  double least = std::numeric_limits<double>::infinity();
  const double b = end_.t - begin_.t;
  const double per_a = 1.0 / (begin_.t - earlier_time_), per_b = 1.0 / b, per_both = 1.0 / (end_.t - earlier_time_);
  for (std::size_t i = 0; i < guards_.size(); ++i) {
    // Guards that nothing can end from here are infinite: no comparison holds for what follows from them.
    const double from = (before_[i] - earlier_[i]) * per_a, to = (guards_[i] - before_[i]) * per_b;
    const double curvature = (to - from) * per_both;  // half the second derivative
    if (!(curvature > 0.0) || !std::isfinite(curvature) || dormant_[i] != 0.0) continue;
    const double slope = to - curvature * b;  // at the beginning of the step
    const double s = -0.5 * slope / curvature;
    if (!(s > 0.0 && s < b)) continue;
    const double share = 1.0 + 0.5 * slope * s / before_[i];
    if (share > 0.1 * std::min(1.0, guards_[i] / before_[i]) || share >= least) continue;
    least = share;
    found = begin_.t + s;
  }
  return found;
}

/// The least guard of those that are not past their end since the piece began, at a time in the last step; each as a
/// share of what it was at the beginning of the step, so that no unit decides which is the least.
double StormerCowellSteps::least_guard(EventfulSystem& system, double t) {
  state_at(t, looked_at_);
  looked_at_.mode = begin_.mode;
  system.guards(looked_at_, false, looked_);
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < looked_.size(); ++i) {
    if (dormant_[i] != 0.0) continue;
    const bool measured = before_[i] > 0.0 && std::isfinite(before_[i]);
    least = std::min(least, measured ? looked_[i] / before_[i] : looked_[i] > 0.0 ? 1.0 : -1.0);
  }
  return least;
}

/// Ends the step, and the piece, at an event.
void StormerCowellSteps::cut(EventfulSystem& system, double t) {
  state_at(t, looked_at_);
  std::swap(end_, looked_at_);
  const std::vector<Mode> modes = end_.mode;
  system.settle(end_);
  // What slid is at first brought to its limit, and only then seen to stick.
  system.guards(end_, false, looked_);
  bool lasts = true;
  for (std::size_t i = 0; i < looked_.size(); ++i)
    lasts = lasts && (looked_[i] > 0.0 || dormant_[i] != 0.0 || end_.mode[i] != modes[i]);
  if (!lasts) system.settle(end_);
  ++events_;
  crowd_ = t - event_time_ <= 1e-3 * usual_ ? crowd_ + 1 : 0;
  event_time_ = t;
  fresh_ = true;
  if (crowd_ == crowd_limit)
    failure_ =
        fmt::format("{} events follow each other with hardly any time between them at t = {:.6g}", crowd_limit, t);
}

void StormerCowellSteps::remember(Memory& memory) {
  memory.part("begin", [&] { talus::remember(memory, begin_); });
  memory.part("end", [&] { talus::remember(memory, end_); });
  new_.resize(end_.v.size() + end_.z.size() + end_.work.size() + end_.impulse.size());
  miss_.resize(new_.size());
  memory.part("rates", [&] { rates_.remember(memory, new_.size()); });
  memory.numbers("new_rates", new_);
  memory.numbers("miss", miss_);
  memory.number("last_value", last_value_);
  memory.flag("fresh", fresh_);
  const auto count = [&](const char* name, std::size_t& value) {
    long whole = static_cast<long>(value);
    memory.count(name, whole);
    value = static_cast<std::size_t>(whole);
    const std::size_t allowed = std::clamp<std::size_t>(rates_.count() + 1, 1, most_terms);
    if (value < 1 || value > allowed)
      throw InputError{fmt::format("{}: found {}; it must lie in [1, {}]", name, value, allowed)};
  };
  count("order", order_);
  count("used", used_);
  memory.number("step", step_);
  memory.number("usual_step", usual_);
  memory.number("way", way_);
  memory.number("speed", speed_);
  memory.numbers("start", start_);
  memory.list("guards", guards_);
  memory.list("earlier", earlier_);
  memory.number("earlier_time", earlier_time_);
  memory.list("dormant", dormant_);
  if (guards_.size() != dormant_.size() || (!guards_.empty() && guards_.size() != end_.mode.size()))
    throw InputError{fmt::format("guards: found {}, of which {} may be dormant; there must be {}", guards_.size(),
                                 dormant_.size(), end_.mode.size())};
  memory.number("event_time", event_time_);
  memory.count("events", events_);
  memory.count("crowd", crowd_);
}

}  // namespace talus
