#include "solver/integrate/stormer_cowell.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "solver/base/error.hpp"
#include "solver/base/pack.hpp"
#include "solver/base/rows.hpp"
#include "solver/integrate/internal_steps.hpp"

namespace talus {
namespace {

constexpr std::size_t maximum_terms = 12;
/// First step of a segment as a fraction of the usual step.
constexpr double first_fraction = 0.25;

/// Cost of an implicit step relative to a step of the polynomial.
constexpr double implicit_cost = 12.0;
/// Steps of the polynomial above this order are limited by their errors, not by stiffness.
constexpr std::size_t stiff_order = 4;
constexpr long maximum_patience = 400;

/// Maximum ratio of a step to the last one: the first few steps search for their length, high orders tolerate little
/// growth.
double largest_growth(std::size_t terms) { return terms == 1 ? 8.0 : terms <= 3 ? 4.0 : terms <= 6 ? 2.0 : 1.3; }

/// e^(-1/n) to 0.6 percent, e > 0 and not subnormal, from sums, products and the bits of the exponent alone: pow of the
/// library is not the same on all processors, and this function decides the length of steps.
double inverse_root(double e, std::size_t n) {
  constexpr std::int64_t one = std::int64_t{1} << 52;
  const auto bits = std::bit_cast<std::int64_t>(std::max(e, std::numeric_limits<double>::min()));
  const double m = std::bit_cast<double>((bits & (one - 1)) | std::bit_cast<std::int64_t>(1.0)) - 1.0;
  const double exponent = static_cast<double>(bits / one - 1023);  // e = (1 + m) 2^exponent
  const double x = -(exponent + m * (1.346 - 0.346 * m)) / static_cast<double>(n);
  const double floor = std::floor(x), f = x - floor;
  return (1.0 + f * (0.6565 + 0.3435 * f)) * std::bit_cast<double>((static_cast<std::int64_t>(floor) + 1023) * one);
}

/// Largest speed and displacement of any coordinate, each times the distance by which one unit of it moves its body.
struct Reach {
  double speed{};
  double displacement{};
};
TALUS_CLONES Reach reach(const State& begin, const State& end, const std::vector<double>& start,
                         const std::vector<double>& lengths) {
  Sizes speeds{}, displacements{};
  for_packs(
      lengths.size(), [&](std::size_t i, auto left) __attribute__((always_inline)) {
        Pack length, before, after, from, to;
        load(length, &lengths[i], left), load(before, &begin.v[i], left), load(after, &end.v[i], left);
        load(from, &start[i], left), load(to, &begin.q[i], left);
        raise(speeds, length * before), raise(speeds, length * after);
        raise(displacements, length * (to - from));
      });
  return {largest(speeds), largest(displacements)};
}

}  // namespace

PolynomialMotion::PolynomialMotion(const State& state, double tolerance)
    : tolerance_{tolerance},
      start_{state.q},
      implicit_step_{state},
      implicit_rates_{state},
      basis_(Differences::capacity + 1),
      predicted_{state},
      found_{state} {}

void PolynomialMotion::flatten(const Rates& rates) {
  new_.assign(rates.v.begin(), rates.v.end());
  if (moves_memory_) new_.insert(new_.end(), rates.z.begin(), rates.z.end());
  if (!keeps_accounts_) return;
  new_.insert(new_.end(), rates.work.begin(), rates.work.end());
  new_.insert(new_.end(), rates.impulse.begin(), rates.impulse.end());
}

/// Number of values that flatten() makes.
std::size_t PolynomialMotion::width(const State& like) const {
  return like.v.size() + (moves_memory_ ? like.z.size() : 0) +
         (keeps_accounts_ ? like.work.size() + like.impulse.size() : 0);
}

/// Begins a segment, whose first step has the rates at one time only.
void PolynomialMotion::begin(HybridSystem& system, const State& start, double interval) {
  if (lengths_.empty()) lengths_ = system.lengths(start);
  moves_memory_ = system.moves_memory(), keeps_accounts_ = system.keeps_accounts();
  system.derivative(start, found_);
  flatten(found_);
  rates_.begin(start.t, new_);
  order_ = 1;
  if (usual_ == 0.0) {
    usual_ = interval;
    start_scales(system, start);
  }
  step_ = first_fraction * usual_;
  probes_ = implicit_ = implicit_last_ = false;
  held_ = 0;
}

/// Sets the initial scales of the errors. If a motion starts at rest, errors relative to its own first displacement
/// would never be small: the memory of friction is first integrated with zero velocity. The springs respond by at least
/// a/w^2 in displacement and a/w in speed, with w the fastest rate of the springs that act.
void PolynomialMotion::start_scales(HybridSystem& system, const State& start) {
  LinearSegment piece;
  if (!system.linearization(start, piece)) return;
  const double rate = fastest_rate(piece, lengths_);
  if (rate == 0.0) return;
  double maximum = 0.0;
  for (std::size_t i = 0; i < lengths_.size(); ++i)
    maximum = std::max(maximum, lengths_[i] * std::abs(found_.v[i]));
  speed_ = maximum / rate, displacement_ = speed_ / rate;
}

std::string PolynomialMotion::advance(HybridSystem& system, const State& begin, State& end, double longest) {
  if (lengths_.empty()) lengths_ = system.lengths(begin);
  if (!implicit_ && held_ >= patience_) implicit_ = is_held_by_stiffness(system, begin);
  if (implicit_) {
    if (advance_implicitly(system, begin, end, longest)) return {};
    leave_implicit(begin);
  }
  implicit_last_ = false;
  // The rates at the end of the last step are added only now: until now the differences described that step.
  if (begin.t > rates_.newest()) {
    if (probes_) {
      rates_.begin(begin.t, new_);
      order_ = 1;
      probes_ = false;
    } else {
      rates_.add(begin.t, new_);
    }
  }
  // A probe step is a ten-thousandth of the last: it must not vanish in the rounding of the time.
  const double shortest = 4.0 * std::numeric_limits<double>::epsilon() * std::abs(begin.t);
  double h = std::max(std::min(step_, longest), shortest);
  for (int attempt = 0; attempt < 60 && begin.t + h > begin.t; ++attempt) {
    used_ = std::min(order_, rates_.count());
    try_step(system, begin, h, end);
    const Errors found = errors(end);
    if (found.now <= 1.0) {
      choose_next(h, found);
      return {};
    }
    shorten(h, found);
    h = step_;
  }
  return short_step_failure(tolerance_, begin.t);
}

/// True if the springs and dashpots that act are too fast for low-order steps of this length.
bool PolynomialMotion::is_held_by_stiffness(HybridSystem& system, const State& begin) {
  held_ = 0;
  system.derivative(begin, implicit_rates_);
  if (!implicit_step_.begin(system, begin) || !(step_ * implicit_step_.fastest_rate(lengths_) > 0.1)) {
    patience_ = std::min(2 * patience_, maximum_patience);
    return false;
  }
  explicit_step_ = step_;
  step_ *= 4.0;
  implicit_count_ = 0, implicit_start_ = begin.t;
  return true;
}

/// Takes one implicit step; returns false if the polynomial must continue from the beginning of the step.
bool PolynomialMotion::advance_implicitly(HybridSystem& system, const State& begin, State& end, double longest) {
  if (implicit_count_ > 0 && !implicit_step_.begin(system, begin)) return false;
  // The first few implicit steps may find their length.
  constexpr long trial = 4;
  if (implicit_count_ >= trial && step_ < implicit_cost * explicit_step_) return false;
  double h = std::min(step_, longest);
  speed_now_ = speed_, displacement_now_ = displacement_;
  while (begin.t + h > begin.t) {
    const double error = implicit_step_.take(system, begin, implicit_rates_, h, scales(), end);
    if (error <= 1.0) {
      measure(h, begin, end);
      speed_ = speed_now_, displacement_ = displacement_now_;
      step_ = h * (error > 0.0 ? std::clamp(0.9 * inverse_root(error, 4), 0.3, 5.0) : 5.0);
      implicit_last_ = true;
      ++implicit_count_;
      return true;
    }
    h *= std::isfinite(error) ? std::clamp(0.8 * inverse_root(error, 4), 0.1, 0.8) : 0.25;
    if (h < explicit_step_) return false;
  }
  return false;
}

/// Restarts the polynomial from the rates at the end of the last implicit step.
void PolynomialMotion::leave_implicit(const State& begin) {
  flatten(implicit_rates_);
  rates_.begin(begin.t, new_);
  order_ = 1;
  const double paid = implicit_cost * static_cast<double>(implicit_count_) * explicit_step_;
  patience_ = begin.t - implicit_start_ > 2.0 * paid ? first_patience : std::min(2 * patience_, maximum_patience);
  step_ = first_fraction * explicit_step_;
  implicit_ = false;
}

/// Predicts, evaluates and corrects a step; does not decide whether it is accepted.
void PolynomialMotion::try_step(HybridSystem& system, const State& begin, double h, State& end) {
  const double t = begin.t + h;
  rates_.basis(t, std::min(used_ + 2, rates_.count() + 1), basis_);
  last_value_ = basis_[used_].value;
  predicted_.mode = begin.mode;
  move(begin, t, {basis_.data(), used_}, predicted_);
  system.derivative(predicted_, found_);
  flatten(found_);
  std::array<double, maximum_terms> weights;
  for (std::size_t i = 0; i < used_; ++i)
    weights[i] = -basis_[i].value;
  miss_.resize(new_.size());
  rates_.sum(new_, 0, {weights.data(), used_}, miss_);
  end.t = t;
  end.mode = begin.mode;
  correct(basis_[used_], predicted_, end);
  measure(h, begin, end);
}

/// State at a time by the first terms of the polynomial.
void PolynomialMotion::move(const State& begin, double t, std::span<const Basis> basis, State& to) const {
  to.t = t;
  rates_.move(begin.q, begin.v, t - begin.t, basis, to.q, to.v);
  std::array<double, maximum_terms> once;
  for (std::size_t i = 0; i < basis.size(); ++i)
    once[i] = basis[i].once;
  std::size_t first = to.v.size();
  const auto integrate = [&](bool moves, const auto& from, auto& sums) {
    if (!moves) return void(sums = from);
    rates_.sum(from, first, {once.data(), basis.size()}, sums);
    first += sums.size();
  };
  integrate(moves_memory_, begin.z, to.z);
  integrate(keeps_accounts_, begin.work, to.work);
  integrate(keeps_accounts_, begin.impulse, to.impulse);
}

/// Adds the term that the prediction missed: its integral over time, and its double integral. `to` may be `from`.
void PolynomialMotion::correct(const Basis& last, const State& from, State& to) const {
  const double once = last.once / last_value_, twice = last.twice / last_value_;
  const double* missed = miss_.data();
  add_scaled(to.q.data(), from.q.data(), twice, missed, to.q.size());
  const auto integrate = [&](bool moves, const auto& start, auto& sums) {
    if (!moves) return void(sums = start);
    add_scaled(sums.data(), start.data(), once, missed, sums.size());
    missed += sums.size();
  };
  integrate(true, from.v, to.v);
  integrate(moves_memory_, from.z, to.z);
  integrate(keeps_accounts_, from.work, to.work);
  integrate(keeps_accounts_, from.impulse, to.impulse);
}

void PolynomialMotion::state_at(const State& begin, const State&, double t, State& out) const {
  if (implicit_last_) return implicit_step_.state_at(begin, t, out);
  std::array<Basis, Differences::capacity + 1> basis;
  rates_.basis(t, used_ + 1, basis);
  move(begin, t, {basis.data(), used_}, out);
  correct(basis[used_], out, out);
}

/// Updates the scales of the errors: the largest displacement and the largest speed so far.
void PolynomialMotion::measure(double h, const State& begin, const State& end) {
  const Reach now = reach(begin, end, start_, lengths_);
  // Not yet stored as speed_ and way_: if the step fails, its end may be anywhere.
  speed_now_ = std::max(speed_, now.speed);
  displacement_now_ = std::max(displacement_, std::max(now.displacement, h * speed_now_));
}

/// The last step's errors as multiples of the tolerance: the difference between prediction and correction.
PolynomialMotion::Errors PolynomialMotion::errors(const State& like) const {
  const std::size_t n = like.v.size(), m = moves_memory_ ? like.z.size() : 0;
  const bool less = used_ > 1, more = used_ < rates_.count() && used_ < maximum_terms;
  // With one term fewer, that term is missed as well; with one more, that term is no longer missed.
  const std::array<Differences::Term, 2> terms{
      less ? Differences::Term{used_ - 1, basis_[used_ - 1].value} : Differences::Term{},
      more ? Differences::Term{used_, -basis_[used_].value} : Differences::Term{}};
  const std::span<const double> missed{miss_};
  const std::array<double, 3> motion = rates_.largest(missed.first(n), 0, terms, lengths_);
  std::array<double, 3> memory{};
  if (m > 0) memory = rates_.largest(missed.subspan(n, m), n, terms, {});
  // NaN counts as the largest.
  const auto raise = [](double& maximum, double x) { maximum = x > maximum || x != x ? x : maximum; };
  // While the motion has not begun, its scale is zero and any error but zero is too large.
  const auto ratio = [](double x, double of) { return x == 0.0 ? 0.0 : x / of; };
  const auto error = [&](std::size_t index, std::size_t used) {
    const Basis& left_out = basis_[used];
    const double once = std::abs(left_out.once / left_out.value), twice = std::abs(left_out.twice / left_out.value);
    double maximum = ratio(motion[index] * once, speed_now_);
    raise(maximum, ratio(motion[index] * twice, displacement_now_));
    raise(maximum, ratio(memory[index] * once, displacement_now_));
    return maximum / tolerance_;
  };
  constexpr double none = std::numeric_limits<double>::infinity();
  return {error(0, used_), less ? error(1, used_ - 1) : none, more ? error(2, used_ + 1) : none};
}

/// Chooses the length of the next attempt after a failed step.
void PolynomialMotion::shorten(double h, const Errors& errors) {
  const double ratio = std::isfinite(errors.now) ? 0.8 * inverse_root(errors.now, used_ + 1) : 0.0;
  step_ = h * std::clamp(ratio, used_ == 1 ? 1e-3 : 0.1, 0.8);
  if (errors.fewer < errors.now) order_ = used_ - 1;
}

/// After an accepted step: adopts its scales, and chooses the order that allows the longest next step, and that step.
void PolynomialMotion::choose_next(double h, const Errors& errors) {
  speed_ = speed_now_, displacement_ = displacement_now_;
  const auto growth = [](double e, std::size_t terms) { return e > 0.0 ? 0.9 * inverse_root(e, terms + 1) : 10.0; };
  double best = growth(errors.now, used_);
  order_ = used_;
  if (used_ > 1) {
    const double lower = growth(errors.fewer, used_ - 1);
    if (lower > best) best = lower, order_ = used_ - 1;
  }
  if (order_ == used_ && used_ < maximum_terms) {
    if (rates_.count() == used_) {
      ++order_;  // all known times were used: the next step has one more
    } else {
      const double higher = growth(errors.more, used_ + 1);
      if (higher > best) best = higher, ++order_;
    }
  }
  if (probes_) {
    // The probe limits the first step; without an error it does not.
    step_ = first_fraction * usual_;
    if (errors.now > 0.0) step_ = std::min(best * h, step_);
    return;
  }
  const double maximum = largest_growth(used_);
  step_ = h * std::clamp(best, 0.3, maximum);
  if (used_ > stiff_order || step_ > 3.0 * held_step_) held_ = 0, held_step_ = step_;
  ++held_;
  usual_ = best < maximum ? step_ : std::max(usual_, step_);
}

void PolynomialMotion::serialize(Archive& archive, const State& like) {
  archive.flag("probes", probes_);
  archive.flag("moves_memory", moves_memory_);
  archive.flag("integrates_balance", keeps_accounts_);
  new_.resize(width(like));
  miss_.resize(new_.size());
  archive.scope("rates", [&] { rates_.serialize(archive, new_.size()); });
  archive.numbers("new_rates", new_);
  archive.numbers("prediction_error", miss_);
  archive.number("last_value", last_value_);
  const auto count = [&](const char* part, std::size_t& value) {
    long whole = static_cast<long>(value);
    archive.count(part, whole);
    value = static_cast<std::size_t>(whole);
    const std::size_t allowed = std::clamp<std::size_t>(rates_.count() + 1, 1, maximum_terms);
    if (value < 1 || value > allowed)
      throw InputError{fmt::format("{}: found {}; it must lie in [1, {}]", part, value, allowed)};
  };
  count("order", order_);
  count("used", used_);
  archive.number("step", step_);
  archive.number("usual_step", usual_);
  archive.number("largest_displacement", displacement_);
  archive.number("largest_speed", speed_);
  archive.numbers("start", start_);
  archive.flag("implicit", implicit_);
  archive.flag("implicit_last", implicit_last_);
  if (archive.is_loading()) implicit_rates_ = Rates{like};
  archive.scope("implicit_rates", [&] { talus::serialize(archive, implicit_rates_); });
  archive.scope("implicit_step", [&] { implicit_step_.serialize(archive, like); });
  archive.number("explicit_step", explicit_step_);
  archive.number("implicit_start", implicit_start_);
  archive.count("implicit_count", implicit_count_);
  archive.count("low_order_steps", held_);
  archive.number("low_order_step", held_step_);
  archive.count("low_order_limit", patience_);
}

}  // namespace talus
