#include "solver/integrate/stormer_cowell.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "solver/base/error.hpp"

namespace talus {
namespace {

constexpr std::size_t most_terms = 12;

/// How much longer than the last a step may be: the first few feel their way, high orders bear little.
double largest_growth(std::size_t terms) { return terms == 1 ? 8.0 : terms <= 3 ? 4.0 : terms <= 6 ? 2.0 : 1.3; }

/// e^(-1/n) to .6 percent, e > 0, by nothing but sums, products and powers of two: the library's power is not the same
/// on all processors, and this decides the length of steps.
double inverse_root(double e, std::size_t n) {
  int exponent = 0;
  const double m = 2.0 * std::frexp(e, &exponent) - 1.0;  // e = (1 + m) 2^(exponent - 1)
  const double x = -(exponent - 1.0 + m * (1.346 - 0.346 * m)) / static_cast<double>(n);
  const double floor = std::floor(x), f = x - floor;
  return std::ldexp(1.0 + f * (0.6565 + 0.3435 * f), static_cast<int>(floor));
}

}  // namespace

PolynomialMotion::PolynomialMotion(const State& state, double tolerance)
    : tolerance_{tolerance}, start_{state.q}, basis_(Differences::most + 1), predicted_{state}, found_{state} {}

void PolynomialMotion::flatten(const Rates& rates) {
  new_.assign(rates.v.begin(), rates.v.end());
  if (moves_memory_) new_.insert(new_.end(), rates.z.begin(), rates.z.end());
  if (!keeps_accounts_) return;
  new_.insert(new_.end(), rates.work.begin(), rates.work.end());
  new_.insert(new_.end(), rates.impulse.begin(), rates.impulse.end());
}

/// Numbers that flatten() makes.
std::size_t PolynomialMotion::width(const State& like) const {
  return like.v.size() + (moves_memory_ ? like.z.size() : 0) +
         (keeps_accounts_ ? like.work.size() + like.impulse.size() : 0);
}

/// The first step of a piece knows the rates at one time alone.
void PolynomialMotion::begin(EventfulSystem& system, const State& start, double interval) {
  if (lengths_.empty()) lengths_ = system.lengths(start);
  moves_memory_ = system.moves_memory, keeps_accounts_ = system.keeps_accounts;
  system.derivative(start, found_);
  flatten(found_);
  rates_.begin(start.t, new_);
  order_ = 1;
  if (usual_ == 0.0) usual_ = interval;
  step_ = 0.25 * usual_;
}

std::string PolynomialMotion::advance(EventfulSystem& system, const State& begin, State& end, double longest) {
  if (lengths_.empty()) lengths_ = system.lengths(begin);
  // The rates at the end of the last step join the others only now: until then they told of that step.
  if (begin.t > rates_.newest()) rates_.add(begin.t, new_);
  double h = std::min(step_, longest);
  for (int attempt = 0; attempt < 60 && begin.t + h > begin.t; ++attempt) {
    used_ = std::min(order_, rates_.count());
    try_step(system, begin, h, end);
    const double error = error_with(used_, end);
    if (error <= 1.0) {
      choose_next(h, error, end);
      return {};
    }
    shorten(h, error, end);
    h = step_;
  }
  return fmt::format("no step is short enough for the tolerance at t = {:.6g}", begin.t);
}

/// Predicts, evaluates and corrects; says nothing of whether the step will do.
void PolynomialMotion::try_step(EventfulSystem& system, const State& begin, double h, State& end) {
  const double t = begin.t + h;
  rates_.basis(t, std::min(used_ + 2, rates_.count() + 1), basis_);
  last_value_ = basis_[used_].value;
  predicted_.mode = begin.mode;
  move(begin, t, {basis_.data(), used_}, predicted_);
  system.derivative(predicted_, found_);
  flatten(found_);
  miss_ = new_;
  for (std::size_t i = 0; i < used_; ++i) {
    const auto d = rates_[i];
    for (std::size_t c = 0; c < miss_.size(); ++c)
      miss_[c] -= d[c] * basis_[i].value;
  }
  end = predicted_;
  correct(basis_[used_], end);
  measure(h, begin, end);
}

/// Adds rates, by their integral over time and the integral of that.
void PolynomialMotion::add(std::span<const double> rates, double once, double twice, State& to) const {
  const std::size_t n = to.v.size();
  for (std::size_t i = 0; i < n; ++i)
    to.v[i] += rates[i] * once, to.q[i] += rates[i] * twice;
  auto rate = rates.begin() + static_cast<std::ptrdiff_t>(n);
  if (moves_memory_) {
    for (double& z : to.z)
      z += *rate++ * once;
  }
  if (!keeps_accounts_) return;
  for (double& work : to.work)
    work += *rate++ * once;
  for (double& impulse : to.impulse)
    impulse += *rate++ * once;
}

/// The state at a time by the first terms of the polynomial.
void PolynomialMotion::move(const State& begin, double t, std::span<const Basis> basis, State& to) const {
  const double h = t - begin.t;
  to.t = t;
  to.q = begin.q, to.v = begin.v, to.z = begin.z, to.work = begin.work, to.impulse = begin.impulse;
  for (std::size_t i = 0; i < to.q.size(); ++i)
    to.q[i] += h * begin.v[i];
  for (std::size_t i = 0; i < basis.size(); ++i)
    add(rates_[i], basis[i].once, basis[i].twice, to);
}

/// Adds the term of what the prediction missed.
void PolynomialMotion::correct(const Basis& last, State& to) const {
  add(miss_, last.once / last_value_, last.twice / last_value_, to);
}

void PolynomialMotion::state_at(const State& begin, const State&, double t, State& out) const {
  std::array<Basis, Differences::most + 1> basis;
  rates_.basis(t, used_ + 1, basis);
  move(begin, t, {basis.data(), used_}, out);
  correct(basis[used_], out);
}

/// How large a motion has to be for its errors to count fully: the longest way and the largest speed so far.
void PolynomialMotion::measure(double h, const State& begin, const State& end) {
  double speed = 0.0, way = 0.0;
  for (std::size_t i = 0; i < end.q.size(); ++i) {
    speed = std::max(speed, lengths_[i] * std::max(std::abs(begin.v[i]), std::abs(end.v[i])));
    way = std::max(way, lengths_[i] * std::abs(begin.q[i] - start_[i]));
  }
  // Of a step that fails nothing is to be remembered: its end may be anywhere.
  speed_now_ = std::max(speed_, speed);
  way_now_ = std::max(way_, std::max(way, h * speed_now_));
}

/// What the last step's error would be with so many terms, as a multiple of the tolerance: the difference between
/// prediction and correction.
double PolynomialMotion::error_with(std::size_t terms, const State& like) const {
  const double once = basis_[terms].once / basis_[terms].value, twice = basis_[terms].twice / basis_[terms].value;
  const std::size_t n = like.v.size(), m = moves_memory_ ? like.z.size() : 0;
  // The terms between are missed as well, or no longer.
  const std::size_t low = std::min(terms, used_), high = std::max(terms, used_);
  const double sign = terms < used_ ? 1.0 : -1.0;
  const auto miss = [&](std::size_t c) {
    double sum = miss_[c];
    for (std::size_t i = low; i < high; ++i)
      sum += sign * rates_[i][c] * basis_[i].value;
    return std::abs(sum);
  };
  // What is not a number is the largest.
  const auto raise = [](double& most, double x) { most = x > most || x != x ? x : most; };
  double motion = 0.0, memory = 0.0;
  for (std::size_t c = 0; c < n; ++c)
    raise(motion, lengths_[c] * miss(c));
  for (std::size_t c = n; c < n + m; ++c)
    raise(memory, miss(c));
  // Of a motion that has not begun no error is too small.
  const auto share = [](double x, double of) { return x == 0.0 ? 0.0 : x / of; };
  double error = share(motion * std::abs(once), speed_now_);
  raise(error, share(motion * std::abs(twice), way_now_));
  raise(error, share(memory * std::abs(once), way_now_));
  return error / tolerance_;
}

/// The step failed: how long the next attempt may be.
void PolynomialMotion::shorten(double h, double error, const State& like) {
  const double share = std::isfinite(error) ? 0.8 * inverse_root(error, used_ + 1) : 0.0;
  step_ = h * std::clamp(share, used_ == 1 ? 1e-3 : 0.1, 0.8);
  if (used_ > 1 && error_with(used_ - 1, like) < error) order_ = used_ - 1;
}

/// The step was good: takes over its scales, and chooses the order that allows the longest next step, and that step.
void PolynomialMotion::choose_next(double h, double error, const State& like) {
  speed_ = speed_now_, way_ = way_now_;
  const auto growth = [](double e, std::size_t terms) { return e > 0.0 ? 0.9 * inverse_root(e, terms + 1) : 10.0; };
  double best = growth(error, used_);
  order_ = used_;
  if (used_ > 1) {
    const double lower = growth(error_with(used_ - 1, like), used_ - 1);
    if (lower > best) best = lower, order_ = used_ - 1;
  }
  if (order_ == used_ && used_ < most_terms) {
    if (rates_.count() == used_) {
      ++order_;  // all that is known served: the next step knows more
    } else {
      const double higher = growth(error_with(used_ + 1, like), used_ + 1);
      if (higher > best) best = higher, ++order_;
    }
  }
  const double most = largest_growth(used_);
  step_ = h * std::clamp(best, 0.3, most);
  usual_ = best < most ? step_ : std::max(usual_, step_);
}

void PolynomialMotion::remember(Memory& memory, const State& like) {
  memory.flag("moves_memory", moves_memory_);
  memory.flag("keeps_accounts", keeps_accounts_);
  new_.resize(width(like));
  miss_.resize(new_.size());
  memory.part("rates", [&] { rates_.remember(memory, new_.size()); });
  memory.numbers("new_rates", new_);
  memory.numbers("miss", miss_);
  memory.number("last_value", last_value_);
  const auto count = [&](const char* part, std::size_t& value) {
    long whole = static_cast<long>(value);
    memory.count(part, whole);
    value = static_cast<std::size_t>(whole);
    const std::size_t allowed = std::clamp<std::size_t>(rates_.count() + 1, 1, most_terms);
    if (value < 1 || value > allowed)
      throw InputError{fmt::format("{}: found {}; it must lie in [1, {}]", part, value, allowed)};
  };
  count("order", order_);
  count("used", used_);
  memory.number("step", step_);
  memory.number("usual_step", usual_);
  memory.number("way", way_);
  memory.number("speed", speed_);
  memory.numbers("start", start_);
}

}  // namespace talus
